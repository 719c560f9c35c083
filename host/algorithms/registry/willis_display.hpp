// Willis's method as it was meant to run: frames sent to the priority display, which resolves them.
#pragma once

#include "emulators/core/time.hpp"
#include "emulators/devices/priority_display.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::registry {

struct WillisDisplay {
  devices::PriorityDisplay device;
  core::Instant now{};  // emulated time, a frame or two further for every picture
};

// Whether the frame is of the display's size and its lists hold all of it. A face's number + 1 is sent as its
// colour, so faces beyond 2^24 - 2 do not fit either.
[[nodiscard]] bool fits_display(const algorithms::willis::FrameSpans& frame,
                                const algorithms::willis::ImageWindow& window);

// Writes the frame into the display's list in vertical blanking, has it shown, and waits until it has been
// scanned. Only for what fits the display.
[[nodiscard]] picture::PixelGrid displayed(const algorithms::willis::FrameSpans& frame, WillisDisplay& display);

}  // namespace sightline::registry
