// See priority_display.hpp.
#include "priority_display.hpp"

#include <algorithm>

namespace sightline::devices {

namespace {

constexpr auto columns = static_cast<std::uint32_t>(priority_display::columns);
constexpr auto lines = static_cast<std::uint32_t>(priority_display::lines);
constexpr std::uint32_t frame_lines = 625;

}  // namespace

PriorityDisplay::PriorityDisplay(std::size_t most_surfaces, std::size_t most_spans)
    : most_surfaces_(most_surfaces), most_spans_(most_spans), picture_(std::size_t{columns} * lines) {}

std::uint32_t PriorityDisplay::read(std::uint8_t number, core::Instant at) {
  advance(at);
  // The scan is always one line past the last line it has begun.
  const std::uint32_t line = (next_number_ + frame_lines - 1) % frame_lines;
  switch (number) {
    case Register::status:
      return (line >= lines ? status_blanking : 0U) | (waiting_ ? status_waiting : 0U) |
             (written_.surfaces.size() >= most_surfaces_ || written_.spans.size() >= most_spans_ ? status_full : 0U);
    case Register::priority: return priority_;
    case Register::colour: return colour_;
    case Register::line: return line;
    default: ++counts_.unanswered; return 0xFFFF'FFFF;
  }
}

void PriorityDisplay::write(std::uint8_t number, std::uint32_t value, core::Instant at) {
  advance(at);
  if (waiting_ && number <= Register::span) {
    ++counts_.writes_lost;
    return;
  }
  switch (number) {
    case Register::control: control(value); break;
    case Register::priority: priority_ = value; break;
    case Register::colour: colour_ = value & 0xFF'FFFFU; break;
    case Register::line: begin_surface(value); break;
    case Register::span: add_span(value); break;
    default: ++counts_.unanswered; break;
  }
}

void PriorityDisplay::control(std::uint32_t value) {
  if ((value & empty) != 0) written_.clear();
  waiting_ = (value & show) != 0;
  open_ = false;
}

void PriorityDisplay::begin_surface(std::uint32_t line) {
  open_ = false;
  if (line >= lines) {
    ++counts_.writes_off_screen;
    return;
  }
  if (written_.surfaces.size() >= most_surfaces_) {
    ++counts_.writes_no_room;
    return;
  }
  written_.surfaces.push_back(
      {priority_, colour_, line, static_cast<std::uint32_t>(written_.spans.size()), 0});
  ++counts_.surfaces;
  open_ = true;
}

void PriorityDisplay::add_span(std::uint32_t value) {
  const std::uint32_t from = value & 0xFFFFU;
  const std::uint32_t to = value >> 16;
  if (!open_) {
    ++counts_.unanswered;
    return;
  }
  if (written_.spans.size() >= most_spans_) {
    ++counts_.writes_no_room;
    return;
  }
  Surface& surface = written_.surfaces.back();
  if (surface.first_line + surface.line_count >= lines) {
    ++counts_.writes_off_screen;
    return;
  }
  Span span{static_cast<std::uint16_t>(from), static_cast<std::uint16_t>(to)};
  if (to > columns) {
    ++counts_.writes_off_screen;
    span = {};
  }
  written_.spans.push_back(span);
  ++surface.line_count;
}

void PriorityDisplay::advance(core::Instant now) {
  while (next_line_ <= now && next_line_ != core::never) {
    if (next_number_ == 0) begin_frame();
    if (next_number_ < lines) scan(next_number_);
    next_number_ = (next_number_ + 1) % frame_lines;
    next_line_ += priority_display::line;
  }
}

void PriorityDisplay::begin_frame() {
  ++counts_.frames;
  if (waiting_) {
    std::swap(shown_, written_);
    written_.clear();
    waiting_ = false;
    ++counts_.exchanges;
    by_line_.resize(shown_.surfaces.size());
    for (std::uint32_t i = 0; i < by_line_.size(); ++i) by_line_[i] = i;
    std::sort(by_line_.begin(), by_line_.end(), [this](std::uint32_t a, std::uint32_t b) {
      const std::uint32_t line_a = shown_.surfaces[a].first_line;
      const std::uint32_t line_b = shown_.surfaces[b].first_line;
      return line_a != line_b ? line_a < line_b : a < b;
    });
  }
  next_surface_ = 0;
  active_.clear();
}

void PriorityDisplay::scan(std::uint32_t line) {
  const auto ended = [&](std::uint32_t i) {
    return line - shown_.surfaces[i].first_line >= shown_.surfaces[i].line_count;
  };
  active_.erase(std::remove_if(active_.begin(), active_.end(), ended), active_.end());
  const std::size_t kept = active_.size();
  while (next_surface_ < by_line_.size() && shown_.surfaces[by_line_[next_surface_]].first_line == line) {
    if (!ended(by_line_[next_surface_])) active_.push_back(by_line_[next_surface_]);
    ++next_surface_;
  }
  std::inplace_merge(active_.begin(), active_.begin() + static_cast<std::ptrdiff_t>(kept), active_.end());
  best_.fill(0);
  std::uint32_t* const row = &picture_[std::size_t{line} * columns];
  std::fill(row, row + columns, 0U);
  for (const std::uint32_t i : active_) {
    const Surface& surface = shown_.surfaces[i];
    resolve(surface, shown_.spans[surface.first_span + (line - surface.first_line)], row);
  }
}

void PriorityDisplay::resolve(const Surface& surface, const Span& span, std::uint32_t* row) {
  ++counts_.spans;
  const std::uint64_t priority = std::uint64_t{surface.priority} + 1;
  for (std::uint32_t column = span.from; column < span.to; ++column) {
    if (priority <= best_[column]) continue;
    best_[column] = priority;
    row[column] = surface.colour;
  }
  if (span.from < span.to) counts_.points += static_cast<std::uint64_t>(span.to - span.from);
}

}  // namespace sightline::devices
