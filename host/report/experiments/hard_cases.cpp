// Hard cases: inputs that break programs of this kind. Every method that a case names has run on it.
//
//   runs      a row for each case and method: what was found, or the tests that check what is inside an algorithm;
//             the right picture and a wrong one of the case, if there are any
//   families  cases with a parameter: the first value at which each build fails, and what was found at each
//   inputs    the files
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/text.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/compare/hard_cases/first_failures.hpp"
#include "host/compare/hard_cases/manifest.hpp"
#include "host/compare/hard_cases/runner.hpp"

namespace sightline::report {

namespace {

using compare::CaseRun;
using compare::Family;
using compare::FamilyResult;
using compare::Finding;
using compare::HardCase;
using compare::HardCaseGroup;
using compare::Manifest;
using compare::SearchResult;
using compare::hard_case_text;

constexpr std::string_view manifest_file = "manifest.json";

Manifest manifest() {
  auto read = compare::read_manifest(hard_case_text(manifest_file), manifest_file);
  if (!read) throw Failure(ErrorKind::bad_input, read.error().message());
  return std::move(*read);
}

// Of a grid and of Willis's, in the words of the commands' options.
std::string options_of(const HardCase& hard) {
  const registry::HeightView& view = hard.options.view;
  std::vector<std::string> options;
  if (hard.input.ends_with(".csv") || hard.input.ends_with(".dat")) {
    constexpr std::array families{"x", "z", "both", "auto"};
    if (view.subject == algorithms::skala::Subject::contours)
      options.push_back(fmt::format("{} contours", view.levels));
    else
      options.push_back(fmt::format("family {}", families[static_cast<std::size_t>(view.family)]));
    options.push_back(fmt::format("rotation {}, elevation {}", view.rotation, view.elevation));
    if (view.zoom != 1) options.push_back(fmt::format("zoom {}", view.zoom));
  }
  if (hard.options.faces.plan) options.emplace_back("plan");
  if (hard.options.faces.oval) options.emplace_back("ovals");
  if (hard.options.faces.rule90) options.emplace_back("90-degree rule");
  if (hard.options.faces.one_silhouette) options.emplace_back("one silhouette");
  if (!hard.options.faces.order_cells) options.emplace_back("distance alone");
  if (hard.options.scale != 512) options.push_back(fmt::format("S = {}", hard.options.scale));
  return base::joined(options, ", ");
}

// Pictures of a case: the right one, and that of the first method that is wrong.
struct CasePictures {
  Value correct;
  Value wrong;
  std::string wrong_by;

  void take(const std::string& method, const Finding& finding) {
    const bool right = finding.good.value_or(false);
    if (finding.truth && correct.missing()) correct = png_picture(*finding.truth);
    // An oracle's picture is taken in place of an earlier one.
    if (finding.image && right && (correct.missing() || method == "oracle")) correct = png_picture(*finding.image);
    if (finding.image && finding.good && !right && wrong.missing()) {
      wrong = png_picture(*finding.image);
      wrong_by = method;
    }
  }
};

void add_runs(RowSet& runs, const HardCaseGroup& group, const HardCase& hard) {
  CasePictures pictures;
  std::vector<std::pair<std::string, Value>> found;
  std::optional<CaseRun> run;
  if (!hard.run.empty()) {
    run.emplace(hard, compare::load_input(hard));
    run->with_images();
  }
  for (const std::string& method : hard.run) {
    const Finding finding = run->run(method);
    pictures.take(method, finding);
    found.emplace_back(method, finding.good ? Value(Verdict{*finding.good, finding.text}) : Value(finding.text));
  }
  if (!hard.tests.empty()) found.emplace_back("tests", base::joined(hard.tests, ", "));
  for (const auto& [method, value] : found) {
    std::string column = method;
    std::replace(column.begin(), column.end(), '-', '_');
    const auto* const verdict = std::get_if<Verdict>(&value.kind());
    runs.add({{"paper", group.id},
              {"case", hard.id},
              {"input", hard.input},
              {"section", hard.section},
              {"what", hard.what},
              {"options", options_of(hard)},
              {"expected", hard.expected},
              {"checked", compare::checked(hard)},
              {"method", method},
              {"column", std::move(column)},
              {"outcome", verdict == nullptr ? "none" : verdict->good ? "right" : "wrong"},
              {"found", value},
              {"correct", pictures.correct},
              {"wrong", pictures.wrong},
              {"wrong_by", pictures.wrong_by}});
  }
}

// "2: 1, 4: 2"
std::string tried_text(const SearchResult& search) {
  std::vector<std::string> parts;
  for (const auto& [value, trial] : search.tried)
    if (trial.measure)
      parts.push_back(fmt::format("{:g}: {:.3g}", trial.shown.value_or(value), *trial.measure));
  return base::joined(parts, ", ");
}

void add_family(RowSet& families, const Family& family) {
  const auto results = compare::run_family(family);
  if (!results) throw Failure(ErrorKind::bad_input, results.error().message());
  for (const FamilyResult& result : *results) {
    const SearchResult& search = result.search;
    Value first;
    const auto shown = [](const auto& tried) { return tried.second.shown.value_or(tried.first); };
    const bool falls = family.values.back() < family.values.front();
    Verdict verdict{true, fmt::format("none {} to {:g}", falls ? "down" : "up", shown(search.tried.back()))};
    if (search.first) {
      const auto& [value, trial] = search.tried[*search.first];
      first = trial.shown.value_or(value);
      verdict = {false, *trial.fault};
    }
    families.add({{"case", family.id},
                  {"parameter", family.parameter},
                  {"input", family.input},
                  {"build", result.build},
                  {"first_failure", std::move(first)},
                  {"what", verdict},
                  {"found", tried_text(search)}});
  }
}

// "J5-strip.json" is "input-j5-strip-json".
std::string listing_id(std::string_view file) {
  std::string id = "input-";
  for (const char c : file)
    id += c == '.' ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return id;
}

// Every file of a case once, in the order of the cases; a model is one of the program's own scenes.
RowSet inputs_of(const Manifest& manifest) {
  RowSet inputs({"id", "file", "text"});
  std::vector<std::string_view> listed;
  for (const HardCaseGroup& group : manifest.groups) {
    for (const HardCase& hard : group.cases) {
      const std::string_view text = hard_case_text(hard.input);
      if (text.empty() || std::find(listed.begin(), listed.end(), hard.input) != listed.end()) continue;
      listed.push_back(hard.input);
      inputs.add({{"id", listing_id(hard.input)}, {"file", hard.input}, {"text", text}});
    }
  }
  return inputs;
}

}  // namespace

Records hard_cases(const Context& context) {
  const Manifest read = manifest();
  Records records;
  for (const HardCaseGroup& group : read.groups) {
    for (const HardCase& hard : group.cases) {
      context.progress(fmt::format("hard case {} {}", hard.id, hard.input));
      add_runs(records["runs"], group, hard);
    }
  }
  for (const Family& family : read.families) {
    context.progress(fmt::format("hard case {}: first failures", family.id));
    add_family(records["families"], family);
  }
  records["inputs"] = inputs_of(read);
  return records;
}

}  // namespace sightline::report
