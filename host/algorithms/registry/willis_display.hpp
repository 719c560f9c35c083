// Runs Willis's method as designed: frames are sent to the priority display, which resolves the hidden faces.
#pragma once

#include "emulators/core/time.hpp"
#include "emulators/devices/priority_display.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::registry {

struct WillisDisplay {
  devices::PriorityDisplay device;
  core::Instant now{};  // emulated time; advances by a frame or two per picture
};

// Whether the frame has the display's size and fits in its lists. A face's number + 1 is sent as its colour, so faces
// beyond 2^24 - 2 do not fit.
[[nodiscard]] bool fits_display(const algorithms::willis::FrameSpans& frame,
                                const algorithms::willis::ImageWindow& window);

// Writes the frame into the display's list during vertical blanking, and waits until the display has scanned it.
// Precondition: fits_display.
[[nodiscard]] picture::PixelGrid show_on_display(const algorithms::willis::FrameSpans& frame, WillisDisplay& display);

}  // namespace sightline::registry
