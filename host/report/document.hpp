// The parts of a report, which writers (html_page.hpp, table_text.hpp, write_report.hpp) turn into files. All text is
// plain UTF-8 and is escaped when written.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/base/file.hpp"

namespace sightline::report {

// A measured or computed number: shown with `places` decimals or, with as_needed, with four significant digits. CSV
// and JSON contain the full value. If it is not finite: words in the page, null in JSON.
struct Real {
  static constexpr int as_needed = -1;

  double value = 0;
  int places = as_needed;

  friend bool operator==(const Real&, const Real&) = default;
};

// A result that is right or wrong; the text alone must say which.
struct Verdict {
  bool good = true;
  std::string text = {};

  friend bool operator==(const Verdict&, const Verdict&) = default;
};

struct Picture {
  std::string media_type = {};  // "image/png", "image/svg+xml"
  base::Bytes bytes = {};
  bool pixelated = false;  // enlarged without smoothing

  friend bool operator==(const Picture&, const Picture&) = default;
};

// Nothing, a text, a count, a number, or a verdict.
using Cell = std::variant<std::monostate, std::string, std::int64_t, Real, Verdict>;

// A text, and the statements that were left out of it because they do not hold in this run.
struct CheckedText {
  std::string text = {};
  std::vector<std::string> failed = {};

  CheckedText() = default;
  CheckedText(std::string said) : text(std::move(said)) {}
  CheckedText(const char* said) : text(said) {}
  CheckedText(std::string said, std::vector<std::string> not_held) : text(std::move(said)), failed(std::move(not_held)) {}
  friend bool operator==(const CheckedText&, const CheckedText&) = default;
  friend CheckedText operator+(CheckedText left, const CheckedText& right) {
    left.text += right.text;
    left.failed.insert(left.failed.end(), right.failed.begin(), right.failed.end());
    return left;
  }
};

struct Column {
  std::string key;         // in CSV and JSON: a-z, 0-9, _; unique in a table; with its unit: "view_s"
  std::string title;       // in the page
  std::string unit;        // "s", "words of 18 bits"; empty: none
};

struct Figure {
  std::string id;  // as a table's
  std::string title;
  CheckedText caption;
  std::string alternative;  // a description of the picture for readers who cannot see it
  std::string media_type;   // "image/png", "image/svg+xml"
  base::Bytes bytes;
  bool pixelated = false;  // enlarged without smoothing
};

struct Table {
  std::string id;  // a-z, 0-9, -; unique in a report: the file's name and the link's target
  std::string title;
  std::vector<Column> columns = {};
  std::vector<std::vector<Cell>> rows = {};  // each as long as columns
  std::vector<CheckedText> notes = {};              // paragraphs under the table
  bool folded = false;                       // collapsed in the page
  // Figures of each row; if there are any, the page shows the rows as cards. Readers filter cards by this name, and
  // by whether a verdict in the row is bad.
  std::vector<std::vector<Figure>> cards = {};
  std::string cards_name = {};
};

// The first screen: questions with their answers, and drawings in SVG, which are part of the page and have colours
// for light and dark backgrounds.
struct Opening {
  std::vector<std::pair<std::string, CheckedText>> answers;
  std::vector<std::string> drawings;
  std::string caption;
};

struct Paragraph {
  CheckedText text;
};

// Begins a chapter: the blocks up to the next heading are collapsed under it.
struct Heading {
  std::string text;
  std::string id;
};

// A method or a finding: its statement, facts side by side ("Here", "0.06 to 0.98 s"), text, figures.
struct Panel {
  std::string id;
  CheckedText title;
  std::string source = {};  // the paper; empty: none
  std::vector<std::pair<std::string, std::string>> facts = {};
  std::vector<CheckedText> text = {};
  std::vector<Figure> figures = {};
};

// A file that the report describes, such as an input: collapsed in the page, to be read there or saved.
struct Listing {
  std::string id;    // as a table's
  std::string file;  // the name it is saved by
  std::string text;  // UTF-8
};

// Small pictures side by side.
struct Gallery {
  std::string id;
  std::string title;
  std::vector<Figure> figures;
  bool folded = false;
};

using Block = std::variant<Opening, Paragraph, Heading, Panel, Table, Figure, Gallery, Listing>;

struct Section {
  std::string id;
  std::string title;
  std::vector<Block> blocks;
};

struct Report {
  std::string title;
  std::string version;  // of the program that made it
  std::vector<std::string> introduction;
  std::vector<Section> sections;
};

}  // namespace sightline::report
