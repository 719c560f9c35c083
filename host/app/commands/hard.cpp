// `sightline hard`: runs the inputs that break programs of this kind, by every method that they name.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/outputs.hpp"
#include "host/base/json.hpp"
#include "host/base/nearest_name.hpp"
#include "host/base/progress.hpp"
#include "host/base/text.hpp"
#include "host/base/text_table.hpp"
#include "host/compare/hard_cases/case_images.hpp"
#include "host/compare/hard_cases/first_failures.hpp"
#include "host/compare/hard_cases/manifest.hpp"
#include "host/compare/hard_cases/run_case.hpp"

namespace sightline::app {

namespace {

using base::Json;
using compare::CaseOutcome;
using compare::FamilyResult;
using compare::HardCase;
using compare::MethodOutcome;

constexpr int picture_side = 480;  // pixels

struct HardArguments {
  std::vector<std::string> cases;
  bool list = false;
  bool json = false;
  std::string directory;
};

struct GroupedCase {
  std::string group;
  HardCase hard;
};

struct Selection {
  std::vector<GroupedCase> cases;
  std::vector<compare::Family> families;
};

std::string stem_of(const std::string& file) { return file.substr(0, file.rfind('.')); }

// Whether `name` is the case's number, "J5", or a file of its inputs, "J5-strip" or "J5-strip.json".
bool is_called(const HardCase& hard, const std::string& name) {
  return hard.id == name || (!hard.input.empty() && (hard.input == name || stem_of(hard.input) == name));
}

Selection choose(const compare::Manifest& manifest, const std::vector<std::string>& names) {
  Selection chosen;
  std::vector<std::string> known;
  for (const auto& group : manifest.groups)
    for (const HardCase& hard : group.cases) {
      known.push_back(hard.id);
      chosen.cases.push_back({group.id, hard});
    }
  chosen.families = manifest.families;
  for (const compare::Family& family : chosen.families) known.push_back(family.id);
  if (names.empty()) return chosen;
  std::set<std::string> ids;
  for (const std::string& name : names) {
    const auto is_meant = [&](const GroupedCase& one) { return is_called(one.hard, name); };
    if (std::find(known.begin(), known.end(), name) != known.end()) {
      ids.insert(name);
    } else if (std::none_of(chosen.cases.begin(), chosen.cases.end(), is_meant)) {
      const std::string nearest = base::did_you_mean(name, known);
      throw base::usage_error(fmt::format("CASE: found \"{}\", expected a case of `sightline hard --list`{}{}", name,
                                                 nearest.empty() ? "" : "; ", nearest));
    }
  }
  const auto is_chosen = [&](const GroupedCase& one) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return is_called(one.hard, name); });
  };
  std::erase_if(chosen.cases, [&](const GroupedCase& one) { return !is_chosen(one); });
  std::erase_if(chosen.families, [&](const compare::Family& family) { return !ids.contains(family.id); });
  return chosen;
}

// --- pictures and inputs

// Makes unique file names: the name of the input, with the case's number in front unless it begins with that.
class FileNames {
 public:
  std::string unused(const HardCase& hard) {
    const std::string stem = stem_of(hard.input);
    const std::string id = hard.id.substr(0, hard.id.find('\''));  // M1' is M1
    const std::string name = stem.starts_with(id) ? stem : id + "-" + stem;
    std::string free = name;
    for (int n = 2; !used_.insert(free).second; ++n) free = fmt::format("{}-{}", name, n);
    return free;
  }

 private:
  std::set<std::string> used_;
};

// Writes the input and the picture; returns the paths.
std::vector<std::string> write_files(const std::string& directory, const HardCase& hard, const CaseOutcome& outcome,
                                     FileNames& names) {
  const auto path_of = [&](const std::string& name) { return (std::filesystem::path(directory) / name).string(); };
  std::vector<std::string> paths;
  if (const std::string_view text = compare::hard_case_text(hard.input); !text.empty()) {
    Output input(paths.emplace_back(path_of(hard.input)));
    input.write(text);
    input.commit();
  }
  if (outcome.found && outcome.correct) {
    Output picture(paths.emplace_back(path_of(names.unused(hard) + ".png")));
    write_png(picture, compare::side_by_side(*outcome.correct, *outcome.found, outcome.found_by),
              {{"Title", fmt::format("{}: {}", hard.id, hard.what)}, {"Software", "sightline"}});
    picture.commit();
  }
  return paths;
}

// --- texts

