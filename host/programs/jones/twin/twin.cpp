#include "host/programs/jones/twin/twin.hpp"

#include "host/programs/jones/twin/elements.hpp"
#include "host/programs/jones/twin/search.hpp"

namespace sightline::programs::jones {

using core::Word18;

Parameters default_parameters(std::span<const Word18> core, std::uint32_t scene_header) {
  const CoreImage words(core);
  Parameters parameters;
  parameters.eye = {words.number(scene_header + 2), words.number(scene_header + 3),
                    words.number(scene_header + 4)};
  return parameters;
}

TwinView run_twin(std::span<const Word18> core, std::uint32_t scene_header, const Parameters& parameters) {
  const ShortWords number(machine_word_bits, parameters.fraction_bits, parameters.truncate);
  return Search(core, scene_header, parameters, number).run();
}

}  // namespace sightline::programs::jones
