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

#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"
#include "emulators/pdp7/bus.hpp"
#include "tests/emulators/reference/pdp7/paper_tape.hpp"
#include "tests/emulators/reference/pdp7/rb09.hpp"
#include "tests/emulators/reference/pdp7/teletype.hpp"
#include "emulators/pdp7/timing.hpp"

namespace sightline::reference {
using namespace pdp7;


// The real-time clock: while it is on, every period of the mains counts location 7 up by one in a stolen
// cycle; when the count passes from 777777 to 0 the clock flag rises and asks for a program interrupt.
//
// The mains runs from instant zero whether the clock is on or not, so the first tick after CLON comes within
// a period. The machine does the counting (it owns core memory); this holds the switch, the flag and the
// phase.
class Clock {
 public:
  // `hertz` of 1 or more; less is taken as 1.
  explicit constexpr Clock(std::int64_t hertz) : hertz_(hertz < 1 ? 1 : hertz) {}

  constexpr void turn_on(core::Instant now) {
    on_ = true;
    flag_ = false;
    const std::int64_t seconds = core::nanoseconds_of(now) / nanoseconds_in_a_second;
    const std::int64_t rest = core::nanoseconds_of(now) % nanoseconds_in_a_second;
    next_period_ = seconds * hertz_ + rest * hertz_ / nanoseconds_in_a_second + 1;
  }
  constexpr void turn_off() { on_ = flag_ = false; }

  [[nodiscard]] constexpr bool on() const { return on_; }
  [[nodiscard]] constexpr bool flag() const { return flag_; }
  constexpr void raise_flag() { flag_ = true; }

  // The next tick; instants are rounded down to a nanosecond, without drift.
  [[nodiscard]] constexpr core::Instant deadline() const {
    if (!on_) return core::never;
    return core::at_nanoseconds(next_period_ / hertz_ * nanoseconds_in_a_second +
                                next_period_ % hertz_ * nanoseconds_in_a_second / hertz_);
  }
  // True once for every tick at or before `now`.
  constexpr bool take_tick(core::Instant now) {
    if (now < deadline()) return false;
    ++next_period_;
    return true;
  }


 private:
  static constexpr std::int64_t nanoseconds_in_a_second = 1'000'000'000;
  static constexpr std::int64_t longest_run = 9'200'000'000;  // seconds that fit into an Instant

  std::int64_t hertz_;
  std::int64_t next_period_ = 0;
  bool on_ = false;
  bool flag_ = false;
};

// Which devices the machine was bought with.
struct Devices {
  bool clock = true;
  bool reader = true;
  bool punch = true;
  bool teletype = true;
  bool disk = false;  // the RB09's controller
};

// Bits of the IORS word; bit 0, interrupts on, is the processor's own.
namespace status {
inline constexpr std::uint32_t reader = 0200000, punch = 0100000, keyboard = 0040000, printer = 0020000,
                               light_pen = 0010000, clock = 0004000, clock_on = 0002000;
}

class Peripherals {
 public:
  // `core_mask`: where the core address of a data break wraps.
  Peripherals(const Devices& present, const Timing& timing, Address core_mask = in_bank_mask)
      : clock(timing.clock_hertz),
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
      case 000: clock_pulses(now, word, reply); break;
      case 001: reader_pulses(now, word, reply); break;
      case 002: punch_pulses(now, word, reply); break;
      case 003: keyboard_pulses(word, reply, elsewhere); break;
      case 004: printer_pulses(now, word, reply); break;
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
    return clock.flag() || reader.flag() || punch.flag() || keyboard.flag() || printer.flag() ||
           (disk && disk->interrupt_request());
  }

  // CAF and START: flags down, transfers abandoned, clock off.
  void clear(core::Instant now) {
    clock.turn_off();
    reader.reset(now);
    punch.reset();
    keyboard.clear_flag();
    printer.reset();
    if (disk) disk->clear();
  }


  Clock clock;
  Reader reader;
  Punch punch;
  Keyboard keyboard;
  Printer printer;
  std::optional<Rb09> disk;

 private:
  static constexpr std::uint32_t subdevice = 040;

