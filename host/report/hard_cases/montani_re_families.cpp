// Hard cases of priority lists and stripes with a parameter. Every build is tried with value after value,
// from easy to hard, until it fails.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/report/hard_cases/montani_re.hpp"
#include "host/report/montani_re_pixels.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::montani_re;
using scene::PolyPoint;
using scene::PolyScene;

constexpr std::array<std::int32_t, 6> thicknesses{2, 4, 8, 16, 32, 64};  // sixteenths a pixel

PolyScene empty_scene() {
  PolyScene scene;
  scene.camera = {false, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  return scene;
}

void add_sheet(PolyScene& scene, const std::vector<PolyPoint>& corners) {
  scene::PolyFace face;
  for (const PolyPoint& corner : corners) {
    face.outline.push_back(static_cast<scene::VertexIndex>(scene.vertices.size()));
    scene.vertices.push_back(corner);
  }
  scene.bodies.push_back({"", true, {std::move(face)}});
}

// Bars along the sides of a regular polygon of n corners p, rounded to integers, four times as large: bar k
// begins a quarter of a side before p(k), deep, and ends a quarter beyond p(k + 1), near.
PolyScene pinwheel(int n) {
  PolyScene scene = empty_scene();
  const auto corner = [n](int k) {
    const double angle = 2 * std::numbers::pi * k / n;
    return std::array{static_cast<std::int32_t>(std::lround(100 * std::cos(angle))),
                      static_cast<std::int32_t>(std::lround(100 * std::sin(angle)))};
  };
  for (int k = 0; k < n; ++k) {
    const auto p = corner(k);
    const auto q = corner((k + 1) % n);
    const auto at = [&](std::int32_t along, std::int32_t out) {
      return PolyPoint{4 * p[0] + along * (q[0] - p[0]) + out * (p[0] + q[0]),
                       4 * p[1] + along * (q[1] - p[1]) + out * (p[1] + q[1]), -200 * along};
    };
    add_sheet(scene, {at(-1, 0), at(5, 0), at(5, 1), at(-1, 1)});
  }
  return scene;
}

// About 0.4 pixels a unit.
constexpr PixelParts pinwheel_pixels{4, 10, {0, 0}};

using Fault = std::optional<std::string>;

Fault exact_fault(const PolyScene& scene) {
  if (algorithms::exact::visible_edges(scene, scene.camera) ==
      algorithms::oracle::visible_edges(scene, scene.camera))
    return std::nullopt;
  return "not the oracle's lines";
}

Fault lines_fault(const PolyScene& scene) {
  return wrong_lines(scene, algorithms::oracle::visible_edges(scene, scene.camera));
}

Fault cuts_fault(const PolyScene& scene) {
  const auto made = native::faces_of(scene, scene.camera);
  const auto& set = *made;
  const auto seen = native::visible_regions(set);
  if (seen.counts.cuts != 1) return fmt::format("{} cuts", seen.counts.cuts);
  for (const native::TrapezoidPcs& region : seen.regions) {
    if (region.empty()) return "a bar is not seen";
  }
  return lines_fault(scene);
}

using Failure = std::optional<std::pair<int, std::string>>;  // the first n, and what happens

void try_stripes(int n, std::array<Failure, thicknesses.size()>& builds) {
  const PolyScene scene = pinwheel(n);
  const auto made = native::faces_of(scene, scene.camera);
  const auto& set = *made;
  const native::ListedFaces listed = native::listed_faces(set);
  const PixelView view = pixels_along_z(scene, pinwheel_pixels);
  for (std::size_t b = 0; b < thicknesses.size(); ++b) {
    if (builds[b]) continue;
    const auto raster =
        native::raster_by_difference(set.image, listed.list, listed.faces, view.frame, thicknesses[b]);
    const auto metrics = picture::pixel_metrics(view.truth, grid_of(scene, set, raster), view.edges);
    if (metrics.different_inside != 0)
      builds[b] = {n, fmt::format("{} of {} pixels away from edges show another face",
                                  metrics.different_inside, metrics.pixels - metrics.boundary_pixels)};
  }
}

std::vector<Cell> row(std::string_view id, std::string_view parameter, std::string_view input,
                      std::string build) {
  return {std::string(id), std::string(parameter), std::string(input), std::move(build)};
}

std::string stripes_name(std::int32_t units) {
  return fmt::format("stripes of {} {}", 16.0 / units, units < 16 ? "pixels" : "pixel");
}

void add_pinwheels(Table& table, const Context& context) {
  constexpr int least = 3;
  constexpr int most = 12;
  constexpr std::string_view input = "pinwheels of n bars, about 600 pixels wide";
  const auto add = [&](const std::string& build, const Failure& failure) {
    auto cells = row("M2", "bars, n", input, build);
    if (failure) {
      cells.insert(cells.end(), {std::int64_t{failure->first}, Verdict{false, failure->second}});
    } else {
      cells.insert(cells.end(), {Cell(), Verdict{true, fmt::format("none up to {}", most)}});
    }
    table.rows.push_back(std::move(cells));
  };
  constexpr std::array<std::pair<const char*, Fault (*)(const PolyScene&)>, 2> exact_builds{
      {{"exact build", cuts_fault}, {"exact", exact_fault}}};
  for (const auto& [build, fault] : exact_builds) {
    Failure failure;
    for (int n = least; n <= most && !failure; ++n) {
      if (auto wrong = fault(pinwheel(n))) failure = {n, std::move(*wrong)};
    }
    add(build, failure);
  }
  std::array<Failure, thicknesses.size()> builds;
  for (int n = least; n <= most; ++n) {
    context.progress(fmt::format("hard case M2: pinwheel of {} bars", n));
    try_stripes(n, builds);
  }
  for (std::size_t b = 0; b < thicknesses.size(); ++b) add(stripes_name(thicknesses[b]), builds[b]);
}

// A pixel has 4096 units; the triangle is 40 pixels long, its base on a line between stripes of 8.
constexpr std::int32_t sliver_pixel = 4096;
constexpr int highest_sliver = 4;  // 2^4 pixels
constexpr int lowest_sliver = -12;

double height(int exponent) {
  return std::ldexp(1.0, exponent);
}

PolyScene sliver(int exponent) {
  const auto high = static_cast<std::int32_t>(sliver_pixel * height(exponent));
  constexpr std::int32_t length = 40 * sliver_pixel;
  PolyScene scene = empty_scene();
  add_sheet(scene, {{0, 0, 0}, {length, 0, 0}, {length, high, 0}});
  add_sheet(
      scene,
      {{-8, -8, 9}, {length + 8, -8, 9}, {length + 8, 20 * sliver_pixel, 9}, {-8, 20 * sliver_pixel, 9}});
  return scene;
}

Fault sliver_fault(const PolyScene& scene) {
  const auto made = native::faces_of(scene, scene.camera);
  const auto& set = *made;
  const auto seen = native::visible_regions(set);
  const double found = native::area(set.image, seen.regions[0]);
  const double expected = 0.5 * scene.vertices[1][0] * scene.vertices[2][1];
  if (found != expected) return fmt::format("area {} of {}", found, expected);
  return lines_fault(scene);
}

// Of its true area.
double share_in_stripes(int exponent, std::int32_t units) {
  const PolyScene scene = sliver(exponent);
  const auto made = native::faces_of(scene, scene.camera);
  const auto& set = *made;
  constexpr double scale = 1.0 / sliver_pixel;
  const native::StripeFrame frame{{scale, scale}, {8, 8}, 64, 64};
  return square_pixels(native::stripe_pcs(set.image, set.faces[0].pcs, frame, units), units) /
         (20 * height(exponent));
}

void add_slivers(Table& table, const Context& context) {
  context.progress("hard case M9: slivers");
  const auto start = [](std::string build) {
    return row("M9", "height, pixels", "triangle 40 pixels long, its base on a line between stripes",
               std::move(build));
  };
  constexpr std::array<std::pair<const char*, Fault (*)(const PolyScene&)>, 2> exact_builds{
      {{"exact build", sliver_fault}, {"exact", exact_fault}}};
  for (const auto& [build, fault] : exact_builds) {
    auto cells = start(build);
    Fault wrong;
    int exponent = highest_sliver;
    for (; exponent >= lowest_sliver; --exponent) {
      wrong = fault(sliver(exponent));
      if (wrong) break;
    }
    if (wrong) {
      cells.insert(cells.end(), {Real{height(exponent)}, Verdict{false, *wrong}});
    } else {
      cells.insert(cells.end(), {Cell(), Verdict{true, fmt::format("none down to 2^{}", lowest_sliver)}});
    }
    table.rows.push_back(std::move(cells));
  }
  for (const std::int32_t units : thicknesses) {
    auto cells = start(stripes_name(units));
    int failed = highest_sliver;
    while (failed >= lowest_sliver && std::abs(share_in_stripes(failed, units) - 1) < 0.01) --failed;
    int lost = failed;
    while (lost >= lowest_sliver && share_in_stripes(lost, units) > 0) --lost;
    cells.emplace_back(Real{height(failed)});
    cells.emplace_back(
        Verdict{false, fmt::format("there {:.0f} % of its area are drawn, from {} down nothing",
                                   100 * share_in_stripes(failed, units), height(lost))});
    table.rows.push_back(std::move(cells));
  }
}

}  // namespace

