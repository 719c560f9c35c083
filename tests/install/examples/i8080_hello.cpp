// An 8080 with a port: a program sends a text to port 1, a byte at a time.
#include <cstdio>
#include <sightline/machines/i8080_machine.hpp>
#include <string>

using namespace sightline;

struct Printer : machines::NoI8080Ports {  // port 1; the others float
  void out(std::uint8_t port, std::uint8_t byte, core::TStateInstant) {
    if (port == 1) text += static_cast<char>(byte);
  }
  std::string text;
};

int main() {
  Printer printer;
  machines::NoI8080Observer observer;
  machines::I8080Machine<Printer> i8080(printer, observer);
  // LXI H,000E; next: MOV A,M; ORA A; JZ stop; OUT 1; INX H; JMP next; stop: HLT
  i8080::Address address = 0;
  for (const unsigned byte :
       {0x21U, 0x0EU, 0U, 0x7EU, 0xB7U, 0xCAU, 0x1CU, 0U, 0xD3U, 1U, 0x23U, 0xC3U, 3U, 0U})
    i8080.deposit(address++, static_cast<i8080::Byte>(byte));
  for (const char c : std::string("Hello, world\n")) i8080.deposit(address++, static_cast<i8080::Byte>(c));
  address = 0x1C;
  i8080.deposit(address, 0x76);
  const bool halted = i8080.run({}) == machines::I8080StopReason::halt;
  std::printf("%s%s after %lld T-states, %llu instructions\n", printer.text.c_str(),
              halted ? "halted" : "stopped", static_cast<long long>(core::t_states_of(i8080.now())),
              static_cast<unsigned long long>(i8080.instructions()));
}
