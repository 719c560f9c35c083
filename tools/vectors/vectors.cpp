#include "tools/vectors/vectors.hpp"

#include <fmt/core.h>

#include <array>
#include <map>
#include <random>
#include <utility>

namespace sightline::vectors {

using base::Json;
using i8080::Address;
using i8080::Byte;

namespace {

// Records the pins, and each address of memory that is used.
class Board {
 public:
  explicit Board(const Start& start) : start_(start) {}

  [[nodiscard]] i8080::PinInputs inputs() const { return rows.size() < start_.inputs.size() ? start_.inputs[rows.size()] : i8080::PinInputs{}; }
  Byte read(i8080::Status status, Address address) {
    if ((status & i8080::status::input) != 0) {
      ports.push_back(Json::array({Json(i8080::low(address)), Json(start_.input), Json("r")}));
      return start_.input;
    }
    if ((status & i8080::status::memory_read) == 0) return start_.vector;
    return cell(address);
  }
  void write(i8080::Status status, Address address, Byte byte) {
    if ((status & i8080::status::output) != 0) ports.push_back(Json::array({Json(i8080::low(address)), Json(byte), Json("w")}));
    else cell(address) = byte;
  }
  void t_state(const i8080::PinState& row) { rows.push_back(row); }

  std::map<Address, Byte> before;
  std::map<Address, Byte> after;
  std::vector<i8080::PinState> rows;
  Json ports = Json::array();

 private:
  Byte& cell(Address address) {
    const auto known = after.find(address);
    if (known != after.end()) return known->second;
    return after[address] = before[address] = start_.memory(address);
  }

