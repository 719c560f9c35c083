// The one reader of the report's data files.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "host/base/json.hpp"
#include "host/base/text.hpp"
#include "host/report/experiment.hpp"
#include "host/report/layout.hpp"

namespace sightline::report {

namespace {

using base::Json;

[[noreturn]] void refuse(const std::string& place, const std::string& why) {
  throw Failure(ErrorKind::bad_input, fmt::format("{}: {}", place, why));
}

// What cannot be read of an expression or text is an error of the data file.
template <class Work>
auto checked(Work&& work) {
  try {
    return work();
  } catch (const Wrong& wrong) {
    throw Failure(ErrorKind::bad_input, wrong.what());
  }
}

// A value of a file, and where it stands. Reading what is not there throws.
class Node {
 public:
  Node(const Json& json, std::string place) : json_(&json), place_(std::move(place)) {}

  [[nodiscard]] const Json& json() const { return *json_; }
  [[nodiscard]] const std::string& place() const { return place_; }

  // An object with these members at most.
  const Node& object(std::initializer_list<std::string_view> allowed) const {
    for (const auto& [name, value] : members())
      if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
        refuse(place_, fmt::format("found member \"{}\", expected {}", name, base::joined(allowed, ", ")));
    return *this;
  }
  [[nodiscard]] bool has(std::string_view name) const { return json_->find(name) != nullptr; }
  [[nodiscard]] Node at(std::string_view name) const {
    const Json* const value = json_->find(name);
    if (value == nullptr) refuse(place_, fmt::format("found {} without \"{}\"", base::describe(*json_), name));
    return {*value, inside(name)};
  }
  [[nodiscard]] std::vector<std::pair<std::string, Node>> members() const {
    if (!json_->is_object()) wrong("an object");
    std::vector<std::pair<std::string, Node>> nodes;
    for (const auto& [name, value] : json_->members()) nodes.emplace_back(name, Node(value, inside(name)));
    return nodes;
  }
  [[nodiscard]] std::vector<Node> elements() const {
    if (!json_->is_array()) wrong("an array");
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < json_->size(); ++i) nodes.emplace_back((*json_)[i], base::indexed(place_, i));
    return nodes;
  }
  [[nodiscard]] std::vector<Node> elements(std::string_view name) const {
    return has(name) ? at(name).elements() : std::vector<Node>{};
  }

  [[nodiscard]] std::string string() const {
    if (json_->text() == nullptr) wrong("a string");
    return *json_->text();
  }
  [[nodiscard]] double number() const {
    if (!json_->number()) wrong("a number");
    return *json_->number();
  }
  [[nodiscard]] int whole() const {
    if (!json_->integer()) wrong("a whole number");
    return static_cast<int>(*json_->integer());
  }
  [[nodiscard]] std::string string(std::string_view name) const { return at(name).string(); }
  [[nodiscard]] std::string string_or(std::string_view name, std::string other) const {
    return has(name) ? string(name) : std::move(other);
  }
  [[nodiscard]] std::vector<std::string> strings(std::string_view name) const {
    std::vector<std::string> all;
    for (const Node& node : elements(name)) all.push_back(node.string());
    return all;
  }
  [[nodiscard]] bool flag(std::string_view name, bool other = false) const {
    if (!has(name)) return other;
    const Node node = at(name);
    if (!node.json_->boolean()) node.wrong("true or false");
    return *node.json_->boolean();
  }
  [[nodiscard]] int places(std::string_view name) const {
    if (!has(name)) return Real::as_needed;
    const Node node = at(name);
    const int places = node.whole();
    if (places < 0 || places > 9) node.wrong("0 to 9");
    return places;
  }
  [[nodiscard]] Text text() const {
    return checked([this] { return Text(string(), place_); });
  }
  [[nodiscard]] Text text(std::string_view name) const { return at(name).text(); }
  [[nodiscard]] Text text_or_none(std::string_view name) const { return has(name) ? text(name) : Text(); }
  [[nodiscard]] Expression expression(std::string_view name) const {
    const Node node = at(name);
    return checked([&node] { return Expression(node.string(), node.place()); });
  }
  [[nodiscard]] std::optional<Expression> expression_or_none(std::string_view name) const {
    if (!has(name)) return std::nullopt;
    return expression(name);
  }
  // Of a record: words, a count, a number or nothing.
  [[nodiscard]] Value value() const {
    if (json_->is_null()) return {};
    if (json_->text() != nullptr) return *json_->text();
    if (json_->integer()) return *json_->integer();
    return number();
  }

