// The devices on the PDP-7's IOT bus other than a display: clock, reader, punch, teletype, disk; which IOT pulse
// does what, the IORS status word, the interrupt request and the skip tests.
//
// Bits 6-11 of an IOT choose the device, bits 12-13 its subdevice (040, 020 below), bits 15-17 make pulses 4,
// 2, 1, which act in the order 1, 2, 4. Every device is brought up to date before it is touched and publishes
// the next instant at which it will do something; one that is absent has none. Sources: PDP-4 manual pages 23
// and 65, codes and IORS bits as another simulator has them. The EAE step counter is left out of IORS
// (unknown).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "../core/time.hpp"
#include "../core/word.hpp"
#include "bus.hpp"
#include "clock.hpp"
#include "paper_tape.hpp"
#include "rb09.hpp"
#include "status.hpp"
#include "teletype.hpp"
#include "timing.hpp"

namespace sightline::pdp7 {

// Which devices the machine was bought with.
struct Devices {
  bool clock = true;
  bool reader = true;
  bool punch = true;
  bool teletype = true;
  bool disk = false;  // the RB09's controller
};

class Peripherals {
 public:
  // `core_mask`: where the core address of a data break wraps.
  Peripherals(const Devices& present, const Timing& timing, Address core_mask = in_bank_mask)
      : clock(timing.clock_hertz, timing.clock_tick_cycles),
        reader(timing.reader_line),
        punch(timing.punch_line),
        keyboard(timing.teletype_character),
        printer(timing.teletype_character),
        device_33_each_pulse_(timing.device_33_each_pulse),
        present_(present) {
    if (!present.disk) return;
    disk.emplace(rb09::Choices{.word = timing.disk_word,
                               .clear_stops = timing.disk_clear_stops,
                               .late_stops = timing.disk_late_stops,
                               .after_last = timing.disk_after_last},
                 core_mask);
  }

  // The pulses of one IOT at `now`. `elsewhere` is what devices outside this class add to IORS.
  IotReply iot(core::Instant now, std::uint32_t word, core::Word18 ac, std::uint32_t elsewhere) {
    advance(now);
    IotReply reply{ac};
    switch ((word >> 6) & 077U) {
      case 000:
        if (present_.clock) clock.iot(now, word, reply);
        break;
      case 001:
        if (present_.reader) reader.iot(now, word, reply);
        break;
      case 002:
        if (present_.punch) punch.iot(now, word, reply);
        break;
      case 003:
        if (present_.teletype) keyboard.iot(now, word, reply);
        if ((word & 04U) != 0) reply.collect(core::Word18(flags(now) | elsewhere));
        reply.answered |= word & 04U;
        break;
      case 004:
        if (present_.teletype) printer.iot(now, word, reply);
        break;
      case 033: control_pulses(now, word, reply); break;
      case 071:
        if (disk) disk->iot(now, word, reply);
        break;
      default: break;
    }
    return reply;
  }

  // Everything up to `now` has happened, except clock ticks and the words of the disk, which need a memory cycle
  // (see Clock::take_tick and Rb09::request).
  void advance(core::Instant now) {
    reader.advance(now);
    punch.advance(now);
    keyboard.advance(now);
    printer.advance(now);
  }

  [[nodiscard]] core::Instant deadline() const {
    return std::min({clock.deadline(), reader.deadline(), punch.deadline(), keyboard.deadline(), printer.deadline(),
                     disk ? disk->deadline() : core::never});
  }

  [[nodiscard]] bool interrupt_request() const {
    return clock.interrupt_request() || reader.interrupt_request() || punch.interrupt_request() ||
           keyboard.interrupt_request() || printer.interrupt_request() ||
           (disk && disk->interrupt_request());
  }

  // CAF and START: flags down, transfers abandoned, clock off.
  void clear(core::Instant now) {
    clock.clear_flags(now);
    reader.clear_flags(now);
    punch.clear_flags(now);
    keyboard.clear_flags(now);
    printer.clear_flags(now);
    if (disk) disk->clear_flags(now);
  }

  // A further device is a further section: snapshots of machines without it have none of that name.
  void visit_state(core::StateVisitor& visit) {
    visit.section("clock", clock);
    visit.section("reader", reader);
    visit.section("punch", punch);
    visit.section("keyboard", keyboard);
    visit.section("printer", printer);
    if (disk) visit.section("rb09", *disk);
  }

  Clock clock;
  Reader reader;
  Punch punch;
  Keyboard keyboard;
  Printer printer;
  std::optional<Rb09> disk;

 private:
  static constexpr std::uint32_t subdevice = 040;

  // TTS 703301 (skips if there is a teletype), CAF 703302.
  void control_pulses(core::Instant now, std::uint32_t word, IotReply& reply) {
    const std::uint32_t pulses = word & 07U;
    if (!device_33_each_pulse_ && (pulses & (pulses - 1)) != 0) return;
    if ((word & subdevice) == 0) reply.test(word, present_.teletype);
    if ((word & 02U) != 0) clear(now);
    reply.answered |= word & 02U;
  }

  [[nodiscard]] std::uint32_t flags(core::Instant now) {
    return reader.status(now) | punch.status(now) | keyboard.status(now) | printer.status(now) | clock.status(now);
  }

  bool device_33_each_pulse_;  // Timing
  Devices present_;
};

}  // namespace sightline::pdp7
