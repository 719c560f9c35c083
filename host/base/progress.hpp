// A progress line on the terminal and Ctrl-C, for long runs.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace sightline::base {

// While it exists the first Ctrl-C is remembered instead of ending the process; a second one ends it.
class InterruptKey {
 public:
  InterruptKey();
  ~InterruptKey();
  InterruptKey(const InterruptKey&) = delete;
  InterruptKey& operator=(const InterruptKey&) = delete;

  [[nodiscard]] static bool pressed();
};

// Rewrites one line on standard error five times a second, from the first second on; no effect unless standard error is a
// terminal that can rewrite a line. Host time decides when the line is shown, never what the run does.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(std::string_view text);  // one line, printable
  void clear();                      // before other output; show() writes the line again
  // For a run on an emulated machine.
  void show_run(std::uint64_t emulated_nanoseconds, std::uint64_t instructions);

 private:
  [[nodiscard]] bool is_time();

  std::chrono::steady_clock::time_point next_;
  bool terminal_ = false;
  bool shown_ = false;
};

// Shows a text and the elapsed seconds during work that shows no progress itself.
class ProgressClock {
 public:
  explicit ProgressClock(std::string text);
  ~ProgressClock();
  ProgressClock(const ProgressClock&) = delete;
  ProgressClock& operator=(const ProgressClock&) = delete;

 private:
  void run();

  std::string text_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread thread_;  // none unless standard error is a terminal
};

}  // namespace sightline::base
