// The input and output ports of Skala's 8080: whichever of the boards, plotters and links a run asks for.
//
//   30-33  ALT-256 raster board                      E4-E7  8255, parallel link to the host
//   40-4F  EF9365 raster board, 50 its colour latch  EC-EF  8251, serial link (data even, control odd)
//   60     CalComp 565 command and status            F0     Minigraf 0507, write only
//
// A port without a device reads as FFh, the level of the undriven bus, and swallows what is written; such
// accesses are counted by port and direction. Absent devices cost the comparison of the port's upper half and
// nothing else. Devices request interrupts only where the configuration connects them to a restart; of
// several the highest restart wins, as an 8214 would have it, and RST 7 is what the bus gives when nobody
// asks.
//
// It is a Ports of the 8080 machine; a program's environment that has further ports (a CP/M stub) wraps it
// and forwards in, out and the rest. Large (64 KB a raster): let it live on the heap. Sources: Intel SBC
// 80/10 for E4-EF; the other addresses are this machine's own.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "../core/raster.hpp"
#include "../core/stroke.hpp"
#include "../core/tstates.hpp"
#include "../devices/alt256.hpp"
#include "../devices/calcomp565.hpp"
#include "../devices/ef9365.hpp"
#include "../devices/minigraf0507.hpp"
#include "../devices/parallel_link.hpp"
#include "../devices/serial_link.hpp"

namespace sightline::machines {

// Restart 0..7 a device's request is wired to, or none.
using Restart = std::optional<std::uint8_t>;

struct SkalaConfiguration {
  core::ClockRate clock{};

  bool ef9365 = false;
  Restart ef9365_restart;

  bool alt256 = false;
  bool alt256_y_counts_down = false;

  bool calcomp565 = false;
  devices::PlotterPlace calcomp565_start{};
  Restart calcomp565_restart;  // on DONE

  bool minigraf0507 = false;
  devices::MinigrafTimes minigraf0507_times{};

  // What the host sends; the bytes must stay where they are. No value: no such chip.
  std::optional<std::span<const std::uint8_t>> parallel;
  devices::ParallelHost parallel_host{};
  Restart parallel_restart;  // on INTR of port A or B
  std::optional<std::span<const std::uint8_t>> serial;
  devices::SerialHost serial_host{};
  Restart serial_receive_restart;   // on RxRDY
  Restart serial_transmit_restart;  // on TxRDY
};

struct UnansweredPort {
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

template <class PlotterSink = core::NoStrokes>
class SkalaPorts {
 public:
  // The sink takes the strokes of whichever plotter there is (of both in their order, if there are two) and
  // must outlive the ports.
  SkalaPorts(const SkalaConfiguration& configuration, PlotterSink& sink) : configuration_(configuration) {
    const core::ClockRate clock = configuration.clock;
    if (configuration.ef9365) ef9365_.emplace(clock);
    if (configuration.alt256) alt256_.emplace(clock, configuration.alt256_y_counts_down);
    if (configuration.calcomp565) calcomp565_.emplace(clock, sink, configuration.calcomp565_start);
    if (configuration.minigraf0507) minigraf0507_.emplace(clock, sink, configuration.minigraf0507_times);
    if (configuration.parallel)
      parallel_.emplace(clock, *configuration.parallel, configuration.parallel_host);
    if (configuration.serial) serial_.emplace(clock, *configuration.serial, configuration.serial_host);
    connected_ = configuration.ef9365_restart || configuration.calcomp565_restart ||
                 configuration.parallel_restart || configuration.serial_receive_restart ||
                 configuration.serial_transmit_restart;
    if (connected_) look();
  }
  SkalaPorts(const SkalaPorts&) = delete;
  SkalaPorts& operator=(const SkalaPorts&) = delete;

  // The 8080 machine's side. `at` never goes back.
  static constexpr bool waits = false;

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) {
    const std::uint8_t value = read(port, at);
    if (connected_) look();
    return value;
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    // The drawing loops write little else. Only the command and CTRL1 have to do with interrupts.
    if (ef9365_ && (port & 0xF0U) == 0x40) [[likely]] {
      ef9365_->write(port & 0x0FU, value, at);
      if (connected_ && port <= 0x41) look();
      return;
    }
    write(port, value, at);
    if (connected_) look();
  }
  // The earliest instant at which the interrupt line may change by itself.
  [[nodiscard]] core::TStateInstant deadline() const { return deadline_; }
  void advance(core::TStateInstant now) {
    if (ef9365_) ef9365_->advance(now);
    if (calcomp565_) calcomp565_->advance(now);
    if (parallel_) parallel_->advance(now);
    if (serial_) serial_->advance(now);
    if (connected_) look();
  }
  [[nodiscard]] bool interrupt() const { return requests_ != 0; }
  // RST n of the highest request.
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant now) {
    advance(now);
    unsigned restart = 7;
    while (restart != 0 && requests_ != 0 && (requests_ >> restart & 1U) == 0) --restart;
    return static_cast<std::uint8_t>(0xC7U | restart << 3);
  }
  [[nodiscard]] static constexpr bool stopped() { return false; }

