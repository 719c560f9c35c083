#include "host/app/commands/sweep_table.hpp"

#include <fmt/core.h>

#include <optional>
#include <vector>

#include "host/app/commands/answer_output.hpp"
#include "host/base/number.hpp"
#include "host/base/terminal.hpp"
#include "host/base/text_table.hpp"

namespace sightline::app {
namespace {

using compare::AnswerRow;
using compare::Spread;

std::string percent_text(double percent) {
  return fmt::format("{:.3g} %", percent);
}

// The median, the 90 % quantile and the greatest value as three cells; empty cells if not measured.
std::vector<std::string> quantiles(const std::optional<Spread>& spread, std::string (*text)(double)) {
  if (!spread) return {"", "", ""};
  return {text(spread->median), text(spread->ninety), text(spread->greatest)};
}

// The method's name for --methods. Rows of devices append the name of the device to it.
std::string_view method_of(const AnswerRow& row) {
  return std::string_view(row.method).substr(0, row.method.find(' '));
}

bool has_worst_view(const AnswerRow& row) {
  return row.right < row.views || (!row.exact && row.wrong.greatest > 0);
}

}  // namespace

std::string sweep_text(const compare::SweepTable& sweep, const ViewCommand& command) {
  const std::vector<AnswerRow> rows = sweep.rows();
  bool emulated = false;
  bool host = false;
  for (const AnswerRow& row : rows) {
    emulated = emulated || row.emulated_seconds.has_value();
    host = host || row.host_seconds.has_value();
  }
  std::vector<int> widths{-20, -10, 7, 8, 19, 13, 13};
  for (int times = (emulated ? 1 : 0) + (host ? 1 : 0); times > 0; --times) widths.insert(widths.end(), {18, 12, 12});
  widths.push_back(12);
  base::TextTable table(widths);
  std::vector<std::string> cells{"", "", "views", "right", "different: median", "90 %", "greatest"};
  const auto add = [&cells](const std::vector<std::string>& more) { cells.insert(cells.end(), more.begin(), more.end()); };
  if (emulated) add({"emulated: median", "90 %", "greatest"});
  if (host) add({"here: median", "90 %", "greatest"});
  add({"worst view"});
  table.row(cells);
  for (const AnswerRow& row : rows) {
    cells = {row.method, row.picture, std::to_string(row.views), std::to_string(row.right)};
    if (row.exact && row.right == row.views)
      add({"0, exact", "", ""});
    else
      add(quantiles(row.wrong_percent, percent_text));
    if (emulated) add(quantiles(row.emulated_seconds, base::time_text));
    if (host) add(quantiles(row.host_seconds, base::time_text));
    add({has_worst_view(row) ? std::to_string(row.worst_view) : ""});
    table.row(cells);
    if (!row.defect.empty()) table.line(fmt::format("    {}: {}", row.method, row.defect));
  }
  for (const compare::SweepTable::LeftOut& left : sweep.left_out())
    table.line(fmt::format("{} left out of {} views: {}", left.method.empty() ? std::string_view("all methods") : left.method, left.views,
                           left.reason));
  table.line("different: lines that are missing, and extra ones that should not be there, in per cent of what is visible; right: none of it more than a point away");
  bool first = true;
  for (const AnswerRow& row : rows) {
    if (!has_worst_view(row)) continue;
    if (std::exchange(first, false)) table.line("worst views:");
    table.line(fmt::format("  {}", command(method_of(row), row.worst_view)));
  }
  // The columns that a narrow terminal omits, in this order: for times the 90 % quantile, then the greatest; the 90 % quantile of the
  // difference; the picture.
  std::vector<std::size_t> least;
  for (const std::size_t of_times : {std::size_t{8}, std::size_t{9}})
    for (std::size_t column = of_times; column + 1 < widths.size(); column += 3) least.push_back(column);
  least.insert(least.end(), {5, 1, 2});
  return table.text_within(base::stdout_columns(), least);
}

}  // namespace sightline::app
