// An 8080 with a device of one's own at port 1, to which a program sends a text, a byte at a time.
#include <cstdio>
#include <sightline/machines/i8080.hpp>
struct Printer : sightline::core::PortDevice {
  void out(std::uint8_t, std::uint8_t byte, sightline::core::TStateInstant) override { std::putchar(byte); }
};
int main() {
  Printer printer;
  sightline::i8080::Machine i8080;
  i8080.put_before({1, 1}, printer);
  i8080.load(0, {{0x21, 14, 0, 0x7E, 0xB7, 0xCA, 28, 0, 0xD3, 1, 0x23, 0xC3, 3, 0,  // LXI H,14; 3: MOV A,M; ORA A; JZ 28; OUT 1; INX H; JMP 3
                  'H', 'e', 'l', 'l', 'o', ',', ' ', 'w', 'o', 'r', 'l', 'd', '\n', 0, 0x76}});  // 28: HLT
  if (i8080.run() != sightline::i8080::StopReason::halt) return 1;
  std::printf("halted after %d T-states, %d instructions\n", int(i8080.now().time_since_epoch().count()), int(i8080.instructions()));
}
