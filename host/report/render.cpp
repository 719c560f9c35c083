#include "host/report/render.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "host/base/text.hpp"
#include "host/report/experiment.hpp"
#include "host/report/table_text.hpp"

namespace sightline::report {

namespace {

const RowSet* find_set(const Layout& layout, const OldResults& results, std::string_view of) {
  const std::size_t dot = of.find('.');
  const std::string_view experiment = of.substr(0, dot);
  const Records* records = nullptr;
  if (experiment == "papers") {
    records = &layout.paper_tables;
  } else if (const auto found = results.find(experiment); found != results.end()) {
    records = &found->second;
  }
  if (records == nullptr) return nullptr;
  const auto found = records->find(of.substr(dot + 1));
  return found == records->end() ? nullptr : &found->second;
}

class Renderer {
 public:
  Renderer(const OldChapter& chapter, const Layout& layout, const OldResults& results, const Rendering& rendering)
      : chapter_(chapter), layout_(layout), results_(results), rendering_(rendering) {
    page_.set_named = [this](std::string_view name) { return set_named(name); };
  }

  std::vector<Block> blocks() && {
    for (const BlockLayout& block : chapter_.blocks) {
      if (block.host_time && !rendering_.host_times) continue;
      place_ = block.place;
      std::visit([this](const auto& content) { add(content); }, block.content);
    }
    return std::move(blocks_);
  }

  [[nodiscard]] const std::string& place() const { return place_; }

 private:
  [[nodiscard]] const RowSet* set_named(std::string_view name) const {
    const auto found = chapter_.sets.find(name);
    if (found == chapter_.sets.end()) return nullptr;
    const RowSet* const set = find_set(layout_, results_, found->second);
    if (set == nullptr) throw Wrong(fmt::format("{}.json: sets.{}: found no records \"{}\"", chapter_.name, name, found->second));
    return set;
  }

  [[nodiscard]] const RowSet& set_of(const RowsOf& rows) const {
    const RowSet* const set = set_named(rows.set);
    if (set == nullptr) throw Wrong(fmt::format("{}: found no set \"{}\" among those of the chapter", place_, rows.set));
    return *set;
  }

  [[nodiscard]] Scope scope_of(const RowSet& set, std::size_t row) const {
    return {&set, row, nullptr, page_.set_named, page_.values};
  }

  // The scopes of the rows.
  [[nodiscard]] std::vector<Scope> scopes_of(const RowsOf& rows) const {
    const RowSet& set = set_of(rows);
    std::vector<Scope> scopes;
    for (std::size_t row = 0; row < set.size(); ++row) {
      Scope scope = scope_of(set, row);
      if (!rows.where || rows.where->holds(scope)) scopes.push_back(std::move(scope));
    }
    return scopes;
  }

  [[nodiscard]] const OldClaim& claim_named(const std::string& name, const std::string& place) const {
    const OldClaim* const claim = layout_.claim(name);
    if (claim == nullptr) throw Wrong(fmt::format("{}: found no claim \"{}\" in papers.json", place, name));
    return *claim;
  }

  // "Jones, 1971 (performance)"
  [[nodiscard]] std::string dated(const std::string& name) const {
    const OldPaper& paper = *layout_.paper(name.substr(0, name.find('.')));
    const std::string& author = paper.authors.front();
    const std::size_t last = author.rfind(' ') + 1;
    return fmt::format("{}{}, {} ({})", author.substr(last), paper.authors.size() > 1 ? " and others" : "", paper.year,
                       claim_named(name, place_).place);
  }

