// Any bytes as a scene file: read, checked, located, encoded and viewed. A scene that passes the checks must be safe for
// everything that uses it.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/programs/jones/encode.hpp"
#include "host/scene/check/cell_scene.hpp"
#include "host/scene/read/cell_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto result = scene::read_cell_scene(text, "fuzz");
  if (!result || !scene::check_scene(*result).empty()) return 0;
  static_cast<void>(programs::jones::write_tape(*result));
  static_cast<void>(algorithms::oracle::visible_lines(*result, result->default_view, {}));
  return 0;
}