// The name of a method in the output: "emulated" or "in C++" for the two builds of a program, else its own name.
std::string shown_method(std::string_view method) {
  for (const auto& [name, shown] : {std::pair{"guest", "emulated"}, std::pair{"twin", "in C++"}})
    if (method.substr(0, method.find(',')) == name) return shown + std::string(method.substr(std::string_view(name).size()));
  return std::string(method);
}

std::string verdict_of(const MethodOutcome& method) {
  if (method.as_recorded && method.right == false) return method.text + " (as recorded)";
  return method.as_recorded ? method.text : method.text + " -- NOT AS RECORDED";
}

// "4 right", "2 right, wrong as recorded: emulated, in C++".
std::string summary_of(const HardCase& hard, const CaseOutcome& outcome) {
  std::size_t right = 0;
  std::size_t none = 0;
  std::vector<std::string> wrong;
  std::vector<std::string> otherwise;
  for (const MethodOutcome& method : outcome.methods) {
    if (!method.as_recorded)
      otherwise.push_back(shown_method(method.method) + ": " + method.text);
    else if (!method.right)
      ++none;
    else if (*method.right)
      ++right;
    else
      wrong.push_back(shown_method(method.method));
  }
  std::vector<std::string> parts;
  if (right != 0) parts.push_back(fmt::format("{} right", right));
  if (none != 0) parts.push_back(fmt::format("{} not applicable", none));
  if (!wrong.empty()) parts.push_back("wrong as recorded: " + base::joined(wrong, ", "));
  if (!otherwise.empty()) parts.push_back("NOT AS RECORDED: " + base::joined(otherwise, "; "));
  if (hard.run.empty()) parts.emplace_back("by tests only");
  return base::joined(parts, ", ");
}

std::string case_text(const GroupedCase& one, const CaseOutcome& outcome, const std::vector<std::string>& paths) {
  const HardCase& hard = one.hard;
  base::TextTable table({-12, 0});
  const auto add = [&](std::string_view title, const std::string& text) {
    if (!text.empty()) table.row({title, text});
  };
  table.line(fmt::format("{} ({}{}{}): {}", hard.id, one.group, hard.input.empty() ? "" : ", ", hard.input, hard.what));
  add("options", compare::options_of(hard));
  add("expected", hard.expected);
  add("checked", compare::checks_of(hard));
  for (const MethodOutcome& method : outcome.methods) table.row({shown_method(method.method), verdict_of(method)});
  add("tests", base::joined(hard.tests, ", "));
  add("compare", compare::compare_command(hard));
  for (const std::string& path : paths) table.row({"written", path});
  return table.text();
}

bool as_recorded(const std::vector<FamilyResult>& results) {
  return std::all_of(results.begin(), results.end(), [](const FamilyResult& result) { return result.as_recorded; });
}

std::string first_failure_text(const compare::Family& family, const FamilyResult& result) {
  const auto shown = [](const auto& tried) { return tried.second.shown.value_or(tried.first); };
  const auto& search = result.search;
  std::string text = search.first ? fmt::format("{:g}: {}", shown(search.tried[*search.first]), *search.tried[*search.first].second.fault)
                                  : fmt::format("none {} to {:g}", family.values.back() < family.values.front() ? "down" : "up",
                                                shown(search.tried.back()));
  return result.as_recorded ? text : text + " -- NOT AS RECORDED";
}

std::string family_text(const compare::Family& family, const std::vector<FamilyResult>& results) {
  base::TextTable table({-34, 0});
  table.line(fmt::format("{}: {}; the first {} at which a build fails", family.id, family.input, family.parameter));
  for (const FamilyResult& result : results) table.row({"  " + shown_method(result.build), first_failure_text(family, result)});
  return table.text();
}

// --- JSON

Json case_json(const GroupedCase& one) {
  const HardCase& hard = one.hard;
  return {{"id", hard.id},           {"group", one.group},
          {"input", hard.input},     {"section", hard.section},
          {"what", hard.what},       {"options", compare::options_of(hard)},
          {"expected", hard.expected}, {"checked", compare::checks_of(hard)},
          {"tests", hard.tests},     {"compare", compare::compare_command(hard)}};
}

Json methods_json(const CaseOutcome& outcome) {
  Json list = Json::array();
  for (const MethodOutcome& method : outcome.methods) {
    Json row{{"name", method.method}, {"found", method.text}, {"as_recorded", method.as_recorded}};
    row["right"] = method.right ? Json(*method.right) : Json();
    list.push_back(std::move(row));
  }
  return list;
}

