// The listings of the monitor, as complete lines. Requests that cannot be answered throw base::Error.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/live/debugger.hpp"

namespace sightline::live::monitor {

inline constexpr std::uint32_t most_listed = 4096;  // words or instructions

// Words with their instructions; on a machine with bytes, several words are a dump with 16 per line.
[[nodiscard]] std::string memory(const Debugger& debugger, std::uint32_t first, std::uint32_t last);
// At most `most` instructions from `at`; none begins after `last`.
[[nodiscard]] std::string disassembly(const Debugger& debugger, std::uint32_t at, std::uint32_t last, std::uint32_t most);
// The instruction that last wrote a word.
[[nodiscard]] std::string writer(Debugger& debugger, std::uint32_t at);
// The cycles of the current instruction.
[[nodiscard]] std::string cycles(const Debugger& debugger, const Debugger::Cycled& cycled);
// The last `instructions` instructions.
[[nodiscard]] std::string history(Debugger& debugger, std::uint64_t instructions);
// registers, devices, display, stack, time, breaks, conditions or symbols, or the beginning of such a word.
[[nodiscard]] std::string state(Debugger& debugger, std::string_view what);

}  // namespace sightline::live::monitor
