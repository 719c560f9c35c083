#include "host/algorithms/registry/willis_display.hpp"

#include <algorithm>
#include <cstddef>

namespace sightline::registry {

namespace {

using devices::PriorityDisplay;
using Register = PriorityDisplay::Register;
constexpr int display_columns = devices::priority_display::columns;
constexpr int scan_lines = devices::priority_display::lines;
constexpr std::uint32_t last_colour = 0xFF'FFFF;

}  // namespace

bool fits_display(const algorithms::willis::FrameSpans& frame,
                  const algorithms::willis::ImageWindow& window) {
  return window.width == display_columns && window.height == scan_lines &&
         frame.surfaces.size() <= PriorityDisplay::usual_surfaces &&
         frame.spans.size() <= PriorityDisplay::usual_spans &&
         std::all_of(frame.surfaces.begin(), frame.surfaces.end(),
                     [](const auto& surface) { return surface.face < last_colour; });
}

picture::PixelGrid show_on_display(const algorithms::willis::FrameSpans& frame, WillisDisplay& display) {
  PriorityDisplay& device = display.device;
  device.write(Register::control, PriorityDisplay::empty, display.now);
  for (const auto& surface : frame.surfaces) {
    device.write(Register::priority, surface.priority, display.now);
    device.write(Register::colour, surface.face + 1, display.now);
    device.write(Register::line, surface.first_line, display.now);
    for (std::uint32_t i = 0; i < surface.line_count; ++i) {
      const auto& span = frame.spans[surface.first_span + i];
      device.write(Register::span, static_cast<std::uint32_t>(span.to) << 16 | span.from, display.now);
    }
  }
  device.write(Register::control, PriorityDisplay::show, display.now);
  // The frame after the current one, until its blanking begins.
  const core::Duration since = display.now.time_since_epoch() % devices::priority_display::frame;
  display.now += devices::priority_display::frame - since + devices::priority_display::line * scan_lines;
  device.advance(display.now);
  picture::PixelGrid faces(display_columns, scan_lines);
  for (int row = 0; row < scan_lines; ++row) {
    const auto line = device.picture().subspan(
        static_cast<std::size_t>(scan_lines - 1 - row) * display_columns, display_columns);
    std::copy(line.begin(), line.end(),
              faces.values.begin() + static_cast<std::ptrdiff_t>(faces.index(0, row)));
  }
  return faces;
}

}  // namespace sightline::registry
