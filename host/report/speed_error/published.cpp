// Published: the suite's specification of Jones's algorithm, section 5, per cent of the visible length.
#include "host/report/speed_error/published.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

namespace sightline::harness::report {

namespace {

constexpr std::size_t builds = 6;  // round f = 0..3, cut off f = 0 and 2
struct Published {
  std::string_view scene;
  std::array<double, builds> per_cent;
};
constexpr std::array<Published, 4> published{{{"house", {0.23, 0.11, 0.05, 0.03, 0.41, 0.11}},
                                              {"roberts", {0.68, 0.31, 0.17, 0.08, 1.27, 0.32}},
                                              {"street4", {0.67, 0.35, 0.18, 0.09, 1.34, 0.33}},
                                              {"corridor8", {0.89, 0.76, 0.06, 0.03, 0.53, 0.11}}}};
constexpr int places = 3;

Table error_table(const guests::jones::ErrorTable& measured) {
  Table table;
  table.id = "jones-error-table";
  table.title = "Jones: wrong length in per cent of the visible, six views a scene";
  table.columns = {{"scene", "Scene", "", false}, {"measured", "Measured", "", false}};
  for (const guests::jones::Precision& column : measured.columns)
    table.columns.push_back(
        {fmt::format("{}_f{}", column.truncate ? "cut" : "round", column.fraction_bits),
         fmt::format("{} f={}", column.truncate ? "cut off," : "rounded,", column.fraction_bits), "%",
         false});
  for (const guests::jones::ErrorTableRow& row : measured.rows) {
    for (const Published& before : published) {
      if (before.scene != row.scene) continue;
      auto& cells = table.rows.emplace_back();
      cells = {row.scene, std::string("first, in a prototype")};
      for (const double value : before.per_cent) cells.emplace_back(Real{value, 2});
    }
    auto& clipped = table.rows.emplace_back();
    clipped = {row.scene, std::string("here, on the PDP-7, after the clip")};
    for (const guests::jones::Measured& cell : row.cells)
      clipped.emplace_back(Real{100 * cell.clipped.share(), places});
    auto& shown = table.rows.emplace_back();
    shown = {row.scene, std::string("here, between the points of the display")};
    for (const guests::jones::Measured& cell : row.cells)
      shown.emplace_back(Real{100 * cell.displayed.value().share(), places});
  }
  table.notes = {
      "The prototype crossed openings from either side and bounded no line in space; the program on the "
      "machine does neither, and so the two open scenes, roberts and street4, come out better. On the "
      "display, between whole points, fraction bits can no longer be seen but where they decide what is "
      "hidden."};
  return table;
}

std::string place_of(const geometry::Point& p) {
  return fmt::format("({}, {}, {})", p[0], p[1], p[2]);
}

Table named_table(const guests::jones::ErrorTable& measured) {
  Table table;
  table.id = "jones-named-pieces";
  table.title =
      fmt::format("Jones: every piece wrong by more than {} pixels", guests::jones::named_from_points);
  table.columns = {{"scene", "Scene", "", false},
                   {"arithmetic", "Arithmetic", "", false},
                   {"eye", "Eye", "", false},
                   {"wrong", "Wrong", "", false},
                   {"length_px", "Length", "pixels", false},
                   {"from", "On the line from", "", false},
                   {"to", "to", "", false}};
  std::size_t pieces = 0;
  for (const guests::jones::ErrorTableRow& row : measured.rows) {
    for (const guests::jones::Measured& cell : row.cells) {
      pieces += cell.clipped.named.size();
      for (const guests::jones::NamedStretch& named : cell.clipped.named)
        table.rows.push_back({row.scene, name(cell.precision), place_of(row.eyes.at(named.view)),
                              std::string(named.stretch.extra ? "drawn, not visible" : "visible, not drawn"),
                              Real{named.stretch.length, 1}, place_of(named.stretch.line.from),
                              place_of(named.stretch.line.to)});
    }
  }
  table.notes = {
      pieces == 0
          ? "There is none."
          : "A line of a farther wall is hidden by a fraction of a pixel; rounded, it lies on the edge of "
            "the mask, which is closed, and is drawn. It falls on a line that is visible, so the picture "
            "looks right: the length is wrong, not the place."};
  return table;
}

}  // namespace

std::vector<Block> published_error_blocks(const guests::jones::ErrorTable& table) {
  return {error_table(table), named_table(table)};
}

}  // namespace sightline::harness::report