Table montani_re_families(const Context& context) {
  Table table;
  table.id = "hard-cases-montani-re-first-failures";
  table.title = "Montani and Re: with a parameter, the first value at which each build fails";
  table.columns = {{"case", "Case", "", false},
                   {"parameter", "Parameter", "", false},
                   {"input", "Input", "", false},
                   {"build", "Build", "", false},
                   {"first_failure", "First failure", "", false},
                   {"what", "What happens", "", false}};
  add_pinwheels(table, context);
  add_slivers(table, context);
  table.notes = {
      "Pinwheels: corners of a regular polygon of radius 100, rounded to integers, each bar along a side, "
      "four times as large, from a quarter before it to a quarter beyond, its near end before the next bar's "
      "far one. The exact build must cut once, show all bars and draw the lines of the oracle; exact must "
      "draw them; stripes fail when a pixel farther than 0.75 pixels from all edges shows another face than "
      "the sight line through its middle meets, with 0.4 pixels a unit.",
      "Slivers: heights are halved from 2^4 to 2^-12 pixels. The exact build must have the whole area and "
      "draw the lines of the oracle; stripes fail when the area in them is not that of the triangle, as "
      "corners are moved to the nearest line between stripes. What is lower than half a stripe is lost, and "
      "nothing is drawn in its place but what lies behind."};
  return table;
}

}  // namespace sightline::harness::report
