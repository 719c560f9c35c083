// Runs the instructions of an 8080 while an observer looks (i8080_observer.hpp): like core/threads.hpp, with each opcode compiled up to
// four times, so that an instruction pays for no question but those that it can answer.
//
// Where a run is asked before an instruction is part of the index by which its opcode's function is found: such an instruction leads to
// a function that asks first, and all others take one host instruction for that. Where an opcode may change what the observer looks at, a
// function is chosen that jumps to the observer's test, which is compiled for the registers it reads; where places are
// watched, an opcode that reads or writes memory has one that first compares the marks of what it is going to touch. Where one is
// found, the instruction is executed T-state by T-state, which tells its cycles.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include "../core/inline.hpp"
#include "../core/reporter.hpp"
#include "../core/threads.hpp"
#include "../i8080/isa.hpp"
#include "i8080_bus.hpp"
#include "i8080_observer.hpp"
#include "i8080_store.hpp"

namespace sightline::machines {

template <class Machine, class Ports, class Observer>
class I8080LookingThreads {
 public:
  using Frame = I8080Frame<Machine, Observer>;
  // Puts into the store what the observer wants now, if that is not what it wanted last.
  static void prepare(I8080Store& store, Observer& observer) {
    const std::optional<I8080Wanted> wanted = observer.renewed();
    if (!wanted) return;
    std::copy_n(wanted->accesses, I8080Store::size, store.accesses.begin());
    store.accesses.back() = store.accesses.front();
    mark_places(store, wanted->places);
    store.doubts.fill(1);
#if SIGHTLINE_THREADS
    choose_functions(store, *wanted);
#endif
  }

  // At least one instruction: the boundary at which it begins is not asked about.
  static void run(Frame& frame) {
    if constexpr (SIGHTLINE_THREADS == 0 || core::WantsPlainLoop<Observer>) core::PlainLoop<Thread>::run(frame);
    else run_threads(frame);
  }

 private:
  using Thread = I8080Thread<Machine, Ports, Observer>;

  // Eight at a time: most have none.
  static void mark_places(I8080Store& store, const std::uint8_t* places) {
    constexpr std::size_t at_once = 8;
    for (std::size_t begin = 0; begin < store.places.size(); begin += at_once) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, places + begin, at_once);
      std::fill_n(&store.places[begin], at_once, 0);
      if ((bits & 0x0101'0101'0101'0101U) == 0) continue;
      for (std::size_t at = begin; at < begin + at_once; ++at) store.places[at] = (places[at] & 1U) * std::uint32_t{I8080Store::codes};
    }
  }

#if SIGHTLINE_THREADS
  static void run_threads(Frame& frame) {
    Thread thread(frame);
    const core::HostWords words = thread.host_words();
    function(*frame.store, thread.code())(frame, words.a, words.b, words.c, static_cast<Word>(words.d), words.e);
  }

  using Long = std::uint64_t;
  using Word = std::uint32_t;
  using Function = void (*)(Frame&, Long, Long, Word, Word, Word);
  using Functions = std::array<Function, I8080Store::codes>;

  static Function function(const I8080Store& store, std::size_t index) { return reinterpret_cast<Function>(store.functions[index]); }

  // Where the function of the next instruction is.
  [[nodiscard]] SIGHTLINE_INLINE static unsigned place(const Thread& thread) {
    return thread.code() | thread.store()->places[thread.pc()];
  }

  template <unsigned code, bool watched, bool tested>
  [[gnu::aligned(64)]] static void one(Frame& frame, Long a, Long b, Word c, Word d, Word e) {
    Thread thread = Thread::resume(frame, {a, b, c, d, e});
    if constexpr (watched) {
      if (thread.template touches_marked<code>()) [[unlikely]] SIGHTLINE_JUMP leave_to_pins(frame, a, b, c, d, e);
    }
    thread.template execute<code>();
    const core::HostWords words = thread.host_words();
    if (thread.due()) [[unlikely]] SIGHTLINE_JUMP leave(frame, words.a, words.b, words.c, static_cast<Word>(words.d), words.e);
    const I8080Store& store = *thread.store();
    if constexpr (tested) {
      constexpr bool also_memory = (i8080::registers_changed_by(static_cast<std::uint8_t>(code)) & i8080::changed::memory) != 0;
      const auto test = reinterpret_cast<Function>(store.tests[also_memory ? 1 : 0]);
      SIGHTLINE_JUMP test(frame, words.a, words.b, words.c, static_cast<Word>(words.d), words.e);
    } else {
      SIGHTLINE_JUMP function(store, place(thread))(frame, words.a, words.b, words.c, static_cast<Word>(words.d), words.e);
    }
  }

