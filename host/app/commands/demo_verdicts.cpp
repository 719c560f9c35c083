#include "host/app/commands/demo_verdicts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "host/base/number.hpp"
#include "host/compare/scenes.hpp"
#include "host/compare/skala_8080.hpp"
#include "host/compare/stripes.hpp"

namespace sightline::app {
namespace {

using compare::AnswerRow;

// The least and the greatest of a set of numbers.
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
  // "0.06 to 1.00", or one number if both are printed alike.
  [[nodiscard]] std::string text(int decimals) const {
    const std::string low = fmt::format("{:.{}f}", low_, decimals);
    const std::string high = fmt::format("{:.{}f}", high_, decimals);
    return low == high ? low : low + " to " + high;
  }
  // For seconds: "6.57 us to 2.12 ms".
  [[nodiscard]] std::string times() const {
    const std::string low = base::time_text(low_);
    const std::string high = base::time_text(high_);
    return low == high ? low : low + " to " + high;
  }

 private:
  double low_ = 0;
  double high_ = 0;
  bool any_ = false;
};

// The range over all rows of a method, one row per scene.
struct MethodRange {
  Range emulated;
  Range host;
  Range wrong;  // per cent
  double far = 0;  // the greatest part farther than a point in any row
  double farthest = 0;
  bool defect = false;
  std::size_t views = 0;
  std::size_t right = 0;

