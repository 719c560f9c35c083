#include "host/report/table_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/base/json.hpp"

namespace sightline::report {

namespace {

using base::Json;

template <class... Functions>
struct Choice : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Choice(Functions...) -> Choice<Functions...>;

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string csv_field(const Cell& cell) {
  return std::visit(Choice{[](std::monostate) { return std::string(); },
                           [](const std::string& text) { return csv_field(text); },
                           [](std::int64_t count) { return fmt::format("{}", count); },
                           [](const Real& real) {
                             return std::isfinite(real.value) ? fmt::format("{}", real.value) : std::string();
                           },
                           [](const Verdict& verdict) { return csv_field(verdict.text); }},
                    cell);
}

Json json_value(const Cell& cell) {
  return std::visit(Choice{[](std::monostate) { return Json(); }, [](const std::string& text) { return Json(text); },
                           [](std::int64_t count) { return Json(count); },
                           [](const Real& real) { return Json(real.value); },
                           [](const Verdict& verdict) {
                             return Json{{"good", verdict.good}, {"text", verdict.text}};
                           }},
                    cell);
}

// Formats 1048576.5 as 1 048 576.5, with narrow no-break spaces.
std::string group_digits(std::string digits) {
  const std::size_t first = digits.front() == '-' ? 1 : 0;
  const std::size_t end = std::min(digits.find('.'), digits.size());
  if (end - first < 5) return digits;
  for (std::size_t at = end - 3; at > first; at -= at - first > 3 ? 3 : at - first)
    digits.insert(at, "\u202f");
  return digits;
}

std::string number_text(const Real& real) {
  if (std::isnan(real.value)) return "not a number";
  if (std::isinf(real.value)) return real.value > 0 ? "infinite" : "-infinite";
  return real.places == Real::as_needed ? fmt::format("{:.4g}", real.value)
                                        : group_digits(fmt::format("{:.{}f}", real.value, real.places));
}

// Appends the statements that were left out.
std::string with_failures(const CheckedText& said) {
  std::string text = said.text;
  for (const std::string& failed : said.failed) text += (text.empty() ? "Not in this run: " : " Not in this run: ") + failed;
  return text;
}

}  // namespace

std::string csv_text(const Table& table) {
  std::string text;
  const char* separator = "";
  for (const Column& column : table.columns) {
    text += separator + csv_field(column.key);
    separator = ",";
  }
  text += "\r\n";
  for (const auto& row : table.rows) {
    separator = "";
    for (const Cell& cell : row) {
      text += separator + csv_field(cell);
      separator = ",";
    }
    text += "\r\n";
  }
  return text;
}

std::string json_text(const Table& table) {
  Json document{{"schema", "sightline/table/1"}, {"id", table.id}, {"title", table.title}};
  document["columns"] = Json::array();
  for (const Column& column : table.columns)
    document["columns"].push_back({{"key", column.key}, {"title", column.title}, {"unit", column.unit}});
  document["rows"] = Json::array();
  for (const auto& row : table.rows) {
    Json values = Json::object();
    for (std::size_t i = 0; i < row.size() && i < table.columns.size(); ++i)
      values[table.columns[i].key] = json_value(row[i]);
    document["rows"].push_back(std::move(values));
  }
  document["notes"] = Json::array();
  for (const CheckedText& note : table.notes) document["notes"].push_back(with_failures(note));
  return document.dump(2) + "\n";
}

std::string cell_text(const Cell& cell) {
  return std::visit(Choice{[](std::monostate) { return std::string("\u2013"); },
                           [](const std::string& text) { return text; },
                           [](std::int64_t count) { return group_digits(fmt::format("{}", count)); },
                           [](const Real& real) { return number_text(real); },
                           [](const Verdict& verdict) { return verdict.text; }},
                    cell);
}

}  // namespace sightline::report
