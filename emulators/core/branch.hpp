// A condition that the host has to guess.
#pragma once

#include <type_traits>

#include "inline.hpp"

namespace sightline::core {

// Sets `value` to `other` if `condition` holds, by a branch. What follows must not wait for the condition, as it would if a
// compiler made a conditional move or a sum of it: a processor's PC after a skip or a conditional jump is an example. The
// empty statement keeps compilers from that.
template <class Value>
SIGHTLINE_INLINE constexpr void set_by_branch(bool condition, Value& value, Value other) {
  if (!condition) return;
  value = other;
  if (!std::is_constant_evaluated()) asm("" : "+r"(value));  // NOLINT(hicpp-no-assembler)
}

}  // namespace sightline::core
