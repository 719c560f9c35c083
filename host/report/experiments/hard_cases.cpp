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
#include "host/compare/hard_cases/case_images.hpp"
#include "host/compare/hard_cases/run_case.hpp"

namespace sightline::report {

namespace {

using compare::Family;
using compare::FamilyResult;
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

void add_runs(RowSet& runs, const HardCaseGroup& group, const HardCase& hard) {
  const compare::CaseOutcome outcome = compare::run_case(hard, compare::case_image_side);
  const Value correct = outcome.correct ? png_picture(*outcome.correct) : Value();
  const Value wrong = outcome.found && outcome.found_is_wrong ? png_picture(*outcome.found) : Value();
  std::vector<std::pair<std::string, Value>> found;
  for (const compare::MethodOutcome& method : outcome.methods)
    found.emplace_back(method.method, method.right ? Value(Verdict{*method.right, method.text}) : Value(method.text));
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
              {"options", compare::options_of(hard)},
              {"expected", hard.expected},
              {"checked", compare::checked(hard)},
              {"method", method},
              {"column", std::move(column)},
              {"outcome", verdict == nullptr ? "none" : verdict->good ? "right" : "wrong"},
              {"found", value},
              {"correct", correct},
              {"wrong", wrong},
              {"wrong_by", wrong.missing() ? "" : outcome.found_by}});
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