  // Texts of a panel may speak of the claim's figure.
  void add(const PanelLayout& layout) {
    const Scope page = page_;
    Panel panel{layout.id, {}, {}, {}, {}, {}};
    if (!layout.paper.empty()) {
      const OldPaper* const paper = layout_.paper(layout.paper);
      if (paper == nullptr) throw Wrong(fmt::format("{}: found no paper \"{}\" in papers.json", place_, layout.paper));
      panel.source = paper->citation();
    }
    const OldClaim* const claim = layout.claim.empty() ? nullptr : &claim_named(layout.claim, place_);
    if (claim != nullptr) speak_of(*claim, page_);
    panel.title = layout.title.said(page_);
    for (const auto& [label, value] : layout.facts) panel.facts.emplace_back(label.words(page_), value.words(page_));
    // With other papers beside it, the paper has its year.
    for (const std::string& name : layout.also) panel.facts.emplace_back(dated(name), claim_named(name, place_).says);
    if (claim != nullptr)
      panel.facts.emplace_back(layout.also.empty() ? fmt::format("The paper ({})", claim->place) : dated(layout.claim), claim->says);
    panel.text = notes_of(layout.text);
    for (const auto& picture : layout.pictures) {
      if (const auto* const plot = std::get_if<PlotLayout>(&picture)) {
        constexpr int width = 520;
        constexpr int height = 360;
        if (auto figure = figure_of(*plot, width, height)) panel.figures.push_back(*std::move(figure));
      } else {
        for (Figure& figure : figures_of(std::get<GalleryLayout>(picture))) panel.figures.push_back(std::move(figure));
      }
    }
    page_ = page;
    blocks_.emplace_back(std::move(panel));
  }

  static void speak_of(const OldClaim& claim, Scope& scope) {
    if (!claim.figure) return;
    scope.values["claim.least"] = claim.figure->first;
    scope.values["claim.greatest"] = claim.figure->second;
  }

  void add(const ParagraphLayout& paragraph) { blocks_.emplace_back(Paragraph{paragraph.text.said(page_)}); }
  void add(const HeadingLayout& heading) { blocks_.emplace_back(Heading{heading.text.words(page_), heading.id}); }

  [[nodiscard]] std::vector<Said> notes_of(const std::vector<NoteLayout>& notes) const {
    std::vector<Said> said;
    for (const NoteLayout& note : notes)
      if (!note.host_time || rendering_.host_times) said.push_back(note.text.said(page_));
    return said;
  }

  [[nodiscard]] Cell cell_of_column(const ColumnLayout& column, const Scope& scope) const {
    if (column.must) {
      const bool good = column.must->holds(scope);
      return Verdict{good, (good ? column.good : column.bad).words(scope)};
    }
    if (column.value) return cell_of(column.value->value(scope), column.places);
    const auto place = scope.set->place_of(column.key);
    if (!place)
      throw Wrong(fmt::format("{}: column \"{}\": found no such key in the records, expected one of {}", place_,
                              column.key, base::joined(scope.set->keys(), ", ")));
    return cell_of(scope.set->at(scope.row, *place), column.places);
  }

  void add(const TableLayout& layout) {
    const auto scopes = scopes_of(layout.rows);
    if (scopes.empty() && layout.only_with_rows) return;
    Table table;
    table.id = layout.id;
    table.title = layout.title.words(page_);
    table.folded = layout.folded;
    std::vector<const ColumnLayout*> columns;
    for (const ColumnLayout& column : layout.columns) {
      if (column.host_time && !rendering_.host_times) continue;
      columns.push_back(&column);
      table.columns.push_back({column.key, column.title, column.unit});
    }
    table.cards_name = layout.cards_name;
    for (const Scope& scope : scopes) {
      std::vector<Cell> row;
      for (const ColumnLayout* const column : columns) row.push_back(cell_of_column(*column, scope));
      if (layout.pivot) {
        add_to_pivot(table, std::move(row), *layout.pivot, scope);
      } else {
        table.rows.push_back(std::move(row));
      }
      // Of the first row of those that a pivot joins.
      if (!table.cards_name.empty() && table.cards.size() < table.rows.size()) table.cards.push_back(card_of(layout, scope));
    }
    for (auto& row : table.rows) row.resize(table.columns.size());
    table.notes = notes_of(layout.notes);
    blocks_.emplace_back(std::move(table));
  }

  void add_to_pivot(Table& table, std::vector<Cell> common, const PivotLayout& pivot, const Scope& scope) const {
    const std::string key = pivot.key.words(scope);
    auto column = std::find_if(table.columns.begin(), table.columns.end(),
                               [&](const Column& known) { return known.key == key; });
    if (column == table.columns.end())
      column = table.columns.insert(column, {key, pivot.title.words(scope), pivot.unit});
    auto row = std::find_if(table.rows.begin(), table.rows.end(), [&](const auto& known) {
      return std::equal(common.begin(), common.end(), known.begin());
    });
    if (row == table.rows.end()) row = table.rows.insert(row, std::move(common));
    row->resize(std::max(row->size(), table.columns.size()));
    (*row)[static_cast<std::size_t>(column - table.columns.begin())] = cell_of(pivot.value.value(scope), pivot.places);
  }

