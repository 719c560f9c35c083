// The priority display on an 8-bit bus, between two computers: a host that knows where surfaces are on the screen, and a
// processor that knows only their priorities.
//
// Over its own connection the host gives the surfaces of the next frame, each with a number from 0 to 255 instead of a
// priority; the processor writes an 8-bit priority for each number. On the processor's command both go to the display and
// are shown together.
// Registers, on ports 70-72 (all chosen here; no document describes any):
//   0 write NUMBER    of the surfaces whose priority is written next
//   1 write PRIORITY  of that number, kept until it is written again
//   2 write CONTROL   bit 0: from the next frame on, show the surfaces the host has given, with these priorities
//     read  STATUS    bit 0: vertical blanking; bit 1: a frame waits to be shown: write nothing
// While a frame waits, writes are lost and counted. A register that does not exist reads as FF. Left out: its state in
// snapshots. Source: Willis 1977, for what the display does; priority_display.hpp is the display.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../core/port_device.hpp"
#include "../core/tstates.hpp"
#include "priority_display.hpp"

namespace sightline::devices {

struct PriorityBoardCounts {
  std::uint64_t priorities = 0;   // written
  std::uint64_t shows = 0;        // commands to show
  std::uint64_t writes_lost = 0;  // while a frame waited
  std::uint64_t unanswered = 0;   // registers that do not exist
};

class PriorityBoard final : public core::PortDevice {
 public:
  static constexpr std::uint8_t first_port = 0x70;
  static constexpr std::array ports{core::PortRange{first_port, first_port + 2}};
  static constexpr core::PortDeviceInfo info{.name = "priority",
                                             .help = "priority display of the Sussex project",
                                             .choice = "priority",
                                             .kind = core::PortDeviceKind::special,
                                             .reads = ports,
                                             .writes = ports,
                                             .has_state = false};

  struct Register {
    static constexpr std::uint8_t number = 0;
    static constexpr std::uint8_t priority = 1;
    static constexpr std::uint8_t control = 2;
    static constexpr std::uint8_t status = 2;
  };
  struct HostSpan {
    std::uint16_t from = 0;  // column
    std::uint16_t to = 0;    // one past the last column
  };
  // One surface as the host gives it.
  struct HostSurface {
    std::uint8_t number = 0;
    std::uint32_t colour = 0;  // 24 bits
    std::uint32_t first_line = 0;
    std::uint32_t first_span = 0;  // index into the list of spans; one span per line
    std::uint32_t line_count = 0;
  };

  explicit PriorityBoard(const core::PortDeviceSetup& setup) : PriorityBoard(setup.clock) {}
  explicit PriorityBoard(core::ClockRate clock) : clock_(clock) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) override {
    return read(static_cast<std::uint8_t>(port - first_port), at);
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override {
    write(static_cast<std::uint8_t>(port - first_port), value, at);
  }

  [[nodiscard]] std::uint8_t read(std::uint8_t number, core::TStateInstant at) {
    if (number != Register::status) {
      ++counts_.unanswered;
      return 0xFF;
    }
    return static_cast<std::uint8_t>(display_.read(PriorityDisplay::Register::status, clock_.to_nanoseconds(at)) & 3U);
  }
  void write(std::uint8_t number, std::uint8_t value, core::TStateInstant at) {
    if (number > Register::control) {
      ++counts_.unanswered;
      return;
    }
    const core::Instant now = clock_.to_nanoseconds(at);
    if ((display_.read(PriorityDisplay::Register::status, now) & PriorityDisplay::status_waiting) != 0) {
      ++counts_.writes_lost;
      return;
    }
    if (number == Register::number) number_ = value;
    if (number == Register::priority) {
      priorities_[number_] = value;
      ++counts_.priorities;
    }
    if (number == Register::control && (value & 1U) != 0) show(now);
  }

  // The host's side: sets the frame that the next command shows.
  void give(std::span<const HostSurface> surfaces, std::span<const HostSpan> spans) {
    surfaces_.assign(surfaces.begin(), surfaces.end());
    spans_.assign(spans.begin(), spans.end());
  }

  [[nodiscard]] std::span<const std::uint8_t, 256> priorities() const { return priorities_; }
  [[nodiscard]] const PriorityDisplay& display() const { return display_; }
  void advance(core::TStateInstant now) override { display_.advance(clock_.to_nanoseconds(now)); }
  [[nodiscard]] const PriorityBoardCounts& totals() const { return counts_; }
  [[nodiscard]] std::vector<core::Count> counts() const override {
    return {{"priorities", counts_.priorities},
            {"shows", counts_.shows},
            {"writes_lost", counts_.writes_lost},
            {"unanswered", counts_.unanswered}};
  }

 private:
  void show(core::Instant now) {
    using DisplayRegister = PriorityDisplay::Register;
    display_.write(DisplayRegister::control, PriorityDisplay::empty, now);
    for (const HostSurface& surface : surfaces_) {
      display_.write(DisplayRegister::priority, priorities_[surface.number], now);
      display_.write(DisplayRegister::colour, surface.colour, now);
      display_.write(DisplayRegister::line, surface.first_line, now);
      for (std::uint32_t i = 0; i < surface.line_count; ++i) {
        const HostSpan span = spans_[surface.first_span + i];
        display_.write(DisplayRegister::span, std::uint32_t{span.to} << 16U | span.from, now);
      }
    }
    display_.write(DisplayRegister::control, PriorityDisplay::show, now);
    ++counts_.shows;
  }

  core::ClockRate clock_;
  PriorityDisplay display_;
  std::uint8_t number_ = 0;
  std::array<std::uint8_t, 256> priorities_{};
  std::vector<HostSurface> surfaces_;
  std::vector<HostSpan> spans_;
  PriorityBoardCounts counts_;
};

}  // namespace sightline::devices
