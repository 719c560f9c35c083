// A chapter of the report, written by the file of its experiment. The experiment returns plain structs, and a
// function writes them to the page:
//
//   void jones_timing(Page& page, const JonesViews& jones) {
//     page.paragraph("Times are " + text_of(least(jones.views, &View::view_s), 2) + " s and more.");
//     page.table("jones-views", "Computing time", jones.views,            // id: of the files in tables/
//                {{"scene", "Scene", &View::scene},                       // key, title, value
//                 {"view_s", "View", "s", &View::view_s, 3},              // key, title, unit, value, places
//                 {"rate", "Rate", "1/s", [](const View& v) { return 1 / v.view_s; }, 1},
//                 {"host_us", "View", "us", &View::host_us, 1, host_time}},  // left out without host times
//                {.notes = {"All scenes. " + page.claim(jones.fits(), "All fit.")}, .folded = true});
//     page.claims("jones-paper", "The paper's numbers",                   // claims of papers.json, measured here
//                 {{"jones.core", least_and_greatest(jones.views, &View::words), Real::as_needed, "all runs", "all fit"}});
//     Plot plot{"jones-plot", "Title", "Caption.", "What is seen", {"faces"}, {"time", "s"}};
//     add_curves(plot, jones.views, "legend", &View::faces, &View::view_s, {.line = false});
//     page.plot(std::move(plot));                                         // fewer than three points: left out
//     page.gallery("jones-screens", "The screens", jones.views, [](const View& v) {
//       return figure(v.screen, "screen-" + v.scene, v.scene, "caption", "What is seen"); });
//     if (page.host_times()) page.paragraph("...");
//   }
//
// rows.hpp has where, least and sum; everything of document.hpp can be added as a block. A number in a text is
// written by text_of(value, places). claim(condition, text) is the text; if the condition does not hold, the page says
// so in red. sections.cpp lists experiments and chapters: the parameters of a chapter select the experiments to run.
#pragma once

#include <algorithm>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "host/report/document.hpp"
#include "host/report/papers.hpp"
#include "host/report/plot.hpp"
#include "host/report/rows.hpp"
#include "host/report/table_text.hpp"

namespace sightline::report {

inline constexpr bool host_time = true;

// A value as a cell: text, count, number, yes or no, verdict, or an optional one of these. Numbers, and counts if
// `places` is given, are shown with so many decimals.
template <class T>
[[nodiscard]] Cell as_cell(const T& value, int places = Real::as_needed) {
  if constexpr (std::is_same_v<T, Cell> || std::is_same_v<T, Verdict>) {
    return value;
  } else if constexpr (std::is_same_v<T, bool>) {
    return std::string(value ? "yes" : "no");
  } else if constexpr (std::is_integral_v<T>) {
    if (places == Real::as_needed) return static_cast<std::int64_t>(value);
    return Real{static_cast<double>(value), places};
  } else if constexpr (std::is_floating_point_v<T>) {
    return Real{static_cast<double>(value), places};
  } else if constexpr (std::is_convertible_v<const T&, std::string_view>) {
    return std::string(std::string_view(value));
  } else {
    if (!value) return std::monostate();
    return as_cell(*value, places);
  }
}

// A value as text.
template <class T>
[[nodiscard]] std::string text_of(const T& value, int places = Real::as_needed) {
  return cell_text(as_cell(value, places));
}

// A column of a table of rows: Row -> value.
template <class Row>
struct RowColumn {
  template <std::invocable<const Row&> Value>
  RowColumn(std::string key, std::string title, std::string unit, Value value, int places = Real::as_needed, bool of_host = false)
      : column{std::move(key), std::move(title), std::move(unit)},
        cell([value, places](const Row& row) { return as_cell(std::remove_cvref_t<std::invoke_result_t<Value, const Row&>>(
                                                          std::invoke(value, row)), places); }),
        host(of_host) {}
  template <std::invocable<const Row&> Value>
  RowColumn(std::string key, std::string title, Value value, int places = Real::as_needed, bool of_host = false)
      : RowColumn(std::move(key), std::move(title), std::string(), value, places, of_host) {}

