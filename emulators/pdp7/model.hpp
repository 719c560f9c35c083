// Which PDP-7 processor it is, and how an instruction of it can end.
#pragma once

#include <cstdint>

namespace sightline::pdp7 {

// What the processor was bought with.
struct Model {
  bool eae = true;         // Type 177; without it class 64 does nothing in one cycle
  bool extend = false;     // Type 148 memory extension control
  bool trap_mode = false;  // without it ITON is ION
  bool strict = false;     // an instruction nothing obeys stops the machine
};

enum class Outcome : std::uint8_t { completed, halted, xct_chain, unanswered };

// The longest chain of XCTs taken for a program; the machine itself would follow a closed chain for ever.
inline constexpr int longest_xct_chain = 16;

}  // namespace sightline::pdp7
