// The input and output ports of the 8080 of Willis's flights: the priority display (70-72) and the 8255 of the link to the host (E4-E7).
// Sources: as devices/priority_board.hpp and skala_ports.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "../core/stroke.hpp"
#include "../core/tstates.hpp"
#include "../devices/priority_board.hpp"
#include "port_table.hpp"
#include "skala_ports.hpp"

namespace sightline::machines {

struct PriorityRow {
  struct Configuration {
    bool priority_display = false;
  };
  template <class>
  using Device = devices::PriorityBoard;
  static constexpr std::string_view name = "priority";
  static constexpr std::uint8_t first_port = 0x70;
  static constexpr std::array reads{PortRange{first_port, first_port + 2}};
  static constexpr std::array writes = reads;
  static constexpr std::array<InterruptLine<Configuration>, 0> lines{};

  template <class Sink>
  static void make(std::optional<devices::PriorityBoard>& board, const Configuration& wanted, core::ClockRate clock, Sink&) {
    if (wanted.priority_display) board.emplace(clock);
  }
  static std::uint8_t read(devices::PriorityBoard& board, std::uint8_t port, core::TStateInstant at) {
    return board.read(static_cast<std::uint8_t>(port - first_port), at);
  }
  static void write(devices::PriorityBoard& board, std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    board.write(static_cast<std::uint8_t>(port - first_port), value, at);
  }
};

using FlightRows = PortRows<PriorityRow, ParallelRow>;
using FlightConfiguration = FlightRows::Configuration;

class FlightPorts : public PortTable<core::NoStrokes, FlightRows> {
 public:
  using Base = PortTable<core::NoStrokes, FlightRows>;
  using Base::Base;

  [[nodiscard]] devices::PriorityBoard* priority() { return device<PriorityRow>(); }
  [[nodiscard]] devices::ParallelLink* parallel() { return device<ParallelRow>(); }
};

}  // namespace sightline::machines