  // What is here, beside what the paper says: texts may speak of claim.least, claim.greatest, here.least,
  // here.greatest and of their ratios, ours to the paper's: ratio.least, ratio.greatest.
  void add(const ClaimsLayout& layout) {
    Table table;
    table.id = layout.id;
    table.title = layout.title.words(page_);
    table.folded = layout.folded;
    table.columns = {{"place", "In the paper", ""},        {"says", "It says", ""},
                     {"here_least", "Here", "least"},      {"here_greatest", "Here", "greatest"},
                     {"unit", "Unit", ""},                 {"ratio_least", "Here to paper", "ratio, least"},
                     {"ratio_greatest", "Here to paper", "ratio, greatest"},
                     {"condition", "Condition here", ""},  {"comparison", "Comparison", ""}};
    for (const OldClaimRow& row : layout.rows) {
      if (row.host_time && !rendering_.host_times) continue;
      table.rows.push_back(claim_cells(row, claim_named(row.claim, row.place)));
    }
    table.notes = notes_of(layout.notes);
    blocks_.emplace_back(std::move(table));
  }

  [[nodiscard]] std::vector<Cell> claim_cells(const OldClaimRow& row, const OldClaim& claim) const {
    Scope scope = page_;
    const Value least = row.least ? row.least->value(scope) : Value();
    const Value greatest = row.greatest ? row.greatest->value(scope) : Value();
    const auto ratio = [](const Value& here, double figure) {
      const auto number = here.number();
      return number && figure != 0 ? Value(*number / figure) : Value();
    };
    Value ratio_least;
    Value ratio_greatest;
    if (claim.figure) {
      ratio_least = ratio(least, claim.figure->second);
      ratio_greatest = ratio(greatest, claim.figure->first);
      speak_of(claim, scope);
    }
    scope.values["here.least"] = least;
    scope.values["here.greatest"] = greatest;
    scope.values["ratio.least"] = ratio_least;
    scope.values["ratio.greatest"] = ratio_greatest;
    const Said comparison = row.comparison.said(scope);
    Cell judged = comparison.text;
    if (!comparison.failed.empty())
      judged = Verdict{false, fmt::format("{}{}not in this run: {}", comparison.text, comparison.text.empty() ? "" : "; ",
                                          base::joined(comparison.failed, "; "))};
    return {claim.place, claim.says, cell_of(least, row.places), cell_of(greatest, row.places),
            row.unit.empty() ? claim.unit : row.unit, cell_of(ratio_least), cell_of(ratio_greatest),
            row.condition.words(scope), judged};
  }

  void add(const PlotLayout& layout) {
    if (auto figure = figure_of(layout)) blocks_.emplace_back(*std::move(figure));
  }

  // Nothing, if there are too few points.
  [[nodiscard]] std::optional<Figure> figure_of(const PlotLayout& layout, int width = 0, int height = 0) const {
    Plot plot;
    plot.id = layout.id;
    plot.title = layout.title.words(page_);
    plot.alternative = layout.alternative.words(page_);
    plot.x = {layout.x.title, layout.x.unit, layout.x.logarithmic};
    plot.y = {layout.y.title, layout.y.unit, layout.y.logarithmic};
    std::set<std::pair<double, double>> points;
    for (const CurveLayout& curve : layout.curves) add_curves(plot, curve, points);
    constexpr std::size_t fewest_points = 3;
    if (points.size() < fewest_points) return std::nullopt;
    plot.caption = layout.caption.said(page_);
    if (width != 0) {
      plot.width = width;
      plot.height = height;
    }
    return rendering_.draw(plot);
  }