  // A skip pulse: skips if the flag is up.
  static void test(std::uint32_t word, bool flag, IotReply& reply) {
    reply.answered |= word & 01U;
    if ((word & 01U) != 0 && flag) reply.skip = true;
  }
  static void collect(IotReply& reply, std::uint32_t bits) { reply.ac = reply.ac | core::Word18(bits); }

  // CLSF 700001, CLOF 700004, CLON 700044.
  void clock_pulses(core::Instant now, std::uint32_t word, IotReply& reply) {
    if (!present_.clock) return;
    test(word, clock.flag(), reply);
    if ((word & 04U) == 0) return;
    reply.answered |= 04U;
    if ((word & subdevice) != 0) {
      clock.turn_on(now);
    } else {
      clock.turn_off();
    }
  }

  // RSF 700101, RCF 700102, RRB 700112, RSA 700104, RSB 700144.
  void reader_pulses(core::Instant now, std::uint32_t word, IotReply& reply) {
    if (!present_.reader) return;
    test(word, reader.flag(), reply);
    if ((word & 02U) != 0) {
      collect(reply, reader.buffer().value());
      reader.clear_flag();
    }
    if ((word & 04U) != 0) {
      if ((word & subdevice) != 0) {
        reader.start_word(now);
      } else {
        reader.start_line(now);
      }
    }
    reply.answered |= word & 06U;
  }

  // PSF 700201, PCF 700202, PSA 700204, PLS 700206, PSB 700244.
  void punch_pulses(core::Instant now, std::uint32_t word, IotReply& reply) {
    if (!present_.punch) return;
    test(word, punch.flag(), reply);
    if ((word & 02U) != 0) punch.clear_flag();
    if ((word & 04U) != 0) {
      const std::uint32_t line = reply.ac.value();
      punch.start(now,
                  static_cast<std::uint8_t>((word & subdevice) != 0 ? (line & 077U) | 0200U : line & 0377U));
    }
    reply.answered |= word & 06U;
  }

  // KSF 700301, KRB 700312, IORS 700314; IORS is part of the interface and needs no teletype.
  void keyboard_pulses(std::uint32_t word, IotReply& reply, std::uint32_t elsewhere) {
    if (present_.teletype) {
      test(word, keyboard.flag(), reply);
      if ((word & 01U) != 0 && !keyboard.flag()) keyboard.ask();
      if ((word & 02U) != 0) {
        collect(reply, keyboard.buffer());
        keyboard.clear_flag();
      }
      reply.answered |= word & 02U;
    }
    if ((word & 04U) != 0) collect(reply, flags() | elsewhere);
    reply.answered |= word & 04U;
  }

  // TSF 700401, TCF 700402, TLS 700406.
  void printer_pulses(core::Instant now, std::uint32_t word, IotReply& reply) {
    if (!present_.teletype) return;
    test(word, printer.flag(), reply);
    if ((word & 02U) != 0) printer.clear_flag();
    if ((word & 04U) != 0) printer.start(now, static_cast<std::uint8_t>(reply.ac.value() & 0377U));
    reply.answered |= word & 06U;
  }

  // TTS 703301 (skips if there is a teletype), CAF 703302.
  void control_pulses(core::Instant now, std::uint32_t word, IotReply& reply) {
    const std::uint32_t pulses = word & 07U;
    if (!device_33_each_pulse_ && (pulses & (pulses - 1)) != 0) return;
    if ((word & subdevice) == 0) test(word, present_.teletype, reply);
    if ((word & 02U) != 0) clear(now);
    reply.answered |= word & 02U;
  }

  [[nodiscard]] std::uint32_t flags() const {
    return (reader.flag() ? status::reader : 0U) | (punch.flag() ? status::punch : 0U) |
           (keyboard.flag() ? status::keyboard : 0U) | (printer.flag() ? status::printer : 0U) |
           (clock.flag() ? status::clock : 0U) | (clock.on() ? status::clock_on : 0U);
  }

  bool device_33_each_pulse_;  // Timing
  Devices present_;
};

}  // namespace sightline::reference