Json family_json(const compare::Family& family, const std::vector<FamilyResult>& results) {
  Json json{{"id", family.id}, {"parameter", family.parameter}, {"input", family.input}, {"builds", Json::array()}};
  for (const FamilyResult& result : results) {
    Json row{{"name", result.build}, {"as_recorded", result.as_recorded}, {"first_failure", Json()}};
    if (result.search.first) {
      const auto& [value, trial] = result.search.tried[*result.search.first];
      row["first_failure"] = trial.shown.value_or(value);
      row["found"] = *trial.fault;
    }
    json["builds"].push_back(std::move(row));
  }
  return json;
}

// --- the command

ExitCode list_cases(const Selection& chosen, bool json) {
  if (json) {
    Json document{{"schema", "sightline/hard/1"}, {"cases", Json::array()}};
    for (const GroupedCase& one : chosen.cases) document["cases"].push_back(case_json(one));
    print_json(document);
    return ExitCode::ok;
  }
  base::TextTable table({-5, -11, 0});
  for (const GroupedCase& one : chosen.cases)
    table.row({one.hard.id, one.group, fmt::format("{}{}", one.hard.what, one.hard.input.empty() ? "" : " [" + one.hard.input + "]")});
  for (const compare::Family& family : chosen.families)
    table.row({family.id, "parameter", fmt::format("{}: {}", family.input, family.parameter)});
  write_stdout(table.text());
  return ExitCode::ok;
}

ExitCode run_hard(const HardArguments& arguments) {
  const compare::Manifest manifest = value_of(compare::read_manifest(compare::hard_case_text("manifest.json"), "manifest.json"), "manifest.json");
  const Selection chosen = choose(manifest, arguments.cases);
  if (arguments.list) return list_cases(chosen, arguments.json);
  if (!arguments.directory.empty()) make_directory(arguments.directory);
  const bool whole = !arguments.cases.empty();
  Json document{{"schema", "sightline/hard/1"}, {"as_recorded", true}, {"cases", Json::array()}, {"families", Json::array()}};
  std::vector<std::string> otherwise;
  FileNames names;
  base::TextTable lines({-5, -20, 0});
  std::string texts;
  {
    const std::size_t count = chosen.cases.size() + chosen.families.size();
    std::size_t done = 0;
    base::ProgressLine progress;
    for (const GroupedCase& one : chosen.cases) {
      progress.show(fmt::format("{} of {}: {} {}", ++done, count, one.hard.id, one.hard.input));
      const CaseOutcome outcome = compare::run_case(one.hard, arguments.directory.empty() ? 0 : picture_side);
      if (!outcome.as_recorded()) otherwise.push_back(one.hard.id);
      std::vector<std::string> paths;
      if (!arguments.directory.empty()) paths = write_files(arguments.directory, one.hard, outcome, names);
      Json row = case_json(one);
      row["methods"] = methods_json(outcome);
      row["files"] = paths;
      document["cases"].push_back(std::move(row));
      if (whole) texts += (texts.empty() ? "" : "\n") + case_text(one, outcome, paths);
      else lines.row({one.hard.id, one.hard.input, summary_of(one.hard, outcome)});
    }
    for (const compare::Family& family : chosen.families) {
      progress.show(fmt::format("{} of {}: {}, first failures", ++done, count, family.id));
      const auto results = value_of(compare::run_family(family), "manifest.json");
      if (!as_recorded(results)) otherwise.push_back(family.id);
      document["families"].push_back(family_json(family, results));
      texts += (texts.empty() && whole ? "" : "\n") + family_text(family, results);
    }
  }
  document["as_recorded"] = otherwise.empty();
  if (arguments.json) print_json(document);
  else write_stdout(lines.text() + texts);
  if (!arguments.json && !whole)
    write_stdout(fmt::format("\n{} cases and {} searches for a first failure, {}\n", chosen.cases.size(), chosen.families.size(),
                             otherwise.empty() ? "all as recorded" : fmt::format("{} NOT AS RECORDED", otherwise.size())));
  if (otherwise.empty()) return ExitCode::ok;
  print_message(fmt::format("not as their entries say: {}", base::joined(otherwise, ", ")));
  return ExitCode::differs;
}

}  // namespace

void add_hard_command(const Command& program) {
  const Command command = program.add_command("hard", help_page("hard"));
  const auto arguments = std::make_shared<HardArguments>();
  command.option("CASE", arguments->cases, "Cases by number, or by the file of an input").default_value("all of them");
  command.flag("--list", arguments->list, "List the cases, without running them: number, method, what is hard");
  command.option("-o,--output", arguments->directory, "Folder for the inputs, and for a picture of each case: expected, found, what differs")
      .value("DIR");
  command.flag("--json", arguments->json, "One JSON document instead of the text");
  command.run([arguments] { return run_hard(*arguments); });
}

}  // namespace sightline::app
