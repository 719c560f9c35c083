// The small texts a run of the 8080 reads: numbers in hexadecimal, registers, places, interrupts.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "emulators/i8080/state.hpp"
#include "emulators/machines/skala_ports.hpp"

namespace sightline::app {

// Hexadecimal digits up to `most`, with or without 0x before or H behind them. Failure usage: "OPTION: found
// TEXT, expected WHAT".
[[nodiscard]] std::uint32_t hexadecimal_argument(std::string_view option, std::string_view text,
                                                 std::uint32_t most, std::string_view what);

// "NAME=VALUE", NAME one of A F B C D E H L SP PC INTE in either case. Bits of F that the machine does not
// have are passed over. Failure usage.
void set_i8080_register(i8080::State& registers, const std::string& text);

// The name of the register in a "NAME=VALUE", in upper case.
[[nodiscard]] std::string register_named(const std::string& text);

// "X,Y", decimal steps, Y on the carriage of the CalComp. Failure usage.
[[nodiscard]] devices::PlotterPlace plotter_place(std::string_view option, const std::string& text);

// "DEVICE=N": the request of ef9365, calcomp, parallel, serial-receive or serial-transmit is wired to RST N.
// Failure usage, also for a device that the machine does not have; `has_parallel` and `has_serial` tell of
// the links.
void wire_interrupt(machines::SkalaConfiguration& machine, const std::string& text, bool has_parallel,
                    bool has_serial);

}  // namespace sightline::app
