// See i8080.hpp.
#include "host/guests/run/i8080.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>

#include "emulators/machines/i8080_machine.hpp"
#include "host/guests/run/i8080_devices.hpp"
#include "host/guests/run/i8080_ports.hpp"
#include "host/guests/run/i8080_text.hpp"

namespace sightline::harness {

namespace {

using Ports = I8080RunPorts<I8080Devices>;

// Emulated in some ten milliseconds: short enough for Ctrl-C, long enough to cost nothing.
constexpr core::TStates time_between_calls{1 << 25};

// PC behind an OUT of the stub.
constexpr i8080::Address behind_exit = 0x0002;
constexpr i8080::Address behind_returned_exit = 0x00D5;
constexpr i8080::Address bdos = 0x0005;
constexpr i8080::Address behind_bdos = 0x0007;

I8080Stop stop_of(machines::I8080StopReason reason) {
  switch (reason) {
    case machines::I8080StopReason::halt: return I8080Stop::halt;
    case machines::I8080StopReason::instruction_limit: return I8080Stop::instruction_limit;
    case machines::I8080StopReason::time_limit: return I8080Stop::state_limit;
    case machines::I8080StopReason::ports: return I8080Stop::unanswered;
    case machines::I8080StopReason::observer: break;
  }
  return I8080Stop::interrupted;
}

// A machine with everything around it; it lives on the heap, the raster boards are large.
template <class Observer>
class Run {
 public:
  Run(const I8080Job& job, Observer& observer)
      : job_(job),
        plotter_(job),
        devices_(configuration_of(job), plotter_),
        ports_(devices_, job.cpm, job.strict),
        machine_(ports_, observer) {
    const auto given = job.memory.bytes();
    std::copy(given.begin(), given.end(), machine_.memory().begin());
    if (job.cpm) {
      for (const auto& [address, byte] : cpm_stub) machine_.deposit(address, byte);
    }
    machine_.registers() = job.registers;
  }

  void run_to_stop() {
    while (true) {
      const I8080Stop stop = run_slice();
      if (stop == I8080Stop::unanswered) {
        if (const auto call = ports_.take_call()) {
          if (answer(*call)) return;
          // Each call begins a new slice: a program that prints all the time never comes to the end of one.
          if (!goes_on()) return end(I8080Stop::interrupted);
          continue;
        }
      }
      const bool slice_done = stop == I8080Stop::state_limit && machine_.now() < job_.limits.until;
      if (!slice_done) return end(stop);
      if (!goes_on()) return end(I8080Stop::interrupted);
    }
  }

  [[nodiscard]] I8080Report report() {
    report_.registers = machine_.registers();
    report_.end = machine_.now();
    report_.instructions = machine_.instructions();
    report_.memory.assign(machine_.memory().begin(), machine_.memory().end());
    for (std::size_t port = 0; port < 256; ++port) {
      const auto& [reads, writes] = devices_.unanswered()[port];
      if (reads + writes != 0) report_.unanswered.push_back({static_cast<std::uint8_t>(port), reads, writes});
    }
    collect_devices(devices_, report_);
    plotter_.finish(report_);
    return std::move(report_);
  }

 private:
  static machines::SkalaConfiguration configuration_of(const I8080Job& job) {
    machines::SkalaConfiguration configuration = job.machine;
    if (job.parallel) configuration.parallel = *job.parallel;
    if (job.serial) configuration.serial = *job.serial;
    return configuration;
  }

  // In slices only if somebody wants to be asked in between; a slice's end changes nothing in the machine.
  I8080Stop run_slice() {
    machines::I8080Limits limits = job_.limits;
    limits.instructions -= machine_.instructions();
    if (job_.keep_running) limits.until = std::min(limits.until, machine_.now() + time_between_calls);
    return stop_of(machine_.run(limits));
  }

  [[nodiscard]] bool goes_on() const {
    return !job_.keep_running || job_.keep_running({machine_.instructions(), machine_.now()});
  }

  void end(I8080Stop stop) { report_.stop = stop; }