  Column column;
  std::function<Cell(const Row&)> cell;
  bool host;  // left out without host times
};

// Adds a column for each different key of the rows. Rows that are equal in the other columns become one.
template <class Row>
struct Pivot {
  std::function<std::string(const Row&)> key;
  std::function<std::string(const Row&)> title;
  std::string unit;
  std::function<Cell(const Row&)> cell;
};

struct TableParts {
  std::vector<CheckedText> notes = {};
  bool folded = false;
};

// A least and a greatest count or number; empty: not measured.
struct Figures {
  Cell least = {};
  Cell greatest = {};
};
template <class T>
[[nodiscard]] Figures one_figure(const T& value) {
  return {as_cell(value), as_cell(value)};
}
template <class Rows, class Value>
[[nodiscard]] Figures least_and_greatest(const Rows& rows, Value value) {
  const auto range = range_of(rows, value);
  return {as_cell(range.least), as_cell(range.greatest)};
}

// A claim of a paper and its counterpart here.
struct ClaimRow {
  std::string claim;  // "jones.core"
  Figures here = {};
  int places = Real::as_needed;
  std::string condition = {};
  CheckedText comparison = {};
  std::string unit = {};  // empty: the claim's
};

// How curves are drawn, and the label next to each point.
template <class Row>
struct CurveParts {
  std::function<std::string(const Row&)> label = {};
  bool line = true;
  bool marks = true;
};

// Adds a curve for each different name. `name`: a text, or Row -> text. Points without a value are left out.
template <class Rows, class Name, class X, class Y>
void add_curves(Plot& plot, const Rows& rows, const Name& name, X x, Y y,
                const CurveParts<typename RowOf<Rows>::Row>& parts = {}) {
  const std::size_t first = plot.curves.size();
  for (const typename RowOf<Rows>::Row& row : rows) {
    std::string called;
    if constexpr (std::is_convertible_v<const Name&, std::string>) {
      called = name;
    } else {
      called = std::invoke(name, row);
    }
    auto curve = std::find_if(plot.curves.begin() + static_cast<std::ptrdiff_t>(first), plot.curves.end(),
                              [&](const Curve& known) { return known.name == called; });
    if (curve == plot.curves.end()) curve = plot.curves.insert(curve, {std::move(called), {}, parts.line, parts.marks});
    const std::optional<double> at_x = std::invoke(x, row);
    const std::optional<double> at_y = std::invoke(y, row);
    if (at_x && at_y) curve->points.push_back({*at_x, *at_y, parts.label ? parts.label(row) : ""});
  }
}

[[nodiscard]] Figure figure(const Picture& picture, std::string id, std::string title, CheckedText caption, std::string alternative);

class Page {
 public:
  explicit Page(bool host_times, const Papers& papers = Papers::built_in()) : host_times_(host_times), papers_(papers) {}

  [[nodiscard]] bool host_times() const { return host_times_; }
  [[nodiscard]] const Papers& papers() const { return papers_; }
  // The figure of a claim; throws base::Error (bad_input) if it has none.
  [[nodiscard]] Range<double> paper_figure(std::string_view claim) const;

  // The sentence, if it holds. `found`: what was measured instead.
  [[nodiscard]] static CheckedText claim(bool holds, std::string sentence, const std::string& found = {});

  void add(Block block) { blocks_.push_back(std::move(block)); }
  void paragraph(CheckedText text) { add(Paragraph{std::move(text)}); }

  template <class Rows, class Row = typename RowOf<Rows>::Row>
  void table(std::string id, std::string title, const Rows& rows,
             std::type_identity_t<std::vector<RowColumn<Row>>> columns, TableParts parts = {},
             const std::type_identity_t<std::optional<Pivot<Row>>>& pivot = {}) {
    Table table{std::move(id), std::move(title), {}, {}, std::move(parts.notes), parts.folded};
    if (!host_times_) std::erase_if(columns, [](const auto& column) { return column.host; });
    for (const auto& column : columns) table.columns.push_back(column.column);
    for (const Row& row : rows) {
      std::vector<Cell> cells;
      for (const auto& column : columns) cells.push_back(column.cell(row));
      if (pivot) {
        add_to_pivot(table, std::move(cells), {pivot->key(row), pivot->title(row), pivot->unit}, pivot->cell(row));
      } else {
        table.rows.push_back(std::move(cells));
      }
    }
    for (auto& row : table.rows) row.resize(table.columns.size());
    add(std::move(table));
  }

  void claims(std::string id, std::string title, const std::vector<ClaimRow>& rows, TableParts parts = {});

  // A plot with fewer than three different points is left out.
  void plot(Plot plot);
  // The same for a panel.
  void add_plot(Panel& panel, Plot plot);

  template <class Rows, class FigureOf>
  void gallery(std::string id, std::string title, const Rows& rows, FigureOf figure_of, bool folded = false) {
    Gallery gallery{std::move(id), std::move(title), {}, folded};
    for (const typename RowOf<Rows>::Row& row : rows) gallery.figures.push_back(figure_of(row));
    add(std::move(gallery));
  }

  // The words of a claim as a fact of a panel: "The paper (abstract)" or, among other papers, "Jones, 1971
  // (abstract)".
  [[nodiscard]] std::pair<std::string, std::string> paper_says(std::string_view claim) const;
  [[nodiscard]] std::pair<std::string, std::string> paper_says_dated(std::string_view claim) const;

  [[nodiscard]] std::vector<Block> blocks() && { return std::move(blocks_); }

 private:
  static void add_to_pivot(Table& table, std::vector<Cell> common, Column column, Cell cell);
  [[nodiscard]] std::vector<Cell> claim_cells(const ClaimRow& row) const;

  bool host_times_;
  const Papers& papers_;
  std::vector<Block> blocks_;
};

}  // namespace sightline::report
