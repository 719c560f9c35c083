#include "host/report/hard_cases/montani_re.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/base/result.hpp"
#include "host/report/hard_cases/hard_cases.hpp"
#include "host/report/montani_re_pixels.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::montani_re;
using picture::PixelGrid;
using scene::PolyScene;

// What is wrong, one after the other; empty: nothing.
class Complaints {
 public:
  void add(const std::string& text) { text_ += (text_.empty() ? "" : "; ") + text; }
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

base::Result<PolyScene> load(const MontaniReHardCase& hard) {
  auto read = scene::read_poly_json(hard_case_text(hard.file), std::string(hard.file));
  if (read) {
    auto errors = scene::check_poly_scene(*read);
    if (!errors.empty()) return std::move(errors.front());
  }
  return read;
}

// By body.
std::vector<double> seen_areas(const PolyScene& scene, const native::FaceSet& set,
                               const native::VisibleRegions& seen) {
  std::vector<double> areas(scene.bodies.size());
  for (std::size_t f = 0; f < set.faces.size(); ++f)
    areas[set.faces[f].body] += native::area(set.image, seen.regions[f]);
  return areas;
}

std::string list_of(const PolyScene& scene, const native::FaceSet& set, const native::PriorityList& list) {
  std::string text;
  for (const native::PriorityClass& members : list.classes()) {
    if (!text.empty()) text += " / ";
    for (const std::uint32_t face : members)
      text += (face == members.front() ? "" : ",") + scene.bodies[set.faces[face].body].name;
  }
  return text;
}

using Pair = std::optional<std::pair<std::uint32_t, std::uint32_t>>;

// Whether faces that pass through each other are found iff there are any; nothing more to check if so.
bool refused(const MontaniReHardCase& hard, const native::FaceSet& set, const Pair& found,
             Complaints& complaints) {
  if (!found) {
    if (hard.through) complaints.add("accepted");
    return false;
  }
  const std::pair<std::size_t, std::size_t> bodies{set.faces[found->first].body,
                                                   set.faces[found->second].body};
  if (hard.through != bodies)
    complaints.add(fmt::format("bodies {} and {} refused", bodies.first, bodies.second));
  return true;
}

Cell native_cell(const MontaniReHardCase& hard, const PolyScene& scene, const native::FaceSet& set) {
  Complaints complaints;
  const auto silhouette = hard.whole_silhouette ? native::Silhouette::whole : native::Silhouette::neighbours;
  const native::VisibleRegions seen = native::visible_regions(set, silhouette);
  if (refused(hard, set, seen.interpenetrating, complaints))
    return complaints.verdict("right: refused by name");
  if (const auto areas = seen_areas(scene, set, seen); areas != hard.areas)
    complaints.add(fmt::format("areas {}", fmt::join(areas, ", ")));
  complaints.compare("relations", seen.counts.relations, hard.relations);
  complaints.compare("cuts", seen.counts.cuts, hard.cuts);
  complaints.compare("parts cut off", seen.counts.mutual_parts, hard.parts);
  complaints.compare("faces seen edge-on", set.edge_on, hard.edge_on);
  complaints.compare("pairs decided by test 3", seen.counts.decided_by[3], hard.by_test_3);
  if (const auto list = list_of(scene, set, seen.list); !hard.list.empty() && list != hard.list)
    complaints.add("list " + list);
  if (const auto wrong = wrong_lines(scene, algorithms::exact::visible_edges(scene, scene.camera)))
    complaints.add(*wrong);
  return complaints.verdict();
}

std::string raster_of(const PolyScene& scene, const native::FaceSet& set, const native::ListedFaces& listed,
                      const PixelView& view, std::int32_t units, PixelGrid& grid) {
  const auto raster = native::raster_by_difference(set.image, listed.list, listed.faces, view.frame, units);
  grid = grid_of(scene, set, raster);
  const bool same =
      raster == native::raster_by_overwriting(set.image, listed.list, listed.faces, view.frame, units);
  return same ? "" : "overwriting gives another raster than differences";
}

// With corners on lines between stripes, every pixel must be right; elsewhere those not on an edge.
Cell stripes_cell(const MontaniReHardCase& hard, const PolyScene& scene, const native::FaceSet& set) {
  Complaints complaints;
  const native::ListedFaces listed = native::listed_faces(set);
  if (refused(hard, set, listed.interpenetrating, complaints))
    return complaints.verdict("right: refused by name");
  PixelGrid grid;
  const PixelView on = pixels_along_z(scene, on_lines);
  const std::vector<std::int32_t> thicknesses =
      hard.on_lines ? std::vector{2, 4, 8, 16, 32, 64} : std::vector{16};
  for (const std::int32_t units : thicknesses) {
    if (const auto wrong = raster_of(scene, set, listed, on, units, grid); !wrong.empty())
      complaints.add(wrong);
    if (const auto metrics = picture::pixel_metrics(on.truth, grid, {}); metrics.different() != 0)
      complaints.add(fmt::format("{} pixels wrong with corners on lines, stripes of {} pixels",
                                 metrics.different(), 16.0 / units));
  }
  const PixelView off = pixels_along_z(scene, off_lines);
  if (const auto wrong = raster_of(scene, set, listed, off, 16, grid); !wrong.empty()) complaints.add(wrong);
  const auto metrics = picture::pixel_metrics(off.truth, grid, off.edges);
  if (metrics.different_inside != 0)
    complaints.add(fmt::format("{} pixels wrong away from edges", metrics.different_inside));
  return complaints.verdict(fmt::format("right; corners off the lines: {} of {} pixels differ, all on edges",
                                        metrics.different(), metrics.pixels));
}

Cell exact_cell(const PolyScene& scene) {
  Complaints complaints;
  if (algorithms::exact::visible_edges(scene, scene.camera) !=
      algorithms::oracle::visible_edges(scene, scene.camera))
    complaints.add("not the oracle's lines");
  return complaints.verdict();
}

// One sight line through every unit square.
Cell oracle_cell(const MontaniReHardCase& hard, const PolyScene& scene) {
  Complaints complaints;
  std::vector<double> areas(scene.bodies.size());
  for (const std::uint32_t face : pixels_along_z(scene, on_lines).truth.values) {
    if (face != 0) areas[face - 1] += 1;
  }
  if (areas != hard.areas) complaints.add(fmt::format("areas {}", fmt::join(areas, ", ")));
  return complaints.verdict();
}

}  // namespace

