#include "host/base/terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <limits>

namespace sightline::base {

namespace {

constexpr std::array end_signals{SIGINT, SIGTERM, SIGHUP, SIGQUIT};

// The state that signal handlers use. They may call tcsetattr, signal and raise.
volatile std::sig_atomic_t signal_received = 0;
volatile std::sig_atomic_t terminal_is_raw = 0;
timespec received_at;  // written before signal_received
termios terminal_before;
termios terminal_raw;

void restore_terminal() {
  if (terminal_is_raw == 0) return;
  static_cast<void>(tcsetattr(STDIN_FILENO, TCSANOW, &terminal_before));
}

extern "C" void end_by_signal(int number) {
  restore_terminal();
  static_cast<void>(std::signal(number, SIG_DFL));
  static_cast<void>(std::raise(number));
}

extern "C" void remember_signal(int number) {
  timespec now{};
  static_cast<void>(clock_gettime(CLOCK_MONOTONIC, &now));
  if (signal_received == 0) {
    received_at = now;
    signal_received = number;
    return;
  }
  constexpr std::int64_t same_press = 250'000'000;
  const std::int64_t since = std::int64_t{now.tv_sec - received_at.tv_sec} * 1'000'000'000 + (now.tv_nsec - received_at.tv_nsec);
  if (since >= same_press) {
    constexpr std::string_view message = "\nsightline: ended by a second signal; files that were not complete are as they were before\n";
    // A terminal that accepts no output must not block the process.
    const int flags = fcntl(STDERR_FILENO, F_GETFL);
    static_cast<void>(fcntl(STDERR_FILENO, F_SETFL, flags | O_NONBLOCK));
    if (write(STDERR_FILENO, message.data(), message.size()) < 0) signal_received = number;
    static_cast<void>(fcntl(STDERR_FILENO, F_SETFL, flags));
    end_by_signal(number);
  }
}

extern "C" void remember_pipe(int number) {
  if (signal_received == 0) signal_received = number;
}

extern "C" void suspend_process(int) {
  const int error = errno;
  restore_terminal();
  static_cast<void>(raise(SIGSTOP));
  if (terminal_is_raw != 0) static_cast<void>(tcsetattr(STDIN_FILENO, TCSANOW, &terminal_raw));
  errno = error;
}

void handle(int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  static_cast<void>(sigaction(number, &action, nullptr));
}

// Before a crash ends the process, the terminal's settings are restored.
constexpr std::array crash_signals{SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};

}  // namespace

bool stderr_is_terminal() {
  return isatty(STDERR_FILENO) != 0;
}

std::size_t stdout_columns() {
  winsize size{};
  if (isatty(STDOUT_FILENO) == 0 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::numeric_limits<std::size_t>::max();
  return size.ws_col;
}

bool stdin_is_terminal() {
  return isatty(STDIN_FILENO) != 0;
}

RawTerminal::RawTerminal() {
  if (tcgetattr(STDIN_FILENO, &terminal_before) != 0) return;
  terminal_raw = terminal_before;
  cfmakeraw(&terminal_raw);
  if (tcsetattr(STDIN_FILENO, TCSADRAIN, &terminal_raw) != 0) return;
  terminal_is_raw = 1;
  handle(SIGTSTP, &suspend_process);
  for (const int number : crash_signals) handle(number, &end_by_signal);
}

RawTerminal::~RawTerminal() {
  if (terminal_is_raw == 0) return;
  for (const int number : crash_signals) static_cast<void>(std::signal(number, SIG_DFL));
  static_cast<void>(std::signal(SIGTSTP, SIG_DFL));
  restore_terminal();
  terminal_is_raw = 0;
}

EndSignals::EndSignals() {
  signal_received = 0;
  for (const int number : end_signals) handle(number, &remember_signal);
  handle(SIGPIPE, &remember_pipe);
}

EndSignals::~EndSignals() {
  for (const int number : end_signals) static_cast<void>(std::signal(number, SIG_DFL));
  static_cast<void>(std::signal(SIGPIPE, SIG_DFL));
}

int EndSignals::received() {
  return signal_received;
}

void EndSignals::forget() {
  signal_received = 0;
}

std::optional<std::string> read_stdin_within(int milliseconds) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  const int ready = poll(&input, 1, milliseconds);
  if (ready <= 0) return std::string();
  std::string text(4096, '\0');
  const ssize_t n = read(STDIN_FILENO, text.data(), text.size());
  if (n < 0 && errno == EINTR) return std::string();
  if (n <= 0) return std::nullopt;
  text.resize(static_cast<std::size_t>(n));
  return text;
}

bool write_now(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(descriptor, text.data(), text.size());
    if (n < 0) {
      if (errno == EINTR) continue;
      if (errno != EAGAIN) return false;
      pollfd output{descriptor, POLLOUT, 0};
      static_cast<void>(poll(&output, 1, -1));
      continue;
    }
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace sightline::base
