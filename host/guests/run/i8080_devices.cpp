// See i8080_devices.hpp.
#include "host/guests/run/i8080_devices.hpp"

#include <cstdlib>
#include <utility>

#include "host/picture/stroke_log.hpp"

namespace sightline::harness {

namespace {

std::uint64_t t_states(core::TStates time) {
  return static_cast<std::uint64_t>(time.count());
}

DeviceReport report_of(const devices::Ef9365Counts& c) {
  return {"ef9365",
          {{"commands", c.commands},
           {"commands_while_busy", c.commands_while_busy},
           {"writes_while_busy", c.writes_while_busy},
           {"unanswered", c.unanswered},
           {"dots", c.dots},
           {"dots_outside", c.dots_outside}}};
}

DeviceReport report_of(const devices::Alt256Counts& c) {
  return {"alt256",
          {{"dots", c.dots},
           {"dots_invisible", c.dots_invisible},
           {"erases", c.erases},
           {"writes_lost", c.writes_lost}}};
}

DeviceReport report_of(const devices::CalComp565Counts& c) {
  return {"calcomp565",
          {{"steps", c.steps},
           {"steps_pen_up", c.steps_pen_up},
           {"pen_lifts", c.pen_lifts},
           {"pen_commands", c.pen_commands},
           {"commands_while_busy", c.commands_while_busy},
           {"off_carriage", c.off_carriage},
           {"unknown_codes", c.unknown_codes},
           {"off_paper", c.off_paper},
           {"busy_t_states", t_states(c.busy)}}};
}

DeviceReport report_of(const devices::MinigrafCounts& c) {
  return {"minigraf0507",
          {{"steps", c.steps},
           {"steps_pen_up", c.steps_pen_up},
           {"pen_lifts", c.pen_lifts},
           {"missed_fast", c.missed_fast},
           {"missed_jump", c.missed_jump},
           {"steps_early", c.steps_early},
           {"off_field", c.off_field}}};
}

DeviceReport report_of(const devices::SerialLink& link) {
  const devices::I8251Counts& c = link.chip().counts();
  return {"serial",
          {{"sent_by_host", link.sent()},
           {"unseen", link.unseen()},
           {"received", c.received},
           {"received_lost", c.received_lost},
           {"overruns", c.overruns},
           {"parity_errors", c.parity_errors},
           {"framing_errors", c.framing_errors},
           {"transmitted", c.transmitted},
           {"transmit_overwritten", c.transmit_overwritten},
           {not_kept, link.chip().sent().left_out()},
           {"unanswered", c.unanswered}}};
}

}  // namespace

void PlotterTaker::log(const core::Stroke& stroke) {
  constexpr std::size_t block_size = 65536;
  picture::append_stroke_line(text_, stroke);
  if (text_.size() < block_size) return;
  job_.strokes(text_);
  text_.clear();
}

void PlotterTaker::draw(picture::PenPoint point) {
  const bool joined = !paths_.empty() && std::abs(point.x - last_.x) <= 1 && std::abs(point.y - last_.y) <= 1;
  const std::size_t kept = corners_ + (paths_.empty() ? 0 : paths_.back().corners.size());
  if (kept >= most_corners) {
    ++left_out_;
    return;
  }
  if (!joined) {
    corners_ = kept;
    paths_.push_back({{point}});
  } else if (point != last_) {
    picture::extend(paths_.back(), point);
  }
  last_ = point;
}

void PlotterTaker::finish(I8080Report& report) {
  if (!text_.empty()) job_.strokes(text_);
  text_.clear();
  report.drawing = std::move(paths_);
  report.drawing_left_out = left_out_;
}

void collect_devices(I8080Devices& devices, I8080Report& report) {
  if (const auto* board = devices.alt256()) {
    report.devices.push_back(report_of(board->counts()));
    report.raster = board->raster();
  }
  if (const auto* board = devices.ef9365()) {
    report.devices.push_back(report_of(board->counts()));
    report.raster = board->raster();
  }
  if (const auto* plotter = devices.calcomp565()) report.devices.push_back(report_of(plotter->counts()));
  if (const auto* plotter = devices.minigraf0507()) report.devices.push_back(report_of(plotter->counts()));
  if (const auto* link = devices.parallel()) {
    const devices::KeptBytes& from_a = link->received(devices::I8255::Port::a);
    const devices::KeptBytes& from_b = link->received(devices::I8255::Port::b);
    std::vector<std::uint8_t>& all = report.parallel_received;
    all = from_b.bytes();
    all.insert(all.end(), from_a.bytes().begin(), from_a.bytes().end());
    const std::uint64_t left_out = from_a.left_out() + from_b.left_out();
    report.devices.push_back({"parallel",
                              {{"sent_by_host", link->sent()},
                               {"received_by_host", all.size() + left_out},
                               {not_kept, left_out}}});
  }
  if (const auto* link = devices.serial()) {
    report.serial_received = link->chip().sent().bytes();
    report.devices.push_back(report_of(*link));
  }
}

}  // namespace sightline::harness
