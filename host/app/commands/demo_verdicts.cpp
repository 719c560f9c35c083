// See demo_verdicts.hpp.
#include "host/app/commands/demo_verdicts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace sightline::app {
namespace {

using compare::AnswerRow;

// Of numbers the least and the greatest.
class Range {
 public:
  void add(double value) {
    low_ = any_ ? std::min(low_, value) : value;
    high_ = any_ ? std::max(high_, value) : value;
    any_ = true;
  }
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }
  // "0.06 to 1.00", or one number if both look the same.
  [[nodiscard]] std::string text(int decimals) const {
    const std::string low = fmt::format("{:.{}f}", low_, decimals);
    const std::string high = fmt::format("{:.{}f}", high_, decimals);
    return low == high ? low : low + " to " + high;
  }
  // Of seconds that are few: "6.57 us to 2.12 ms".
  [[nodiscard]] std::string times() const {
    const auto number = [](double seconds) {
      return seconds < 1e-3 ? fmt::format("{:.3g} us", seconds * 1e6) : fmt::format("{:.3g} ms", seconds * 1e3);
    };
    return number(low_) == number(high_) ? number(low_) : number(low_) + " to " + number(high_);
  }

 private:
  double low_ = 0;
  double high_ = 0;
  bool any_ = false;
};

// Of all rows of a method, a scene each.
struct MethodRange {
  Range emulated;
  Range host;
  Range wrong;  // per cent
  double farthest = 0;
  std::size_t views = 0;
  std::size_t right = 0;
};

MethodRange range_of(const DemoAnswer& answer, std::string_view method, std::string_view picture) {
  MethodRange range;
  for (const AnswerRow& row : answer.rows) {
    if (row.method != method || row.picture != picture) continue;
    if (row.emulated_seconds) range.emulated.add(row.emulated_seconds->greatest);
    if (row.host_seconds) range.host.add(row.host_seconds->greatest);
    range.wrong.add(row.exact && row.right == row.views ? 0 : row.wrong_percent.greatest);
    if (row.greatest) range.farthest = std::max(range.farthest, row.greatest->greatest);
    range.views += row.views;
    range.right += row.right;
  }
  return range;
}

// Whether all pictures are right, then what else there is to say.
std::string verdict_text(const MethodRange& range, const std::string& also = "") {
  std::string text = range.right == range.views ? fmt::format("right in {} of {}", range.right, range.views)
                                                : fmt::format("WRONG in {} of {}", range.views - range.right, range.views);
  if (!also.empty()) text += ", " + also;
  return text;
}

double drawing_seconds(const SkalaOutcome& outcome) {
  return seconds_at(core::ClockRate{}, outcome.picture.drawing);
}

Verdict jones_verdict(const DemoResults& results) {
  constexpr double a_few_seconds = 5;
  Range with;
  Range without;
  bool complete = true;
  for (const JonesRow& row : results.jones) {
    (row.eae ? with : without).add(seconds(row.view.time));
    complete = complete && row.view.status == guests::jones::Status::complete;
  }
  const MethodRange range = range_of(results.answer, "jones-pdp7", "lines");
  return {"Jones 1971 on the PDP-7",
          fmt::format("a view in {} s, {} s without the EAE (paper: \"a few seconds\"); {} % of the visible length wrong, no "
                      "point farther off than {:.1f}",
                      with.text(2), without.text(2), range.wrong.text(2), range.farthest),
          verdict_text(range, without.high() <= a_few_seconds ? "no slower than the paper" : "slower than the paper"),
          complete && range.right == range.views};
}

Verdict turn_verdict(const DemoResults& results) {
  Range frames;
  Range with;
  Range without;
  for (const TurnRow& row : results.turns) {
    frames.add(row.measure.hidden.summary.frames_per_second_mean);
    (row.eae ? with : without).add(row.measure.cost_against_wire_frame());
  }
  const MethodRange range = range_of(results.answer, "turn-pdp7", "lines");
  const auto claim = [](const Range& cost) { return cost.high() <= 1 ? "holds" : "does not"; };
  return {"Plantinga 1990 on the PDP-7",
          fmt::format("a solid turning at {} pictures a second, for {} of the wire frame's time, {} without the EAE (paper: no "
                      "more than it); no point "
                      "farther off than {:.1f}",
                      frames.text(0), with.text(2), without.text(2), range.farthest),
          verdict_text(range, fmt::format("the claim {} with the EAE, {} without", claim(with), claim(without))),
          range.right == range.views};
}

