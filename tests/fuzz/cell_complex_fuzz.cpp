// Any bytes as a file of cells: an accepted file is written, read and written again to the same bytes, and searched by Jones's
// algorithm.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "host/algorithms/jones/visible_edges.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/read/cell_complex_file.hpp"

namespace {

std::string write_file_text(const sightline::scene::CellComplexFile& file) {
  std::string text;
  sightline::scene::write_cell_complex(file.scene, file.decomposition,
                                       [&](std::string_view piece) { text += piece; });
  return text;
}

void walk(const sightline::scene::CellComplexFile& file) {
  namespace native = sightline::algorithms::jones;
  if (sightline::scene::eye_error(file.scene, file.scene.camera)) return;
  const native::PreparedComplex prepared(file.decomposition.complex);
  native::Walker walker(prepared);
  static_cast<void>(walker.visible_edges(file.scene.camera));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  static_cast<void>(scene::is_cell_complex(text));
  const auto read = scene::read_cell_complex(text, "fuzz");
  if (!read) return 0;
  const std::string once = write_file_text(*read);
  const auto again = scene::read_cell_complex(once, "written");
  if (!again || write_file_text(*again) != once) std::abort();
  walk(*read);
  return 0;
}
