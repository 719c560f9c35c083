// The texts of an 8080 run: trace and bus log while it runs, the line of registers in trace and dump.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "emulators/i8080/state.hpp"
#include "emulators/machines/i8080_observer.hpp"
#include "host/guests/run/i8080.hpp"

namespace sightline::harness {

// As i8080_registers_help says, without an end of line.
void append_registers(fmt::memory_buffer& text, const i8080::State& state);

// An observer that writes what has a taker in the job, in blocks; the job outlives it.
class I8080Recorder {
 public:
  static constexpr bool instructions = true;
  static constexpr bool cycles = true;
  static constexpr bool stops = false;

  explicit I8080Recorder(const I8080Job& job) : job_(job) {}

  void instruction(const machines::I8080InstructionRecord& record) {
    if (job_.trace) trace(record);
  }
  void cycle(const machines::I8080Cycle& cycle) {
    if (job_.bus) bus(cycle);
  }
  // Hands out what is left.
  void finish();

 private:
  struct Remembered {
    std::array<i8080::Byte, 3> bytes;
    int length = 0;  // 0: nothing remembered
    std::string text;
  };

  void trace(const machines::I8080InstructionRecord& record);
  void bus(const machines::I8080Cycle& cycle);
  const Remembered& disassembled(const machines::I8080InstructionRecord& record);

  const I8080Job& job_;
  fmt::memory_buffer trace_text_;
  fmt::memory_buffer bus_text_;
  std::vector<Remembered> remembered_ = std::vector<Remembered>(65536);
};

}  // namespace sightline::harness