Verdict flight_verdict(const DemoResults& results) {
  constexpr double wanted = 24.95;  // 25.0 as shown
  Range frames_8;
  Range frames_16;
  Range wrong_8;
  for (const FlightRow& row : results.flights) {
    (row.bits == 8 ? frames_8 : frames_16).add(row.summary.frames_per_second_mean);
    if (row.bits == 8) wrong_8.add(100 * static_cast<double>(row.summary.wrong_orders) / static_cast<double>(row.summary.pairs));
  }
  const MethodRange range = range_of(results.answer, "willis-8080", "faces");
  return {"Willis 1977 on the 8080",
          fmt::format("flights at {} pictures a second with 8 bits, {} with 16 (paper: 25); {} % of pairs in the wrong order "
                      "with 8 bits; of single views {} % of "
                      "the points wrong",
                      frames_8.text(1), frames_16.text(1), wrong_8.text(2), range.wrong.text(3)),
          verdict_text(range, frames_8.low() >= wanted    ? "as fast as the paper wants with 8 bits"
                              : frames_8.high() >= wanted ? "with 8 bits as fast as the paper wants on one scene, else slower"
                                                          : "slower than the paper wants"),
          range.right == range.views};
}

Verdict stripes_verdict(const DemoResults& results) {
  Range drawing;
  for (const StripesDemoRow& row : results.stripes) {
    const auto& guest = row.drawn.picture.guest;
    if (!row.plotter) drawing.add(stripes_seconds(guest.receiving + guest.working()));
  }
  const MethodRange range = range_of(results.answer, "stripes-8080", "faces");
  return {
      "Montani and Re 1985 on the 8080",
      fmt::format("a picture of faces in {} s; {} % of its points wrong, those at edges", drawing.text(2), range.wrong.text(2)),
      verdict_text(range), range.right == range.views};
}

Verdict skala_verdict(const DemoResults& results) {
  constexpr double about_two_seconds = 2;
  Range lines;
  Range surfaces;
  Range contours;
  for (const SkalaDemoRow& row : results.skala.rows) {
    lines.add(drawing_seconds(row.lines));
    surfaces.add(drawing_seconds(row.surface));
    contours.add(drawing_seconds(row.contours));
  }
  const MethodRange range = range_of(results.answer, "skala-8080", "dots");
  return {"Skala 1985 on the 8080",
          fmt::format("lines in {} s (paper: about 2 s), surfaces in {} s, contours in {} s; {} % of the visible length farther "
                      "off than a dot, at most {:.1f}",
                      lines.text(2), surfaces.text(1), contours.text(1), range.wrong.text(2), range.farthest),
          lines.high() <= about_two_seconds ? "faster than the paper" : "slower than the paper", true};
}

Verdict visibility_verdict(const DemoResults& results) {
  constexpr double of_paper = 15;
  bool more = false;
  Range cost;
  for (const SkalaDemoRow& row : results.skala.rows) {
    if (!row.lines.visibility_cost) continue;
    cost.add(*row.lines.visibility_cost);
    more = more || *row.lines.visibility_cost > of_paper;
  }
  return {"Its visibility test", fmt::format("costs {} % of the time of lines (paper: about 15 %)", cost.text(0)),
          more ? "dearer than the paper says" : "no dearer than the paper says", true};
}

Verdict plotter_verdict(const DemoResults& results) {
  const guests::skala::PlotterWork& work = results.skala.plot.plotter;
  const MethodRange range = range_of(results.answer, "skala-8080 calcomp", "dots");
  double on_board = 0;
  for (const SkalaDemoRow& row : results.skala.rows)
    if (row.function == results.skala.plotted) on_board = drawing_seconds(row.lines);
  return {"Skala on the CalComp 565",
          fmt::format("{} in {:.0f} s, {} steps, {} pen lifts; of all functions no dot farther off than {:.1f}",
                      results.skala.plotted, core::in_seconds(work.time), work.steps_pen_down + work.steps_pen_up, work.pen_lifts,
                      range.farthest),
          fmt::format("{:.0f} times as long as on the board", core::in_seconds(work.time) / on_board), true};
}

// Methods written for this computer, and that they are exact, or how wrong.
Verdict exact_verdict(const DemoResults& results) {
  MethodRange all;
  std::string times;
  for (const std::string_view method : {"exact", "jones", "montani-re", "plantinga"}) {
    const MethodRange range = range_of(results.answer, method, "lines");
    all.views += range.views;
    all.right += range.right;
    times += fmt::format("{}{}{}", times.empty() ? "" : ", ", method, range.host.any() ? " " + range.host.times() : "");
  }
  return {"This computer, exact lines", times + ": the oracle's lines, not rounded", verdict_text(all), all.right == all.views};
}