  [[nodiscard]] bool all_right() const { return right == views; }
};

MethodRange range_of(const DemoAnswer& answer, std::string_view method, std::string_view picture) {
  MethodRange range;
  for (const AnswerRow& row : answer.rows) {
    if (row.method != method || row.picture != picture) continue;
    if (row.emulated_seconds) range.emulated.add(row.emulated_seconds->greatest);
    if (row.host_seconds) range.host.add(row.host_seconds->greatest);
    range.wrong.add(row.exact && row.right == row.views ? 0 : row.wrong_percent.greatest);
    range.far = std::max(range.far, row.far.greatest);
    if (row.greatest) range.farthest = std::max(range.farthest, row.greatest->greatest);
    range.defect = range.defect || !row.defect.empty();
    range.views += row.views;
    range.right += row.right;
  }
  return range;
}

// The native methods that are exact.
constexpr std::array<std::string_view, 4> exact_methods{"exact", "jones", "montani-re", "plantinga"};

// Says whether all pictures are right, and appends `also`.
std::string verdict_text(const MethodRange& range, const std::string& also = "") {
  std::string text = range.all_right() ? fmt::format("right in {} of {}", range.right, range.views)
                                       : fmt::format("WRONG in {} of {}", range.views - range.right, range.views);
  if (!also.empty()) text += ", " + also;
  return text;
}

double drawing_seconds(const programs::skala::Outcome& outcome) {
  return core::in_seconds(outcome.picture.drawing);
}

Verdict jones_verdict(const DemoResults& results) {
  constexpr double a_few_seconds = 5;
  Range with;
  Range without;
  bool complete = true;
  for (const JonesRow& row : results.jones) {
    (row.eae ? with : without).add(core::in_seconds(row.view.time));
    complete = complete && row.view.status == programs::jones::Status::complete;
  }
  const MethodRange range = range_of(results.answer, compare::jones_pdp7_name, "lines");
  return {"Jones 1971 on the PDP-7",
          fmt::format("a view in {} s, {} s without the EAE (paper: \"a few seconds\"); up to {:.2f} % different along lines, "
                      "points up to {:.1f} beside",
                      with.text(2), without.text(2), range.wrong.high(), range.farthest),
          verdict_text(range, without.high() <= a_few_seconds ? "" : "slower than the paper"), complete && range.all_right()};
}

Verdict turn_verdict(const DemoResults& results) {
  Range frames;
  Range with;
  Range without;
  for (const TurnRow& row : results.turns) {
    frames.add(row.outcome.hidden.summary.frames_per_second_mean);
    (row.eae ? with : without).add(row.outcome.cost_against_wire_frame());
  }
  const MethodRange range = range_of(results.answer, "turn-pdp7", "lines");
  const bool holds_with = with.high() <= 1;
  const bool holds_without = without.high() <= 1;
  return {"Plantinga 1990 on the PDP-7",
          fmt::format("full turns at {} pictures a second, in up to {:.2f} of a wire frame's time, {:.2f} without the EAE (paper: 1)",
                      frames.text(0), with.high(), without.high()),
          verdict_text(range, holds_with && holds_without ? "as the paper"
                              : holds_with                ? "as the paper with the EAE"
                                                          : "slower than the paper"),
          range.all_right()};
}

Verdict circle_verdict(const DemoResults& results) {
  MethodRange range;
  std::string text;
  for (const CircleRow& row : results.circles) {
    range.views += static_cast<std::size_t>(row.frames);
    range.right += static_cast<std::size_t>(row.right);
    text += fmt::format("{}{} {} ({} events)", text.empty() ? "" : ", ", row.model, row.view, row.events);
  }
  return {"Plantinga 1990 on this computer", text, verdict_text(range), range.all_right()};
}

Verdict flight_verdict(const DemoResults& results) {
  constexpr double wanted = 25;
  constexpr double noise = 1e-9;  // rounding error of a mean of quotients
  Range frames_8;
  Range frames_16;
  Range wrong_8;
  std::size_t flights = 0;
  std::size_t fast = 0;
  for (const FlightRow& row : results.flights) {
    (row.bits == 8 ? frames_8 : frames_16).add(row.summary.frames_per_second_mean);
    if (row.bits != 8) continue;
    wrong_8.add(100 * static_cast<double>(row.summary.wrong_orders) / static_cast<double>(row.summary.pairs));
    ++flights;
    fast += row.summary.frames_per_second_mean >= wanted - noise ? 1U : 0U;
  }
  const MethodRange range = range_of(results.answer, "willis-8080", "faces");
  return {"Willis 1977 on the 8080",
          fmt::format("{} pictures/s (paper: 25), up to {:.2f} % of pairs out of order, in 8 bits; {} in 16",
                      frames_8.text(1), wrong_8.high(), frames_16.text(1)),
          "still views " + verdict_text(range, fmt::format("as fast in {} of {} flights", fast, flights)), range.all_right()};
}

Verdict stripes_verdict(const DemoResults& results) {
  Range drawing;
  for (const StripesDemoRow& row : results.stripes) {
    const programs::stripes::MachinePicture& picture = row.drawn.picture;
    if (!row.plotter && !row.antialias) drawing.add(core::in_seconds(picture.receiving + picture.working()));
  }
  const MethodRange range = range_of(results.answer, compare::stripes_name, "faces");
  const MethodRange pen = range_of(results.answer, fmt::format("{} pen", compare::stripes_name), "lines");
  return {"Montani and Re 1985 on the 8080",
          fmt::format("faces in {} s, up to {:.2f} % of points different{}; plotted in {} s, no step farther off than {:.1f}",
                      drawing.text(2), range.wrong.high(), range.far == 0 ? ", all at edges" : "", pen.emulated.text(0),
                      pen.farthest),
          verdict_text(range, pen.all_right() ? "" : "WRONG on the plotter"), range.all_right() && pen.all_right()};
}

// Whether lines on a device agree with the twin and are no farther from the reference than its dots or steps explain.
bool within_dots(const MethodRange& range, programs::skala::Device device) {
  compare::SkalaInk ink;
  ink.kind = algorithms::skala::Subject::lines;
  ink.device = device;
  const compare::InkBounds bounds = compare::ink_bounds(ink);
  return !range.defect && range.farthest <= std::max(bounds.of_ink, bounds.of_lines.value_or(0));
}

Verdict skala_verdict(const DemoResults& results) {
  constexpr double about_two_seconds = 2;
  Range lines;
  Range others;
  for (const SkalaDemoRow& row : results.skala.rows) {
    lines.add(drawing_seconds(row.lines));
    others.add(drawing_seconds(row.surface));
    others.add(drawing_seconds(row.contours));
  }
  const MethodRange range = range_of(results.answer, "skala-8080", "dots");
  const bool right = within_dots(range, programs::skala::Device::ef9365);
  return {"Skala 1985 on the 8080",
          fmt::format("lines in {} s (paper: about 2 s), other pictures in {} s; up to {:.2f} % over a dot off, at most {:.1f}{}",
                      lines.text(2), others.text(1), range.wrong.high(), range.farthest, right ? ", by rounding" : ""),
          fmt::format("{}lines {} than the paper", right ? "" : "WRONG, ", lines.high() <= about_two_seconds ? "faster" : "slower"), right};
}

Verdict visibility_verdict(const DemoResults& results) {
  constexpr double of_paper = 15;
  bool more = false;
  Range cost;
  for (const SkalaDemoRow& row : results.skala.rows) {
    if (!row.lines.visibility_cost()) continue;
    cost.add(*row.lines.visibility_cost());
    more = more || *row.lines.visibility_cost() > of_paper;
  }
  return {"Its visibility test", fmt::format("costs {} % of the time of lines (paper: about 15 %)", cost.text(0)),
          more ? "dearer than the paper says" : "no dearer than the paper says"};
}

Verdict plotter_verdict(const DemoResults& results) {
  const programs::skala::PlotterWork& work = results.skala.plot.plotter;
  const MethodRange range = range_of(results.answer, "skala-8080 calcomp", "dots");
  double on_board = 0;
  for (const SkalaDemoRow& row : results.skala.rows)
    if (row.function == results.skala.plotted) on_board = drawing_seconds(row.lines);
  const bool right = within_dots(range, programs::skala::Device::calcomp);
  return {"Skala on the CalComp 565",
          fmt::format("{} in {:.0f} s, {} steps, {} pen lifts; of all functions no dot farther off than {:.1f}",
                      results.skala.plotted, core::in_seconds(work.time), work.steps_pen_down + work.steps_pen_up, work.pen_lifts,
                      range.farthest),
          fmt::format("{}{:.0f} times as long as on the board", right ? "" : "WRONG, ", core::in_seconds(work.time) / on_board),
          right};
}

MethodRange exact_range(const DemoResults& results) {
  MethodRange all;
  for (const std::string_view method : exact_methods) {
    const MethodRange range = range_of(results.answer, method, "lines");
    all.views += range.views;
    all.right += range.right;
  }
  return all;
}

// Methods written for this computer: that they are exact, or their error.
Verdict exact_verdict(const DemoResults& results) {
  std::string times;
  for (const std::string_view method : exact_methods) {
    const MethodRange range = range_of(results.answer, method, "lines");
    times += fmt::format("{}{}{}", times.empty() ? "" : ", ", method, range.host.any() ? " " + range.host.times() : "");
  }
  const MethodRange all = exact_range(results);
  return {"This computer, exact lines", times + ", not rounded", verdict_text(all), all.all_right()};
}

Verdict rounded_verdict(const DemoResults& results) {
  constexpr std::pair<std::string_view, std::string_view> methods[] = {
      {"willis", "faces"}, {"montani-re", "faces"}, {"skala", "lines"}};
  std::string text;
  MethodRange all;
  for (const auto& [method, picture] : methods) {
    const MethodRange range = range_of(results.answer, method, picture);
    all.views += range.views;
    all.right += range.right;
    text += fmt::format("{}{}{}, {:.3f} %", text.empty() ? "" : "; ", method,
                        range.host.any() ? " " + range.host.times() : "", range.wrong.high());
  }
  return {"This computer, faces and Skala", text + " different at most", verdict_text(all), all.all_right()};
}

}  // namespace