  void add_curves(Plot& plot, const CurveLayout& layout, std::set<std::pair<double, double>>& points) const {
    const std::size_t first = plot.curves.size();
    for (const Scope& scope : scopes_of(layout.rows)) {
      const auto x = layout.x.value(scope).number();
      const auto y = layout.y.value(scope).number();
      const std::string name = layout.by.words(scope);
      auto curve = std::find_if(plot.curves.begin() + static_cast<std::ptrdiff_t>(first), plot.curves.end(),
                                [&](const Curve& known) { return known.name == name; });
      if (curve == plot.curves.end()) curve = plot.curves.insert(curve, {name, {}, layout.line, layout.marks});
      if (!x || !y) continue;
      curve->points.push_back({*x, *y, layout.label.empty() ? "" : layout.label.words(scope)});
      if (plot.x.shows(*x) && plot.y.shows(*y)) points.emplace(*x, *y);
    }
  }

  void add(const GalleryLayout& layout) {
    blocks_.emplace_back(Gallery{layout.id, layout.title.words(page_), figures_of(layout), layout.folded});
  }

  [[nodiscard]] std::vector<Figure> figures_of(const GalleryLayout& layout) const {
    std::vector<Figure> figures;
    for (const Scope& scope : scopes_of(layout.rows)) {
      const Picture* const picture = picture_at(scope, layout.image);
      if (picture == nullptr) throw Wrong(fmt::format("{}: found no picture under \"{}\"", place_, layout.image));
      figures.push_back({layout.figure_id.words(scope), layout.name.words(scope), layout.caption.said(scope),
                         layout.alternative.words(scope), picture->media_type, picture->bytes,
                         picture->pixelated});
    }
    return figures;
  }

  // nullptr: none.
  [[nodiscard]] static const Picture* picture_at(const Scope& scope, std::string_view key) {
    const auto place = scope.set->place_of(key);
    return place ? std::get_if<Picture>(&scope.set->at(scope.row, *place).kind()) : nullptr;
  }

  // Of a row; those that it does not have are left out.
  [[nodiscard]] std::vector<Figure> card_of(const TableLayout& layout, const Scope& scope) const {
    std::vector<Figure> figures;
    for (const CardPicture& card : layout.cards) {
      if (!scope.set->place_of(card.image)) throw Wrong(fmt::format("{}: found no key \"{}\" in the records", place_, card.image));
      const Picture* const picture = picture_at(scope, card.image);
      if (picture == nullptr) continue;
      const std::string name = card.name.words(scope);
      figures.push_back({{}, name, {}, name, picture->media_type, picture->bytes, picture->pixelated});
    }
    return figures;
  }

  void add(const ListingsLayout& layout) {
    for (const Scope& scope : scopes_of(layout.rows)) {
      const auto text = layout.text.value(scope);
      blocks_.emplace_back(
          Listing{layout.id.words(scope), layout.file.words(scope), std::string(text.text().value_or(""))});
    }
  }

  const OldChapter& chapter_;
  const Layout& layout_;
  const OldResults& results_;
  const Rendering& rendering_;
  Scope page_;
  std::string place_;
  std::vector<Block> blocks_;
};

// The keys that a chapter reads.
class References {
 public:
  explicit References(const OldChapter& chapter) {
    for (const BlockLayout& block : chapter.blocks)
      std::visit([this](const auto& content) { add(content); }, block.content);
  }
  [[nodiscard]] const std::vector<Reference>& all() const { return all_; }

 private:
  void add(const Text& text, std::string_view set = {}) { text.collect(all_, set); }
  void add(const std::optional<Expression>& expression, std::string_view set = {}) {
    if (expression) expression->collect(all_, set);
  }
  void add(const RowsOf& rows) { add(rows.where, rows.set); }
  void add(const std::vector<NoteLayout>& notes) {
    for (const NoteLayout& note : notes) add(note.text);
  }

