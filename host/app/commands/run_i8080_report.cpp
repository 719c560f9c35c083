// See run_i8080_report.hpp.
#include "host/app/commands/run_i8080_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "host/base/json.hpp"

namespace sightline::app {

namespace {

using base::Json;

// Nine digits behind the point, rounded down. From T-states: nanoseconds end after 292 years.
std::string seconds_text(core::TStateInstant t, core::ClockRate clock) {
  constexpr std::int64_t second = 1'000'000'000;
  const std::int64_t t_states = core::t_states_of(t);
  return fmt::format("{}.{:09}", t_states / clock.hertz, t_states % clock.hertz * second / clock.hertz);
}

// null where no 64 bits hold it.
Json nanoseconds(core::Instant t) {
  return t == core::never ? Json() : Json(core::nanoseconds_of(t));
}

std::string byte_text(unsigned byte) {
  return fmt::format("{:02X}", byte);
}
std::string address_text(unsigned address) {
  return fmt::format("{:04X}", address);
}

// Bytes as the characters of Latin-1, in UTF-8: JSON has no bytes.
std::string as_utf8(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text.push_back(c);
    } else {
      text.push_back(static_cast<char>(0xC0U | byte >> 6));
      text.push_back(static_cast<char>(0x80U | (byte & 0x3FU)));
    }
  }
  return text;
}

Json registers_of(const i8080::State& r) {
  return {{"a", byte_text(r.a)},
          {"f", byte_text(r.f)},
          {"b", byte_text(i8080::high(r.bc))},
          {"c", byte_text(i8080::low(r.bc))},
          {"d", byte_text(i8080::high(r.de))},
          {"e", byte_text(i8080::low(r.de))},
          {"h", byte_text(i8080::high(r.hl))},
          {"l", byte_text(i8080::low(r.hl))},
          {"sp", address_text(r.sp)},
          {"pc", address_text(r.pc)},
          {"inte", r.interrupts_on ? 1 : 0}};
}

std::string times(std::uint64_t n, std::string_view what) {
  return n == 1 ? fmt::format("once {}", what) : fmt::format("{} times {}", n, what);
}

// Where the IN or OUT of the stop stands: PC has gone on.
i8080::Address port_instruction_before(i8080::Address pc) {
  return static_cast<i8080::Address>(pc - 2);
}

}  // namespace

std::string json_report(const harness::I8080Job& job, const harness::I8080Report& report,
                        const std::optional<std::string>& console) {
  const core::ClockRate clock = job.machine.clock;
  const double seconds =
      static_cast<double>(core::t_states_of(report.end)) / static_cast<double>(clock.hertz);
  Json document{{"schema", "sightline/run-i8080/1"},
                {"stop_reason", harness::name_of(report.stop)},
                {"pc", address_text(report.registers.pc)},
                {"instructions", report.instructions},
                {"t_states", core::t_states_of(report.end)},
                {"clock_hz", clock.hertz},
                {"emulated_ns", nanoseconds(clock.to_nanoseconds(report.end))},
                {"emulated_seconds", seconds},
                {"registers", registers_of(report.registers)},
                {"cpm", job.cpm}};
  if (report.stop == harness::I8080Stop::unknown_bdos || report.stop == harness::I8080Stop::endless_string) {
    document["bdos"] = {{"function", report.bdos_function}, {"caller", address_text(report.bdos_caller)}};
  }
  if (console) document["console"] = as_utf8(*console);
  document["devices"] = Json::object();
  for (const harness::DeviceReport& device : report.devices) {
    for (const auto& [name, count] : device.counts) document["devices"][device.device][name] = count;
  }
  document["unanswered"] = Json::array();
  for (const harness::I8080UnansweredPort& port : report.unanswered) {
    document["unanswered"].push_back(
        {{"port", byte_text(port.port)}, {"reads", port.reads}, {"writes", port.writes}});
  }
  return document.dump(2) + "\n";
}

std::string table_report(const harness::I8080Job& job, const harness::I8080Report& report) {
  const i8080::State& r = report.registers;
  std::string reason(harness::name_of(report.stop));
  std::replace(reason.begin(), reason.end(), '_', ' ');
  std::string text = fmt::format("stopped by      {}, PC {:04X}\n", reason, r.pc);
  text += fmt::format("T-states        {}\n", core::t_states_of(report.end));
  text += fmt::format("emulated time   {} s at {} Hz\n", seconds_text(report.end, job.machine.clock),
                      job.machine.clock.hertz);
  text += fmt::format("instructions    {}\n", report.instructions);
  for (const harness::DeviceReport& device : report.devices) {
    std::string counts;
    for (const auto& [name, count] : device.counts) {
      if (count == 0) continue;
      std::string spoken(name);
      std::replace(spoken.begin(), spoken.end(), '_', ' ');
      counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", spoken, count);
    }
    text += fmt::format("{:<15} {}\n", device.device, counts.empty() ? "nothing" : counts);
  }
  text += fmt::format(
      "registers       A {:02X}  F {:02X}  B {:02X}  C {:02X}  D {:02X}  E {:02X}  H {:02X}  L {:02X}  SP "
      "{:04X}  INTE {}\n",
      r.a, r.f, i8080::high(r.bc), i8080::low(r.bc), i8080::high(r.de), i8080::low(r.de), i8080::high(r.hl),
      i8080::low(r.hl), r.sp, r.interrupts_on ? 1 : 0);
  return text;
}

void warn_about(const harness::I8080Report& report) {
  for (const harness::DeviceReport& device : report.devices) {
    for (const auto& [name, count] : device.counts) {
      if (name == harness::not_kept && count != 0)
        warn(fmt::format("{}: the last {} bytes from the program were not kept", device.device, count));
    }
  }
  for (const harness::I8080UnansweredPort& port : report.unanswered) {
    if (port.reads != 0)
      warn(fmt::format("port {:02X}: nothing answers, {}", port.port, times(port.reads, "read as FF")));
    if (port.writes != 0)
      warn(fmt::format("port {:02X}: nothing answers, {}", port.port, times(port.writes, "written in vain")));
  }
}

ExitCode judge(const harness::I8080Report& report) {
  switch (report.stop) {
    case harness::I8080Stop::interrupted:
      complain("stopped by Ctrl-C; all outputs hold what was done so far");
      return ExitCode::interrupted;
    case harness::I8080Stop::unknown_bdos:
      complain(fmt::format("PC {:04X}: stopped: found a call of BDOS function {}, expected 0, 2 or 9",
                           report.bdos_caller, report.bdos_function));
      return ExitCode::guest_failed;
    case harness::I8080Stop::endless_string:
      complain(fmt::format(
          "PC {:04X}: stopped: found no $ in memory for BDOS function 9, expected one to end the text",
          report.bdos_caller));
      return ExitCode::guest_failed;
    case harness::I8080Stop::unanswered:
      complain(fmt::format("PC {:04X}: stopped by --strict: nothing answers at that port",
                           port_instruction_before(report.registers.pc)));
      return ExitCode::guest_failed;
    default: return ExitCode::ok;
  }
}

}  // namespace sightline::app