std::vector<Verdict> verdicts_of(const DemoResults& results) {
  std::vector<Verdict> verdicts{jones_verdict(results),   turn_verdict(results),  flight_verdict(results),
                                stripes_verdict(results), skala_verdict(results), visibility_verdict(results)};
  if (const std::string why = visibility_line(results.skala); !why.empty()) verdicts.push_back({"Why not 15 %", why, ""});
  for (const auto& verdict : {plotter_verdict, circle_verdict, exact_verdict, rounded_verdict}) verdicts.push_back(verdict(results));
  return verdicts;
}

ThreeAnswers answers_of(const DemoResults& results) {
  Range jones;
  for (const JonesRow& row : results.jones)
    if (row.eae) jones.add(core::in_seconds(row.view.time));
  Range skala;
  for (const SkalaDemoRow& row : results.skala.rows) skala.add(drawing_seconds(row.lines));
  const MethodRange pdp7 = range_of(results.answer, compare::jones_pdp7_name, "lines");
  const MethodRange dots = range_of(results.answer, "skala-8080", "dots");
  const MethodRange exact = range_of(results.answer, "exact", "lines");
  const MethodRange all_exact = exact_range(results);
  ThreeAnswers answers;
  answers.fast = fmt::format("A view takes the PDP-7 of 1965 {} s (Jones 1971) and the 8080 of 1974 {} s (Skala 1985)",
                             jones.text(2), skala.text(2));
  answers.fast += exact.host.any() ? fmt::format("; the exact program of today takes {} on this computer.", exact.host.times())
                                   : std::string(".");
  answers.wrong = fmt::format(
      "The PDP-7 has {} % of the visible length different and no lit point farther than {:.1f} of its 1024; of lines of the 8080 {} % are farther "
      "than a dot, none farther than {:.1f} of its 256; the exact programs {}.",
      pdp7.wrong.text(2), pdp7.farthest, dots.wrong.text(2), dots.farthest,
      all_exact.all_right() ? std::string("have nothing different")
                            : fmt::format("are wrong in {} of {} views", all_exact.views - all_exact.right, all_exact.views));
  answers.against =
      "In each scene all draw the same view, and each is compared with the exact visible lines or faces of an oracle that "
      "shares no "
      "visibility code with it; what a machine's rounding moves counts as different, and as wrong if it is more than a point away.";
  return answers;
}

// Why visibility does not cost the 15 % of the paper: the time that the test adds per point, and the share of points that it hides.
std::string visibility_line(const SkalaDemo& demo) {
  struct Cost {
    std::string function;
    double plain = 0;  // T-states per point without the test
    double added = 0;
    double hidden = 0;  // per cent of all points
  };
  std::vector<Cost> costs;
  for (const SkalaDemoRow& row : demo.rows) {
    if (!row.lines.visibility_cost() || row.lines.points_walked == 0) continue;
    const auto points = static_cast<double>(row.lines.points_walked);
    const double with = static_cast<double>(row.lines.picture.drawing.count()) / points;
    const double plain = with / (1 + *row.lines.visibility_cost() / 100);
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
