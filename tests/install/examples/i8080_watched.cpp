// An 8080 that is watched: a limit of instructions, why a run stopped, registers, and an observer with a breakpoint.
#include <array>
#include <cstdio>
#include <sightline/machines/i8080.hpp>

using namespace sightline;

struct Watcher : i8080::Observer {
  Watcher() {
    places[7] = i8080::mark::stop;
    marks = places.data();
    instructions = true;
  }
  void instruction(const i8080::InstructionRecord& done) override { decrements += done.bytes[0] == 0x05; }
  bool stop(core::TStateInstant, i8080::Address next) override { return next == 7; }
  std::array<std::uint8_t, 65536> places{};
  int decrements = 0;
};

int main() {
  i8080::Machine i8080;
  i8080.load(0, {{0xFB, 0x06, 5, 0x05, 0xC2, 3, 0, 0x76}});  // EI; MVI B,5; 3: DCR B; JNZ 3; 7: HLT
  Watcher watcher;
  // Four instructions; limits.until is a time.
  if (i8080.run({.instructions = 4}, watcher) != i8080::StopReason::instruction_limit) return 1;
  const i8080::State& registers = i8080.registers();
  std::printf("PC %04X, B %d, INTE %d\n", static_cast<unsigned>(registers.pc), registers.bc >> 8, int{registers.interrupts_on});
  if (i8080.run({}, watcher) != i8080::StopReason::observer) return 1;  // continues from there to the breakpoint
  std::printf("PC %04X after %lld T-states: %d times DCR B\n", static_cast<unsigned>(registers.pc),
              static_cast<long long>(core::t_states_of(i8080.now())), watcher.decrements);
}
