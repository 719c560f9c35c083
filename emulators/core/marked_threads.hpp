// The threads of threads.hpp for a run whose memory has marks: bits above an instruction that choose another function, so that an
// instruction without a mark pays nothing for those that have one. The processor has, beside what threads.hpp names,
//   static constexpr unsigned first_mark, mark_bits     code() gives so many bits from that one on, above those of the code. The
//                                           lowest: the boundary before this instruction is asked about
//   static constexpr std::array<unsigned, n> kinds    sets of tests, the last of them all
//   static unsigned tests_of(const Frame&)  what a run needs; it takes the functions of the first kind that has all of it
//   template <unsigned code> static constexpr unsigned useful_tests     what a code can need: it is compiled once for each set of these
//   template <unsigned code, unsigned tests> bool is_rare() const, leaves() const
//   bool leaves_after_any() const           may say true too often, as leaves<code, tests>() may: leaves() has the last word
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "inline.hpp"
#include "threads.hpp"

namespace sightline::core {

template <class Thread>
struct MarkedLoop {
  [[gnu::noinline]] static void run(typename Thread::Frame& frame) {
    Thread thread(frame);
    unsigned code = thread.code();
    for (;;) {
      if (dispatch<Thread::codes>(code, Executor{&thread}) && thread.leaves()) break;
      code = thread.code();
      if ((code & 1U << Thread::first_mark) != 0 && thread.leaves()) break;
    }
    thread.leave();
  }

 private:
  struct Executor {
    Thread* thread;
    template <unsigned code>
    SIGHTLINE_INLINE bool execute() const {
      constexpr unsigned tests = Thread::kinds.back();
      if (thread->template is_rare<code, tests>()) {
        thread->execute_any();
        return thread->leaves_after_any();
      }
      thread->template execute<code>();
      return thread->template leaves<code, tests>();
    }
  };
};

#if SIGHTLINE_THREADS

template <class Thread>
class MarkedThreads {
 public:
  static void run(typename Thread::Frame& frame) {
    const unsigned needed = Thread::tests_of(frame);
    std::size_t kind = 0;
    while (kind + 1 < Thread::kinds.size() && (needed & ~Thread::kinds[kind]) != 0) ++kind;
    Thread thread(frame);
    const unsigned code = thread.code() & ~asked;  // this boundary has been asked about
    const HostWords words = thread.host_words();
    tables[kind].functions[code](frame, words.a, words.b, words.c, words.d, &tables[kind]);
  }

 private:
  static_assert(Thread::has_spare_word);
  struct Table;
  using Frame = typename Thread::Frame;
  using Long = std::uint64_t;
  using Word = std::uint32_t;
  using Function = void (*)(Frame&, Long, Long, Word, Long, const Table*);
  static constexpr unsigned asked = 1U << Thread::first_mark;
  static constexpr std::size_t entries = std::size_t{1} << (Thread::first_mark + Thread::mark_bits);
  struct Table {
    std::array<Function, entries> functions;
  };

  template <unsigned code, unsigned tests>
  [[gnu::aligned(64)]] static void one(Frame& frame, Long a, Long b, Word c, Long d, const Table* of) {
    Thread thread = Thread::resume(frame, {a, b, c, d});
    if (thread.template is_rare<code, tests>()) SIGHTLINE_JUMP any(frame, a, b, c, d, of);
    thread.template execute<code>();
    if (thread.template leaves<code, tests>()) [[unlikely]] {
      const HostWords last = thread.host_words();
      SIGHTLINE_JUMP look(frame, last.a, last.b, last.c, last.d, of);
    }
    const unsigned next = thread.code();
    const HostWords words = thread.host_words();
    SIGHTLINE_JUMP of->functions[next](frame, words.a, words.b, words.c, words.d, of);
  }

  SIGHTLINE_OUT_OF_LINE static void any(Frame& frame, Long a, Long b, Word c, Long d, const Table* of) {
    Thread thread = Thread::resume(frame, {a, b, c, d});
    thread.execute_any();
    const bool asks = thread.leaves_after_any();
    const unsigned next = thread.code();
    const HostWords words = thread.host_words();
    if (asks) SIGHTLINE_JUMP look(frame, words.a, words.b, words.c, words.d, of);
    SIGHTLINE_JUMP of->functions[next](frame, words.a, words.b, words.c, words.d, of);
  }

  // At a boundary, before what is there.
  SIGHTLINE_OUT_OF_LINE static void look(Frame& frame, Long a, Long b, Word c, Long d, const Table* of) {
    Thread thread = Thread::resume(frame, {a, b, c, d});
    if (thread.leaves()) SIGHTLINE_JUMP leave(frame, a, b, c, d, of);
    const unsigned next = thread.code() & ~asked;
    const HostWords words = thread.host_words();
    SIGHTLINE_JUMP of->functions[next](frame, words.a, words.b, words.c, words.d, of);
  }

  SIGHTLINE_OUT_OF_LINE static void leave(Frame& frame, Long a, Long b, Word c, Long d, const Table*) {
    Thread::resume(frame, {a, b, c, d}).leave();
  }

  template <unsigned tests, std::size_t... code>
  static constexpr Table table(std::index_sequence<code...>) {
    constexpr std::array<Function, Thread::codes> of_codes{&one<code, tests & Thread::template useful_tests<code>>...};
    Table table{};
    for (std::size_t n = 0; n < entries; ++n) table.functions[n] = (n & asked) != 0 ? &look : of_codes[n % Thread::codes];
    return table;
  }
  template <std::size_t... kind>
  static constexpr std::array<Table, sizeof...(kind)> all(std::index_sequence<kind...>) {
    return {table<Thread::kinds[kind]>(std::make_index_sequence<Thread::codes>{})...};
  }
  static constexpr auto tables = all(std::make_index_sequence<Thread::kinds.size()>{});
};

#else

template <class Thread>
using MarkedThreads = MarkedLoop<Thread>;

#endif

}  // namespace sightline::core
