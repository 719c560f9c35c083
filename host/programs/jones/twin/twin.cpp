#include "host/programs/jones/twin/twin.hpp"

#include "host/programs/jones/twin/elements.hpp"
#include "host/programs/jones/twin/search.hpp"

namespace sightline::programs::jones {

using core::Word18;

std::string_view name(Status status) {
  switch (status) {
    case Status::complete: return "complete";
    case Status::stack_overflow: return "stack overflow";
    case Status::display_file_overflow: return "display file overflow";
    case Status::arithmetic_overflow: return "arithmetic overflow";
    case Status::too_many_mask_vertices: return "too many mask vertices";
    case Status::deeper_than_cells: return "deeper than the number of cells";
    case Status::bad_data_element: return "bad data element";
    case Status::unfinished: return "unfinished: the search goes on";
  }
  return "unknown status";
}

Parameters default_parameters(std::span<const Word18> core, std::uint32_t scene_header) {
  const CoreImage words(core);
  Parameters parameters;
  parameters.eye = {words.number(scene_header + 2), words.number(scene_header + 3),
                    words.number(scene_header + 4)};
  return parameters;
}

View run(std::span<const Word18> core, std::uint32_t scene_header, const Parameters& parameters) {
  const ShortWords number(machine_word_bits, parameters.fraction_bits, parameters.truncate);
  return Search(core, scene_header, parameters, number).run();
}

}  // namespace sightline::programs::jones
