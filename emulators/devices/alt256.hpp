// The alternative raster board: three Matrox ALT-256 cards, one bit plane each, behind one set of ports.
//
// Four outputs and one input are documented, their order is not. Chosen here: ports 30-33, 0 DATA (bits 2-0; the write
// draws the dot), 1 X, 2 Y, 3 ERASE (the whole screen to bits 2-0); reading 0 gives bit 7 ready, bit 6 horizontal blanking.
// The board writes one dot per scan line, in horizontal blanking: a dot ordered at any time is written when the next
// blanking begins, and then the board is ready again. A write to any port before that is lost and counted, as on the
// maker's other boards. A field has 262 lines of 63.5 us (60 Hz); 240 of the 256 rows are visible.
//
// The direction of Y is not documented for this board. Up is chosen; `y_counts_down` selects that of its LSI-11 sibling,
// where y = 0 is at the top and vertical blanking hides the first rows. Either way the hidden rows are those above 239 of
// the Raster, and dots there are counted. The raster shows a dot when it is ordered, not when it is written. Approximate:
// the place of blanking in the line is the television standard's (10.9 us at its end), not the board's. Sources: Holden
// 2019 (memory, visible rows, three cards for eight colours); E. Smith, classiccmp (ports); J. Battle, cctech 2007 (one dot
// per scan line); the NIH header of the MLSI 512 (register set, Y direction).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../core/port_device.hpp"
#include "../core/raster.hpp"
#include "../core/tstates.hpp"

namespace sightline::devices {

namespace alt256 {
inline constexpr core::Duration line{63'500};
inline constexpr core::Duration blanking_begins{52'600};  // in each line; lasts to the end of the line
inline constexpr core::Duration erase{33'300'000};        // two fields
inline constexpr int visible_rows = 240;
}  // namespace alt256

struct Alt256Counts {
  std::uint64_t dots = 0;
  std::uint64_t dots_invisible = 0;  // in the 16 rows that the frame does not show; also in `dots`
  std::uint64_t erases = 0;
  std::uint64_t writes_lost = 0;  // while not ready: a driver's error
};

class Alt256 final : public core::PortDevice {
 public:
  static constexpr std::array reads{core::PortRange{0x30, 0x30}};
  static constexpr std::array writes{core::PortRange{0x30, 0x33}};
  static constexpr std::array options{core::DeviceOption{"y-counts-down", "y = 0 is at the top", 0, 0, 1}};
  static constexpr core::PortDeviceInfo info{.name = "alt256",
                                             .help = "three Matrox ALT-256 raster boards, 256 by 256 points of eight colours",
                                             .choice = "alt256",
                                             .kind = core::PortDeviceKind::raster_board,
                                             .reads = reads,
                                             .writes = writes,
                                             .options = options};

  explicit Alt256(const core::PortDeviceSetup& setup) : Alt256(setup.clock, setup.value(info, "y-counts-down") != 0) {}
  explicit Alt256(core::ClockRate rate, bool y_counts_down = false)
      : rate_(rate), y_flip_(y_counts_down ? std::uint8_t{0xFF} : std::uint8_t{0}) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t, core::TStateInstant at) override { return read_status(at); }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override { write(port & 3U, value, at); }

  static constexpr std::uint8_t status_ready = 0x80;
  static constexpr std::uint8_t status_blanking = 0x40;

  [[nodiscard]] std::uint8_t read_status(core::TStateInstant at) const {
    unsigned bits = ready(at) ? status_ready : 0U;
    if (in_line(at) >= alt256::blanking_begins) bits |= status_blanking;
    return static_cast<std::uint8_t>(bits);
  }

  // Port 0..3.
  void write(std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    if (!ready(at)) {
      ++counts_.writes_lost;
      return;
    }
    switch (port & 3U) {
      case 0: dot(value & 7U, at); break;
      case 1: x_ = value; break;
      case 2: y_ = value ^ y_flip_; break;
      default:
        raster_.fill(value & 7U);
        ++counts_.erases;
        ready_at_ = at + rate_.t_states_in(alt256::erase);
        break;
    }
  }

  [[nodiscard]] bool ready(core::TStateInstant at) const { return at >= ready_at_; }
  // The end of the last command.
  [[nodiscard]] core::TStateInstant ready_at() const { return ready_at_; }
  [[nodiscard]] const core::Raster* raster() const override { return &raster_; }
  [[nodiscard]] const Alt256Counts& totals() const { return counts_; }
  [[nodiscard]] std::vector<core::Count> counts() const override {
    return {{"dots", counts_.dots},
            {"dots_invisible", counts_.dots_invisible},
            {"erases", counts_.erases},
            {"writes_lost", counts_.writes_lost}};
  }

  void visit_state(core::StateVisitor& visit) override {
    visit("x", x_);
    visit("y", y_);
    visit("ready_at", ready_at_);
    visit.part("raster", raster_);
    visit("dots", counts_.dots);
    visit("dots_invisible", counts_.dots_invisible);
    visit("erases", counts_.erases);
    visit("writes_lost", counts_.writes_lost);
  }

 private:
  [[nodiscard]] core::Duration in_line(core::TStateInstant at) const {
    return rate_.to_nanoseconds(at).time_since_epoch() % alt256::line;
  }

  void dot(std::uint8_t value, core::TStateInstant at) {
    raster_.set(x_, y_, value);
    ++counts_.dots;
    if (y_ >= alt256::visible_rows) ++counts_.dots_invisible;
    ready_at_ = core::TStateInstant(rate_.t_states_in(next_blanking(at)));
  }

  // The beginning of the first blanking after `at`.
  [[nodiscard]] core::Duration next_blanking(core::TStateInstant at) const {
    const core::Instant now = rate_.to_nanoseconds(at);
    if (now == core::never) return now.time_since_epoch();  // beyond what nanoseconds can count
    const core::Duration since = now.time_since_epoch() + alt256::line - alt256::blanking_begins;
    return since / alt256::line * alt256::line + alt256::blanking_begins;
  }

  core::ClockRate rate_;
  std::uint8_t y_flip_;
  std::uint8_t x_ = 0;
  std::uint8_t y_ = 0;
  core::TStateInstant ready_at_{};
  core::Raster raster_;
  Alt256Counts counts_;
};

}  // namespace sightline::devices
