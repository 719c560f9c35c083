#include "host/report/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "host/base/text.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

namespace {

bool worth_drawing(const Plot& plot) {
  constexpr std::size_t fewest_points = 3;
  std::set<std::pair<double, double>> points;
  for (const Curve& curve : plot.curves)
    for (const PlotPoint& point : curve.points)
      if (plot.x.shows(point.x) && plot.y.shows(point.y)) points.emplace(point.x, point.y);
  return points.size() >= fewest_points;
}

Figure drawn_figure(const Plot& plot) {
  auto figure = draw_plot(plot);
  if (!figure) throw std::move(figure.error());
  return *std::move(figure);
}

// Numbers with `places` decimals; counts, too, if `places` is given.
Cell with_places(const Cell& cell, int places) {
  if (places == Real::as_needed) return cell;
  if (const auto* const count = std::get_if<std::int64_t>(&cell)) return Real{static_cast<double>(*count), places};
  if (const auto* const real = std::get_if<Real>(&cell)) return Real{real->value, places};
  return cell;
}

// Empty if one of them is missing.
Cell ratio_of(const Cell& here, double figure) {
  if (figure == 0) return {};
  if (const auto* const count = std::get_if<std::int64_t>(&here)) return Real{static_cast<double>(*count) / figure};
  if (const auto* const real = std::get_if<Real>(&here)) return Real{real->value / figure};
  return {};
}

}  // namespace

Figure figure(const Picture& picture, std::string id, std::string title, CheckedText caption, std::string alternative) {
  return {std::move(id), std::move(title), std::move(caption), std::move(alternative), picture.media_type, picture.bytes,
          picture.pixelated};
}

Range<double> Page::paper_figure(std::string_view claim) const {
  const PaperClaim& of = papers_.claim(claim);
  if (!of.has_figure) throw base::bad_input(fmt::format("papers.json: claim {}: found no figure", claim));
  return of.figure;
}

CheckedText Page::claim(bool holds, std::string sentence, const std::string& found) {
  if (holds) return {std::move(sentence)};
  return {"", {fmt::format("\"{}\"{}{}", sentence, found.empty() ? "" : "; here ", found)}};
}

void Page::add_to_pivot(Table& table, std::vector<Cell> common, Column column, Cell cell) {
  auto at = std::find_if(table.columns.begin(), table.columns.end(),
                         [&](const Column& known) { return known.key == column.key; });
  if (at == table.columns.end()) at = table.columns.insert(at, std::move(column));
  auto row = std::find_if(table.rows.begin(), table.rows.end(), [&](const auto& known) {
    return std::equal(common.begin(), common.end(), known.begin());
  });
  if (row == table.rows.end()) row = table.rows.insert(row, std::move(common));
  row->resize(std::max(row->size(), table.columns.size()));
  (*row)[static_cast<std::size_t>(at - table.columns.begin())] = std::move(cell);
}

void Page::claims(std::string id, std::string title, const std::vector<ClaimRow>& rows, TableParts parts) {
  Table table{std::move(id), std::move(title), {}, {}, std::move(parts.notes), parts.folded};
  table.columns = {{"place", "In the paper", ""},       {"says", "It says", ""},
                   {"here_least", "Here", "least"},     {"here_greatest", "Here", "greatest"},
                   {"unit", "Unit", ""},                {"ratio_least", "Here to paper", "ratio, least"},
                   {"ratio_greatest", "Here to paper", "ratio, greatest"},
                   {"condition", "Condition here", ""}, {"comparison", "Comparison", ""}};
  for (const ClaimRow& row : rows) table.rows.push_back(claim_cells(row));
  add(std::move(table));
}

std::vector<Cell> Page::claim_cells(const ClaimRow& row) const {
  const PaperClaim& claim = papers_.claim(row.claim);
  const Range<double> figure = claim.has_figure ? claim.figure : Range<double>();
  Cell compared = row.comparison.text;
  if (!row.comparison.failed.empty())
    compared = Verdict{false, fmt::format("{}{}not in this run: {}", row.comparison.text, row.comparison.text.empty() ? "" : "; ",
                                          base::joined(row.comparison.failed, "; "))};
  return {claim.place, claim.says, with_places(row.here.least, row.places), with_places(row.here.greatest, row.places),
          row.unit.empty() ? claim.unit : row.unit, ratio_of(row.here.least, figure.greatest),
          ratio_of(row.here.greatest, figure.least), row.condition, compared};
}

void Page::plot(Plot plot) {
  if (worth_drawing(plot)) add(drawn_figure(plot));
}

void Page::add_plot(Panel& panel, Plot plot) {
  if (!worth_drawing(plot)) return;
  plot.width = 520;
  plot.height = 360;
  panel.figures.push_back(drawn_figure(plot));
}

std::pair<std::string, std::string> Page::paper_says(std::string_view claim) const {
  const PaperClaim& of = papers_.claim(claim);
  return {fmt::format("The paper ({})", of.place), of.says};
}

std::pair<std::string, std::string> Page::paper_says_dated(std::string_view claim) const {
  const PaperClaim& of = papers_.claim(claim);
  const Paper& paper = papers_.paper(claim.substr(0, claim.find('.')));
  const std::string& author = paper.authors.front();
  return {fmt::format("{}{}, {} ({})", author.substr(author.rfind(' ') + 1), paper.authors.size() > 1 ? " and others" : "",
                      paper.year, of.place),
          of.says};
}

}  // namespace sightline::report
