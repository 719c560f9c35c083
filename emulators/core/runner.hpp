// A loop in the place of threads.hpp, for the machine that is still a template over its observer.
#pragma once

#include <type_traits>

#include "dispatch.hpp"
#include "inline.hpp"
#include "threads.hpp"

namespace sightline::core {

// The loop: portable C++.
template <class Thread>
struct PlainLoop {
  [[gnu::noinline]] static void run(typename Thread::Frame& frame) {
    Thread thread(frame);
    while (!dispatch<Thread::codes>(thread.code(), Executor{&thread})) {
    }
    thread.leave();
  }

 private:
  struct Executor {
    Thread* thread;
    template <unsigned code>
    SIGHTLINE_INLINE bool execute() const {
      if (thread->template is_rare<code>()) thread->execute_any();
      else thread->template execute<code>();
      return thread->leaves();
    }
  };
};

#if !SIGHTLINE_THREADS
template <class Thread>
using Threads = PlainLoop<Thread>;
#endif

// A test asks for the loop by an observer that has a member `plain_loop`.
template <class Observer>
concept WantsPlainLoop = requires { Observer::plain_loop; };
template <class Thread, class Observer>
using Runner = std::conditional_t<WantsPlainLoop<Observer>, PlainLoop<Thread>, Threads<Thread>>;

}  // namespace sightline::core
