// The PDP-7's IOTs of a Type 340: devices 05, 06, 07 and 10.
//
//   700501 IDVE  700504 IDRS  700512 IDRA  700601 IDSI  700606 IDLA  700614 IDRD
//   700701 IDSP  700704 IDCF  700712 IDRC  701001 IDHE  701012 (347: return address)
// Pulse 1 skips, 2 reads, 4 acts, in this order. On device 06 pulse 2 clears the address counter and 4 ORs AC
// into it and starts, so 606 loads, and 614 (which clears AC first) starts at the address already there.
// Pulse 2 of device 06 by itself is no instruction of the display and goes unanswered. Source: Type 340
// programs of the Cambridge CAD Group (1972); inferred: IDRD.
#pragma once

#include <cstdint>

#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"
#include "emulators/pdp7/bus.hpp"

namespace sightline::reference {

[[nodiscard]] constexpr bool is_display_iot(std::uint32_t word) {
  const std::uint32_t device = (word >> 6) & 077U;
  return device >= 005 && device <= 010;
}

namespace detail {

inline void answer_skip(std::uint32_t word, bool flag, pdp7::IotReply& reply) {
  reply.answered |= word & 01U;
  if ((word & 01U) != 0 && flag) reply.skip = true;
}

template <class Display>
void start_display(Display& display, core::Instant now, std::uint32_t word, pdp7::IotReply& reply) {
  answer_skip(word, (word & 01U) != 0 && display.stop_interrupt(now), reply);
  if ((word & 04U) == 0) return;
  reply.answered |= word & 06U;
  if ((word & 02U) != 0) {
    display.load_address_and_start(now, reply.ac);
  } else if (reply.ac.value() == 0) {
    display.restart(now);
  } else {
    display.load_address_and_start(now, reply.ac | display.address_counter(now));
  }
}

}  // namespace detail

// Carries out the pulses of a display IOT; `reply` holds AC on entry.
template <class Display>
void display_iot(Display& display, core::Instant now, std::uint32_t word, pdp7::IotReply& reply) {
  const bool skips = (word & 01U) != 0;
  const bool reads = (word & 02U) != 0;
  const bool acts = (word & 04U) != 0;
  switch ((word >> 6) & 077U) {
    case 005:
      detail::answer_skip(word, skips && display.vertical_edge(now), reply);
      if (reads) reply.ac = reply.ac | display.address_counter(now);
      if (acts) display.resume(now);
      reply.answered |= word & 06U;
      break;
    case 006: detail::start_display(display, now, word, reply); break;
    case 007:
      detail::answer_skip(word, skips && display.light_pen_flag(now), reply);
      if (reads) reply.ac = reply.ac | display.coordinates(now);
      if (acts) display.clear_flags(now);
      reply.answered |= word & 06U;
      break;
    default:
      detail::answer_skip(word, skips && display.horizontal_edge(now), reply);
      if (reads) reply.ac = reply.ac | display.return_address(now);
      reply.answered |= word & 02U;
      break;
  }
}

}  // namespace sightline::reference