  void add(const ParagraphLayout& paragraph) { add(paragraph.text); }
  void add(const HeadingLayout& heading) { add(heading.text); }
  void add(const PanelLayout& panel) {
    add(panel.title);
    for (const auto& [label, value] : panel.facts) {
      add(label);
      add(value);
    }
    add(panel.text);
    for (const auto& picture : panel.pictures) std::visit([this](const auto& content) { add(content); }, picture);
  }
  void add(const TableLayout& table) {
    const std::string& set = table.rows.set;
    add(table.title);
    add(table.rows);
    for (const CardPicture& card : table.cards) {
      all_.push_back({set, card.image});
      add(card.name, set);
    }
    for (const ColumnLayout& column : table.columns) {
      if (!column.value && !column.must) all_.push_back({set, column.key});
      add(column.value, set);
      add(column.must, set);
      add(column.good, set);
      add(column.bad, set);
    }
    if (table.pivot) {
      add(table.pivot->key, set);
      add(table.pivot->title, set);
      table.pivot->value.collect(all_, set);
    }
    add(table.notes);
  }
  void add(const ClaimsLayout& claims) {
    for (const OldClaimRow& row : claims.rows) {
      add(row.least);
      add(row.greatest);
      add(row.condition);
      add(row.comparison);
    }
    add(claims.notes);
  }
  void add(const PlotLayout& plot) {
    for (const Text* const text : {&plot.title, &plot.caption, &plot.alternative}) add(*text);
    for (const CurveLayout& curve : plot.curves) {
      add(curve.rows);
      curve.x.collect(all_, curve.rows.set);
      curve.y.collect(all_, curve.rows.set);
      add(curve.by, curve.rows.set);
      add(curve.label, curve.rows.set);
    }
  }
  void add(const GalleryLayout& gallery) {
    add(gallery.rows);
    all_.push_back({gallery.rows.set, gallery.image});
    for (const Text* const text : {&gallery.figure_id, &gallery.name, &gallery.caption, &gallery.alternative})
      add(*text, gallery.rows.set);
  }
  void add(const ListingsLayout& listings) {
    add(listings.rows);
    listings.text.collect(all_, listings.rows.set);
    add(listings.id, listings.rows.set);
    add(listings.file, listings.rows.set);
  }

  std::vector<Reference> all_;
};

// Single values of claims, and the number of rows.
bool is_no_key(const Reference& reference) {
  static const std::set<std::string, std::less<>> values{"claim", "here", "ratio"};
  return values.contains(reference.set) || reference.key == "rows" || reference.set.empty();
}

}  // namespace

std::vector<Block> render(const OldChapter& chapter, const Layout& layout, const OldResults& results,
                          const Rendering& rendering) {
  Renderer renderer(chapter, layout, results, rendering);
  try {
    return std::move(renderer).blocks();
  } catch (const Wrong& wrong) {
    throw Failure(ErrorKind::bad_input, wrong.what());
  } catch (const std::invalid_argument& wrong) {
    throw Failure(ErrorKind::bad_input, fmt::format("{}: {}", renderer.place(), wrong.what()));
  }
}

std::vector<std::string> mismatches(const Layout& layout, const OldResults& results) {
  std::vector<std::string> lines;
  std::set<std::pair<std::string, std::string>> read;  // "EXPERIMENT.SET", key
  std::set<std::string, std::less<>> of_outer_rows;
  for (const auto& [name, chapter] : layout.chapters) {
    const References references(chapter);
    for (const Reference& reference : references.all()) {
      if (reference.set.empty()) of_outer_rows.insert(reference.key);
      if (is_no_key(reference)) continue;
      const auto set = chapter.sets.find(reference.set);
      if (set == chapter.sets.end()) {
        lines.push_back(fmt::format("{}.json: reads {}.{}, but has no set {}", name, reference.set, reference.key, reference.set));
        continue;
      }
      read.emplace(set->second, reference.key);
      const RowSet* const rows = find_set(layout, results, set->second);
      if (rows == nullptr) {
        lines.push_back(fmt::format("{}.json: found no records {}", name, set->second));
      } else if (!rows->place_of(reference.key)) {
        lines.push_back(fmt::format("{}.json: found no key {} in {}", name, reference.key, set->second));
      }
    }
  }
  for (const auto& [experiment, records] : results)
    for (const auto& [name, set] : records)
      for (const std::string& key : set.keys())
        if (!read.contains({experiment + "." + name, key}) && !of_outer_rows.contains(key))
          lines.push_back(fmt::format("{}.{}: nothing reads key {}", experiment, name, key));
  return lines;
}

}  // namespace sightline::report
