// Hard cases: inputs that break programs of this kind, with the results of every method that a case names.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/experiments/montani_re_tables.hpp"
#include "host/report/experiments/willis_order.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

// The result of a method; or the tests that check an algorithm's internals, which have no verdict.
struct CaseFinding {
  std::string method;
  std::string text;
  std::optional<bool> right;
};

struct CaseResult {
  std::string paper;
  std::string id;
  std::string input;
  std::string section;
  std::string what;
  std::string options;
  std::string expected;
  std::string checked;
  std::string commands;  // the commands that run and compare it
  std::vector<CaseFinding> findings;
  std::optional<Picture> correct;
  std::optional<Picture> wrong;  // by the first wrong method
  std::string wrong_by;

  // Null if the method was not run.
  [[nodiscard]] const CaseFinding* finding(std::string_view method) const;
};

// A case with a parameter, and a build: the first value at which it fails, and the result at each value.
struct FirstFailure {
  std::string id;
  std::string parameter;
  std::string input;
  std::string build;
  std::optional<double> first;
  Verdict what;
  std::string found;
};

// An input file of a case.
struct InputFile {
  std::string file;
  std::string text;
};

struct HardCases {
  std::vector<CaseResult> cases;
  std::vector<FirstFailure> first_failures;
  std::vector<InputFile> inputs;
};

[[nodiscard]] HardCases hard_cases(const Context& context);

void hard_cases_chapter(Page& page, const HardCases& hard);
// Of the opening page.
void finding_hard_cases(Page& page, const HardCases& hard, const MontaniReTables& tables, const WillisOrder& willis);

}  // namespace sightline::report
