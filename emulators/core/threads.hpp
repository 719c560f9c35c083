// The fast engine of a processor: its instructions as functions of which each ends with a jump to the next one.
//
// Each of the processor's codes becomes a function that executes one instruction and jumps to the function of the next. The
// registers that instructions need most are the arguments of these functions, so they stay in the host's registers by the rules
// of calls, whatever a compiler thinks of the rest: no function is large, and none depends on where another one lies. What
// instructions need less lies in a frame in memory. Whether something outside the processor is due costs one test an
// instruction (allowance.hpp); if it is, all goes into the frame and Threads::run returns.
//
// A processor of this kind is a type
//   using Frame                         what stays in memory
//   static constexpr unsigned codes     32 or 256
//   static constexpr bool has_spare_word    HostWords::e is not used
//   static Thread resume(Frame&, HostWords)     and, with a spare word, takes the instruction again
//   HostWords host_words() const        all that is not in the frame
//   explicit Thread(Frame&)             from what leave() has put there
//   unsigned code()                     takes the next instruction, gives its code
//   template <unsigned code> bool is_rare() const    the instruction taken has to be executed by execute_any()
//   template <unsigned code> void execute()          without a call, which would spill the host's registers
//   void execute_any()                  any instruction
//   bool leaves() const                 something is due at the boundary after it
//   void leave()                        puts all into the frame
//
// The jump is a call in tail position. clang turns it into a jump because of an attribute; g++ does so where it optimises
// (-O2). Where a compiler makes a real call after all, Allowance::most bounds the depth of the stack. WebAssembly has no such
// call, and checks of addresses spoil it: there is no fast engine (SIGHTLINE_THREADS is 0), and a machine runs by the plain loop
// that serves its observers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "inline.hpp"

// A function that stays one, with its arguments where the rules of calls put them.
#if defined(__clang__)
#define SIGHTLINE_OUT_OF_LINE [[gnu::noinline]]
#else
#define SIGHTLINE_OUT_OF_LINE [[gnu::noinline, gnu::noipa]]
#endif

#if defined(__SANITIZE_ADDRESS__) || defined(__wasm__)
#define SIGHTLINE_THREADS 0
#elif defined(__clang__)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || !__has_cpp_attribute(clang::musttail)
#define SIGHTLINE_THREADS 0
#else
#define SIGHTLINE_THREADS 1
#define SIGHTLINE_JUMP [[clang::musttail]] return
#endif
#elif defined(__GNUC__) && defined(__OPTIMIZE__)
#define SIGHTLINE_THREADS 1
#define SIGHTLINE_JUMP return
#else
#define SIGHTLINE_THREADS 0
#endif

namespace sightline::core {

// As much as fits into the host's registers beside the address of the frame. If a processor does not use `e`, the dispatch
// table is passed in its register, which saves an instruction of the host each time, and `d` has 64 bits, so that an index into
// memory need not be widened; else `d` has 32.
struct HostWords {
  std::uint64_t a;
  std::uint64_t b;
  std::uint32_t c;
  std::uint64_t d;
  std::uint32_t e = 0;
};

#if SIGHTLINE_THREADS

template <class Thread>
class Threads {
 public:
  static void run(typename Thread::Frame& frame) {
    Thread thread(frame);
    const unsigned code = thread.code();
    const HostWords words = thread.host_words();
    table.functions[code](frame, words.a, words.b, words.c, static_cast<Index>(words.d), last_of(words, &table));
  }

 private:
  struct Table;
  using Frame = typename Thread::Frame;
  using Long = std::uint64_t;
  using Word = std::uint32_t;
  using Index = std::conditional_t<Thread::has_spare_word, Long, Word>;
  using Last = std::conditional_t<Thread::has_spare_word, const Table*, Word>;
  using Function = void (*)(Frame&, Long, Long, Word, Index, Last);
  struct Table {
    std::array<Function, Thread::codes> functions;
  };

  SIGHTLINE_INLINE static HostWords words_of(Long a, Long b, Word c, Index d, Last last) {
    if constexpr (Thread::has_spare_word) return {a, b, c, d};
    else return {a, b, c, d, last};
  }
  SIGHTLINE_INLINE static Last last_of(const HostWords& words, const Table* of) {
    if constexpr (Thread::has_spare_word) return of;
    else return words.e;
  }
  SIGHTLINE_INLINE static const Table* table_of(Last last) {
    if constexpr (Thread::has_spare_word) return last;
    else return &table;
  }

  // Each begins a line of the host's cache, so that its speed does not depend on what a linker puts before it.
  template <unsigned code>
  [[gnu::aligned(64)]] static void one(Frame& frame, Long a, Long b, Word c, Index d, Last e) {
    Thread thread = Thread::resume(frame, words_of(a, b, c, d, e));
    if (thread.template is_rare<code>()) SIGHTLINE_JUMP any(frame, a, b, c, d, e);
    thread.template execute<code>();
    const Table* const of = table_of(e);
    if (thread.leaves()) [[unlikely]] {
      const HostWords last = thread.host_words();
      SIGHTLINE_JUMP leave(frame, last.a, last.b, last.c, static_cast<Index>(last.d), last_of(last, of));
    }
    const unsigned next = thread.code();
    const HostWords words = thread.host_words();
    SIGHTLINE_JUMP of->functions[next](frame, words.a, words.b, words.c, static_cast<Index>(words.d), last_of(words, of));
  }

  SIGHTLINE_OUT_OF_LINE static void any(Frame& frame, Long a, Long b, Word c, Index d, Last e) {
    Thread thread = Thread::resume(frame, words_of(a, b, c, d, e));
    thread.execute_any();
    const bool leaves = thread.leaves();
    const unsigned next = thread.code();
    const HostWords words = thread.host_words();
    const Table* const of = table_of(e);
    if (leaves) SIGHTLINE_JUMP leave(frame, words.a, words.b, words.c, static_cast<Index>(words.d), last_of(words, of));
    SIGHTLINE_JUMP of->functions[next](frame, words.a, words.b, words.c, static_cast<Index>(words.d), last_of(words, of));
  }

  SIGHTLINE_OUT_OF_LINE static void leave(Frame& frame, Long a, Long b, Word c, Index d, Last e) {
    Thread::resume(frame, words_of(a, b, c, d, e)).leave();
  }

  template <std::size_t... code>
  static constexpr Table all(std::index_sequence<code...>) {
    return {{&one<code>...}};
  }
  static constexpr Table table = all(std::make_index_sequence<Thread::codes>{});
};

#endif

}  // namespace sightline::core
