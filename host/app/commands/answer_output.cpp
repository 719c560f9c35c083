#include "host/app/commands/answer_output.hpp"

#include <fmt/core.h>

#include <optional>
#include <string_view>

#include "host/base/number.hpp"
#include "host/base/terminal.hpp"
#include "host/base/text_table.hpp"
#include "host/compare/papers.hpp"

namespace sightline::app {
namespace {

using base::Json;
using compare::AnswerRow;
using compare::Spread;

// The value of one view, or the median and the greatest value of several.
template <class Text>
std::string spread_text(const std::optional<Spread>& spread, std::size_t views, Text&& text) {
  if (!spread) return "";
  return views == 1 ? text(spread->greatest) : fmt::format("{} ({})", text(spread->median), text(spread->greatest));
}

std::string wrong_text(const AnswerRow& row) {
  if (row.exact && row.right == row.views) return "0, exact";
  if (row.views > 1)
    return spread_text(row.wrong_percent, row.views, [](double percent) { return fmt::format("{:.3g} %", percent); });
  return fmt::format("{:.4g} {}, {:.3g} %", row.wrong.greatest, row.unit, row.wrong_percent.greatest);
}

std::string read_text(const AnswerRow& row) {
  const std::string read = spread_text(row.read, row.views, [](double count) { return fmt::format("{:.0f}", count); });
  if (read.empty()) return "";
  return row.of_all ? fmt::format("{} of {} {}", read, *row.of_all, row.what) : fmt::format("{} {}", read, row.what);
}

Json spread_json(const Spread& spread) {
  return {{"median", spread.median}, {"greatest", spread.greatest}};
}

}  // namespace

AnswerCells answer_cells(const AnswerRow& row) {
  return {row.rounding == compare::not_rounded ? std::string() : row.rounding,
          spread_text(row.emulated_seconds, row.views, base::time_text),
          spread_text(row.host_seconds, row.views, base::time_text),
          wrong_text(row),
          spread_text(row.greatest, row.views, [](double points) { return fmt::format("{:.2f}", points); }),
          row.views > 1 ? fmt::format("{} of {}", row.right, row.views) : fmt::format("{:.4g}", row.far.greatest),
          row.chord ? fmt::format("{:.2f}", *row.chord) : std::string(),
          read_text(row),
          compare::paper_figure(row.method, row.picture)};
}

std::string answer_text(const std::vector<AnswerRow>& rows) {
  bool several = false;
  bool host = false;
  bool chord = false;
  for (const AnswerRow& row : rows) {
    several = several || row.scene != rows.front().scene;
    host = host || row.host_seconds.has_value();
    chord = chord || row.chord.has_value();
  }
  const bool many = !rows.empty() && rows.front().views > 1;
  // Columns begin with two blanks to keep a distance from a long cell before them. Columns for times of this computer and for chord
  // errors are only in tables that have them.
  base::TextTable table({-20, -10, -11, many ? 21 : 12, host ? (many ? 21 : 12) : 0, many ? 21 : 20, many ? 15 : 10, many ? 13 : 9,
                         chord ? 8 : 0, -24, 0});
  std::string said;
  const auto line = [&](std::string_view method, std::string_view picture, const AnswerCells& cells) {
    const auto apart = [](std::string_view cell) { return cell.empty() ? std::string() : "  " + std::string(cell); };
    table.row({method, apart(picture), apart(cells.rounding), apart(cells.emulated), apart(cells.host), apart(cells.wrong), apart(cells.greatest),
               apart(cells.far), apart(cells.chord), apart(cells.read), apart(cells.paper)});
  };
  line("", "", {"rounded to", "emulated", host ? "here" : "", "different", "farthest", many ? "none wrong" : "wrong", chord ? "chord" : "", "read", "the paper says"});
  for (const AnswerRow& row : rows) {
    if (several && row.scene != said) table.line(said = row.scene);
    line(row.method, row.picture, answer_cells(row));
    if (!row.defect.empty()) table.line(fmt::format("    {}: {}", row.method, row.defect));
  }
  constexpr std::size_t picture = 1, rounding = 2, here = 4, farthest = 6, chords = 8, read = 9, paper = 10;
  return table.text_within(base::stdout_columns(), {paper, read, chords, rounding, farthest, picture, here});
}

base::Json answer_json(const std::vector<AnswerRow>& rows) {
  Json list = Json::array();
  for (const AnswerRow& row : rows) {
    Json object{{"scene", row.scene},   {"method", row.method}, {"picture", row.picture}, {"rounding", row.rounding},
                {"views", row.views},   {"right", row.right},   {"unit", row.unit},       {"wrong", spread_json(row.wrong)},
                {"wrong_percent", spread_json(row.wrong_percent)}, {"far", spread_json(row.far)}};
    if (row.greatest) object["greatest"] = spread_json(*row.greatest);
    if (row.emulated_seconds) object["emulated_s"] = spread_json(*row.emulated_seconds);
    if (row.host_seconds) object["host_s"] = spread_json(*row.host_seconds);
    if (row.read) object["read"] = spread_json(*row.read);
    if (row.of_all) object["of_all"] = *row.of_all;
    if (row.read) object["what"] = row.what;
    if (row.chord) object["chord"] = *row.chord;
    object["exact"] = row.exact;
    if (!row.defect.empty()) object["defect"] = row.defect;
    if (row.views > 1) object["worst_view"] = row.worst_view;
    if (const std::string paper = compare::paper_figure(row.method, row.picture); !paper.empty()) object["paper"] = paper;
    list.push_back(std::move(object));
  }
  return list;
}

}  // namespace sightline::app