  SIGHTLINE_OUT_OF_LINE static void any(Frame& frame, Long a, Long b, Word c, Word d, Word e) {
    auto thread = Thread::resume(frame, {a, b, c, d, e});
    thread.execute_any();
    const core::HostWords words = thread.host_words();
    if (thread.due()) SIGHTLINE_JUMP leave(frame, words.a, words.b, words.c, static_cast<Word>(words.d), words.e);
    SIGHTLINE_JUMP look(frame, words.a, words.b, words.c, static_cast<Word>(words.d), words.e);
  }

  template <unsigned test>
  [[gnu::aligned(64)]] static void hits(Frame& frame, Long a, Long b, Word c, Word d, Word e) {
    const auto thread = Thread::resume(frame, {a, b, c, d, e});
    if (thread.template hits<test>()) [[unlikely]] SIGHTLINE_JUMP look(frame, a, b, c, d, e);
    SIGHTLINE_JUMP function(*thread.store(), place(thread))(frame, a, b, c, d, e);
  }

  // At a marked instruction, and where a test has hit.
  SIGHTLINE_OUT_OF_LINE static void look(Frame& frame, Long a, Long b, Word c, Word d, Word e) {
    const auto thread = Thread::resume(frame, {a, b, c, d, e});
    if (thread.asks()) SIGHTLINE_JUMP leave(frame, a, b, c, d, e);
    SIGHTLINE_JUMP function(*thread.store(), thread.code())(frame, a, b, c, d, e);
  }

  SIGHTLINE_OUT_OF_LINE static void leave_to_pins(Frame& frame, Long a, Long b, Word c, Word d, Word e) {
    Thread thread = Thread::resume(frame, {a, b, c, d, e});
    thread.leave_to_pins();
    thread.leave();
  }

  SIGHTLINE_OUT_OF_LINE static void leave(Frame& frame, Long a, Long b, Word c, Word d, Word e) {
    Thread::resume(frame, {a, b, c, d, e}).leave();
  }

  // Opcodes for which it makes no difference share a function.
  template <unsigned code, bool watched, bool tested>
  static constexpr Function function_of() {
    constexpr auto opcode = static_cast<std::uint8_t>(code);
    if constexpr (Thread::template leaves_memory<code>) return &any;
    else return &one<code, watched && touch_of(opcode).bytes != 0, tested && i8080::registers_changed_by(opcode) != 0>;
  }
  template <bool watched, bool tested, std::size_t... code>
  static constexpr Functions all(std::index_sequence<code...>) {
    return {function_of<code, watched, tested>()...};
  }
  template <bool watched, bool tested>
  static constexpr Functions functions = all<watched, tested>(std::make_index_sequence<I8080Store::codes>{});
  template <std::size_t... test>
  static constexpr auto all_tests(std::index_sequence<test...>) {
    return std::array<Function, sizeof...(test)>{&hits<test>...};
  }
  static constexpr auto tests = all_tests(std::make_index_sequence<Observer::Look::tests>{});

  static void choose_functions(I8080Store& store, const I8080Wanted& wanted) {
    const auto stored = [](Function chosen) { return reinterpret_cast<void (*)()>(chosen); };
    for (std::size_t opcode = 0; opcode < I8080Store::codes; ++opcode) {
      const bool tested = (i8080::registers_changed_by(static_cast<std::uint8_t>(opcode)) & wanted.tested) != 0;
      const Function chosen = tested ? (wanted.watches ? functions<true, true> : functions<false, true>)[opcode]
                                     : (wanted.watches ? functions<true, false> : functions<false, false>)[opcode];
      store.functions[opcode] = stored(chosen);
      store.functions[I8080Store::codes + opcode] = stored(&look);
    }
    const Function test = wanted.test ? tests[*wanted.test] : &look;
    store.tests = {stored(test), stored((wanted.tested & i8080::changed::memory) != 0 ? &look : test)};
  }
#else
  static void run_threads(Frame&) {}
#endif
};

}  // namespace sightline::machines
