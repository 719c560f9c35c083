// What a report is made of, as writers (html_page.hpp, table_text.hpp, write_report.hpp) turn it into files.
// All text is plain UTF-8 and is escaped when written.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/base/file.hpp"

namespace sightline::report {

// A measured or computed number: shown with so many places behind the point, or, with as_needed, with four
// significant digits. CSV and JSON carry the whole value. Not finite: shown in words, null in JSON.
struct Real {
  static constexpr int as_needed = -1;

  double value = 0;
  int places = as_needed;

  friend bool operator==(const Real&, const Real&) = default;
};

// Something that is right or wrong; the words alone must say it.
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

// Nothing, words, a count, a number, a judgement.
using Cell = std::variant<std::monostate, std::string, std::int64_t, Real, Verdict>;

// A text, and the statements in it that do not hold in this run and were left out.
struct Said {
  std::string text = {};
  std::vector<std::string> failed = {};

  Said() = default;
  Said(std::string said) : text(std::move(said)) {}
  Said(const char* said) : text(said) {}
  Said(std::string said, std::vector<std::string> not_held) : text(std::move(said)), failed(std::move(not_held)) {}
  friend bool operator==(const Said&, const Said&) = default;
  friend Said operator+(Said left, const Said& right) {
    left.text += right.text;
    left.failed.insert(left.failed.end(), right.failed.begin(), right.failed.end());
    return left;
  }
};

struct Column {
  std::string key;         // in CSV and JSON: a-z, 0-9, _; once in a table; with its unit: "view_s"
  std::string title;       // in the page
  std::string unit;        // "s", "words of 18 bits"; empty: none
};

struct Figure {
  std::string id;  // as a table's
  std::string title;
  Said caption;
  std::string alternative;  // what is to be seen, for those who cannot
  std::string media_type;   // "image/png", "image/svg+xml"
  base::Bytes bytes;
  bool pixelated = false;  // enlarged without smoothing
};

struct Table {
  std::string id;  // a-z, 0-9, -; once in a report: the file's name and the place to link to
  std::string title;
  std::vector<Column> columns = {};
  std::vector<std::vector<Cell>> rows = {};  // each as wide as columns
  std::vector<Said> notes = {};              // paragraphs under the table
  bool folded = false;                       // to be opened in the page
  // Pictures of each row: the page shows the rows as cards. Readers choose cards by this name, and by whether a
  // judgement in the row is bad.
  std::vector<std::vector<Figure>> cards = {};
  std::string cards_name = {};
};

// The first screen: questions with their answers, and drawings in SVG, which are part of the page and have colours for
// light and dark grounds.
struct Opening {
  std::vector<std::pair<std::string, Said>> answers;
  std::vector<std::string> drawings;
  std::string caption;
};

struct Paragraph {
  Said text;
};

// Begins a chapter: what follows, up to the next one, is folded under it.
struct Heading {
  std::string text;
  std::string id;
};

// A method or a finding: its statement, figures beside each other ("Here", "0.06 to 0.98 s"), text, pictures.
struct Panel {
  std::string id;
  Said title;
  std::string source = {};  // the paper; empty: none
  std::vector<std::pair<std::string, std::string>> facts = {};
  std::vector<Said> text = {};
  std::vector<Figure> figures = {};
};

// A file the report is about, such as an input: folded up in the page, to be opened there or saved.
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