  // The devices, null when absent.
  [[nodiscard]] devices::Ef9365* ef9365() { return ef9365_ ? &*ef9365_ : nullptr; }
  [[nodiscard]] devices::Alt256* alt256() { return alt256_ ? &*alt256_ : nullptr; }
  [[nodiscard]] devices::CalComp565<PlotterSink>* calcomp565() {
    return calcomp565_ ? &*calcomp565_ : nullptr;
  }
  [[nodiscard]] devices::Minigraf0507<PlotterSink>* minigraf0507() {
    return minigraf0507_ ? &*minigraf0507_ : nullptr;
  }
  [[nodiscard]] devices::ParallelLink* parallel() { return parallel_ ? &*parallel_ : nullptr; }
  [[nodiscard]] devices::SerialLink* serial() { return serial_ ? &*serial_ : nullptr; }

  // Accesses nothing answered, by port.
  [[nodiscard]] std::span<const UnansweredPort, 256> unanswered() const { return unanswered_; }

 private:
  std::uint8_t read(std::uint8_t port, core::TStateInstant at) {
    switch (port >> 4) {
      case 0x3:
        if (alt256_ && port == 0x30) return alt256_->read_status(at);
        break;
      case 0x4:
        if (ef9365_) return ef9365_->read(port & 0x0FU, at);
        break;
      case 0x5:
        if (ef9365_ && port == 0x50) return ef9365_->colour();
        break;
      case 0x6:
        if (calcomp565_ && port == 0x60) return calcomp565_->read_status(at);
        break;
      case 0xE:
        if (parallel_ && (port & 0xFCU) == 0xE4) return parallel_->read(port & 3U, at);
        if (serial_ && port >= 0xEC) return serial_->read(port & 1U, at);
        break;
      default: break;
    }
    ++unanswered_[port].reads;
    return 0xFF;
  }

  // All ports but the EF9365's own.
  [[gnu::noinline]] void write(std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    switch (port >> 4) {
      case 0x3:
        if (alt256_ && port <= 0x33) return alt256_->write(port & 3U, value, at);
        break;
      case 0x5:
        if (ef9365_ && port == 0x50) return ef9365_->set_colour(value, at);
        break;
      case 0x6:
        if (calcomp565_ && port == 0x60) return calcomp565_->write(value, at);
        break;
      case 0xE:
        if (parallel_ && (port & 0xFCU) == 0xE4) return parallel_->write(port & 3U, value, at);
        if (serial_ && port >= 0xEC) return serial_->write(port & 1U, value, at);
        break;
      case 0xF:
        if (minigraf0507_ && port == 0xF0) return minigraf0507_->write(value, at);
        break;
      default: break;
    }
    ++unanswered_[port].writes;
  }

  // Requests and the next deadline of the devices whose interrupt is connected.
  void look() {
    requests_ = 0;
    deadline_ = core::never_t;
    if (ef9365_) consider(configuration_.ef9365_restart, ef9365_->interrupt(), ef9365_->deadline());
    if (calcomp565_)
      consider(configuration_.calcomp565_restart, calcomp565_->done(), calcomp565_->deadline());
    if (parallel_) consider(configuration_.parallel_restart, parallel_->interrupt(), parallel_->deadline());
    if (serial_) {
      const devices::I8251& chip = serial_->chip();
      consider(configuration_.serial_receive_restart, chip.receive_ready(), serial_->deadline());
      consider(configuration_.serial_transmit_restart, chip.transmit_ready(), serial_->deadline());
    }
  }
  void consider(Restart restart, bool requests, core::TStateInstant deadline) {
    if (!restart) return;
    if (requests) requests_ |= 1U << (*restart & 7U);
    deadline_ = std::min(deadline_, deadline);
  }

  SkalaConfiguration configuration_;
  std::optional<devices::Ef9365> ef9365_;
  std::optional<devices::Alt256> alt256_;
  std::optional<devices::CalComp565<PlotterSink>> calcomp565_;
  std::optional<devices::Minigraf0507<PlotterSink>> minigraf0507_;
  std::optional<devices::ParallelLink> parallel_;
  std::optional<devices::SerialLink> serial_;
  bool connected_ = false;
  unsigned requests_ = 0;  // bit n: restart n
  core::TStateInstant deadline_ = core::never_t;
  std::array<UnansweredPort, 256> unanswered_{};
};

}  // namespace sightline::machines