std::optional<std::string> wrong_lines(const PolyScene& scene, const picture::LinePicture& truth) {
  const LineAlgorithm& algorithm = *find_line_algorithm("montani-re");
  if (algorithm.why_not(scene) || algorithm.why_not_seen(scene, scene.camera)) return std::nullopt;
  const auto prepared = algorithm.prepare(scene);
  if (!prepared) return prepared.error().message();
  const auto drawn = prepared->view(scene.camera);
  if (!drawn) return drawn.error().message();
  if (agrees(algorithm, drawn->picture, truth, scene, scene.camera)) return std::nullopt;
  return "other lines";
}

std::string expected_value(const MontaniReHardCase& hard) {
  std::vector<std::string> parts;
  if (hard.through)
    parts.push_back(fmt::format("bodies {} and {} named", hard.through->first, hard.through->second));
  if (!hard.areas.empty()) parts.push_back(fmt::format("seen areas {}", fmt::join(hard.areas, ", ")));
  const auto count = [&parts](const std::optional<std::uint64_t>& number, const char* one, const char* many) {
    if (number) parts.push_back(fmt::format("{} {}", *number, *number == 1 ? one : many));
  };
  count(hard.relations, "relation", "relations");
  count(hard.cuts, "cut of a cycle", "cuts of cycles");
  count(hard.parts, "part cut off", "parts cut off");
  count(hard.edge_on, "face left out", "faces left out");
  count(hard.by_test_3, "pair decided by test 3", "pairs decided by test 3");
  if (!hard.list.empty()) parts.push_back("list " + std::string(hard.list));
  constexpr std::array names{"A", "A and B", "A or B", "A less B"};
  for (const LatticeExpected& region : hard.regions) {
    parts.push_back(fmt::format("{}: area {}, {} {}", names[static_cast<std::size_t>(region.combination)],
                                static_cast<double>(region.eighths) / 8, region.loops,
                                region.loops == 1 ? "loop" : "loops"));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

MontaniReHardResult run_hard_case(const MontaniReHardCase& hard) {
  if (hard.file.ends_with(".txt")) return run_lattice_case(hard);
  const auto input = load(hard);
  if (!input) {
    const Cell cell = Verdict{false, "refused: " + input.error().message()};
    return {cell, cell, cell, cell};
  }
  const auto& scene = *input;
  const auto made = native::faces_of(scene, scene.camera);
  if (!made) {
    const Cell cell = Verdict{false, "refused: " + made.error().message()};
    return {cell, cell, exact_cell(scene), oracle_cell(hard, scene)};
  }
  const auto& set = *made;
  return {native_cell(hard, scene, set), stripes_cell(hard, scene, set), exact_cell(scene),
          oracle_cell(hard, scene)};
}

Table montani_re_cases(const Context& context) {
  Table table;
  table.id = "hard-cases-montani-re";
  table.title = "Montani and Re: stripes and priority lists, M1 to M18";
  table.columns = {{"case", "Case", "", false},
                   {"input", "Input", "", false},
                   {"what", "What it is", "", false},
                   {"expected", "Expected", "", false},
                   {"expected_value", "Checked", "", false},
                   {"native", "Exact build", "", false},
                   {"stripes", "Stripes of a pixel", "", false},
                   {"exact", "exact", "", false},
                   {"oracle", "Oracle", "", false}};
  for (const MontaniReHardCase& hard : montani_re_hard_cases()) {
    context.progress(fmt::format("hard case {}", hard.file));
    MontaniReHardResult result = run_hard_case(hard);
    table.rows.push_back({std::string(hard.id), std::string(hard.file), std::string(hard.what),
                          std::string(hard.expected), expected_value(hard), std::move(result.native),
                          std::move(result.stripes), std::move(result.exact), std::move(result.oracle)});
  }
  table.notes = {
      "Scenes (.json) are sheets seen along z without perspective; bodies count from 0. The exact build must "
      "show the areas and draw the lines of exact. Stripes of a pixel are held against the oracle's sight "
      "lines through the middles of pixels: once with a pixel a unit, so that all corners lie on lines "
      "between stripes and no pixel may be wrong, once with 4.25 pixels a unit, where pixels within 0.75 "
      "pixels of an edge may. exact must draw the lines of the oracle of edges; the areas of the oracle are "
      "counts of sight lines, one through every unit square.",
      "Saved, a scene is drawn by `sightline draw montani-re FILE -o picture.svg`. Chains (.txt) have a line "
      "a chain: the name of its region, its starting point, its links (0 east, 1 north-east, ... 7 "
      "south-east); a region is what lies inside an odd number of its chains. They are given to lattice_pcs "
      "(host/algorithms/montani_re/lattice_pcs.hpp); with stripes of a step, areas must come out the same. "
      "Their oracle asks for each quarter of each square whether its middle is inside."};
  return table;
}

}  // namespace sightline::harness::report
