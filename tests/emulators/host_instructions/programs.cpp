// The programs whose host instructions are counted, 100,000 guest instructions of each in a function of its own, whose name
// check.sh and bounds.txt use. Valgrind counts what lies within them.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>

#include "emulators/machines/i8080.hpp"
#include "emulators/machines/pdp7.hpp"
#include "emulators/type340/display.hpp"

namespace {

using namespace sightline;

constexpr std::uint64_t guest_instructions = 100'000;

struct Pdp7 {
  Pdp7() { static_cast<void>(machine.attach("display")); }
  pdp7::Machine machine;

  template <std::size_t n>
  void put(pdp7::Address at, const std::array<std::uint32_t, n>& words) {
    for (const std::uint32_t word : words) machine.deposit(at++, core::Word18(word));
  }
  void put_loop() {
    put(0100, std::array<std::uint32_t, 6>{0200110, 0340111, 0040110, 0440112, 0600100, 0600100});
    put(0111, std::array<std::uint32_t, 1>{3});
    machine.start(0100);
  }
  void put_mix(bool eae) {
    // law -10; dac 301; lac 300; dac 10
    put(0200, std::array<std::uint32_t, 4>{0777770, 0040301, 0200300, 0040010});
    if (eae) {
      // 204: lac i 10; mul; 123; lrs 7; div; 1000; lacq; isz 301; jmp 204; jmp 200
      put(0204, std::array<std::uint32_t, 10>{0220010, 0653122, 0000123, 0640507, 0640323, 0001000, 0641002, 0440301,
                                              0600204, 0600200});
    } else {
      // 204: lac i 10; tad 302; cll rar; and 303; spa; cma; dac 304; jms 320; sad 304; nop; isz 301; jmp 204; jmp 200
      put(0204, std::array<std::uint32_t, 13>{0220010, 0340302, 0744020, 0500303, 0741100, 0740001, 0040304, 0100320,
                                              0540304, 0740000, 0440301, 0600204, 0600200});
      // 320: 0; dac 305; isz 306; nop; xor 302; jmp i 320
      put(0320, std::array<std::uint32_t, 6>{0, 0040305, 0440306, 0740000, 0240302, 0620320});
    }
    put(0300, std::array<std::uint32_t, 4>{01777, 0, 054321, 0377777});
    for (pdp7::Address i = 0; i < 16; ++i) machine.deposit(02000 + i, core::Word18(i * 012345));
    machine.start(0200);
  }
  // 100 lines, each placed by two point words and drawn by two vectors; an interrupt starts the next pass.
  void put_picture() {
    put(1, std::array<std::uint32_t, 7>{0040030, 0200032, 0700606, 0200030, 0700042, 0620000, 0740040});
    put(0032, std::array<std::uint32_t, 1>{01000});
    pdp7::Address at = 01000;
    for (std::uint32_t line = 0; line < 100; ++line, at += 5) {
      put(at, std::array<std::uint32_t, 5>{0020117, 0220000 | (100 + line * 8), 0100000 | 200, 0200000U | (074U << 8) | 044U,
                                           0600000U | (044U << 8) | 074U});
    }
    put(at, std::array<std::uint32_t, 1>{0003000});
    machine.registers().interrupts_on = true;
    machine.find<type340::Display>()->load_address_and_start(machine.now(), core::Word18(01000));
  }
};

// The checksum of a page, then calls, 16-bit sums, the stack and conditional jumps.
constexpr std::array<std::uint8_t, 42> i8080_program{
    0x31, 0x00, 0xF0,  // 0100         LXI  SP,F000
    0x21, 0x00, 0x20,  // 0103 again:  LXI  H,2000
    0x01, 0x00, 0x00,  // 0106         LXI  B,0
    0x7E,              // 0109 sum:    MOV  A,M
    0x81,              // 010A         ADD  C
    0x4F,              // 010B         MOV  C,A
    0x23,              // 010C         INX  H
    0x05,              // 010D         DCR  B
    0xC2, 0x09, 0x01,  // 010E         JNZ  sum
    0x06, 0x40,        // 0111         MVI  B,40
    0xCD, 0x1E, 0x01,  // 0113 calls:  CALL plot
    0x05,              // 0116         DCR  B
    0xC2, 0x13, 0x01,  // 0117         JNZ  calls
    0xC3, 0x03, 0x01,  // 011A         JMP  again
    0x00,              // 011D
    0xE5,              // 011E plot:   PUSH H
    0x7D,              // 011F         MOV  A,L
    0x0F,              // 0120         RRC
    0xE6, 0x3F,        // 0121         ANI  3F
    0x2A, 0x02, 0x40,  // 0123         LHLD 4002
    0x09,              // 0126         DAD  B
    0xE1,              // 0127         POP  H
    0xA8,              // 0128         XRA  B
    0xC9,              // 0129         RET
};

void run(Pdp7& pdp7) { pdp7.machine.run({guest_instructions, core::never}); }

}  // namespace

// Names that a pattern of valgrind finds.
extern "C" {
[[gnu::noinline]] void count_pdp7_loop(void* pdp7) { run(*static_cast<Pdp7*>(pdp7)); }
[[gnu::noinline]] void count_pdp7_mix(void* pdp7) { run(*static_cast<Pdp7*>(pdp7)); }
[[gnu::noinline]] void count_pdp7_eae(void* pdp7) { run(*static_cast<Pdp7*>(pdp7)); }
[[gnu::noinline]] void count_pdp7_refreshing(void* pdp7) { run(*static_cast<Pdp7*>(pdp7)); }
[[gnu::noinline]] void count_i8080_mix(void* i8080) {
  static_cast<i8080::Machine*>(i8080)->run({guest_instructions, core::never_t});
}
}

int main() {
  Pdp7 loop;
  loop.put_loop();
  count_pdp7_loop(&loop);
  Pdp7 mix;
  mix.put_mix(false);
  count_pdp7_mix(&mix);
  Pdp7 eae;
  eae.put_mix(true);
  count_pdp7_eae(&eae);
  Pdp7 refreshing;
  refreshing.put_loop();
  refreshing.put_picture();
  count_pdp7_refreshing(&refreshing);
  i8080::Machine machine;
  machine.load(0x100, i8080_program);
  machine.start(0x100);
  count_i8080_mix(&machine);
  std::printf("%ld %ld\n", static_cast<long>(core::nanoseconds_of(eae.machine.now())),
              static_cast<long>(core::t_states_of(machine.now())));
}
