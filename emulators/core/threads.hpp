// The fast engine of a processor: one function per instruction code, each ending with a jump to the next.
//
// Each function executes one instruction and jumps to the function of the next. The registers that instructions need most
// are arguments, so the calling convention keeps them in host registers: no function is large, and the speed does not
// depend on a compiler's register allocation for a large loop. Registers needed less are in a frame in memory. A test per
// instruction finds out whether anything outside the processor is due (allowance.hpp); if so, all registers go into the
// frame and Threads::run returns.
//
// Such a processor is a type with
//   using Frame                         the state kept in memory
//   static constexpr unsigned codes     32 or 256
//   static constexpr bool has_spare_word    HostWords::e is not used
//   static Thread resume(Frame&, HostWords)     and, with a spare word, fetches the instruction again
//   HostWords host_words() const        all state that is not in the frame
//   explicit Thread(Frame&)             from the state that leave() stored there
//   unsigned code()                     fetches the next instruction and returns its code
//   template <unsigned code> bool is_rare() const    the fetched instruction must be executed by execute_any()
//   template <unsigned code> void execute()          makes no call, which would spill the host's registers
//   void execute_any()                  any instruction
//   bool leaves() const                 something is due at the boundary that follows
//   void leave()                        stores all state in the frame
//
// The jump is a call in tail position. clang turns it into a jump because of an attribute, g++ because it optimises (-O2).
// Where a compiler makes a real call after all, Allowance::most bounds the depth of the stack. WebAssembly has no such
// call, and address sanitizers prevent it: then there is no fast engine (SIGHTLINE_THREADS is 0), and a machine always uses
// the plain loop that observed runs use.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "inline.hpp"

// A function that is never inlined and has its arguments where the calling convention puts them.
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

// As much as fits into host registers beside the address of the frame. If a processor does not use `e`, the dispatch table
// is passed in its register, which saves one host instruction per instruction, and `d` has 64 bits, so that a memory index
// need not be widened; otherwise `d` has 32.
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

  // Each function begins a cache line of the host, so that its speed does not depend on the linker's layout.
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
