// Emulated T-states of the 8080 (the items) per second on an ordinary mix: the checksum of a page, then a line drawn over a
// mask of bytes with a call for each point above it, then port input and output. Also with a timer that interrupts fifty times
// per emulated second and is serviced by RST 7, and with the raster board attached, its interrupt connected and INTE on.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "emulators/core/port_device.hpp"
#include "emulators/machines/i8080.hpp"

namespace sightline {
namespace {

constexpr std::uint64_t instructions_a_round = 1'000'000;
constexpr i8080::Address program_start = 0x0100;
constexpr i8080::Address handler_start = 0x0038;

// A timer that interrupts every 60 000 T-states, 50 times a second at 3 MHz.
class Timer final : public core::PortDevice {
 public:
  static constexpr core::PortRange ports[]{{0x40, 0x41}};
  static constexpr std::string_view lines[]{"timer"};
  static constexpr core::PortDeviceInfo info{.name = "timer", .help = "interrupts", .choice = "timer", .reads = ports, .writes = ports, .lines = lines};

  [[nodiscard]] std::uint8_t in(std::uint8_t, core::TStateInstant) override { return 0x01; }
  [[nodiscard]] bool drives_interrupt() const override { return true; }
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant) override {
    raised_ = false;
    return 0xFF;
  }
  void advance(core::TStateInstant now) override {
    if (now < next_) return;
    raised_ = true;
    while (next_ <= now) next_ += core::TStates(60'000);
  }
  [[nodiscard]] core::TStateInstant deadline() const override { return next_; }
  [[nodiscard]] unsigned requests() const override { return raised_ ? 1 : 0; }

 private:
  core::TStateInstant next_ = core::at_t_state(60'000);
  bool raised_ = false;
};

constexpr std::array<std::uint8_t, 81> program{
    0x31, 0x00, 0xF0,        // 0100         LXI  SP,F000
    0xFB,                    // 0103         EI
    0x21, 0x00, 0x20,        // 0104 again:  LXI  H,2000
    0x01, 0x00, 0x00,        // 0107         LXI  B,0
    0x7E,                    // 010A sum:    MOV  A,M
    0x81,                    // 010B         ADD  C
    0x4F,                    // 010C         MOV  C,A
    0x23,                    // 010D         INX  H
    0x05,                    // 010E         DCR  B
    0xC2, 0x0A, 0x01,        // 010F         JNZ  sum
    0x79,                    // 0112         MOV  A,C
    0x32, 0x00, 0x40,        // 0113         STA  4000
    0x21, 0x00, 0x30,        // 0116         LXI  H,3000
    0x11, 0x40, 0x00,        // 0119         LXI  D,0040
    0x7A,                    // 011C line:   MOV  A,D
    0xBE,                    // 011D         CMP  M
    0xDA, 0x25, 0x01,        // 011E         JC   below
    0x72,                    // 0121         MOV  M,D
    0xCD, 0x3C, 0x01,        // 0122         CALL plot
    0x7B,                    // 0125 below:  MOV  A,E
    0xC6, 0x5B,              // 0126         ADI  5B
    0x5F,                    // 0128         MOV  E,A
    0xD2, 0x2D, 0x01,        // 0129         JNC  flat
    0x14,                    // 012C         INR  D
    0x2C,                    // 012D flat:   INR  L
    0xC2, 0x1C, 0x01,        // 012E         JNZ  line
    0xDB, 0x40,              // 0131         IN   40
    0xE6, 0x01,              // 0133         ANI  1
    0xD3, 0x41,              // 0135         OUT  41
    0xC3, 0x04, 0x01,        // 0137         JMP  again
    0x00, 0x00,              // 013A
    0xE5,                    // 013C plot:   PUSH H
    0x7D,                    // 013D         MOV  A,L
    0x0F,                    // 013E         RRC
    0x0F,                    // 013F         RRC
    0xE6, 0x3F,              // 0140         ANI  3F
    0x2A, 0x02, 0x40,        // 0142         LHLD 4002
    0x85,                    // 0145         ADD  L
    0x6F,                    // 0146         MOV  L,A
    0x22, 0x02, 0x40,        // 0147         SHLD 4002
    0xE1,                    // 014A         POP  H
    0xA8,                    // 014B         XRA  B
    0xC9,                    // 014C         RET
};
constexpr std::array<std::uint8_t, 11> handler{
    0xF5,              // 0038  PUSH PSW
    0x3A, 0x04, 0x40,  // 0039  LDA  4004
    0x3C,              // 003C  INR  A
    0x32, 0x04, 0x40,  // 003D  STA  4004
    0xF1,              // 0040  POP  PSW
    0xFB,              // 0041  EI
    0xC9,              // 0042  RET
};

void run_mix(benchmark::State& state, i8080::Machine& machine) {
  machine.load(program_start, program);
  machine.load(handler_start, handler);
  machine.start(program_start);
  for (auto _ : state) machine.run({instructions_a_round, core::never_t});
  const std::int64_t t_states = core::t_states_of(machine.now());
  state.SetItemsProcessed(t_states);
  state.counters["T_an_instruction"] =
      static_cast<double>(t_states) / static_cast<double>(machine.instructions());
}

void with_timer(benchmark::State& state) {
  i8080::Machine machine;
  if (const std::string error = machine.attach(Timer::info, std::make_unique<Timer>()); !error.empty()) state.SkipWithError(error.c_str());
  run_mix(state, machine);
}

void with_raster_board(benchmark::State& state) {
  i8080::Machine machine;
  for (const std::string& error : {machine.attach("ef9365"), machine.wire("ef9365", 7)})
    if (!error.empty()) state.SkipWithError(error.c_str());
  run_mix(state, machine);
}

BENCHMARK(with_timer)->Name("i8080/with_timer");
BENCHMARK(with_raster_board)->Name("i8080/with_raster_board");

}  // namespace
}  // namespace sightline
