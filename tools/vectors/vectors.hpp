// Test vectors of the 8080 in the JSON form of single-step test collections: registers and memory before and after, and the bus in
// each T-state. README.md explains every member.
//
// The cases are computed by i8080::PinMachine. The authority is the gate-level model whose data the tests compare with that machine
// and with what is written here: tests/data/i8080. Left out: the address pins where they are undefined, data pins that float.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "emulators/i8080/pin_bus.hpp"
#include "host/base/json.hpp"

namespace sightline::vectors {

struct Start {
  i8080::State state;
  std::function<i8080::Byte(i8080::Address)> memory;  // contents before
  i8080::Byte input = 0;                              // what IN reads
  std::vector<i8080::PinInputs> inputs = {};          // by T-state; after them no INT, ready, no HOLD
  i8080::Byte vector = 0;                             // the opcode that an interrupting device gives
};

// Runs one instruction; with `t_states`, whole instructions until so many T-states have passed, and adds the inputs of each.
[[nodiscard]] base::Json run_case(const std::string& name, const Start& start, std::size_t t_states = 0);

// `number` cases of one opcode.
[[nodiscard]] std::vector<base::Json> opcode_cases(i8080::Byte opcode, std::size_t number, std::uint64_t seed);

// Cases of several instructions in which the pins INT, READY and HOLD change at random T-states; the first instructions of 256
// successive cases have all opcodes.
struct PinSet {
  std::string name;
  bool interrupt = false;
  bool ready = false;
  bool hold = false;
};
[[nodiscard]] const std::vector<PinSet>& pin_sets();
[[nodiscard]] std::vector<base::Json> pin_cases(const PinSet& set, std::size_t number, std::uint64_t seed);

// A file of cases: an array with one case on a line.
[[nodiscard]] std::string text_of(const std::vector<base::Json>& cases);

}  // namespace sightline::vectors
