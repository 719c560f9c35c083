// See run_i8080_settings.hpp.
#include "host/app/commands/run_i8080_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "emulators/devices/calcomp565.hpp"
#include "host/app/byte_image_argument.hpp"
#include "host/app/command.hpp"
#include "host/base/number.hpp"

namespace sightline::app {

namespace {

i8080::Address with_high(i8080::Address pair, std::uint32_t value) {
  return i8080::joined(static_cast<i8080::Byte>(value), i8080::low(pair));
}
i8080::Address with_low(i8080::Address pair, std::uint32_t value) {
  return i8080::joined(i8080::high(pair), static_cast<i8080::Byte>(value));
}

struct RegisterName {
  std::string_view name;
  std::uint32_t most;
  void (*set)(i8080::State& state, std::uint32_t value);
};

constexpr std::array<RegisterName, 11> register_names{{
    {"A", 0xFF, [](i8080::State& s, std::uint32_t v) { s.a = static_cast<i8080::Byte>(v); }},
    {"F", 0xFF, [](i8080::State& s, std::uint32_t v) { s.f = i8080::as_flags(static_cast<i8080::Byte>(v)); }},
    {"B", 0xFF, [](i8080::State& s, std::uint32_t v) { s.bc = with_high(s.bc, v); }},
    {"C", 0xFF, [](i8080::State& s, std::uint32_t v) { s.bc = with_low(s.bc, v); }},
    {"D", 0xFF, [](i8080::State& s, std::uint32_t v) { s.de = with_high(s.de, v); }},
    {"E", 0xFF, [](i8080::State& s, std::uint32_t v) { s.de = with_low(s.de, v); }},
    {"H", 0xFF, [](i8080::State& s, std::uint32_t v) { s.hl = with_high(s.hl, v); }},
    {"L", 0xFF, [](i8080::State& s, std::uint32_t v) { s.hl = with_low(s.hl, v); }},
    {"SP", 0xFFFF, [](i8080::State& s, std::uint32_t v) { s.sp = static_cast<i8080::Address>(v); }},
    {"PC", 0xFFFF, [](i8080::State& s, std::uint32_t v) { s.pc = static_cast<i8080::Address>(v); }},
    {"INTE", 1, [](i8080::State& s, std::uint32_t v) { s.interrupts_on = v != 0; }},
}};

struct InterruptName {
  std::string_view name;
  machines::Restart machines::SkalaConfiguration::*restart;
};

constexpr std::array<InterruptName, 5> interrupt_names{{
    {"ef9365", &machines::SkalaConfiguration::ef9365_restart},
    {"calcomp", &machines::SkalaConfiguration::calcomp565_restart},
    {"parallel", &machines::SkalaConfiguration::parallel_restart},
    {"serial-receive", &machines::SkalaConfiguration::serial_receive_restart},
    {"serial-transmit", &machines::SkalaConfiguration::serial_transmit_restart},
}};

template <class Names>
std::string all_names(const Names& names) {
  std::string text;
  for (const auto& row : names) text += fmt::format(" {}", row.name);
  return text;
}

}  // namespace

std::uint32_t hexadecimal_argument(std::string_view option, std::string_view text, std::uint32_t most,
                                   std::string_view what) {
  const auto value = base::whole_number<std::uint32_t>(without_hexadecimal_mark(text), 16);
  if (value && *value <= most) return *value;
  throw Failure(ExitCode::usage, fmt::format("{}: found \"{}\", expected {}, hexadecimal, 0 to {:X}", option,
                                             text, what, most));
}

std::string register_named(const std::string& text) {
  std::string name = text.substr(0, text.find('='));
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

void set_i8080_register(i8080::State& registers, const std::string& text) {
  const std::string name = register_named(text);
  const auto* const row = std::find_if(register_names.begin(), register_names.end(),
                                       [&name](const RegisterName& r) { return r.name == name; });
  const std::size_t equals = text.find('=');
  if (row == register_names.end() || equals == std::string::npos) {
    throw Failure(ExitCode::usage, fmt::format("--set: found \"{}\", expected REGISTER=VALUE with one of{}",
                                               text, all_names(register_names)));
  }
  row->set(registers, hexadecimal_argument("--set " + name, std::string_view(text).substr(equals + 1),
                                           row->most, "a value"));
}

devices::PlotterPlace plotter_place(std::string_view option, const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view whole = text;
  const auto x = base::whole_number<std::uint16_t>(whole.substr(0, comma), 10);
  const auto y = base::whole_number<std::uint16_t>(whole.substr(std::min(comma + 1, text.size())), 10);
  constexpr std::int32_t highest = devices::calcomp565::carriage_steps;
  if (x && y && *y <= highest) return {*x, *y};
  throw Failure(
      ExitCode::usage,
      fmt::format("{}: found \"{}\", expected X,Y, decimal, X 0 to 65535, Y 0 to {}", option, text, highest));
}

void wire_interrupt(machines::SkalaConfiguration& machine, const std::string& text, bool has_parallel,
                    bool has_serial) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = std::string_view(text).substr(0, equals);
  const auto* const row = std::find_if(interrupt_names.begin(), interrupt_names.end(),
                                       [name](const InterruptName& r) { return r.name == name; });
  const auto restart =
      base::whole_number<std::uint8_t>(std::string_view(text).substr(std::min(equals + 1, text.size())), 10);
  if (row == interrupt_names.end() || !restart || *restart > 7) {
    throw Failure(ExitCode::usage,
                  fmt::format("--interrupt: found \"{}\", expected DEVICE=N with N of 0 to 7 and one of{}",
                              text, all_names(interrupt_names)));
  }
  const bool there = name == "ef9365"     ? machine.ef9365
                     : name == "calcomp"  ? machine.calcomp565
                     : name == "parallel" ? has_parallel
                                          : has_serial;
  if (!there) {
    throw Failure(ExitCode::usage,
                  fmt::format("--interrupt: found \"{}\", expected a device that is there", name));
  }
  machine.*row->restart = restart;
}

}  // namespace sightline::app