  // True when that was the end of the run.
  bool answer(const StubCall& call) {
    const i8080::Address pc = machine_.registers().pc;
    if (call.port == Ports::exit_port && (pc == behind_exit || pc == behind_returned_exit)) {
      end(I8080Stop::exit);
      return true;
    }
    if (call.port == Ports::bdos_port && pc == behind_bdos) return call_bdos();
    ports_.pass_on(call);
    if (!ports_.unanswered()) return false;
    end(I8080Stop::unanswered);
    return true;
  }

  bool call_bdos() {
    i8080::State& registers = machine_.registers();
    report_.bdos_function = i8080::low(registers.bc);
    switch (report_.bdos_function) {
      case 0: registers.pc = 0; return false;
      case 2: print(std::string(1, static_cast<char>(i8080::low(registers.de)))); return false;
      case 9:
        if (const auto text = string_at(registers.de)) {
          print(*text);
          return false;
        }
        return fail(I8080Stop::endless_string);
      default: return fail(I8080Stop::unknown_bdos);
    }
  }
  bool fail(I8080Stop stop) {
    report_.bdos_caller = caller();
    end(stop);
    return true;
  }

  void print(std::string_view text) {
    if (job_.console) job_.console(text);
  }

  // Up to the $ behind it.
  [[nodiscard]] std::optional<std::string> string_at(i8080::Address address) const {
    std::string text;
    for (std::size_t n = 0; n < image::byte_memory_size; ++n) {
      const i8080::Byte byte = machine_.peek(address++);
      if (byte == '$') return text;
      text.push_back(static_cast<char>(byte));
    }
    return std::nullopt;
  }

  // The CALL 5 whose return address is on the stack. A program may have come by a jump instead.
  [[nodiscard]] i8080::Address caller() const {
    const auto at = [this](int address) { return machine_.peek(static_cast<i8080::Address>(address)); };
    const int sp = machine_.registers().sp;
    const int from = i8080::joined(at(sp + 1), at(sp)) - 3;
    constexpr i8080::Byte call = 0xCD;
    const bool called = at(from) == call && i8080::joined(at(from + 2), at(from + 1)) == bdos;
    return called ? static_cast<i8080::Address>(from) : bdos;
  }

  const I8080Job& job_;
  PlotterTaker plotter_;
  I8080Devices devices_;
  Ports ports_;
  machines::I8080Machine<Ports, Observer> machine_;
  I8080Report report_;
};

template <class Observer>
I8080Report run_with(const I8080Job& job, Observer& observer) {
  const auto run = std::make_unique<Run<Observer>>(job, observer);
  run->run_to_stop();
  return run->report();
}

}  // namespace

std::string_view name_of(I8080Stop stop) {
  switch (stop) {
    case I8080Stop::halt: return "halt";
    case I8080Stop::exit: return "exit";
    case I8080Stop::instruction_limit: return "instruction_limit";
    case I8080Stop::state_limit: return "state_limit";
    case I8080Stop::unknown_bdos: return "unknown_bdos";
    case I8080Stop::endless_string: return "endless_string";
    case I8080Stop::unanswered: return "strict";
    case I8080Stop::interrupted: break;
  }
  return "interrupted";
}

I8080Report run_i8080(const I8080Job& job) {
  if (!job.trace && !job.bus) {
    machines::NoI8080Observer nobody;
    return run_with(job, nobody);
  }
  I8080Recorder recorder(job);
  I8080Report report = run_with(job, recorder);
  recorder.finish();
  return report;
}

std::string dump_text(const I8080Report& report) {
  fmt::memory_buffer text;
  append_registers(text, report.registers);
  text.push_back('\n');
  constexpr std::size_t bytes_a_line = 16;
  for (std::size_t a = 0; a < report.memory.size(); ++a) {
    const bool last_in_line = a % bytes_a_line == bytes_a_line - 1;
    fmt::format_to(std::back_inserter(text), "{:02X}{}", report.memory[a], last_in_line ? '\n' : ' ');
  }
  return fmt::to_string(text);
}

}  // namespace sightline::harness
