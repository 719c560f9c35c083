// What a report is made of. Data flows one way: parts measure and compute sections of plain values, writers
// (html_page.hpp, table_text.hpp, write_report.hpp) turn them into files and change nothing.
//
// A part is one function and one line in parts.cpp. It says nothing of HTML: all text is plain UTF-8 and is
// escaped when written.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "host/base/file.hpp"
#include "host/base/result.hpp"

namespace sightline::harness::report {

// A measured or computed number: shown with so many places behind the point, or, with as_needed, with four
// significant digits. CSV and JSON carry the whole value. Not finite: shown in words, null in JSON.
struct Real {
  static constexpr int as_needed = -1;

  double value = 0;
  int places = as_needed;

  friend bool operator==(const Real&, const Real&) = default;
};

// Something that is right or wrong, said in words; the words alone must say it.
struct Verdict {
  bool good = true;
  std::string text;

  friend bool operator==(const Verdict&, const Verdict&) = default;
};

// Nothing, words, a count, a number, a judgement.
using Cell = std::variant<std::monostate, std::string, std::int64_t, Real, Verdict>;

struct Column {
  std::string key;         // in CSV and JSON: a-z, 0-9, _; once in a table; with its unit: "view_s"
  std::string title;       // in the page
  std::string unit;        // "s", "words of 18 bits"; empty: none
  bool host_time = false;  // of this computer and this run: left out where equal bytes are asked for
};

struct Table {
  std::string id;  // a-z, 0-9, -; once in a report: the file's name and the place to link to
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  // each as wide as columns
  std::vector<std::string> notes;       // paragraphs under the table
};

struct Figure {
  std::string id;  // as a table's
  std::string title;
  std::string caption;
  std::string alternative;  // what is to be seen, for those who cannot
  std::string media_type;   // "image/png", "image/svg+xml"
  base::Bytes bytes;
  bool host_time = false;  // made of times of this computer: left out where equal bytes are asked for
  bool pixelated = false;  // enlarged without smoothing
};

struct Paragraph {
  std::string text;
};

struct Heading {
  std::string text;
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
};

using Block = std::variant<Paragraph, Heading, Table, Figure, Gallery, Listing>;

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

enum class ErrorKind {
  guest_failed,  // a program on an emulated machine did not do its work
  differs,       // results that must be equal are not: a defect of this program
  missing_tool,  // gnuplot
  bad_input,     // a scene or case that comes with the program cannot be used
  file,          // something cannot be read or written
};

struct ReportError {
  ErrorKind kind = ErrorKind::file;
  std::string message;
};

template <class Value>
using Outcome = base::Result<Value, ReportError>;

// What a part is told.
struct Context {
  bool full = false;       // take the time a thorough measurement needs; else the whole report takes minutes
  bool host_times = true;  // false: do not measure time on this computer
  std::string cache = {};  // folder where what takes long to find is kept for the next report; empty: nowhere
  std::function<void(std::string_view)> progress = [](std::string_view) {
  };  // what is being done, in few words
};

struct Part {
  int number = 0;  // as people ask for it
  std::string_view title;
  Outcome<Section> (*make)(const Context& context) = nullptr;
};

// The parts of this program's report, ascending.
[[nodiscard]] std::span<const Part> all_parts();

// The parts one after the other, and of what they give only what may stay: without host times, the columns
// and figures marked so are gone. The first error ends it.
[[nodiscard]] Outcome<std::vector<Section>> make_sections(std::span<const Part> parts,
                                                          const Context& context);

}  // namespace sightline::harness::report
