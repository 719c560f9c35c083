// The input and output ports of Skala's 8080: the boards, plotters and links that a run selects.
//
//   30-33  ALT-256 raster board                      E4-E7  8255, parallel link to the host
//   40-4F  EF9365 raster board, 50 its colour latch  EC-EF  8251, serial link (data even, control odd)
//   60     CalComp 565 command and status            F0     Minigraf 0507, write only
//   00-01  Altair 88-SIO with a terminal             10-11  Altair 88-2SIO with a terminal, first channel
//
// A new device is its file in emulators/devices, a row here and a test: options, interrupt names and counts
// of `sightline run i8080` follow from the row. Large (64 KB a raster): let a SkalaPorts live on the heap.
// Sources: Intel SBC 80/10 for E4-EF; the addresses of the Altair's boards are MITS's; the others are this machine's own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "../core/raster.hpp"
#include "../core/stroke.hpp"
#include "../core/tstates.hpp"
#include "../devices/alt256.hpp"
#include "../devices/altair_serial.hpp"
#include "../devices/calcomp565.hpp"
#include "../devices/ef9365.hpp"
#include "../devices/minigraf0507.hpp"
#include "../devices/parallel_link.hpp"
#include "../devices/serial_link.hpp"
#include "port_table.hpp"

namespace sightline::machines {

// What a device is: a host offers the devices of a kind under one option, and takes from each what its kind
// gives (a raster, strokes, the bytes that it sent to the host); a terminal is where a console can be. Any other device it attaches by name, with
// --device, and takes the counts only.
enum class DeviceKind : std::uint8_t { raster_board, plotter, link, terminal, other };

// The bytes that a host sends over a link; they must stay where they are. No value: no such chip.
using HostBytes = std::optional<std::span<const std::uint8_t>>;

// The count of bytes beyond what is kept of a link.
inline constexpr std::string_view not_kept = "not_kept";

struct Ef9365Row {
  struct Configuration {
    bool ef9365 = false;
    Restart ef9365_restart;
  };
  template <class>
  using Device = devices::Ef9365;
  static constexpr DeviceKind kind = DeviceKind::raster_board;
  static constexpr std::string_view name = "ef9365";
  static constexpr std::string_view choice = "ef9365";  // of its kind's option
  static constexpr bool Configuration::*attached = &Configuration::ef9365;
  static constexpr std::uint8_t colour_latch = 0x50;
  static constexpr std::array reads{PortRange{0x40, 0x4F}, PortRange{colour_latch, colour_latch}};
  static constexpr std::array writes = reads;
  static constexpr std::array lines{InterruptLine<Configuration>{"ef9365", &Configuration::ef9365_restart}};

  template <class Sink>
  static void make(std::optional<devices::Ef9365>& board, const Configuration& wanted, core::ClockRate clock,
                   Sink&) {
    if (wanted.ef9365) board.emplace(clock);
  }
  static std::uint8_t read(devices::Ef9365& board, std::uint8_t port, core::TStateInstant at) {
    return port == colour_latch ? board.colour() : board.read(port & 0x0FU, at);
  }
  static void write(devices::Ef9365& board, std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    if (port == colour_latch) [[unlikely]]
      return board.set_colour(value, at);
    board.write(port & 0x0FU, value, at);
  }
  static bool requests(const devices::Ef9365& board, std::size_t) { return board.interrupt(); }
  // Only the command and CTRL1 have to do with interrupts.
  static bool write_may_request(std::uint8_t port) { return port <= 0x41; }
  template <class Take>
  static void count(const devices::Ef9365& board, Take take) {
    const devices::Ef9365Counts counts = board.counts();
    take("commands", counts.commands);
    take("commands_while_busy", counts.commands_while_busy);
    take("writes_while_busy", counts.writes_while_busy);
    take("unanswered", counts.unanswered);
    take("dots", counts.dots);
    take("dots_outside", counts.dots_outside);
  }
};

struct Alt256Row {
  struct Configuration {
    bool alt256 = false;
    bool alt256_y_counts_down = false;
  };
  template <class>
  using Device = devices::Alt256;
  static constexpr DeviceKind kind = DeviceKind::raster_board;
  static constexpr std::string_view name = "alt256";
  static constexpr std::string_view choice = "alt256";
  static constexpr bool Configuration::*attached = &Configuration::alt256;
  static constexpr std::array reads{PortRange{0x30, 0x30}};
  static constexpr std::array writes{PortRange{0x30, 0x33}};
  static constexpr std::array<InterruptLine<Configuration>, 0> lines{};

