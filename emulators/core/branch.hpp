// A condition that the host evaluates by a predicted branch.
#pragma once

#include <type_traits>

#include "inline.hpp"

namespace sightline::core {

// Sets `value` to `other` if `condition` holds, by a branch. With a conditional move or a sum the code that follows would
// wait for the condition; a processor's PC after a skip or a conditional jump is an example. The empty asm statement stops
// compilers from making one.
template <class Value>
SIGHTLINE_INLINE constexpr void set_by_branch(bool condition, Value& value, Value other) {
  if (!condition) return;
  value = other;
  if (!std::is_constant_evaluated()) asm("" : "+r"(value));  // NOLINT(hicpp-no-assembler)
}

}  // namespace sightline::core
