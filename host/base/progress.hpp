// User interface of a long run: a line of progress on a terminal, and Ctrl-C.
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

namespace sightline::base {

// While it lives the first Ctrl-C is remembered instead of ending the process; a second one ends it.
class InterruptKey {
 public:
  InterruptKey();
  ~InterruptKey();
  InterruptKey(const InterruptKey&) = delete;
  InterruptKey& operator=(const InterruptKey&) = delete;

  [[nodiscard]] static bool pressed();
};

// Rewrites one line on standard error a few times a second, beginning after one second; no effect unless
// standard error is a terminal that can. Host time decides when it is shown, never what the run does.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(std::string_view text);  // one line, printable
  // Of a run on an emulated machine; says how to stop it.
  void show_run(std::uint64_t emulated_nanoseconds, std::uint64_t instructions);

 private:
  [[nodiscard]] bool is_time();

  std::chrono::steady_clock::time_point next_;
  bool terminal_ = false;
  bool shown_ = false;
};

}  // namespace sightline::base
