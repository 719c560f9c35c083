// One run of any 8080 program: a machine is put together from what the run asks for, loaded, run, and its
// state handed back. What nobody asked for is not there: without a trace and a bus log no observer is
// compiled in.
//
// For CP/M programs two entries of the operating system stand in memory as the programs that check and time
// 8080s have them since their first emulator: OUT 0 at 0000, which ends the run, and OUT 1; RET at 0005,
// where BDOS functions are called. The host does their work between the OUT and the RET, in no time; so a
// call costs 20 T-states and the end 10, and the published T-states of such programs are met. A program may
// begin with SP = 0000: a RET at the top level then takes the two bytes of the OUT 0 for its address, 00D3,
// where a second OUT 0 ends the run for the same time. Functions 0 (ends like a jump to 0000), 2 and 9 are
// there; registers come back as they were.
//
// Left out: looking into the machine while it runs, the rest of CP/M, HOLD.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/raster.hpp"
#include "emulators/core/tstates.hpp"
#include "emulators/i8080/state.hpp"
#include "emulators/machines/i8080_run.hpp"
#include "emulators/machines/skala_ports.hpp"
#include "host/picture/pen_path.hpp"
#include "tools/image/binary.hpp"

namespace sightline::harness {

// Takes text as it comes: of the console what one call of BDOS prints, a character or a string; all else in
// blocks of whole lines.
using I8080TextTaker = std::function<void(std::string_view)>;

struct I8080Progress {
  std::uint64_t instructions;
  core::TStateInstant now;
};

// What stands in memory for CP/M, address and byte.
inline constexpr std::array<std::pair<std::uint16_t, std::uint8_t>, 7> cpm_stub{{{0x0000, 0xD3},
                                                                                 {0x0001, 0x00},
                                                                                 {0x0005, 0xD3},
                                                                                 {0x0006, 0x01},
                                                                                 {0x0007, 0xC9},
                                                                                 {0x00D3, 0xD3},
                                                                                 {0x00D4, 0x00}}};

struct I8080Job {
  // The clock, and which devices there are. The bytes their host sends are taken from the two members below.
  machines::SkalaConfiguration machine;
  std::optional<std::vector<std::uint8_t>> parallel;  // no value: no such chip
  std::optional<std::vector<std::uint8_t>> serial;
  image::ByteImage memory;  // the rest of memory is 0
  i8080::State registers;   // at the start
  bool cpm = false;         // puts the stub into memory, whatever the image has there
  bool strict = false;      // a port that nothing answers ends the run
  machines::I8080Limits limits;

  I8080TextTaker console;  // what functions 2 and 9 print; without a taker it is lost
  I8080TextTaker trace;    // one line an instruction, see i8080_trace_line_help
  I8080TextTaker bus;      // one line a machine cycle, see i8080_bus_line_help
  I8080TextTaker strokes;  // of the plotter, as host/picture/stroke_log writes them
  bool drawing = false;    // keep the lines the plotter draws
  // Asked every some million T-states and after every call of BDOS; false ends the run there. Empty: never
  // asked.
  std::function<bool(const I8080Progress&)> keep_running;
};

enum class I8080Stop : std::uint8_t {
  halt,  // HLT, and no interrupt can ever end it
  exit,  // CP/M: at 0000
  instruction_limit,
  state_limit,
  unknown_bdos,    // CP/M: a function that is not there
  endless_string,  // CP/M: function 9 found no $ in all of memory
  unanswered,      // strict
  interrupted,
};

// "halt", "exit", "instruction_limit", "state_limit", "unknown_bdos", "endless_string", "strict",
// "interrupted".
[[nodiscard]] std::string_view name_of(I8080Stop stop);

struct I8080UnansweredPort {
  std::uint8_t port;
  std::uint64_t reads;
  std::uint64_t writes;
};

// The count of bytes beyond what is kept of a link.
inline constexpr std::string_view not_kept = "not_kept";

// What a device counted, under names for reports, in the order of skala_ports.hpp.
struct DeviceReport {
  std::string_view device;
  std::vector<std::pair<std::string_view, std::uint64_t>> counts;
};

struct I8080Report {
  I8080Stop stop = I8080Stop::halt;
  i8080::State registers;
  core::TStateInstant end;
  std::uint64_t instructions = 0;
  // The BDOS function that ended the run and where it was called; 0005 if that cannot be told.
  std::uint8_t bdos_function = 0;
  i8080::Address bdos_caller = 0;
  std::vector<I8080UnansweredPort> unanswered;
  std::vector<std::uint8_t> memory;  // 65536
  std::vector<DeviceReport> devices;
  std::optional<core::Raster> raster;           // of the raster board; of the EF9365 if there are both
  std::vector<std::uint8_t> parallel_received;  // what the host took from port B, then from port A
  std::vector<std::uint8_t> serial_received;
  std::vector<picture::PenPath> drawing;  // of the plotter; marks one step apart are joined
  std::uint64_t drawing_left_out = 0;     // marks beyond what is kept
};

[[nodiscard]] I8080Report run_i8080(const I8080Job& job);

// Registers in the order of --set: A F B C D E H L, two hexadecimal digits each, SP PC, four, and INTE.
inline constexpr std::string_view i8080_registers_help = "A F B C D E H L SP PC INTE";
// T of the fetch in decimal, address and bytes, the instruction, registers after it. INT stands before an
// instruction that a device supplied, * before an opcode that Intel left undefined and that does the same as
// another.
inline constexpr std::string_view i8080_trace_line_help = "T PC BYTES INSTRUCTION A F B C D E H L SP PC INTE";
// T of the cycle's T1 in decimal, status byte, address, data; -- in the halt cycle. DAD's internal cycles
// have none.
inline constexpr std::string_view i8080_bus_line_help = "T SS AAAA DD";

// The registers on the first line, then 4096 lines of 16 bytes; hexadecimal, one space between.
[[nodiscard]] std::string dump_text(const I8080Report& report);

}  // namespace sightline::harness