  template <class Sink>
  static void make(std::optional<devices::Alt256>& board, const Configuration& wanted, core::ClockRate clock,
                   Sink&) {
    if (wanted.alt256) board.emplace(clock, wanted.alt256_y_counts_down);
  }
  static std::uint8_t read(devices::Alt256& board, std::uint8_t, core::TStateInstant at) {
    return board.read_status(at);
  }
  static void write(devices::Alt256& board, std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    board.write(port & 3U, value, at);
  }
  template <class Take>
  static void count(const devices::Alt256& board, Take take) {
    const devices::Alt256Counts& counts = board.counts();
    take("dots", counts.dots);
    take("dots_invisible", counts.dots_invisible);
    take("erases", counts.erases);
    take("writes_lost", counts.writes_lost);
  }
};

struct CalComp565Row {
  struct Configuration {
    bool calcomp565 = false;
    devices::PlotterPlace calcomp565_start{};
    Restart calcomp565_restart;  // on DONE
  };
  template <class Sink>
  using Device = devices::CalComp565<Sink>;
  static constexpr DeviceKind kind = DeviceKind::plotter;
  static constexpr std::string_view name = "calcomp565";
  static constexpr std::string_view choice = "calcomp";
  static constexpr std::int64_t micrometres_a_step = 254;
  static constexpr bool Configuration::*attached = &Configuration::calcomp565;
  static constexpr std::array reads{PortRange{0x60, 0x60}};
  static constexpr std::array writes = reads;
  static constexpr std::array lines{
      InterruptLine<Configuration>{"calcomp", &Configuration::calcomp565_restart}};

  template <class Sink>
  static void make(std::optional<Device<Sink>>& plotter, const Configuration& wanted, core::ClockRate clock,
                   Sink& sink) {
    if (wanted.calcomp565) plotter.emplace(clock, sink, wanted.calcomp565_start);
  }
  template <class Sink>
  static std::uint8_t read(devices::CalComp565<Sink>& plotter, std::uint8_t, core::TStateInstant at) {
    return plotter.read_status(at);
  }
  template <class Sink>
  static void write(devices::CalComp565<Sink>& plotter, std::uint8_t, std::uint8_t value,
                    core::TStateInstant at) {
    plotter.write(value, at);
  }
  template <class Sink>
  static bool requests(const devices::CalComp565<Sink>& plotter, std::size_t) {
    return plotter.done();
  }
  template <class Sink, class Take>
  static void count(const devices::CalComp565<Sink>& plotter, Take take) {
    const devices::CalComp565Counts& counts = plotter.counts();
    take("steps", counts.steps);
    take("steps_pen_up", counts.steps_pen_up);
    take("pen_lifts", counts.pen_lifts);
    take("pen_commands", counts.pen_commands);
    take("commands_while_busy", counts.commands_while_busy);
    take("off_carriage", counts.off_carriage);
    take("unknown_codes", counts.unknown_codes);
    take("off_paper", counts.off_paper);
    take("busy_t_states", static_cast<std::uint64_t>(counts.busy.count()));
  }
};

struct Minigraf0507Row {
  struct Configuration {
    bool minigraf0507 = false;
    devices::MinigrafTimes minigraf0507_times{};
  };
  template <class Sink>
  using Device = devices::Minigraf0507<Sink>;
  static constexpr DeviceKind kind = DeviceKind::plotter;
  static constexpr std::string_view name = "minigraf0507";
  static constexpr std::string_view choice = "minigraf";
  static constexpr std::int64_t micrometres_a_step = 125;
  static constexpr bool Configuration::*attached = &Configuration::minigraf0507;
  static constexpr std::array<PortRange, 0> reads{};
  static constexpr std::array writes{PortRange{0xF0, 0xF0}};
  static constexpr std::array<InterruptLine<Configuration>, 0> lines{};

