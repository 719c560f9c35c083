// The wide integer in which exact predicates are evaluated: 127 bits and a sign.
#pragma once

#include <cstdint>

namespace sightline::geometry {

// __extension__ because -Wpedantic is right that ISO C++ has no such type; g++ 12 and clang 14 both do.
__extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): an alias-declaration cannot carry it

}  // namespace sightline::geometry
