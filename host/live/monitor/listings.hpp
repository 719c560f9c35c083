// What the monitor shows of a stopped machine: whole lines. What is not to be shown throws base::Error.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/live/debugger.hpp"

namespace sightline::live::monitor {

inline constexpr std::uint32_t most_listed = 4096;  // words or instructions

// Words, each with its instruction; of several on a machine of bytes a dump, 16 a line.
[[nodiscard]] std::string memory(const Debugger& debugger, std::uint32_t first, std::uint32_t last);
// At most so many instructions from `at`, none that begins behind `last`.
[[nodiscard]] std::string disassembly(const Debugger& debugger, std::uint32_t at, std::uint32_t last, std::uint32_t most);
// A number in the radix, in decimal, as a word with a sign and as a place, where it is one.
[[nodiscard]] std::string value(const Debugger& debugger, std::int64_t value);
// Who last wrote that word.
[[nodiscard]] std::string writer(Debugger& debugger, std::uint32_t at);
// The cycles of the instruction that is under way.
[[nodiscard]] std::string cycles(const Debugger& debugger, const Debugger::Cycled& cycled);
// The last so many instructions.
[[nodiscard]] std::string history(Debugger& debugger, std::uint64_t instructions);
// registers, devices, display, stack, time, breaks, conditions or symbols, or the beginning of such a word.
[[nodiscard]] std::string state(Debugger& debugger, std::string_view what);

}  // namespace sightline::live::monitor
