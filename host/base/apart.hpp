// Work that may crash, run without an end or need any amount of memory, such as a library that reads damaged files: done
// in a process of its own, which can be lost.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "host/base/result.hpp"

namespace sightline::base {

struct ApartLimits {
  unsigned seconds = 60;                     // of processor time
  std::size_t memory = std::size_t{4} << 30;  // bytes of addresses; not limited under AddressSanitizer, which maps terabytes
};

// What `work` returns, done in a copy of this process; what it changes or prints is lost. It may throw.
// Errors have neither file nor place: what the work threw, that it crashed or met a limit, or that there can
// be no process. This process has one thread (precondition).
[[nodiscard]] Result<std::string> run_apart(const std::function<Result<std::string>()>& work, const ApartLimits& limits = {});

}  // namespace sightline::base