 private:
  [[noreturn]] void wrong(std::string_view expected) const {
    refuse(place_, fmt::format("found {}, expected {}", base::describe(*json_), expected));
  }
  // "file.json: a.b[3]".
  [[nodiscard]] std::string inside(std::string_view name) const {
    return fmt::format("{}{}{}", place_, place_.ends_with(".json") ? ": " : ".", name);
  }
  const Json* json_;
  std::string place_;
};

RowsOf rows_of(const Node& node) {
  return {node.string("from"), node.expression_or_none("where")};
}

std::vector<NoteLayout> notes_of(const Node& node, std::string_view name = "notes") {
  std::vector<NoteLayout> notes;
  for (const Node& note : node.elements(name)) {
    if (note.json().text() != nullptr) {
      notes.push_back({note.text(), false});
    } else {
      note.object({"text", "host"});
      notes.push_back({note.text("text"), note.flag("host")});
    }
  }
  return notes;
}

ColumnLayout column_of(const Node& node) {
  node.object({"key", "title", "unit", "places", "host", "value", "must", "good", "bad"});
  ColumnLayout column;
  column.key = node.string("key");
  column.title = node.string("title");
  column.unit = node.string_or("unit", "");
  column.places = node.places("places");
  column.host_time = node.flag("host");
  column.value = node.expression_or_none("value");
  column.must = node.expression_or_none("must");
  if (column.must) {
    column.good = node.text("good");
    column.bad = node.text("bad");
  }
  return column;
}

TableLayout table_of(const Node& node) {
  node.object({"table", "title", "from", "where", "columns", "pivot", "notes", "folded", "only_with_rows", "host", "cards"});
  TableLayout table;
  table.id = node.string("table");
  table.title = node.text("title");
  table.rows = rows_of(node);
  for (const Node& column : node.elements("columns")) table.columns.push_back(column_of(column));
  if (node.has("pivot")) {
    const Node pivot = node.at("pivot");
    pivot.object({"key", "title", "unit", "value", "places"});
    table.pivot = PivotLayout{pivot.text("key"), pivot.text("title"), pivot.string_or("unit", ""),
                              pivot.expression("value"), pivot.places("places")};
  }
  table.notes = notes_of(node);
  table.folded = node.flag("folded");
  table.only_with_rows = node.flag("only_with_rows");
  if (node.has("cards")) {
    const Node cards = node.at("cards").object({"name", "pictures"});
    table.cards_name = cards.string("name");
    for (const Node& picture : cards.elements("pictures"))
      table.cards.push_back({picture.object({"image", "name"}).string("image"), picture.text("name")});
  }
  return table;
}

ClaimsLayout claims_of(const Node& node) {
  node.object({"claims", "title", "rows", "notes", "folded", "host"});
  ClaimsLayout claims;
  claims.id = node.string("claims");
  claims.title = node.text("title");
  for (const Node& row : node.elements("rows")) {
    row.object({"claim", "here", "least", "greatest", "places", "unit", "host", "condition", "comparison"});
    OldClaimRow claim;
    claim.claim = row.string("claim");
    claim.place = row.place();
    claim.least = row.expression_or_none(row.has("here") ? "here" : "least");
    claim.greatest = row.expression_or_none(row.has("here") ? "here" : "greatest");
    claim.places = row.places("places");
    claim.unit = row.string_or("unit", "");
    claim.host_time = row.flag("host");
    claim.condition = row.text_or_none("condition");
    claim.comparison = row.text("comparison");
    claims.rows.push_back(std::move(claim));
  }
  claims.notes = notes_of(node);
  claims.folded = node.flag("folded");
  return claims;
}

AxisLayout axis_of(const Node& node) {
  node.object({"title", "unit", "linear"});
  return {node.string("title"), node.string_or("unit", ""), !node.flag("linear")};
}

PlotLayout plot_of(const Node& node) {
  node.object({"plot", "title", "caption", "alternative", "x", "y", "curves", "host"});
  PlotLayout plot;
  plot.id = node.string("plot");
  plot.title = node.text("title");
  plot.caption = node.text("caption");
  plot.alternative = node.text("alternative");
  plot.x = axis_of(node.at("x"));
  plot.y = axis_of(node.at("y"));
  for (const Node& curve : node.elements("curves")) {
    curve.object({"from", "where", "by", "x", "y", "label", "line", "marks"});
    plot.curves.push_back({rows_of(curve), curve.text("by"), curve.expression("x"), curve.expression("y"),
                           curve.text_or_none("label"), curve.flag("line", true), curve.flag("marks", true)});
  }
  return plot;
}

GalleryLayout gallery_of(const Node& node) {
  node.object({"gallery", "title", "from", "where", "image", "id", "name", "caption", "alternative", "folded", "host"});
  return {node.string("gallery"), node.text("title"),   rows_of(node),           node.string("image"), node.text("id"),
          node.text("name"),      node.text("caption"), node.text("alternative"), node.flag("folded")};
}

ListingsLayout listings_of(const Node& node) {
  node.object({"listings", "from", "where", "id", "file", "host"});
  return {rows_of(node), node.text("id"), node.text("file"), node.expression("listings")};
}

PanelLayout panel_of(const Node& node) {
  node.object({"panel", "title", "paper", "claim", "also", "facts", "text", "pictures", "host"});
  PanelLayout panel{node.string("panel"), node.text("title"), node.string_or("paper", ""), node.string_or("claim", ""), {}, {},
                    notes_of(node, "text"), {}};
  if (node.has("also")) panel.also = node.strings("also");
  for (const Node& fact : node.elements("facts")) {
    const auto both = fact.elements();
    if (both.size() != 2) refuse(fact.place(), fmt::format("found {} texts, expected a label and a value", both.size()));
    panel.facts.emplace_back(both[0].text(), both[1].text());
  }
  for (const Node& picture : node.elements("pictures")) {
    if (picture.has("plot")) {
      panel.pictures.emplace_back(plot_of(picture));
    } else {
      panel.pictures.emplace_back(gallery_of(picture));
    }
  }
  return panel;
}

BlockLayout block_of(const Node& node) {
  BlockLayout block;
  block.place = node.place();
  block.host_time = node.flag("host");
  if (node.has("paragraph")) {
    block.content = ParagraphLayout{node.object({"paragraph", "host"}).text("paragraph")};
  } else if (node.has("heading")) {
    block.content = HeadingLayout{node.object({"heading", "id", "host"}).text("heading"), node.string("id")};
  } else if (node.has("panel")) {
    block.content = panel_of(node);
  } else if (node.has("table")) {
    block.content = table_of(node);
  } else if (node.has("claims")) {
    block.content = claims_of(node);
  } else if (node.has("plot")) {
    block.content = plot_of(node);
  } else if (node.has("gallery")) {
    block.content = gallery_of(node);
  } else if (node.has("listings")) {
    block.content = listings_of(node);
  } else {
    refuse(node.place(), "expected a paragraph, heading, panel, table, claims, plot, gallery or listings");
  }
  return block;
}

// {"vary": [{"NAME": "text"}...], "block": {...}}: the block for each, in which $NAME stands for the text.
void add_varied(const Node& node, std::vector<BlockLayout>& blocks) {
  node.object({"vary", "block"});
  for (const Node& choice : node.elements("vary")) {
    std::string text = node.at("block").json().dump();
    for (const auto& [name, value] : choice.members()) {
      std::string escaped = value.json().dump();
      escaped = escaped.substr(1, escaped.size() - 2);
      const std::string sign = "$" + name;
      for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + escaped.size()))
        text.replace(at, sign.size(), escaped);
    }
    const auto varied = base::parse_json(text, choice.place());
    if (!varied) refuse(choice.place(), varied.error().message());
    blocks.push_back(block_of(Node(*varied, choice.place())));
  }
}

