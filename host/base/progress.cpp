#include "host/base/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace sightline::base {

namespace {

// A signal handler may write to nothing else.
volatile std::sig_atomic_t interrupt_pressed = 0;

extern "C" void remember_interrupt(int) {
  interrupt_pressed = 1;
}

bool is_terminal() {
  const char* const kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && kind != nullptr && std::string_view(kind) != "dumb";
}

}  // namespace

InterruptKey::InterruptKey() {
  interrupt_pressed = 0;
  struct sigaction action {};
  action.sa_handler = &remember_interrupt;
  // The handler is removed after the first signal: a second Ctrl-C ends a run that does not stop.
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  static_cast<void>(sigaction(SIGINT, &action, nullptr));
}

InterruptKey::~InterruptKey() {
  static_cast<void>(std::signal(SIGINT, SIG_DFL));
}

bool InterruptKey::pressed() {
  return interrupt_pressed != 0;
}

ProgressLine::ProgressLine()
    : next_(std::chrono::steady_clock::now() + std::chrono::seconds(1)), terminal_(is_terminal()) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (!std::exchange(shown_, false)) return;
  fmt::print(stderr, "\r\033[K");
}

bool ProgressLine::is_time() {
  if (!terminal_) return false;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return false;
  next_ = now + std::chrono::milliseconds(200);
  return true;
}

void ProgressLine::show_run(std::uint64_t emulated_nanoseconds, std::uint64_t instructions) {
  if (!is_time()) return;
  shown_ = true;
  fmt::print(stderr, "\r\033[K{:.1f} s emulated, {} million instructions (Ctrl-C stops)",
             static_cast<double>(emulated_nanoseconds) / 1e9, instructions / 1'000'000);
  static_cast<void>(std::fflush(stderr));
}

void ProgressLine::show(std::string_view text) {
  if (!is_time()) return;
  shown_ = true;
  fmt::print(stderr, "\r\033[K{} (Ctrl-C stops)", text);
  static_cast<void>(std::fflush(stderr));
}

ProgressClock::ProgressClock(std::string text) : text_(std::move(text)) {
  if (is_terminal()) thread_ = std::thread([this] { run(); });
}

ProgressClock::~ProgressClock() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    end_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

void ProgressClock::run() {
  ProgressLine line;
  const auto begin = std::chrono::steady_clock::now();
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ended_.wait_for(lock, std::chrono::milliseconds(250), [this] { return end_; })) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - begin).count();
    line.show(fmt::format("{}, {} s", text_, seconds));
  }
}

}  // namespace sightline::base
