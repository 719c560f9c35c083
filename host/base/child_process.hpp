// Runs work that may crash, never end or exhaust memory, such as a library that reads damaged files, in a child process.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "host/base/result.hpp"

namespace sightline::base {

struct ChildLimits {
  unsigned seconds = 60;                     // processor time
  std::size_t memory = std::size_t{4} << 30;  // bytes of address space; not limited under AddressSanitizer, which maps terabytes
};

// Runs `work` in a forked copy of this process and returns its result; what it changes or prints is lost. It may throw.
// Errors have neither file nor place: the work threw, crashed or exceeded a limit, or no process could be started.
// The calling process has one thread (precondition).
[[nodiscard]] Result<std::string> run_in_child(const std::function<Result<std::string>()>& work, const ChildLimits& limits = {});

}  // namespace sightline::base