  template <class Sink>
  static void make(std::optional<Device<Sink>>& plotter, const Configuration& wanted, core::ClockRate clock,
                   Sink& sink) {
    if (wanted.minigraf0507) plotter.emplace(clock, sink, wanted.minigraf0507_times);
  }
  template <class Sink>
  static void write(devices::Minigraf0507<Sink>& plotter, std::uint8_t, std::uint8_t value,
                    core::TStateInstant at) {
    plotter.write(value, at);
  }
  template <class Sink, class Take>
  static void count(const devices::Minigraf0507<Sink>& plotter, Take take) {
    const devices::MinigrafCounts& counts = plotter.counts();
    take("steps", counts.steps);
    take("steps_pen_up", counts.steps_pen_up);
    take("pen_lifts", counts.pen_lifts);
    take("missed_fast", counts.missed_fast);
    take("missed_jump", counts.missed_jump);
    take("steps_early", counts.steps_early);
    take("off_field", counts.off_field);
  }
};

struct ParallelRow {
  struct Configuration {
    HostBytes parallel;
    devices::ParallelHost parallel_host{};
    Restart parallel_restart;  // on INTR of port A or B
  };
  template <class>
  using Device = devices::ParallelLink;
  static constexpr DeviceKind kind = DeviceKind::link;
  static constexpr std::string_view name = "parallel";
  static constexpr std::string_view chip = "8255";
  static constexpr std::string_view received_by_host = "What the host took from the 8255";
  static constexpr HostBytes Configuration::*bytes = &Configuration::parallel;
  static constexpr std::array reads{PortRange{0xE4, 0xE7}};
  static constexpr std::array writes = reads;
  static constexpr std::array lines{
      InterruptLine<Configuration>{"parallel", &Configuration::parallel_restart}};

  template <class Sink>
  static void make(std::optional<devices::ParallelLink>& link, const Configuration& wanted,
                   core::ClockRate clock, Sink&) {
    if (wanted.parallel) link.emplace(clock, *wanted.parallel, wanted.parallel_host);
  }
  static std::uint8_t read(devices::ParallelLink& link, std::uint8_t port, core::TStateInstant at) {
    return link.read(port & 3U, at);
  }
  static void write(devices::ParallelLink& link, std::uint8_t port, std::uint8_t value,
                    core::TStateInstant at) {
    link.write(port & 3U, value, at);
  }
  static bool requests(const devices::ParallelLink& link, std::size_t) { return link.interrupt(); }
  // take(KeptBytes) of what the host took: from port B, then from port A.
  template <class Take>
  static void received(const devices::ParallelLink& link, Take take) {
    take(link.received(devices::I8255::Port::b));
    take(link.received(devices::I8255::Port::a));
  }
  template <class Take>
  static void count(const devices::ParallelLink& link, Take take) {
    std::uint64_t total = 0;
    std::uint64_t left_out = 0;
    received(link, [&](const devices::KeptBytes& bytes) {
      total += bytes.total();
      left_out += bytes.left_out();
    });
    take("sent_by_host", link.sent());
    take("received_by_host", total);
    take(not_kept, left_out);
  }
};

struct SerialRow {
  struct Configuration {
    HostBytes serial;
    devices::SerialHost serial_host{};
    Restart serial_receive_restart;   // on RxRDY
    Restart serial_transmit_restart;  // on TxRDY
  };
  template <class>
  using Device = devices::SerialLink;
  static constexpr DeviceKind kind = DeviceKind::link;
  static constexpr std::string_view name = "serial";
  static constexpr std::string_view chip = "8251";
  static constexpr std::string_view received_by_host = "What the 8251 sent to the host";
  static constexpr HostBytes Configuration::*bytes = &Configuration::serial;
  static constexpr std::array reads{PortRange{0xEC, 0xEF}};
  static constexpr std::array writes = reads;
  static constexpr std::array lines{
      InterruptLine<Configuration>{"serial-receive", &Configuration::serial_receive_restart},
      InterruptLine<Configuration>{"serial-transmit", &Configuration::serial_transmit_restart}};

  template <class Sink>
  static void make(std::optional<devices::SerialLink>& link, const Configuration& wanted,
                   core::ClockRate clock, Sink&) {
    if (wanted.serial) link.emplace(clock, *wanted.serial, wanted.serial_host);
  }
  static std::uint8_t read(devices::SerialLink& link, std::uint8_t port, core::TStateInstant at) {
    return link.read(port & 1U, at);
  }
  static void write(devices::SerialLink& link, std::uint8_t port, std::uint8_t value,
                    core::TStateInstant at) {
    link.write(port & 1U, value, at);
  }
  static bool requests(const devices::SerialLink& link, std::size_t line) {
    return line == 0 ? link.chip().receive_ready() : link.chip().transmit_ready();
  }
  template <class Take>
  static void received(const devices::SerialLink& link, Take take) {
    take(link.chip().sent());
  }
  template <class Take>
  static void count(const devices::SerialLink& link, Take take) {
    const devices::I8251Counts& counts = link.chip().counts();
    take("sent_by_host", link.sent());
    take("unseen", link.unseen());
    take("received", counts.received);
    take("received_lost", counts.received_lost);
    take("overruns", counts.overruns);
    take("parity_errors", counts.parity_errors);
    take("framing_errors", counts.framing_errors);
    take("transmitted", counts.transmitted);
    take("transmit_overwritten", counts.transmit_overwritten);
    take(not_kept, link.chip().sent().left_out());
    take("unanswered", counts.unanswered);
  }
};

// What the rows of both boards have in common.
template <devices::AltairBoard board>
struct AltairRow {
  template <class>
  using Device = devices::AltairSerial;
  static constexpr DeviceKind kind = DeviceKind::terminal;

