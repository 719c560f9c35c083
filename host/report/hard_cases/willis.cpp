// See willis.hpp.
#include "host/report/hard_cases/willis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "host/base/result.hpp"
#include "host/report/hard_cases/hard_cases.hpp"
#include "host/report/willis_views.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::harness::report {

namespace {

namespace willis = algorithms::willis;
using base::Error;
using scene::PolyScene;
using willis::Model;
using willis::Surface;

constexpr int picture_size = 128;

base::Result<PolyScene> load(const WillisHardCase& hard) {
  auto read = scene::read_poly_json(hard_case_text(hard.file), hard.file);
  if (!read) return std::move(read.error());
  auto errors = scene::check_poly_scene(*read);
  if (!errors.empty()) return std::move(errors.front());
  return read;
}

Cell build_cell(const WillisHardCase& hard, const PolyScene& scene, const Model& model) {
  if (hard.end == WillisEnd::refused) {
    const auto error = scene::eye_error(scene, scene.camera);
    return Verdict{error.has_value(), error ? "refused: " + error->message() : "accepted"};
  }
  const auto named = willis::residual_lines(model, scene);
  std::string text = named.empty() ? "solved: " : fmt::format("left over, named: {}; ", named.front());
  text += fmt::format("clusters {}, pieces {} of {}, order cells {}", model.clusters, model.pieces.size(),
                      model.surfaces, model.cells.cells);
  bool good = !hard.clusters || *hard.clusters == model.clusters;
  if (hard.end == WillisEnd::left_over) {
    good = good && !named.empty() &&
           std::all_of(model.residual.begin(), model.residual.end(), [](const willis::Residual& pair) {
             return pair.reason == willis::ResidualReason::touching;
           });
  } else {
    good = good && named.empty();
  }
  return Verdict{good, (good ? "" : "differs: ") + text};
}

// From the scene's own camera and from all sides.
Cell picture_cell(const WillisHardCase& hard, const PolyScene& scene, const Model& model) {
  auto cameras = cameras_around(scene, scene.camera.eye[1]);
  if (hard.end != WillisEnd::refused) cameras.insert(cameras.begin(), scene.camera);
  const TrueFaces truth(scene, std::move(cameras), picture_size);
  const FaceErrors errors = truth.errors_of(model);
  const std::string text =
      fmt::format("{} views, {} points, {} wrong, {} more next to edges", truth.cameras().size(),
                  errors.points, errors.wrong_inside, errors.wrong_on_edges);
  if (hard.end == WillisEnd::left_over) return "not promised: " + text;
  return Verdict{errors.wrong_inside == 0, (errors.wrong_inside == 0 ? "right: " : "differs: ") + text};
}

// (0, 0)-(length, 0) and, at 1 from its middle, a wall of 1; the sides between which the first hides the
// second.
std::vector<Surface> long_beside_small(std::int32_t length) {
  const auto wall = [](std::int32_t from, std::int32_t to, std::int32_t z, std::uint32_t face) {
    Surface s;
    s.points = {willis::on_lattice({from, 0, z}), willis::on_lattice({to, 0, z})};
    s.plane.normal = {0, 0, from - to};
    s.plane.offset = std::int64_t{from - to} * z;
    s.face = s.body = face;
    s.high = 1;
    return s;
  };
  return {wall(0, length, 0, 0), wall(length / 2, length / 2 + 1, 1, 1)};
}

}  // namespace

WillisHardResult run_hard_case(const WillisHardCase& hard) {
  const auto loaded = load(hard);
  if (!loaded) {
    const Cell cell = Verdict{false, "refused: " + loaded.error().message()};
    return {cell, cell, cell};
  }
  const auto& scene = *loaded;
  const auto made = willis::make_model(scene, hard.options);
  if (!made) {
    const Cell cell = Verdict{false, "refused: " + made.error().message()};
    return {cell, cell, cell};
  }
  const auto& model = *made;
  WillisHardResult result;
  if (hard.facts != nullptr) result.facts = hard.facts(scene, model);
  result.build = build_cell(hard, scene, model);
  result.picture = picture_cell(hard, scene, model);
  return result;
}

Table willis_table(const Context& context) {
  Table table;
  table.id = "hard-cases-willis";
  table.title = "Willis: distance as priority, W1 to W16";
  table.columns = {{"case", "Case", "", false},       {"input", "Input", "", false},
                   {"what", "What it is", "", false}, {"expected", "Expected", "", false},
                   {"checked", "Checked", "", false}, {"facts", "Found", "", false},
                   {"build", "The build", "", false}, {"picture", "Picture", "", false}};
  for (const WillisHardCase& hard : willis_hard_cases()) {
    context.progress(fmt::format("hard case {}", hard.file));
    WillisHardResult result = run_hard_case(hard);
    table.rows.push_back({std::string(hard.id), std::string(hard.file), std::string(hard.what),
                          std::string(hard.expected), std::string(hard.checked), std::move(result.facts),
                          std::move(result.build), std::move(result.picture)});
  }
  table.notes = {
      "Walls are seen from both sides, so a cluster of two walls counts twice. Pictures of 128 by 128 "
      "points, 90 degrees wide, from the scene's own camera and from four sides, are held against the "
      "nearest face of every point; within 0.75 points of an edge rounding may choose either side. Drawn by "
      "`sightline draw willis FILE --plan -o picture.png`; W7 without --plan."};
  return table;
}

Table willis_lengths(const Context& context) {
  Table table;
  table.id = "hard-cases-willis-lengths";
  table.title = "Willis, W10: a long wall at 1 from a wall of 1, pieces needed";
  table.columns = {{"length", "Length", "", false},
                   {"boundary", "Boundary", "", false},
                   {"long_pieces", "Pieces of the long wall", "", false},
                   {"small_pieces", "of the short one", "", false},
                   {"depth", "Cuts of one piece, at most", "", false},
                   {"two_log2", "2 log2 of the length", "", false},
                   {"outcome", "Outcome", "", false}};
  for (const std::int32_t length : {10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 9999, 10000}) {
    context.progress(fmt::format("hard case W10, length {}", length));
    for (const auto& [shape, name] : {std::pair{willis::BoundaryShape::oval, "oval"},
                                      std::pair{willis::BoundaryShape::ball, "two circles"}}) {
      const Model model =
          willis::make_model(long_beside_small(length), {.rules = {shape, false}, .plan = true});
      std::array<std::int64_t, 2> pieces{};
      int depth = 0;
      for (const Surface& s : model.pieces) {
        ++pieces[s.face];
        depth = std::max(depth, s.depth);
      }
      const bool solved = model.residual.empty();
      table.rows.push_back(
          {std::int64_t{length}, std::string(name), pieces[0], pieces[1], std::int64_t{depth},
           Real{2 * std::log2(static_cast<double>(length)), 1},
           Verdict{solved,
                   solved ? "solved"
                          : fmt::format("left over: {}", willis::name_of(model.residual.front().reason))}});
    }
  }
  table.notes = {
      "Cut into equal parts the long wall would need more pieces than it is long. Bisection cuts only what "
      "is near the short wall, some two pieces for each halving."};
  return table;
}

}  // namespace sightline::harness::report
