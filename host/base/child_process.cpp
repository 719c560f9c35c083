// See apart.hpp.
#include "host/base/child_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>

namespace sightline::base {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool addresses_can_be_limited = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool addresses_can_be_limited = false;
#else
constexpr bool addresses_can_be_limited = true;
#endif
#else
constexpr bool addresses_can_be_limited = true;
#endif

// The first byte that the child sends; the fields of an error are separated by zero bytes.
constexpr char value_mark = 'V';
constexpr char error_mark = 'E';

std::string memory_text(std::size_t bytes) {
  return std::to_string(bytes >> 20) + " MB of memory";
}

void send(int pipe, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::write(pipe, bytes.data(), bytes.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

std::string answer_of(const std::function<Result<std::string>()>& work, const ChildLimits& limits) {
  Error error;
  try {
    Result<std::string> result = work();
    if (result) return value_mark + *result;
    error = std::move(result.error());
  } catch (const std::bad_alloc&) {
    error = bad_input("needs more than " + memory_text(limits.memory));
  } catch (const std::exception& thrown) {
    error = bad_input(thrown.what());
  } catch (...) {
    error = bad_input("an unknown failure");
  }
  std::string text(1, error_mark);
  for (const std::string* field : {&error.file, &error.place, &error.found, &error.expected, &error.remedy}) {
    text += *field;
    text += '\0';
  }
  return text;
}

[[noreturn]] void work_in_child(int pipe, const std::function<Result<std::string>()>& work, const ChildLimits& limits) {
  const rlimit seconds{limits.seconds, limits.seconds + 1};
  static_cast<void>(::setrlimit(RLIMIT_CPU, &seconds));
  const rlimit none{0, 0};
  static_cast<void>(::setrlimit(RLIMIT_CORE, &none));
  if (addresses_can_be_limited) {
    const rlimit memory{limits.memory, limits.memory};
    static_cast<void>(::setrlimit(RLIMIT_AS, &memory));
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) ::signal(signal, SIG_DFL);
  ::signal(SIGPIPE, SIG_IGN);
  if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0) {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
  send(pipe, answer_of(work, limits));
  ::_exit(0);  // without flushing stdio: the parent writes what was buffered before the fork
}

Error error_in(std::string_view fields) {
  Error error;
  for (std::string* field : {&error.file, &error.place, &error.found, &error.expected, &error.remedy}) {
    const std::size_t end = fields.find('\0');
    *field = std::string(fields.substr(0, end));
    fields.remove_prefix(end == std::string_view::npos ? fields.size() : end + 1);
  }
  return error;
}

}  // namespace

Result<std::string> run_in_child(const std::function<Result<std::string>()>& work, const ChildLimits& limits) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return bad_input(std::string("cannot make a pipe: ") + std::strerror(errno));
  const pid_t child = ::fork();
  if (child < 0) {
    const int code = errno;
    ::close(ends[0]);
    ::close(ends[1]);
    return bad_input(std::string("cannot start a process: ") + std::strerror(code));
  }
  if (child == 0) {
    ::close(ends[0]);
    work_in_child(ends[1], work, limits);
  }
  ::close(ends[1]);
  std::string answer;
  std::array<char, 65536> block{};
  for (;;) {
    const ssize_t got = ::read(ends[0], block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    answer.append(block.data(), static_cast<std::size_t>(got));
  }
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGKILL)
      return bad_input("takes more than " + std::to_string(limits.seconds) + " seconds or more than " + memory_text(limits.memory));
    return bad_input(std::string("crashed (") + ::strsignal(signal) + ")");
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || answer.empty()) return bad_input("crashed");
  if (answer[0] == value_mark) {
    answer.erase(0, 1);
    return answer;
  }
  return error_in(std::string_view(answer).substr(1));
}

}  // namespace sightline::base