Verdict rounded_verdict(const DemoResults& results) {
  struct Method {
    std::string_view name;
    std::string_view picture;
    std::string_view of;
  };
  constexpr Method methods[] = {
      {"willis", "faces", "the points"}, {"montani-re", "faces", "the points"}, {"skala", "lines", "the length"}};
  std::string text;
  MethodRange all;
  for (const Method& method : methods) {
    const MethodRange range = range_of(results.answer, method.name, method.picture);
    all.views += range.views;
    all.right += range.right;
    text += fmt::format("{}{}{}, {} % of {} wrong", text.empty() ? "" : "; ", method.name,
                        range.host.any() ? " " + range.host.times() : "", range.wrong.text(3), method.of);
  }
  return {"This computer, faces and Skala", text, verdict_text(all), all.right == all.views};
}

}  // namespace

std::vector<Verdict> verdicts_of(const DemoResults& results) {
  std::vector<Verdict> verdicts{jones_verdict(results),   turn_verdict(results),  flight_verdict(results),
                                stripes_verdict(results), skala_verdict(results), visibility_verdict(results)};
  if (const std::string why = visibility_line(results.skala); !why.empty()) verdicts.push_back({"Why not 15 %", why, "", true});
  for (const auto& verdict : {plotter_verdict, exact_verdict, rounded_verdict}) verdicts.push_back(verdict(results));
  return verdicts;
}

ThreeAnswers answers_of(const DemoResults& results) {
  Range jones;
  for (const JonesRow& row : results.jones)
    if (row.eae) jones.add(seconds(row.view.time));
  Range skala;
  for (const SkalaDemoRow& row : results.skala.rows) skala.add(drawing_seconds(row.lines));
  const MethodRange pdp7 = range_of(results.answer, "jones-pdp7", "lines");
  const MethodRange dots = range_of(results.answer, "skala-8080", "dots");
  const MethodRange exact = range_of(results.answer, "exact", "lines");
  ThreeAnswers answers;
  answers.fast = fmt::format("A view takes the PDP-7 of 1965 {} s (Jones 1971) and the 8080 of 1974 {} s (Skala 1985)",
                             jones.text(2), skala.text(2));
  answers.fast += exact.host.any() ? fmt::format("; the exact program of today takes {} on this computer.", exact.host.times())
                                   : std::string(".");
  answers.wrong = fmt::format(
      "The PDP-7 has {} % of the visible length wrong and no point farther than {:.1f} of its 1024; the 8080 has {} % farther "
      "than a "
      "dot, none farther than {:.1f} of its 256; the exact programs have nothing wrong.",
      pdp7.wrong.text(2), pdp7.farthest, dots.wrong.text(2), dots.farthest);
  answers.against =
      "All draw the same view of the same scene, and each is compared with the exact visible lines or faces of an oracle that "
      "shares no "
      "visibility code with it; what a machine's rounding moves counts as wrong.";
  return answers;
}

// Why visibility does not cost the paper's 15 %: what the test adds to a point, and how many points it hides.
std::string visibility_line(const SkalaDemo& demo) {
  struct Cost {
    std::string function;
    double plain = 0;  // T-states a point without the test
    double added = 0;
    double hidden = 0;  // per cent of the points
  };
  std::vector<Cost> costs;
  for (const SkalaDemoRow& row : demo.rows) {
    if (!row.lines.visibility_cost || row.lines.points_walked == 0) continue;
    const auto points = static_cast<double>(row.lines.points_walked);
    const double with = static_cast<double>(row.lines.picture.drawing.count()) / points;
    const double plain = with / (1 + *row.lines.visibility_cost / 100);
    costs.push_back({row.function, plain, with - plain, 100 - 100 * static_cast<double>(row.lines.points_lit) / points});
  }
  if (costs.empty()) return {};
  const auto by_added = [](const Cost& a, const Cost& b) { return a.added < b.added; };
  const auto [least, most] = std::minmax_element(costs.begin(), costs.end(), by_added);
  return fmt::format(
      "the test adds {:.0f} T-states to the {:.0f} of a point of {} ({:.0f} % are hidden, not drawn), {:.0f} to the {:.0f} "
      "of {} ({:.0f} %)",
      least->added, least->plain, least->function, least->hidden, most->added, most->plain, most->function, most->hidden);
}

}  // namespace sightline::app
