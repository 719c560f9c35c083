// See run_outputs.hpp.
#include "host/app/commands/run_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "host/app/outputs.hpp"
#include "host/picture/crisp_raster.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/svg.hpp"

namespace sightline::app {

namespace {

// The exposure that the photograph's parameters are set for.
constexpr core::Duration shutter_time = core::milliseconds(200);

std::vector<std::uint8_t> seven_bits(std::vector<std::uint8_t> codes) {
  for (std::uint8_t& code : codes) code &= 0177U;
  return codes;
}

}  // namespace

RunOutputs::RunOutputs(const RunArguments& arguments) {
  const std::array<NamedOutput, 8> files{{{&arguments.dump, &dump_},
                                          {&arguments.trace, &trace_},
                                          {&arguments.strokes, &strokes_},
                                          {&arguments.png, &png_},
                                          {&arguments.svg, &svg_},
                                          {&arguments.phosphor, &phosphor_},
                                          {&arguments.punch, &punch_},
                                          {&arguments.teletype, &teletype_}}};
  uses_stdout_ = open_outputs(files, arguments.json);
}

void RunOutputs::attach(harness::Pdp7Job& job) {
  if (trace_) job.trace = [this](std::string_view text) { trace_->write(text); };
  if (!strokes_ && !png_ && !svg_ && !phosphor_) return;
  harness::Screen::Wishes wishes;
  wishes.picture = png_ || svg_;
  wishes.photograph = phosphor_.has_value();
  if (strokes_) wishes.log = [this](std::string_view text) { strokes_->write(text); };
  screen_ = std::make_unique<harness::Screen>(std::move(wishes));
  job.screen = screen_.get();
}

void RunOutputs::write(const harness::Pdp7Report& report) {
  if (dump_) dump_->write(harness::dump_text(report));
  if (punch_) punch_->write(std::span<const std::uint8_t>(report.punched));
  if (teletype_) teletype_->write(std::span<const std::uint8_t>(seven_bits(report.printed)));
  if (png_ || svg_) write_picture(report);
  if (phosphor_) write_photograph(report);
  for (auto* output : {&dump_, &trace_, &strokes_, &png_, &svg_, &phosphor_, &punch_, &teletype_}) {
    if (*output) (*output)->commit();
  }
}

void RunOutputs::write_picture(const harness::Pdp7Report& report) {
  const auto strokes = screen_->picture_strokes();
  std::string shown = "the last complete pass";
  if (!screen_->has_complete_pass()) {
    shown = strokes.empty() ? "nothing, no point was lit"
                            : fmt::format("no complete pass; the {} newest points", strokes.size());
    warn("the picture shows " + shown);
  }
  const std::string made_at = fmt::format("{} ns of emulated time", core::nanoseconds_of(report.end));
  if (png_) {
    write_png(*png_, picture::crisp_raster(strokes),
              {{"Software", "sightline " SIGHTLINE_VERSION}, {"Shown", shown}, {"End of run", made_at}});
  }
  if (svg_) svg_->write(picture::svg_drawing(strokes, "Type 340: " + shown));
}

void RunOutputs::write_photograph(const harness::Pdp7Report& report) {
  const core::Instant open = std::max(core::Instant{}, report.end - shutter_time);
  picture::PhosphorPhotograph photograph(open, report.end);
  photograph.expose(screen_->newest_strokes());
  write_png(*phosphor_, photograph.develop(),
            {{"Software", "sightline " SIGHTLINE_VERSION},
             {"Shutter", fmt::format("{} to {} ns of emulated time", core::nanoseconds_of(open),
                                     core::nanoseconds_of(report.end))}});
}

}  // namespace sightline::app
