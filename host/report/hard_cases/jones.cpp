#include "host/report/hard_cases/jones.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/base/result.hpp"
#include "host/report/hard_cases/hard_cases.hpp"
#include "host/report/hard_cases/program.hpp"
#include "host/report/hard_cases/segments.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/cells/from_cell_scene.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/cell_scene.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::jones;
using base::Error;
using picture::LinePicture;
using scene::PolyScene;

// A case as every build wants it.
struct Loaded {
  std::optional<scene::CellScene> cells;
  PolyScene poly;
  scene::CellComplex complex;
};

base::Result<Loaded> load_poly(std::string_view text, const std::string& file) {
  auto read = scene::read_poly_json(text, file);
  if (!read) return std::move(read.error());
  Loaded loaded;
  loaded.poly = std::move(*read);
  auto errors = scene::check_poly_scene(loaded.poly);
  if (!errors.empty()) return std::move(errors.front());
  auto complex = scene::compartment(loaded.poly);
  if (!complex) return std::move(complex.error());
  loaded.complex = std::move(*complex);
  return loaded;
}

base::Result<Loaded> load(const JonesHardCase& hard) {
  const std::string_view text = hard_case_text(hard.file);
  const std::string file(hard.file);
  if (scene::is_poly_json(text)) return load_poly(text, file);
  auto read = scene::read_possible_cell_scene(text, file);
  if (!read) return std::move(read.error());
  Loaded loaded;
  loaded.cells = std::move(*read);
  loaded.poly = scene::poly_scene_of(*loaded.cells);
  loaded.complex = scene::complex_of(*loaded.cells, loaded.poly);
  return loaded;
}

// What is wrong, one after the other; empty: nothing.
class Complaints {
 public:
  void add(std::string text) { text_ += (text_.empty() ? "" : "; ") + std::move(text); }
  void compare(const char* what, std::uint64_t found, const std::optional<std::uint64_t>& expected) {
    if (expected && found != *expected) add(fmt::format("{} {}, not {}", what, found, *expected));
  }
  [[nodiscard]] Cell verdict(std::string_view when_right = "right") const {
    if (text_.empty()) return Verdict{true, std::string(when_right)};
    return Verdict{false, "differs: " + text_};
  }

 private:
  std::string text_;
};

void check_lines(const JonesHardCase& hard, const LinePicture& picture, const PolyScene& scene,
                 Complaints& complaints) {
  const auto wrong = [&](const std::vector<SceneSegment>& segments, SegmentSeen expected) {
    return std::count_if(segments.begin(), segments.end(), [&](const SceneSegment& segment) {
      return seen_of(segment, picture, scene) != expected;
    });
  };
  if (const auto count = wrong(hard.seen, SegmentSeen::whole); count != 0)
    complaints.add(fmt::format("{} lines not seen whole", count));
  if (const auto count = wrong(hard.hidden, SegmentSeen::nothing); count != 0)
    complaints.add(fmt::format("{} lines not hidden", count));
}

std::vector<scene::PolyCamera> cameras_of(const JonesHardCase& hard, const PolyScene& scene) {
  return hard.cameras.empty() ? std::vector{scene.camera} : hard.cameras;
}

Cell native_cell(const JonesHardCase& hard, const Loaded& loaded, bool compare) {
  Complaints complaints;
  for (const scene::PolyCamera& camera : cameras_of(hard, loaded.poly)) {
    const auto result = native::visible_edges(loaded.complex, camera);
    if (!result) {
      complaints.add(result.error().message());
      continue;
    }
    const auto& view = *result;
    if (compare && view.picture != algorithms::oracle::visible_edges(loaded.poly, camera))
      complaints.add("not the oracle's picture");
    complaints.compare("cells", view.counts.cells, hard.cells);
    complaints.compare("visits", view.counts.visits, hard.visits);
    complaints.compare("mask sides", view.counts.mask_sides, hard.sides);
    check_lines(hard, view.picture, loaded.poly, complaints);
  }
  return complaints.verdict();
}

// `draw`: a picture of a scene from a camera.
template <class Draw>
Cell exact_cell(const JonesHardCase& hard, const Loaded& loaded, Draw draw) {
  Complaints complaints;
  for (const scene::PolyCamera& camera : cameras_of(hard, loaded.poly)) {
    const LinePicture picture = draw(loaded.poly, camera);
    if (picture != algorithms::oracle::visible_edges(loaded.poly, camera))
      complaints.add("not the oracle's picture");
    check_lines(hard, picture, loaded.poly, complaints);
  }
  return complaints.verdict();
}

Cell oracle_cell(const JonesHardCase& hard, const Loaded& loaded) {
  Complaints complaints;
  for (const scene::PolyCamera& camera : cameras_of(hard, loaded.poly))
    check_lines(hard, algorithms::oracle::visible_edges(loaded.poly, camera), loaded.poly, complaints);
  return complaints.verdict();
}

// Both are defined for an eye in free space only.
std::optional<std::string> why_no_oracle(const JonesHardCase& hard, const Loaded& loaded) {
  for (const scene::PolyCamera& camera : cameras_of(hard, loaded.poly)) {
    if (const auto error = scene::eye_error(loaded.poly, camera))
      return "not applicable: " + error->message();
  }
  return std::nullopt;
}

JonesHardResult run_rejected(const base::Result<Loaded>& loaded) {
  Cell cell = Verdict{false, "accepted"};
  if (!loaded) cell = Verdict{true, "refused: " + loaded.error().message()};
  return {cell, cell, cell, cell, cell};
}

}  // namespace

JonesHardResult run_hard_case(const JonesHardCase& hard) {
  const auto input = load(hard);
  if (hard.rejected) return run_rejected(input);
  if (!input) {
    const Cell cell = Verdict{false, "refused: " + input.error().message()};
    return {cell, cell, cell, cell, cell};
  }
  const auto& loaded = *input;
  JonesHardResult result;
  const auto no_oracle = why_no_oracle(hard, loaded);
  result.native = native_cell(hard, loaded, !no_oracle);
  if (no_oracle) {
    result.exact = result.oracle = *no_oracle;
  } else {
    result.exact = exact_cell(hard, loaded, [](const PolyScene& scene, const scene::PolyCamera& camera) {
      return algorithms::exact::visible_edges(scene, camera);
    });
    result.oracle = oracle_cell(hard, loaded);
  }
  if (loaded.cells) {
    std::tie(result.guest, result.twin) = run_programs(hard, *loaded.cells);
  } else {
    result.guest = result.twin = "not applicable: " + why_no_machine(loaded.poly);
  }
  return result;
}

}  // namespace sightline::harness::report
