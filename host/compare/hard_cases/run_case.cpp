// See run_case.hpp.
#include "host/compare/hard_cases/run_case.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "host/base/text.hpp"
#include "host/compare/hard_cases/case_input.hpp"
#include "host/programs/skala/commands.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::compare {

namespace {

bool is_grid(const HardCase& hard) { return hard.input.ends_with(".csv") || hard.input.ends_with(".dat"); }

bool is_contours(const HardCase& hard) { return hard.options.view.subject == algorithms::skala::Subject::contours; }

struct Drawn {
  std::string method;
  bool right = false;
  picture::Image image;
  std::optional<picture::Image> truth;  // empty: the correct picture of the others
};

// A method without its own reference is shown next to the oracle's picture, or to that of the first method that is
// right.
void choose_pictures(CaseOutcome& outcome, std::vector<Drawn>& drawn) {
  const auto first = [&](auto is) { return std::find_if(drawn.begin(), drawn.end(), is); };
  const auto end = drawn.end();
  auto found = first([](const Drawn& d) { return !d.right; });
  if (found == end) found = first([](const Drawn& d) { return d.method != "oracle"; });
  if (found == end) found = drawn.begin();
  if (found == end) return;
  auto correct = first([](const Drawn& d) { return d.method == "oracle" && d.right; });
  if (correct == end) correct = first([](const Drawn& d) { return d.right && !d.truth; });
  outcome.found_by = found->method;
  outcome.found_is_wrong = !found->right;
  if (found->truth)
    outcome.correct = found->truth;
  else if (correct != end)
    outcome.correct = correct->image;
  outcome.found = std::move(found->image);
}

// With the command's default view if the oracle cannot take the case's, which then has no zoom; empty if it can take
// neither.
std::string command_of_grid(const std::string& command, const HardCase& hard) {
  const auto input = load_input(hard);
  if (!input) return command;
  const auto& why_not = find_height_method("oracle")->why_not;
  algorithms::skala::View view = hard.options.view;
  view.zoom = 1;
  if (why_not(*input->heights, view)) return why_not(*input->heights, {}) ? "" : command;
  constexpr std::array families{" --along x", " --along z", " --both", ""};
  return fmt::format("{}{} --rotate {} --elevate {}", command,
                     is_contours(hard) ? fmt::format(" --picture contours --levels {}", view.levels)
                                       : std::string(families[static_cast<std::size_t>(view.family)]),
                     view.rotation, view.elevation);
}

}  // namespace

bool CaseOutcome::as_recorded() const {
  return std::all_of(methods.begin(), methods.end(), [](const MethodOutcome& method) { return method.as_recorded; });
}

CaseOutcome run_case(const HardCase& hard, int image_side) {
  CaseOutcome outcome;
  if (hard.run.empty()) return outcome;
  CaseRun run(hard, load_input(hard));
  run.enable_images(image_side);
  std::vector<Drawn> drawn;
  for (const std::string& method : hard.run) {
    Finding finding = run.run(method);
    if (finding.image && finding.good)
      drawn.push_back({method, *finding.good, std::move(*finding.image), std::move(finding.truth)});
    const auto known = hard.found.find(method);
    const bool as_recorded = known != hard.found.end() ? finding.good == false && finding.text == known->second
                             : finding.good            ? *finding.good
                                                       : finding.text.starts_with("not applicable: ");
    outcome.methods.push_back({method, finding.good, std::move(finding.text), as_recorded});
  }
  choose_pictures(outcome, drawn);
  return outcome;
}

std::string options_of(const HardCase& hard) {
  const algorithms::skala::View& view = hard.options.view;
  std::vector<std::string> options;
  if (is_grid(hard)) {
    constexpr std::array families{"x", "z", "both", "auto"};
    if (is_contours(hard))
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

std::string hard_command(const HardCase& hard) {
  const std::string id = hard.id.substr(0, hard.id.find('\''));  // M1' has the file M1-four
  return "sightline hard " + (hard.input.starts_with(id) ? hard.input.substr(0, hard.input.rfind('.')) : hard.id);
}

std::string compare_command(const HardCase& hard) {
  if (hard.input.empty() || hard.input == "octants" || hard.input.ends_with(".txt")) return "";
  if (hard.expect.refused || hard.expect.eye_refused) return "";
  const std::string stem = hard.input.substr(0, hard.input.rfind('.'));
  const std::string command = "sightline compare " + (scene::builtin_scene_text(stem) ? stem : hard.input);
  if (is_grid(hard)) return command_of_grid(command, hard);
  return hard.options.scale == 512 ? command : fmt::format("{} --scale {}", command, hard.options.scale);
}

std::string_view kind_of_commands(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  std::array<std::string_view, 4> words{};
  for (std::size_t n = 0; n < words.size() && !text.empty();) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    if (text.starts_with('#')) {
      text.remove_prefix(std::min(text.find('\n'), text.size()));
      continue;
    }
    words[n] = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(words[n++].size());
  }
  const auto is_number = [](std::string_view word, std::string_view digits) {
    return !word.empty() && word.find_first_not_of(digits) == std::string_view::npos;
  };
  const std::string_view first = words[0];
  const auto& rows = programs::skala::commands;
  if (std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.name == first; }) && is_number(words[1], "0123456789"))
    return "commands of Skala's program on the 8080";
  if ((first == "edge" || first == "vertex") && is_number(words[1], "-0123456789")) return "edges and vertices of a turn";
  if (first.size() == 1 && first[0] >= 'A' && first[0] <= 'Z' && is_number(words[1], "0123456789") && is_number(words[2], "0123456789") &&
      is_number(words[3], "01234567"))
    return "chains around regions";
  return "";
}

}  // namespace sightline::compare
