#include "host/report/papers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "host/base/json_reader.hpp"
#include "host/base/nearest_name.hpp"
#include "host/compare/papers.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

namespace {

using base::Json;

constexpr std::string_view file = "papers.json";

[[noreturn]] void refuse(const std::string& why) {
  throw base::bad_input(fmt::format("{}: {}", file, why));
}

[[noreturn]] void not_found(std::string_view kind, std::string_view name, const std::vector<std::string>& names) {
  const std::string meant = base::did_you_mean(name, names);
  refuse(fmt::format("found no {} \"{}\"{}{}", kind, name, meant.empty() ? "" : "; ", meant));
}

// Reads members; the reader keeps the first error and its place.
class PaperReader {
 public:
  explicit PaperReader(base::JsonReader& reader) : reader_(reader) {}

  Paper paper(const Json& json, const std::string& place) {
    Paper paper{text(json, "id", place), {}, 0, text(json, "title", place), text(json, "in", place), {}};
    if (const Json* const authors = reader_.field(json, "authors", place))
      reader_.each(*authors, place + ".authors", [&](const Json& author, const std::string& at) {
        paper.authors.push_back(text(author, at));
      });
    if (const Json* const year = reader_.field(json, "year", place))
      paper.year = static_cast<int>(reader_.integer(*year, place + ".year", 1900, 2000));
    if (const Json* const claims = reader_.optional_field(json, "claims", place))
      for (const auto& [name, claim] : claims->members())
        paper.claims[name] = claim_of(claim, fmt::format("{}.claims.{}", place, name));
    return paper;
  }

  PrintedTable table(const Json& json, const std::string& place) {
    PrintedTable table;
    if (const Json* const keys = reader_.field(json, "keys", place))
      reader_.each(*keys, place + ".keys", [&](const Json& key, const std::string& at) { table.keys.push_back(text(key, at)); });
    if (const Json* const rows = reader_.field(json, "rows", place))
      reader_.each(*rows, place + ".rows", [&](const Json& row, const std::string& at) {
        if (!reader_.array(row, at, table.keys.size())) return;
        std::vector<Cell>& cells = table.rows.emplace_back();
        for (const Json& cell : row.elements()) cells.push_back(cell_of(cell));
      });
    return table;
  }

 private:
  std::string text(const Json& json, const std::string& place) {
    if (json.text() != nullptr) return *json.text();
    reader_.expected("a string", json, place);
    return {};
  }
  std::string text(const Json& json, const char* name, const std::string& place) {
    const Json* const value = reader_.field(json, name, place);
    return value == nullptr ? std::string() : text(*value, fmt::format("{}.{}", place, name));
  }
  std::string text_or_none(const Json& json, const char* name, const std::string& place) {
    return json.find(name) == nullptr ? std::string() : text(json, name, place);
  }

  double number(const Json& json, const std::string& place) {
    if (!json.number()) reader_.expected("a number", json, place);
    return json.number().value_or(0);
  }

  PaperClaim claim_of(const Json& json, const std::string& place) {
    PaperClaim claim{text(json, "place", place), {}, false, {}, text_or_none(json, "unit", place)};
    claim.says = json.find("quote") == nullptr ? text(json, "says", place) : '"' + text(json, "quote", place) + '"';
    const Json* const figure = json.find("figure");
    if (figure == nullptr) return claim;
    // One number, or the least and the greatest.
    claim.has_figure = true;
    if (!figure->is_array()) {
      claim.figure.least = claim.figure.greatest = number(*figure, place + ".figure");
    } else if (reader_.array(*figure, place + ".figure", 2)) {
      claim.figure = {number((*figure)[0], place + ".figure"), number((*figure)[1], place + ".figure")};
    }
    return claim;
  }

  static Cell cell_of(const Json& json) {
    if (json.text() != nullptr) return *json.text();
    if (json.integer()) return *json.integer();
    if (json.number()) return Real{*json.number()};
    return {};
  }

  base::JsonReader& reader_;
};

}  // namespace

std::string Paper::citation() const {
  std::string text;
  for (std::size_t i = 0; i < authors.size(); ++i)
    text += (i == 0 ? "" : i + 1 < authors.size() ? ", " : " and ") + authors[i];
  return fmt::format("{}: \u201C{}\u201D, {}{}{}", text, title, published_in, published_in.empty() ? "" : ", ", year);
}

const Cell& PrintedTable::cell(std::size_t row, std::string_view key) const {
  const auto found = std::find(keys.begin(), keys.end(), key);
  if (found == keys.end()) not_found("column", key, keys);
  return rows.at(row)[static_cast<std::size_t>(found - keys.begin())];
}

double PrintedTable::number(std::size_t row, std::string_view key) const {
  const Cell& found = cell(row, key);
  if (const auto* const whole = std::get_if<std::int64_t>(&found)) return static_cast<double>(*whole);
  if (const auto* const real = std::get_if<Real>(&found)) return real->value;
  refuse(fmt::format("column {}, row {}: expected a number", key, row + 1));
}

const std::string& PrintedTable::text(std::size_t row, std::string_view key) const {
  const auto* const words = std::get_if<std::string>(&cell(row, key));
  if (words == nullptr) refuse(fmt::format("column {}, row {}: expected a string", key, row + 1));
  return *words;
}

Papers::Papers(std::string_view json) {
  const auto document = base::parse_json(json, file);
  if (!document) throw base::bad_input(document.error().message());
  base::JsonReader reader{std::string(file)};
  PaperReader papers(reader);
  if (const Json* const all = reader.field(*document, "papers", ""))
    reader.each(*all, "papers", [&](const Json& paper, const std::string& place) {
      papers_.push_back(papers.paper(paper, place));
      if (const Json* const tables = reader.optional_field(paper, "tables", place))
        for (const auto& [name, table] : tables->members())
          tables_[name] = papers.table(table, fmt::format("{}.tables.{}", place, name));
    });
  if (reader.failed()) throw base::bad_input(reader.error().message());
}

const Papers& Papers::built_in() {
  static const Papers papers(compare::papers_file().front().second);
  return papers;
}

const Paper& Papers::paper(std::string_view id) const {
  const auto found = std::find_if(papers_.begin(), papers_.end(), [id](const Paper& paper) { return paper.id == id; });
  if (found != papers_.end()) return *found;
  std::vector<std::string> names;
  for (const Paper& paper : papers_) names.push_back(paper.id);
  not_found("paper", id, names);
}

const PaperClaim& Papers::claim(std::string_view name) const {
  const Paper& of = paper(name.substr(0, name.find('.')));
  const std::string_view behind = name.substr(std::min(name.find('.') + 1, name.size()));
  const auto found = of.claims.find(behind);
  if (found != of.claims.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, claim] : of.claims) names.push_back(known);
  not_found("claim of " + of.id, behind, names);
}

const PrintedTable& Papers::table(std::string_view name) const {
  const auto found = tables_.find(name);
  if (found != tables_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, table] : tables_) names.push_back(known);
  not_found("table", name, names);
}

}  // namespace sightline::report