  static std::uint8_t read(devices::AltairSerial& serial, std::uint8_t port, core::TStateInstant at) {
    return serial.read(port & 1U, at);
  }
  static void write(devices::AltairSerial& serial, std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    serial.write(port & 1U, value, at);
  }
  static bool requests(const devices::AltairSerial& serial, std::size_t) { return serial.interrupt(); }
  template <class Take>
  static void count(const devices::AltairSerial& serial, Take take) {
    take("received", serial.counts().received);
    take("sent", serial.counts().sent);
    take("overwritten", serial.counts().overwritten);
  }
};

struct AltairSioRow : AltairRow<devices::AltairBoard::sio> {
  struct Configuration {
    bool sio = false;
    std::uint32_t sio_baud = 9600;
    Restart sio_restart;
  };
  static constexpr std::string_view name = "sio";
  static constexpr std::string_view choice = "sio";
  static constexpr bool Configuration::*attached = &Configuration::sio;
  static constexpr std::uint32_t Configuration::*baud = &Configuration::sio_baud;
  static constexpr std::array reads{PortRange{0x00, 0x01}};
  static constexpr std::array writes = reads;
  static constexpr std::array lines{InterruptLine<Configuration>{"sio", &Configuration::sio_restart}};

  template <class Sink>
  static void make(std::optional<devices::AltairSerial>& serial, const Configuration& wanted, core::ClockRate clock, Sink&) {
    if (wanted.sio) serial.emplace(clock, devices::AltairBoard::sio, wanted.sio_baud);
  }
};

struct Altair2SioRow : AltairRow<devices::AltairBoard::two_sio> {
  struct Configuration {
    bool two_sio = false;
    std::uint32_t two_sio_baud = 9600;
    Restart two_sio_restart;
  };
  static constexpr std::string_view name = "2sio";
  static constexpr std::string_view choice = "2sio";
  static constexpr bool Configuration::*attached = &Configuration::two_sio;
  static constexpr std::uint32_t Configuration::*baud = &Configuration::two_sio_baud;
  static constexpr std::array reads{PortRange{0x10, 0x11}};
  static constexpr std::array writes = reads;
  static constexpr std::array lines{InterruptLine<Configuration>{"2sio", &Configuration::two_sio_restart}};

  template <class Sink>
  static void make(std::optional<devices::AltairSerial>& serial, const Configuration& wanted, core::ClockRate clock, Sink&) {
    if (wanted.two_sio) serial.emplace(clock, devices::AltairBoard::two_sio, wanted.two_sio_baud);
  }
};

using SkalaRows = PortRows<Ef9365Row, Alt256Row, CalComp565Row, Minigraf0507Row, ParallelRow, SerialRow, AltairSioRow,
                           Altair2SioRow>;
using SkalaConfiguration = SkalaRows::Configuration;

template <class PlotterSink = core::NoStrokes>
class SkalaPorts : public PortTable<PlotterSink, SkalaRows> {
 public:
  using PortTable<PlotterSink, SkalaRows>::PortTable;

  // The devices, null when absent.
  [[nodiscard]] auto* ef9365() { return this->template device<Ef9365Row>(); }
  [[nodiscard]] auto* alt256() { return this->template device<Alt256Row>(); }
  [[nodiscard]] auto* calcomp565() { return this->template device<CalComp565Row>(); }
  [[nodiscard]] auto* minigraf0507() { return this->template device<Minigraf0507Row>(); }
  [[nodiscard]] auto* parallel() { return this->template device<ParallelRow>(); }
  [[nodiscard]] auto* serial() { return this->template device<SerialRow>(); }
  [[nodiscard]] auto* sio() { return this->template device<AltairSioRow>(); }
  [[nodiscard]] auto* two_sio() { return this->template device<Altair2SioRow>(); }
};

}  // namespace sightline::machines
