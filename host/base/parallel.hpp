// Runs many tasks on several threads and delivers their results in order.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace sightline::base {

template <class Value>
struct OrderedWork {
  std::uint64_t first = 0;
  std::uint64_t last = 0;                           // excluded
  unsigned jobs = 1;                                // threads
  std::function<Value(std::uint64_t)> make;        // called on any of these threads
  std::function<void(std::uint64_t, Value)> take;  // called on the caller's thread, from first to last
  std::function<bool()> go_on;                      // called on the caller's thread several times a second; false: stop
};

// Returns once every value has been taken, or soon after go_on returns false: tasks that have begun are then finished and
// their values dropped. An exception of make or take is rethrown here. The threads make at most 16 values per job ahead of
// the one to be taken.
template <class Value>
void run_in_order(const OrderedWork<Value>& work) {
  std::mutex mutex;
  std::condition_variable changed;
  std::map<std::uint64_t, Value> ready;
  std::exception_ptr failure;
  std::uint64_t next = work.first;
  std::uint64_t taken = work.first;
  bool stop = false;
  const std::uint64_t ahead = std::uint64_t{work.jobs} * 16;

  const auto worker = [&] {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [&] { return stop || next >= work.last || next < taken + ahead; });
      if (stop || next >= work.last) return;
      const std::uint64_t number = next++;
      lock.unlock();
      std::exception_ptr thrown;
      std::map<std::uint64_t, Value> made;
      try {
        made.emplace(number, work.make(number));
      } catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      ready.merge(made);
      if (thrown) {
        failure = thrown;
        stop = true;
      }
      changed.notify_all();
    }
  };

  std::vector<std::thread> threads;
  // If an exception is thrown, the threads are stopped and joined.
  struct Join {
    std::mutex& mutex;
    std::condition_variable& changed;
    bool& stop;
    std::vector<std::thread>& threads;
    ~Join() {
      {
        const std::lock_guard lock(mutex);
        stop = true;
      }
      changed.notify_all();
      for (std::thread& thread : threads) thread.join();
    }
  };
  {
    const Join join{mutex, changed, stop, threads};
    for (unsigned i = 0; i < work.jobs; ++i) threads.emplace_back(worker);
    while (taken < work.last && work.go_on()) {
      std::unique_lock lock(mutex);
      changed.wait_for(lock, std::chrono::milliseconds(100),
                       [&] { return failure || ready.contains(taken); });
      if (failure) break;
      auto found = ready.extract(taken);
      if (found.empty()) continue;
      ++taken;
      changed.notify_all();
      lock.unlock();
      work.take(found.key(), std::move(found.mapped()));
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace sightline::base
