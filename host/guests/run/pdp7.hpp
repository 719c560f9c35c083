// One run of any PDP-7 program: a machine is put together from what the run asks for, loaded, run, and its
// state handed back. What nobody asked for is not there: without a trace no observer is compiled in, without
// a taker of strokes the display never looks for single flashes.
//
// Left out: looking into the machine while it runs; a run is one START to one stop.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"
#include "emulators/machines/pdp7.hpp"
#include "emulators/pdp7/console.hpp"
#include "emulators/pdp7/state.hpp"
#include "host/guests/run/screen.hpp"

namespace sightline::harness {

// Takes text in blocks of some tens of kilobytes, whole lines.
using TextTaker = std::function<void(std::string_view)>;

// What --set writes: only what is there is changed.
struct RegisterSettings {
  std::optional<pdp7::Address> pc;
  std::optional<core::Word18> ac;
  std::optional<core::Word18> mq;
  std::optional<core::Word18> switches;
  std::optional<core::Word<6>> sc;
  std::optional<bool> link;
  std::optional<bool> interrupts_on;
};

struct KeyPress {
  core::Instant time;
  std::uint8_t code;  // 7 bits
};

// Someone holds the light pen elsewhere: at the first instruction boundary at or after `time`.
struct PenMove {
  core::Instant time;
  std::optional<type340::LightPen> pen;  // nullopt: taken away
};

struct Progress {
  std::uint64_t instructions;
  core::Instant now;
};

struct Pdp7Job {
  machines::Pdp7Options machine;
  std::map<pdp7::Address, core::Word18> core;  // the rest of core is 0
  // The START key at this address; without it the machine continues from PC as `registers` has it, or 0.
  std::optional<pdp7::Address> start;
  RegisterSettings registers;  // set after START
  std::vector<pdp7::SwitchSetting> switch_script;
  std::vector<std::uint8_t> reader_tape;  // one byte a line, hole 8 = 0200
  std::vector<KeyPress> keys;             // not before one another
  std::vector<PenMove> pen_script;        // likewise; nothing without a display
  machines::Limits limits;

  TextTaker trace;           // empty: no trace. One line an instruction, see trace_line_help
  Screen* screen = nullptr;  // nullptr: nobody takes the strokes. Outlives the run
  // Asked every few million instructions; false ends the run there. Empty: never asked.
  std::function<bool(const Progress&)> keep_running;
};

enum class Stop : std::uint8_t { halt, instruction_limit, time_limit, xct_chain, unanswered, interrupted };

// "halt", "instruction_limit", "time_limit", "xct_chain", "strict", "interrupted".
[[nodiscard]] std::string_view name_of(Stop stop);

struct Pdp7Report {
  Stop stop = Stop::halt;
  pdp7::State registers;
  core::Word18 switches;  // at the end
  core::Instant end;
  machines::Counts counts;
  std::uint64_t display_words = 0;   // that the display took by data break
  std::uint64_t passes_started = 0;  // of the display
  std::uint64_t passes = 0;          // that came to their stop
  std::vector<machines::Unanswered> unanswered;
  std::vector<core::Word18> core;     // as many words as the machine has
  std::vector<std::uint8_t> punched;  // one byte a line
  std::vector<std::uint8_t> printed;  // eight-bit codes
  bool reader_out_of_tape = false;    // the program waits for a line or word that the tape does not have
};

[[nodiscard]] Pdp7Report run_pdp7(const Pdp7Job& job);

// The fields of a trace line: time (ns, decimal, of the fetch), PC, word, disassembly, then AC, L, MQ after
// it.
inline constexpr std::string_view trace_line_help = "TIME_NS PC WORD INSTRUCTION AC L MQ";

// `PC AC L MQ SC` on the first line, then all words, eight to a line; octal, one space between.
[[nodiscard]] std::string dump_text(const Pdp7Report& report);

}  // namespace sightline::harness
