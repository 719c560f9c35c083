// What the page shows of the records, as data/*.json say it: report.json the parts, sections and their chapters,
// papers.json what the papers say and where, and a file a chapter, which is a list of blocks. All expressions and
// texts are read, and what is wrong with one is an error that names file and place; names are looked up when a
// chapter is rendered (render.hpp).
//
// data/README.md tells of the members of each file.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "host/report/document.hpp"
#include "host/report/expression.hpp"
#include "host/report/records.hpp"
#include "host/report/text.hpp"

namespace sightline::report {

// Rows of a set, all or those for which an expression holds.
struct RowsOf {
  std::string set;
  std::optional<Expression> where;
};

// A value of a row. Or a judgement: what must hold, and the words for both cases.
struct ColumnLayout {
  std::string key;
  std::string title;
  std::string unit;
  int places = Real::as_needed;
  bool host_time = false;
  std::optional<Expression> value;  // none: the row's value of that key
  std::optional<Expression> must;
  Text good;
  Text bad;
};

// A column for each value that some expression has in the rows; what rows have in common stands once.
struct PivotLayout {
  Text key;
  Text title;
  std::string unit;
  Expression value;
  int places = Real::as_needed;
};

struct NoteLayout {
  Text text;
  bool host_time = false;
};

// A picture of a card, if the row has one under this key.
struct CardPicture {
  std::string image;
  Text name;
};

struct TableLayout {
  std::string id;
  Text title;
  RowsOf rows;
  std::vector<ColumnLayout> columns;
  std::optional<PivotLayout> pivot;
  std::vector<NoteLayout> notes;
  bool folded = false;
  bool only_with_rows = false;
  std::string cards_name = {};  // not empty: the rows are cards
  std::vector<CardPicture> cards = {};
};

// A claim of a paper, and the measured figures shown with it.
struct OldClaimRow {
  std::string claim;  // "PAPER.CLAIM" of papers.json
  std::string place;  // in the data file, for errors
  std::optional<Expression> least;
  std::optional<Expression> greatest;
  int places = Real::as_needed;
  std::string unit;  // empty: the claim's
  bool host_time = false;
  Text condition;
  Text comparison;
};

struct ClaimsLayout {
  std::string id;
  Text title;
  std::vector<OldClaimRow> rows;
  std::vector<NoteLayout> notes;
  bool folded = false;
};

struct AxisLayout {
  std::string title;
  std::string unit;
  bool logarithmic = true;
};

// A curve for each different text that `by` gives; its rows in their order.
struct CurveLayout {
  RowsOf rows;
  Text by;  // the name in the legend
  Expression x;
  Expression y;
  Text label;
  bool line = true;
  bool marks = true;
};

struct PlotLayout {
  std::string id;
  Text title;
  Text caption;
  Text alternative;
  AxisLayout x;
  AxisLayout y;
  std::vector<CurveLayout> curves;
};

struct GalleryLayout {
  std::string id;
  Text title;
  RowsOf rows;
  std::string image;  // key of the pictures
  Text figure_id;
  Text name;
  Text caption;
  Text alternative;
  bool folded = false;
};

struct ListingsLayout {
  RowsOf rows;
  Text id;
  Text file;
  Expression text;
};

struct ParagraphLayout {
  Text text;
};
struct HeadingLayout {
  Text text;
  std::string id;
};

// Texts may speak of the claim's figure, as those of a OldClaimRow.
struct PanelLayout {
  std::string id;
  Text title;
  std::string paper;  // whose title stands with it; empty: none
  std::string claim;  // as a OldClaimRow's; empty: none
  std::vector<std::string> also;  // claims of other papers, whose words stand before that one's
  std::vector<std::pair<Text, Text>> facts;
  std::vector<NoteLayout> text;
  std::vector<std::variant<PlotLayout, GalleryLayout>> pictures;
};

struct BlockLayout {
  std::variant<ParagraphLayout, HeadingLayout, PanelLayout, TableLayout, ClaimsLayout, PlotLayout, GalleryLayout,
               ListingsLayout>
      content;
  std::string place;       // in its file: "skala.json: blocks[3]"
  bool host_time = false;  // left out without host times
};

struct OldChapter {
  std::string name;
  std::map<std::string, std::string, std::less<>> sets;  // name here -> "EXPERIMENT.SET"
  std::vector<BlockLayout> blocks;

  [[nodiscard]] std::vector<std::string> experiments() const;
};

struct OldClaim {
  std::string place;  // section, table, figure
  std::string says;
  std::optional<std::pair<double, double>> figure;  // least and greatest
  std::string unit;
};

struct OldPaper {
  std::string id;
  std::vector<std::string> authors;
  int year = 0;
  std::string title;
  std::string published_in;
  std::map<std::string, OldClaim, std::less<>> claims;

  // C. B. Jones, "A new approach ...", The Computer Journal 14(3), 1971.
  [[nodiscard]] std::string citation() const;
};

// A kind of chapters, which people ask for by its number.
struct PartLayout {
  int number = 0;
  std::string title;
};

// Chapters in their order, each of a part; those of none are left out where parts are asked for.
struct SectionLayout {
  std::string id;
  std::string title;
  std::string paper;  // empty: none
  std::vector<std::pair<std::string, int>> chapters;  // and the number of its part; 0: none
};

struct Layout {
  std::string title;
  std::vector<std::string> introduction;
  std::string without_host_times;  // said of a report without them
  std::vector<PartLayout> parts;
  std::vector<SectionLayout> sections;
  std::vector<OldPaper> papers;
  Records paper_tables;  // tables that papers print: the sets "papers.NAME"
  std::map<std::string, OldChapter, std::less<>> chapters;

  // nullptr: there is none.
  [[nodiscard]] const OldClaim* claim(std::string_view paper_and_claim) const;
  [[nodiscard]] const OldPaper* paper(std::string_view id) const;
  [[nodiscard]] const PartLayout* part(int number) const;
};

using DataFiles = std::span<const std::pair<std::string_view, std::string_view>>;  // name, contents

// Throws Failure (bad_input) that names file and place, for data that cannot be used: no JSON, a member that is
// missing, of another kind or not known, an expression that cannot be read, a part without its chapter.
[[nodiscard]] Layout read_layout(DataFiles files);

// Those of data/.
[[nodiscard]] DataFiles layout_files();

}  // namespace sightline::report
