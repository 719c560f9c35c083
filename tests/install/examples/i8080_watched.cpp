// An 8080 that is watched: a limit of instructions, why a run stopped, registers, and an observer with a breakpoint.
#include <cstdio>
#include <sightline/machines/i8080_machine.hpp>

using namespace sightline;

struct Watcher {
  static constexpr bool instructions = true, cycles = false, stops = true;
  void instruction(const machines::I8080InstructionRecord& done) { decrements += done.bytes[0] == 0x05; }
  bool stop(core::TStateInstant, i8080::Address next) const { return next == 7; }
  int decrements = 0;
};

int main() {
  machines::NoI8080Ports ports;
  Watcher watcher;
  machines::I8080Machine<machines::NoI8080Ports, Watcher> i8080(ports, watcher);
  // EI; MVI B,5; 3: DCR B; JNZ 3; 7: HLT
  i8080::Address address = 0;
  for (const unsigned byte : {0xFBU, 0x06U, 5U, 0x05U, 0xC2U, 3U, 0U, 0x76U})
    i8080.deposit(address++, static_cast<i8080::Byte>(byte));
  machines::I8080Limits limits;
  limits.instructions = 4;  // of this run; limits.until is a time
  if (i8080.run(limits) != machines::I8080StopReason::instruction_limit) return 1;
  const i8080::State& registers = i8080.registers();
  std::printf("PC %04X, B %d, INTE %d\n", static_cast<unsigned>(registers.pc), registers.bc >> 8, int{registers.interrupts_on});
  if (i8080.run({}) != machines::I8080StopReason::observer) return 1;  // goes on from there to the breakpoint
  std::printf("PC %04X after %lld T-states: %d times DCR B\n", static_cast<unsigned>(registers.pc),
              static_cast<long long>(core::t_states_of(i8080.now())), watcher.decrements);
}
