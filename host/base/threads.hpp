// Locks and threads that also compile without them: the WebAssembly module has one thread, which then does all the work.
#pragma once

#include <cstddef>
#include <functional>

#if defined(__wasi__)

namespace sightline::base {

class Mutex {};

class Lock {
 public:
  explicit Lock(Mutex&) {}
};

[[nodiscard]] inline unsigned available_threads() { return 1; }
inline void run_on_threads(unsigned, const std::function<void()>& work) { work(); }

}  // namespace sightline::base

#else

#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace sightline::base {

using Mutex = std::mutex;
using Lock = std::lock_guard<std::mutex>;

// At least 1.
[[nodiscard]] inline unsigned available_threads() {
  const unsigned threads = std::thread::hardware_concurrency();
  return threads != 0 ? threads : 1;
}

// Starts threads with run(1) to run(count - 1), as far as the system has threads. Returns the number of the first one that is missing,
// or `count`.
template <class Run>
std::size_t start_threads(std::size_t count, const Run& run, std::vector<std::thread>& threads) {
  std::size_t next = 1;
  try {
    threads.reserve(count);
    for (; next < count; ++next) threads.emplace_back([&run, next] { run(next); });
  } catch (const std::system_error&) {
  }
  return next;
}

// Runs `work` on `count` threads at once, one of them the caller's, or fewer if the system has no more; returns when all have finished.
inline void run_on_threads(unsigned count, const std::function<void()>& work) {
  std::vector<std::thread> others;
  const auto run = [&work](std::size_t) { work(); };
  static_cast<void>(start_threads(count, run, others));
  work();
  for (std::thread& thread : others) thread.join();
}

}  // namespace sightline::base

#endif

namespace sightline::base {

// More threads than this are no faster than so many.
[[nodiscard]] inline unsigned useful_threads(unsigned wanted) {
  constexpr unsigned few = 8;  // may wait for memory
  const unsigned most = available_threads() < few ? few : available_threads();
  return wanted < most ? wanted : most;
}

// Calls work(part, begin, end) on a separate thread for each of `parts` consecutive, nearly equal parts of [0, count), empty
// ones included. Returns when all have finished; then throws what the first part that failed has thrown.
template <class Work>
void for_parts(unsigned parts, std::size_t count, const Work& work) {
  const auto begin_of = [&](std::size_t part) { return count / parts * part + count % parts * part / parts; };
  const auto run = [&](std::size_t part) { work(part, begin_of(part), begin_of(part + 1)); };
#if !defined(__wasi__)
  if (parts == 1) return run(0);
  std::vector<std::exception_ptr> failures(parts);
  const auto try_run = [&](std::size_t part) {
    try {
      run(part);
    } catch (...) {
      failures[part] = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  const std::size_t missing = start_threads(parts, try_run, others);
  try_run(0);
  for (std::size_t part = missing; part < parts; ++part) try_run(part);
  for (std::thread& thread : others) thread.join();
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
#else
  for (std::size_t part = 0; part < parts; ++part) run(part);
#endif
}

}  // namespace sightline::base