OldChapter chapter_of(std::string name, const Node& node) {
  node.object({"sets", "blocks"});
  OldChapter chapter;
  chapter.name = std::move(name);
  for (const auto& [set, of] : node.at("sets").members()) {
    chapter.sets[set] = of.string();
    if (of.string().find('.') == std::string::npos)
      refuse(of.place(), fmt::format("found \"{}\", expected EXPERIMENT.SET", of.string()));
  }
  for (const Node& block : node.at("blocks").elements()) {
    if (block.has("vary")) {
      add_varied(block, chapter.blocks);
    } else {
      chapter.blocks.push_back(block_of(block));
    }
  }
  return chapter;
}

// One number, or the least and the greatest.
std::pair<double, double> figure_of(const Node& node) {
  if (!node.json().is_array()) return {node.number(), node.number()};
  const auto both = node.elements();
  if (both.size() != 2) refuse(node.place(), fmt::format("found {} numbers, expected 2", both.size()));
  return {both[0].number(), both[1].number()};
}

void read_paper(const Node& node, Layout& layout) {
  node.object({"id", "authors", "year", "title", "in", "claims", "tables"});
  OldPaper paper{node.string("id"), node.strings("authors"), node.at("year").whole(), node.string("title"), node.string("in"), {}};
  if (node.has("claims")) {
    for (const auto& [name, claim] : node.at("claims").members()) {
      claim.object({"place", "quote", "says", "figure", "unit"});
      paper.claims[name] = {claim.string("place"),
                            claim.has("quote") ? '"' + claim.string("quote") + '"' : claim.string("says"),
                            std::nullopt, claim.string_or("unit", "")};
      if (claim.has("figure")) paper.claims[name].figure = figure_of(claim.at("figure"));
    }
  }
  if (node.has("tables")) {
    for (const auto& [name, table] : node.at("tables").members()) {
      table.object({"place", "keys", "rows"});
      const auto keys = table.strings("keys");
      RowSet& rows = layout.paper_tables[name] = RowSet(keys);
      for (const Node& row : table.elements("rows")) {
        const auto cells = row.elements();
        if (cells.size() != keys.size())
          refuse(row.place(), fmt::format("found {} values, expected {}", cells.size(), keys.size()));
        NamedValues values;
        for (std::size_t i = 0; i < keys.size(); ++i) values.emplace_back(keys[i], cells[i].value());
        rows.add(values);
      }
    }
  }
  layout.papers.push_back(std::move(paper));
}