  const Start& start_;
};

Json state_of(const i8080::State& state, const std::map<Address, Byte>& memory) {
  Json ram = Json::array();
  for (const auto& [address, byte] : memory) ram.push_back(Json::array({Json(address), Json(byte)}));
  return Json{{"pc", state.pc},
              {"sp", state.sp},
              {"a", state.a},
              {"b", i8080::high(state.bc)},
              {"c", i8080::low(state.bc)},
              {"d", i8080::high(state.de)},
              {"e", i8080::low(state.de)},
              {"f", state.f},
              {"h", i8080::high(state.hl)},
              {"l", i8080::low(state.hl)},
              {"inte", state.interrupts_on ? 1 : 0},
              {"ei", state.deferred ? 1 : 0},
              {"halted", state.halted ? 1 : 0},
              {"ram", std::move(ram)}};
}

Json row_of(const i8080::PinState& pins) {
  using enum i8080::TState;
  const bool addressed = pins.state != t4 && pins.state != t5 && pins.state != held && !pins.hold_acknowledge;
  const bool driven = pins.direction != i8080::DataPins::floating && !pins.hold_acknowledge;
  return Json::array({addressed ? Json(pins.address) : Json(), driven ? Json(pins.data) : Json(), Json(pins.status)});
}

std::string active_pins(const i8080::PinState& pins) {
  std::string shown;
  for (const auto& [high, letter] : {std::pair{pins.sync, 's'}, {pins.data_in, 'd'}, {pins.write_strobe, 'w'}, {pins.waiting, 'a'},
                                     {pins.hold_acknowledge, 'h'}, {pins.interrupts_on, 'e'}})
    shown += high ? letter : '-';
  return shown;
}

// The sequence of the engine is fixed by the C++ standard; distributions are not.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t set, std::uint64_t number) : engine_(seed * 1'000'003 + set * 65'537 + number) {}
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }
  bool one_in(std::uint64_t n) { return below(n) == 0; }
  // Every fourth byte is one at which results and flags change.
  Byte byte() {
    static constexpr std::array<Byte, 12> corners{0x00, 0x01, 0x09, 0x0A, 0x0F, 0x10, 0x7F, 0x80, 0x99, 0x9A, 0xF0, 0xFF};
    return one_in(4) ? corners[below(corners.size())] : static_cast<Byte>(below(256));
  }
  Address pair() {
    const Byte first = byte();  // the order in which arguments are computed depends on the compiler
    return i8080::joined(first, byte());
  }
  i8080::State state() {
    i8080::State state;
    state.pc = pair();
    state.sp = pair();
    state.a = byte();
    state.f = i8080::as_flags(static_cast<Byte>(below(256)));
    state.bc = pair();
    state.de = pair();
    state.hl = pair();
    state.interrupts_on = one_in(2);
    return state;
  }
  // Memory of random bytes with an opcode at an address. The contents of an address do not depend on the order of the accesses.
  std::function<Byte(Address)> memory(Address opcode_at, Byte opcode) {
    return [opcode_at, opcode, salt = engine_()](Address address) {
      return address == opcode_at ? opcode : Random(salt, address, 0).byte();
    };
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace

Json run_case(const std::string& name, const Start& start, std::size_t t_states) {
  Board board(start);
  i8080::PinMachine machine(board, start.state);
  do machine.step();
  while (board.rows.size() < t_states);
  Json cycles = Json::array();
  Json pins = Json::array();
  Json inputs = Json::array();
  for (const auto& row : board.rows) {
    cycles.push_back(row_of(row));
    pins.push_back(active_pins(row));
    inputs.push_back(Json::array({Json(row.inputs.interrupt ? 1 : 0), Json(row.inputs.ready ? 1 : 0), Json(row.inputs.hold ? 1 : 0)}));
  }
  Json made{{"name", name},
            {"initial", state_of(start.state, board.before)},
            {"final", state_of(machine.registers(), board.after)},
            {"cycles", std::move(cycles)},
            {"pins", std::move(pins)}};
  if (t_states > 0) {
    made["inputs"] = std::move(inputs);
    made["vector"] = Json(start.vector);
  }
  if (board.ports.size() > 0) made["ports"] = std::move(board.ports);
  return made;
}

std::vector<Json> opcode_cases(Byte opcode, std::size_t number, std::uint64_t seed) {
  std::vector<Json> cases;
  for (std::size_t n = 0; n < number; ++n) {
    Random random(seed, opcode, n);
    Start start{random.state(), {}};
    start.memory = random.memory(start.state.pc, opcode);
    start.input = random.byte();
    cases.push_back(run_case(fmt::format("{:02X} {:04}", opcode, n), start));
  }
  return cases;
}

const std::vector<PinSet>& pin_sets() {
  static const std::vector<PinSet> sets{{"int", true, false, false}, {"ready", false, true, false}, {"hold", false, false, true}, {"pins", true, true, true}};
  return sets;
}

std::vector<Json> pin_cases(const PinSet& set, std::size_t number, std::uint64_t seed) {
  constexpr std::uint64_t opcodes = 256;
  constexpr std::size_t t_states = 40;
  std::vector<Json> cases;
  for (std::size_t n = 0; n < number; ++n) {
    // The numbers of these sets are two apart: their cases, up to 100,000, need more seeds than lie between a number and the next.
    Random random(seed, opcodes + (set.interrupt ? 2U : 0U) + (set.ready ? 4U : 0U) + (set.hold ? 8U : 0U), n);
    Start start{random.state(), {}};
    if (set.interrupt && !random.one_in(4)) start.state.interrupts_on = true;
    start.memory = random.memory(start.state.pc, static_cast<Byte>(n % opcodes));
    start.input = random.byte();
    start.vector = static_cast<Byte>(0xC7 | random.below(8) << 3);  // RST
    // Pins keep their level for some T-states. READY comes back, so that every case ends.
    i8080::PinInputs now;
    for (std::size_t t = 0; t < t_states; ++t) {
      if (set.interrupt && random.one_in(6)) now.interrupt = !now.interrupt;
      if (set.ready) now.ready = now.ready ? !random.one_in(5) : random.one_in(2);
      if (set.hold && random.one_in(now.hold ? 3 : 10)) now.hold = !now.hold;
      start.inputs.push_back(now);
    }
    cases.push_back(run_case(fmt::format("{} {:04}", set.name, n), start, t_states));
  }
  return cases;
}

std::string text_of(const std::vector<Json>& cases) {
  std::string text = "[\n";
  for (std::size_t n = 0; n < cases.size(); ++n) text += cases[n].dump() + (n + 1 < cases.size() ? ",\n" : "\n");
  return text + "]\n";
}

}  // namespace sightline::vectors
