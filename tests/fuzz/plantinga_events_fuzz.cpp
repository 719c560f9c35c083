// Event files with arbitrary contents and a correct checksum, so that the reader reaches them: an error, or a list that can
// be used for a rotation.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/event_file.hpp"
#include "host/base/file.hpp"

namespace {

using namespace sightline;

scene::PolyScene two_triangles() {
  scene::PolyScene scene;
  scene.vertices = {{-9, -7, 1}, {8, -5, 2}, {1, 9, 3}, {-6, -4, 30}, {7, -8, 28}, {2, 5, 33}};
  scene.bodies = {{"", true, {scene::PolyFace{{0, 1, 2}, {}}}}, {"", true, {scene::PolyFace{{3, 4, 5}, {}}}}};
  return scene;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const algorithms::plantinga::RotationModel model(two_triangles());
  base::Bytes bytes(data, data + size);
  if (size >= 26) {
    // Inserts the model's identifier, so that the corpus does not contain it.
    for (std::size_t i = 0; i < 8; ++i)
      bytes[18 + i] = static_cast<std::uint8_t>(model.fingerprint() >> (8 * i));
    std::uint64_t hash = 14695981039346656037ULL;
    for (std::size_t i = 0; i + 8 < size; ++i) hash = (hash ^ bytes[i]) * 1099511628211ULL;
    for (std::size_t i = 0; i < 8 && size >= 42; ++i)
      bytes[size - 8 + i] = static_cast<std::uint8_t>(hash >> (8 * i));
  }
  const auto read = algorithms::plantinga::decode_events(bytes, "fuzz", model);
  if (!read) return 0;
  algorithms::plantinga::EdgeStructureGraph graph(*read);
  for (std::size_t i = 0; i < read->events.size(); ++i) {
    if (!graph.step_forward()) std::abort();
  }
  return 0;
}