void read_report(const Node& node, Layout& layout) {
  node.object({"title", "introduction", "without_host_times", "parts", "sections"});
  layout.title = node.string("title");
  layout.introduction = node.strings("introduction");
  layout.without_host_times = node.string_or("without_host_times", "");
  for (const Node& part : node.elements("parts"))
    layout.parts.push_back({part.object({"number", "title"}).at("number").whole(), part.string("title")});
  for (const Node& section : node.elements("sections")) {
    section.object({"id", "title", "paper", "chapters"});
    SectionLayout& read = layout.sections.emplace_back(
        SectionLayout{section.string("id"), section.string("title"), section.string_or("paper", ""), {}});
    for (const Node& chapter : section.elements("chapters")) {
      chapter.object({"chapter", "part"});
      read.chapters.emplace_back(chapter.string("chapter"), chapter.has("part") ? chapter.at("part").whole() : 0);
    }
  }
}

void check_sections(const Layout& layout) {
  for (const SectionLayout& section : layout.sections) {
    const std::string place = fmt::format("report.json: section \"{}\"", section.id);
    if (!section.paper.empty() && layout.paper(section.paper) == nullptr)
      refuse(place, fmt::format("found paper \"{}\", expected one of papers.json", section.paper));
    for (const auto& [chapter, number] : section.chapters) {
      if (!layout.chapters.contains(chapter))
        refuse(place, fmt::format("found chapter \"{}\", expected a file {}.json", chapter, chapter));
      if (number != 0 && layout.part(number) == nullptr)
        refuse(place, fmt::format("chapter \"{}\": found part {}, expected one of \"parts\"", chapter, number));
    }
  }
}

}  // namespace

std::vector<std::string> OldChapter::experiments() const {
  std::set<std::string> names;
  for (const auto& [here, of] : sets) names.insert(of.substr(0, of.find('.')));
  names.erase("papers");
  return {names.begin(), names.end()};
}

std::string OldPaper::citation() const {
  std::string text;
  for (std::size_t i = 0; i < authors.size(); ++i)
    text += (i == 0 ? "" : i + 1 < authors.size() ? ", " : " and ") + authors[i];
  return fmt::format("{}: \u201C{}\u201D, {}{}{}", text, title, published_in, published_in.empty() ? "" : ", ", year);
}

const OldClaim* Layout::claim(std::string_view paper_and_claim) const {
  const std::size_t dot = paper_and_claim.find('.');
  const OldPaper* const of = dot == std::string_view::npos ? nullptr : paper(paper_and_claim.substr(0, dot));
  if (of == nullptr) return nullptr;
  const auto found = of->claims.find(paper_and_claim.substr(dot + 1));
  return found == of->claims.end() ? nullptr : &found->second;
}

const OldPaper* Layout::paper(std::string_view id) const {
  const auto found = std::find_if(papers.begin(), papers.end(), [id](const OldPaper& paper) { return paper.id == id; });
  return found == papers.end() ? nullptr : &*found;
}

const PartLayout* Layout::part(int number) const {
  const auto found = std::find_if(parts.begin(), parts.end(), [number](const PartLayout& part) { return part.number == number; });
  return found == parts.end() ? nullptr : &*found;
}

Layout read_layout(DataFiles files) {
  Layout layout;
  for (const auto& [name, text] : files) {
    const std::string file(name);
    const auto json = base::parse_json(text, name);
    if (!json) throw Failure(ErrorKind::bad_input, json.error().message());
    const Node node(*json, file);
    if (file == "report.json") {
      read_report(node, layout);
    } else if (file == "papers.json") {
      node.object({"papers"});
      for (const Node& paper : node.elements("papers")) read_paper(paper, layout);
    } else {
      const std::string chapter = file.substr(0, file.rfind(".json"));
      layout.chapters[chapter] = chapter_of(chapter, node);
    }
  }
  check_sections(layout);
  return layout;
}

}  // namespace sightline::report
