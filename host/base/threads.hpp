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

#include <mutex>
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

// Runs `work` on `count` threads at once, one of them the caller's; returns when all have finished.
inline void run_on_threads(unsigned count, const std::function<void()>& work) {
  std::vector<std::thread> others;
  for (unsigned i = 1; i < count; ++i) others.emplace_back(work);
  work();
  for (std::thread& thread : others) thread.join();
}

}  // namespace sightline::base

#endif

namespace sightline::base {

// Calls work(part, begin, end) on a separate thread for each of `parts` consecutive, nearly equal parts of [0, count), empty
// ones included. Returns when all have finished.
template <class Work>
void for_parts(unsigned parts, std::size_t count, const Work& work) {
  const auto begin_of = [&](std::size_t part) { return count / parts * part + count % parts * part / parts; };
  const auto run = [&](std::size_t part) { work(part, begin_of(part), begin_of(part + 1)); };
#if !defined(__wasi__)
  std::vector<std::thread> others;
  for (std::size_t part = 1; part < parts; ++part) others.emplace_back([&run, part] { run(part); });
  run(0);
  for (std::thread& thread : others) thread.join();
#else
  for (std::size_t part = 0; part < parts; ++part) run(part);
#endif
}

}  // namespace sightline::base
