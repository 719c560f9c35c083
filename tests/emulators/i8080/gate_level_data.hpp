// Readers of tests/data/i8080: what a gate-level model of the processor does, by instructions and by random programs.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "emulators/i8080/state.hpp"

namespace sightline::tests {

// --- single-step.txt ---

struct Cell {
  unsigned address;
  unsigned byte;
};

struct Case {
  std::string name;
  std::size_t t_states = 0;
  bool halts = false;
  i8080::State initial;
  i8080::State final;
  std::vector<Cell> memory_before;
  std::vector<Cell> memory_after;
  std::vector<std::string> rows;       // "T ADDRESS DATA FLAGS", address -- where it is undefined
  std::vector<std::string> transfers;  // "KIND ADDRESS DATA STATUS"
};

inline i8080::State read_state(std::istream& line, std::vector<Cell>& memory) {
  unsigned pc = 0, sp = 0, a = 0, f = 0, bc = 0, de = 0, hl = 0, inte = 0;
  line >> std::hex >> pc >> sp >> a >> f >> bc >> de >> hl >> inte;
  Cell cell{};
  for (char colon = 0; line >> cell.address >> colon >> cell.byte;) memory.push_back(cell);
  i8080::State state;
  state.pc = static_cast<i8080::Address>(pc);
  state.sp = static_cast<i8080::Address>(sp);
  state.a = static_cast<i8080::Byte>(a);
  state.f = static_cast<i8080::Byte>(f);
  state.bc = static_cast<i8080::Address>(bc);
  state.de = static_cast<i8080::Address>(de);
  state.hl = static_cast<i8080::Address>(hl);
  state.interrupts_on = inte != 0;
  return state;
}

inline std::vector<Case> read_cases() {
  std::ifstream file(SIGHTLINE_TEST_DATA "/i8080/single-step.txt");
  std::vector<Case> cases;
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    std::string word;
    line >> word;
    if (word == "case") {
      Case& next = cases.emplace_back();
      std::string t, halt;
      line >> next.name >> t >> halt;
      next.t_states = std::stoul(t.substr(2));
      next.halts = halt == "halt=1";
    } else if (word == "initial") {
      cases.back().initial = read_state(line, cases.back().memory_before);
    } else if (word == "final") {
      cases.back().final = read_state(line, cases.back().memory_after);
    } else if (word[0] >= '0' && word[0] <= '9') {
      std::string t, address, rest;
      line >> t >> address;
      std::getline(line, rest);
      cases.back().rows.push_back(t + (t == "4" || t == "5" ? " --" : " " + address) + rest);
    } else {
      cases.back().transfers.push_back(text);
    }
  }
  return cases;
}

inline std::string hexadecimal(unsigned value, int digits) {
  std::string text;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) text += "0123456789ABCDEF"[value >> shift & 15U];
  return text;
}

// --- pins.txt ---

using Fields = std::vector<std::string>;

struct Program {
  Fields header;
  std::vector<Fields> rows;  // inputs, T-state, address, data, flags, status
  Fields end;                // registers after the last row
};

inline std::vector<Program> read_programs() {
  std::ifstream file(SIGHTLINE_TEST_DATA "/i8080/pins.txt");
  std::vector<Program> programs;
  for (std::string text; std::getline(file, text);) {
    std::istringstream line(text);
    Fields fields;
    for (std::string field; line >> field;) fields.push_back(field);
    if (fields.empty()) continue;
    if (fields[0] == "CASE") programs.push_back({fields, {}, {}});
    else if (fields[0] == "END") programs.back().end = fields;
    else programs.back().rows.push_back(fields);
  }
  return programs;
}

inline std::uint64_t value_of(const Fields& line, const std::string& key, int base = 16) {
  for (const std::string& field : line) {
    if (field.rfind(key + "=", 0) == 0) return std::stoull(field.substr(key.size() + 1), nullptr, base);
  }
  ADD_FAILURE() << "no " << key << " in " << line[0];
  return 0;
}

inline i8080::Byte memory_byte(std::uint64_t i, std::uint64_t salt, std::uint64_t bias) {
  std::uint64_t z = (i + 1) * 0x9E3779B97F4A7C15U ^ salt * 0xBF58476D1CE4E5B9U;
  z ^= z >> 29;
  z *= 0x94D049BB133111EBU;
  z ^= z >> 32;
  if (bias == 1 && (z >> 40) % 4 == 0) return 0xFB;
  if (bias == 2 && (z >> 40) % 8 == 0) return 0x76;
  return static_cast<i8080::Byte>(z);
}

inline i8080::State initial_state(const Program& program) {
  const auto pair = [&](const char* key) { return static_cast<i8080::Address>(value_of(program.header, key)); };
  i8080::State state;
  state.pc = pair("pc");
  state.sp = pair("sp");
  state.a = static_cast<i8080::Byte>(value_of(program.header, "a"));
  state.f = static_cast<i8080::Byte>(value_of(program.header, "f"));
  state.bc = pair("bc");
  state.de = pair("de");
  state.hl = pair("hl");
  state.interrupts_on = value_of(program.header, "inte") != 0;
  return state;
}

// Where the chip has a transparent latch the model knows only one instant per clock phase. If HOLD falls in the T-state in which
// a
// cycle ends, the model never starts again: from there on 31 of the programs show only held T-states. Returns true at such a
// place
// if the processor under test began its next cycle as the manual says.
// `begins`: the T-state found is a T1.
inline bool model_hangs(const Program& program, bool begins, std::size_t at) {
  if (at < 2 || !begins || program.rows[at - 1][1] == "-") return false;
  const bool released = program.rows[at - 1][0][2] == '0' && program.rows[at - 2][0][2] == '1';
  bool silent = true;
  for (std::size_t i = at; i < program.rows.size(); ++i) {
    silent = silent && program.rows[i][1] == "-" && program.rows[i][4].find('H') == std::string::npos;
  }
  return released && silent;
}

}  // namespace sightline::tests
