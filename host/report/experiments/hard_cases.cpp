#include "host/report/experiments/hard_cases.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "host/base/text.hpp"
#include "host/compare/hard_cases/case_images.hpp"
#include "host/compare/hard_cases/first_failures.hpp"
#include "host/compare/hard_cases/manifest.hpp"
#include "host/compare/hard_cases/run_case.hpp"
#include "host/report/experiments/png_picture.hpp"

namespace sightline::report {

namespace {

using compare::Family;
using compare::FamilyResult;
using compare::HardCase;
using compare::HardCaseGroup;
using compare::hard_case_text;
using compare::Manifest;
using compare::SearchResult;

constexpr std::string_view manifest_file = "manifest.json";

Manifest manifest() {
  auto read = compare::read_manifest(hard_case_text(manifest_file), manifest_file);
  if (!read) throw base::bad_input(read.error().message());
  return std::move(*read);
}

CaseResult result_of(const HardCaseGroup& group, const HardCase& hard) {
  const compare::CaseOutcome outcome = compare::run_case(hard, compare::case_image_side);
  CaseResult made{group.id,      hard.id,       hard.input, hard.section, hard.what, compare::options_of(hard),
                  hard.expected, compare::checks_of(hard), compare::hard_command(hard), {}, {}, {}, {}};
  if (const std::string command = compare::compare_command(hard); !command.empty()) made.commands += "; " + command;
  for (const compare::MethodOutcome& method : outcome.methods) made.findings.push_back({method.method, method.text, method.right});
  if (!hard.tests.empty()) made.findings.push_back({"tests", base::joined(hard.tests, ", "), {}});
  if (outcome.correct) made.correct = png_picture(*outcome.correct);
  if (outcome.found && outcome.found_is_wrong) {
    made.wrong = png_picture(*outcome.found);
    made.wrong_by = outcome.found_by;
  }
  return made;
}

// "2: 1, 4: 2"
std::string tried_text(const SearchResult& search) {
  std::vector<std::string> parts;
  for (const auto& [value, trial] : search.tried)
    if (trial.measure)
      parts.push_back(fmt::format("{:g}: {:.3g}", trial.shown.value_or(value), *trial.measure));
  return base::joined(parts, ", ");
}

void add_first_failures(std::vector<FirstFailure>& made, const Family& family) {
  const auto results = compare::run_family(family);
  if (!results) throw base::bad_input(results.error().message());
  for (const FamilyResult& result : *results) {
    const SearchResult& search = result.search;
    FirstFailure row{family.id, family.parameter, family.input, result.build, {}, {}, tried_text(search)};
    if (search.first) {
      const auto& [value, trial] = search.tried[*search.first];
      row.first = trial.shown.value_or(value);
      row.what = {false, *trial.fault};
    } else {
      const auto& [value, trial] = search.tried.back();
      const bool falls = family.values.back() < family.values.front();
      row.what = {true, fmt::format("none {} to {:g}", falls ? "down" : "up", trial.shown.value_or(value))};
    }
    made.push_back(std::move(row));
  }
}

// "J5-strip.json" is "input-j5-strip-json".
std::string listing_id(std::string_view file) {
  std::string id = "input-";
  for (const char c : file)
    id += c == '.' ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return id;
}

// Every file of a case once, in the order of the cases. A model is one of the program's own scenes.
std::vector<InputFile> inputs_of(const Manifest& manifest) {
  std::vector<InputFile> inputs;
  for (const HardCaseGroup& group : manifest.groups) {
    for (const HardCase& hard : group.cases) {
      const std::string_view text = hard_case_text(hard.input);
      if (!text.empty() && count(inputs, equals(&InputFile::file, hard.input)) == 0) inputs.push_back({hard.input, std::string(text)});
    }
  }
  return inputs;
}

// The chapter.

struct CaseTable {
  std::string paper;
  std::string cards_name;
  std::string title;
  std::vector<CheckedText> notes;
};

// Cards: a row for each case, a column for each method.
void case_table(Page& page, const HardCases& hard, CaseTable of) {
  using Case = CaseResult;
  std::vector<RowColumn<Case>> columns{{"case", "Case", &Case::id},
                                       {"what", "What it is", &Case::what},
                                       {"section", "In the paper", &Case::section},
                                       {"input", "Input", &Case::input},
                                       {"options", "Options", &Case::options},
                                       {"expected", "Expected", &Case::expected},
                                       {"checked", "Checked", &Case::checked},
                                       {"commands", "Commands", &Case::commands}};
  // Cases of turns have no options.
  if (of.paper == "plantinga") std::erase_if(columns, [](const auto& column) { return column.column.key == "options"; });
  const auto cases = where(hard.cases, equals(&Case::paper, of.paper));
  const std::string title = fmt::format("{}, {} to {}", of.title, cases.front().get().id, cases.back().get().id);
  Table table{"hard-cases-" + of.paper, title, {}, {}, std::move(of.notes)};
  table.notes.emplace_back(
      "Tests check what is inside the algorithm, on the same file: their names are those of the repository's tests.");
  table.cards_name = of.cards_name;
  for (const auto& column : columns) table.columns.push_back(column.column);
  std::vector<std::string> methods;
  for (const Case& row : cases)
    for (const CaseFinding& finding : row.findings)
      if (std::find(methods.begin(), methods.end(), finding.method) == methods.end()) methods.push_back(finding.method);
  for (const std::string& method : methods) {
    std::string key = method;
    std::replace(key.begin(), key.end(), '-', '_');
    table.columns.push_back({key, method, ""});
  }
  for (const Case& row : cases) {
    std::vector<Cell>& cells = table.rows.emplace_back();
    for (const auto& column : columns) cells.push_back(column.cell(row));
    for (const std::string& method : methods) {
      const CaseFinding* const finding = row.finding(method);
      cells.push_back(finding == nullptr ? Cell() : finding->right ? Cell(Verdict{*finding->right, finding->text}) : Cell(finding->text));
    }
    std::vector<Figure>& card = table.cards.emplace_back();
    if (row.correct) card.push_back(figure(*row.correct, "", "correct", "", "correct"));
    const std::string wrong = "wrong, by " + row.wrong_by;
    if (row.wrong) card.push_back(figure(*row.wrong, "", wrong, "", wrong));
  }
  page.add(std::move(table));
}

void first_failures_table(Page& page, const HardCases& hard) {
  using Row = FirstFailure;
  page.table("hard-cases-first-failures", "With a parameter: the first value at which each build fails", hard.first_failures,
             {{"case", "Case", &Row::id},
              {"parameter", "Parameter", &Row::parameter},
              {"input", "Input", &Row::input},
              {"build", "Build", &Row::build},
              {"first_failure", "First failure", &Row::first},
              {"what", "What happens", &Row::what},
              {"found", "Found (value: measure)", &Row::found}},
             {{"In the names of builds f=1 is one fraction bit. J: a corridor 100 wide and high (J12: 32,000) from z = -100, "
               "the eye at the origin. A build fails if it does not visit every cell, stops, or rejects the scene; the native "
               "algorithm also if its picture differs from that of exact. Twins have the limits of the machine's core: 8192 "
               "words for the scene alone, without the program, and a mask stack of 450 words. Coordinates of the program's "
               "scenes are at most 32767, those of native ones 262143.",
               "S11: slices 0 0, then 100 101, then 99 and 100 + 255/d, then 255 255, seen level: heights are rows. The second "
               "and the third cross in column d, at slopes that differ by 1/d. On a raster, the farther line appears where it "
               "is a row above the nearer one: off by up to d columns. Measured: columns.",
               "W10: measured: pieces. Cut into equal parts the long wall would need more pieces than it is long.",
               "M2: corners of a regular polygon of radius 100, rounded to integers, each bar along a side, four times as "
               "large, from a quarter before it to a quarter beyond, its near end before the next bar's far one. The exact "
               "build must cut once and draw the lines of the oracle; stripes fail if a pixel farther than 0.75 pixels from "
               "all edges shows another face than the sight line through its centre meets, with 0.4 pixels per unit. M9: "
               "measured: % of the triangle's area that its stripes cover; corners are moved to the nearest line between "
               "stripes.",
               "P6, triple point: coordinates of scenes are below 2^18, those of events below 2^23, directions of events below "
               "2^52; the least angles between events of scenes are 2^-104."}});
}

// Counts how many verdicts of a paper, or of all, are wrong.
struct Tally {
  std::size_t wrong = 0;
  std::size_t all = 0;
};
template <class Holds>
Tally tally(const HardCases& hard, Holds holds) {
  Tally made;
  for (const CaseResult& row : hard.cases) {
    for (const CaseFinding& finding : row.findings) {
      if (!finding.right || !holds(row, finding)) continue;
      ++made.all;
      if (!*finding.right) ++made.wrong;
    }
  }
  return made;
}

std::string wrong_of(const Tally& tally) {
  return fmt::format("{} of {} wrong", tally.wrong, tally.all);
}

}  // namespace

const CaseFinding* CaseResult::finding(std::string_view method) const {
  for (const CaseFinding& finding : findings)
    if (finding.method == method) return &finding;
  return nullptr;
}

HardCases hard_cases(const Context& context) {
  const Manifest read = manifest();
  HardCases made;
  for (const HardCaseGroup& group : read.groups) {
    for (const HardCase& hard : group.cases) {
      context.progress(fmt::format("hard case {} {}", hard.id, hard.input));
      made.cases.push_back(result_of(group, hard));
    }
  }
  for (const Family& family : read.families) {
    context.progress(fmt::format("hard case {}: first failures", family.id));
    add_first_failures(made.first_failures, family);
  }
  made.inputs = inputs_of(read);
  return made;
}

void hard_cases_chapter(Page& page, const HardCases& hard) {
  page.paragraph(
      "Each card is an input that breaks programs of this kind, with the expected result and the result of every method when "
      "this page was made. The picture is the correct one; where a method was wrong, its picture is next to it. Hidden edges "
      "are dashed. Errors of a program for a small machine are due to its arithmetic and memory; an exact method must be right "
      "everywhere. Guest is the program on its emulated machine, twin is the same program in C++.");
  case_table(page, hard, {"jones", "Jones",
                         "Jones: cells and portals",
                         {"Program (guest) and twin are compared with the oracle of cells on the screen: lines farther than a "
                          "point from the oracle's are wrong. The native algorithm (jones) uses the cells of the file and must "
                          "draw the oracle's picture, piece for piece. If the eye is not in free space there is no such "
                          "picture; then the lines named must be completely visible or hidden."}});
  case_table(page, hard, {"skala", "Skala",
                         "Skala: slices on a raster",
                         {"The oracle decides each column by depth alone. Program (guest) and twin must have the same dots; "
                          "the native algorithm must be within a dot of them. In views without rotation, the first and the "
                          "last column are ignored: there the program's order hides one of the two side edges, and vectors "
                          "show both. S7: all lines from (x, y) to (x + u, y + v), u and v from -16 to 16, and back, 49 a "
                          "screen without visibility test, at x, y = 18 + 36 n, n = 0 to 6, x first."}});
  case_table(page, hard, {"willis", "Willis",
                         "Willis: distance as priority",
                         {"Walls are seen from both sides, so a cluster of two walls counts twice. Pictures of 128 by 128 points, 90 "
                          "degrees wide, from the scene's own camera and from four sides, are compared with the nearest face of every "
                          "point; within 0.75 points of an edge rounding may choose either side. Drawn by `sightline draw willis FILE "
                          "--plan -o picture.png`, where plan is among the options."}});
  case_table(page, hard, {"montani-re", "Montani and Re",
                         "Montani and Re: stripes and priority lists",
                         {"Scenes (.json) are sheets seen along z without perspective; bodies count from 0. The exact build "
                          "(montani-re) must show the areas and draw the lines of the oracle. Stripes of a pixel are compared "
                          "with the oracle's sight lines through the centres of pixels: once with one pixel per unit, where "
                          "all corners lie on lines between stripes and no pixel may be wrong, and once with 4.25 pixels per "
                          "unit, where pixels within 0.75 pixels of an edge may be. The areas of the oracle are counts of "
                          "sight lines, one through every unit square.",
                          "Drawn by `sightline draw montani-re FILE -o picture.svg`. Chains (.txt) have one line per chain: "
                          "the name of its region, its starting point, its links (0 east, 1 north-east, ... 7 south-east); a "
                          "region is the set of points inside an odd number of its chains."}});
  case_table(page, hard, {"plantinga", "Plantinga, Seales and Dyer",
                         "Plantinga, Seales and Dyer: events of a turn",
                         {"Scenes are viewed along 24 horizontal directions: the first picture is made from scratch, the "
                          "others by stepping through the events of a full turn; all must equal the oracle's, piece for piece "
                          "(P18: those of exact, because the oracle is too slow). Files of edges and vertices (.txt) are "
                          "inputs of tests: directions are X : Z, the sine to the cosine of theta; a direction and its "
                          "opposite are two."}});
  page.add(Heading{"First failures", "first-failures"});
  first_failures_table(page, hard);
  page.add(Heading{"Inputs of the hard cases", "hard-case-inputs"});
  page.paragraph(
      "`sightline hard CASE -o DIR` runs a case by all its methods, and writes its input and a picture of the expected and the "
      "found result side by side. The command on a card compares its scene (.json) or grid (.csv, .dat), saved by this command "
      "or from this page; a scene is drawn by `sightline draw METHOD FILE -o picture.svg`, a grid by `sightline draw skala "
      "FILE -o picture.svg`. Texts (.txt) are inputs of `sightline hard` only: for S, commands of the program on the 8080, by "
      "name, with arguments in decimal; for M, chains around regions; for P, edges and vertices. Scenes of P turn by "
      "`sightline spin FILE -o turn.apng`.");
  for (const InputFile& input : hard.inputs) page.add(Listing{listing_id(input.file), input.file, input.text});
}

void finding_hard_cases(Page& page, const HardCases& hard, const MontaniReTables& tables, const WillisOrder& willis) {
  const Tally all = tally(hard, [](const CaseResult&, const CaseFinding&) { return true; });
  const auto guests_of = [&](std::string_view paper) {
    return wrong_of(tally(hard, [=](const CaseResult& row, const CaseFinding& finding) {
      return row.paper == paper && finding.method == "guest";
    }));
  };
  const Tally exact = tally(hard, [](const CaseResult&, const CaseFinding& finding) {
    return finding.method == "jones" || finding.method == "montani-re" || finding.method == "plantinga" || finding.method == "exact";
  });
  const auto is_wrong = [&](std::string_view input, std::string_view method) {
    const CaseFinding* const finding = only(hard.cases, equals(&CaseResult::input, input)).finding(method);
    return finding != nullptr && finding->right == false;
  };
  Panel panel{"finding-hard-cases", fmt::format("Of {} runs on hard cases {} are wrong", text_of(all.all), text_of(all.wrong)), {}, {}, {}, {}};
  panel.facts = {{"Jones on the PDP-7", guests_of("jones")},
                 {"Skala on the 8080", guests_of("skala")},
                 {"Exact programs of today", wrong_of(exact)},
                 page.paper_says("montani_re.figure_10")};
  const auto uncut = where(willis.models, equals(&WillisModel::depth, 0));
  panel.text = {
      "Hard cases are inputs that break programs of this kind: a door seen edge-on, a point exactly on the horizon, a cyclic "
      "overlap of surfaces. " +
          page.claim(is_wrong("J11.json", "guest"), "Jones's program misses a portal that is smaller than a point of the screen.") + " " +
          page.claim(is_wrong("S8-backwards.txt", "guest"),
                     "Skala's program draws hidden lines if slices are not sent from front to back, as the paper assumes.") +
          " " + page.claim(is_wrong("S5.csv", "native"), "The native program loses parts of upright lines.") + " " +
          page.claim(tables.cycles.back().right, "The case that Montani and Re could not solve is solved here by cutting a face.") + " " +
          page.claim(sum(uncut, &WillisModel::lines_wrong) > 0,
                     "Willis's order is wrong at some points as long as no surface is cut."),
      fmt::format("Some cases have a parameter that makes them harder until a program fails. {} of {} builds fail within the "
                  "range that was tried; the table of first failures gives the first such value of each.",
                  count(hard.first_failures, [](const FirstFailure& row) { return row.first.has_value(); }), hard.first_failures.size())};
  const CaseResult& backwards = only(hard.cases, equals(&CaseResult::input, "S8-backwards.txt"));
  if (backwards.correct)
    panel.figures.push_back(figure(*backwards.correct, "finding-hard-cases-correct", "Correct.",
                                   fmt::format("Case {}: {}.", backwards.id, backwards.what), "A few lines, those behind cut off"));
  if (backwards.wrong)
    panel.figures.push_back(figure(*backwards.wrong, "finding-hard-cases-drawn", "As drawn by the 8080.",
                                   backwards.finding("guest")->text + ".", "The same lines, none cut off"));
  page.add(std::move(panel));
}

}  // namespace sightline::report
