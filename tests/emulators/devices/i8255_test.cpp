// The 8255 mode by mode against the data sheet's control words and status bits, and the parallel link's
// handshake with its times: at 3 MHz the host's 2 us are 6 T-states, its pulse of 500 ns 2 (1.5 rounded up).
#include "emulators/devices/i8255.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "emulators/devices/parallel_link.hpp"
#include "tests/emulators/devices/device_test.hpp"

namespace {

using sightline::core::at_t_state;
using sightline::core::never_t;
using sightline::devices::I8255;
using sightline::devices::ParallelLink;
using sightline::tests::Access;
using sightline::tests::three_megahertz;
constexpr auto a = I8255::Port::a;
constexpr auto b = I8255::Port::b;

TEST(I8255, AfterResetAllPortsAreInputs) {
  I8255 chip;
  chip.set_levels(a, 0x12);
  chip.set_levels(b, 0x34);
  chip.set_levels_c(0x56);
  EXPECT_EQ(chip.read(0), 0x12);
  EXPECT_EQ(chip.read(1), 0x34);
  EXPECT_EQ(chip.read(2), 0x56);
  EXPECT_EQ(chip.read(3), 0xFF);
  EXPECT_EQ(chip.lines(a), 0xFF);
  EXPECT_EQ(chip.lines_c(), 0xFF);
}

TEST(I8255, ModeZeroHasFourIndependentDirections) {
  for (unsigned choice = 0; choice < 16; ++choice) {
    const bool a_in = (choice & 8U) != 0;
    const bool upper_in = (choice & 4U) != 0;
    const bool b_in = (choice & 2U) != 0;
    const bool lower_in = (choice & 1U) != 0;
    I8255 chip;
    chip.set_levels(a, 0xA5);
    chip.set_levels(b, 0x5A);
    chip.set_levels_c(0x96);
    chip.write(3, static_cast<std::uint8_t>(0x80U | (choice & 8U) << 1 | (choice & 4U) << 1 | (choice & 3U)));
    chip.write(0, 0x11);
    chip.write(1, 0x22);
    chip.write(2, 0x33);
    EXPECT_EQ(chip.read(0), a_in ? 0xA5 : 0x11) << choice;
    EXPECT_EQ(chip.read(1), b_in ? 0x5A : 0x22) << choice;
    EXPECT_EQ(chip.read(2), (upper_in ? 0x90 : 0x30) | (lower_in ? 0x06 : 0x03)) << choice;
    EXPECT_EQ(chip.lines(a), a_in ? 0xFF : 0x11) << choice;
    EXPECT_EQ(chip.lines_c(), (upper_in ? 0xF0 : 0x30) | (lower_in ? 0x0F : 0x03)) << choice;
  }
}

TEST(I8255, SettingAModeClearsTheLatches) {
  I8255 chip;
  chip.write(3, 0x80);
  chip.write(0, 0xFF);
  chip.write(2, 0xFF);
  chip.write(3, 0x80);
  EXPECT_EQ(chip.read(0), 0);
  EXPECT_EQ(chip.read(2), 0);
}

TEST(I8255, BitSetAndReset) {
  I8255 chip;
  chip.write(3, 0x80);
  for (unsigned bit = 0; bit < 8; ++bit) {
    chip.write(3, static_cast<std::uint8_t>(bit << 1 | 1U));
    EXPECT_EQ(chip.read(2), 1U << bit);
    chip.write(3, static_cast<std::uint8_t>(bit << 1));
    EXPECT_EQ(chip.read(2), 0);
  }
}

// Port C's status: b5 IBF, b4 INTE, b3 INTR.
TEST(I8255, StrobedInputOnPortA) {
  I8255 chip;
  chip.write(3, 0xB0);
  EXPECT_EQ(chip.read(2) & 0x38, 0x00);
  chip.strobe_falls(a, 0x42);
  EXPECT_EQ(chip.read(2) & 0x38, 0x20);
  chip.write(3, 0x09);  // PC4: INTE
  EXPECT_EQ(chip.read(2) & 0x38, 0x30);
  EXPECT_FALSE(chip.interrupt(a));
  chip.strobe_rises(a);
  EXPECT_EQ(chip.read(2) & 0x38, 0x38);
  EXPECT_TRUE(chip.interrupt(a));
  EXPECT_EQ(chip.read(0), 0x42);
  EXPECT_EQ(chip.read(2) & 0x38, 0x10);
  chip.write(3, 0x08);
  chip.strobe_falls(a, 1);
  chip.strobe_rises(a);
  EXPECT_FALSE(chip.interrupt(a));
}

TEST(I8255, StrobedInputOnPortB) {
  I8255 chip;
  chip.write(3, 0x86);
  chip.write(3, 0x05);  // PC2: INTE
  chip.strobe_falls(b, 0x77);
  chip.strobe_rises(b);
  EXPECT_EQ(chip.read(2) & 0x07, 0x07);
  EXPECT_EQ(chip.read(1), 0x77);
  EXPECT_EQ(chip.read(2) & 0x07, 0x04);
}

TEST(I8255, StrobedOutputOnBothPorts) {
  I8255 chip;
  chip.write(3, 0xA4);
  EXPECT_EQ(chip.read(2) & 0xCF, 0x82);  // OBF# high on both
  chip.write(3, 0x0D);                   // PC6: INTE A
  chip.write(3, 0x05);                   // PC2: INTE B
  EXPECT_EQ(chip.read(2) & 0xCF, 0xCF);
  chip.write(0, 0x5C);
  chip.write(1, 0xC5);
  EXPECT_EQ(chip.read(2) & 0xCF, 0x44);
  EXPECT_EQ(chip.acknowledge_falls(a), 0x5C);
  EXPECT_EQ(chip.read(2) & 0xC8, 0xC0);
  chip.acknowledge_rises(a);
  EXPECT_EQ(chip.read(2) & 0xC8, 0xC8);
  EXPECT_EQ(chip.acknowledge_falls(b), 0xC5);
  chip.acknowledge_rises(b);
  EXPECT_EQ(chip.read(2) & 0x07, 0x07);
}

TEST(I8255, ModeTwoHasBothHandshakesOnPortA) {
  I8255 chip;
  chip.write(3, 0xC0);
  EXPECT_EQ(chip.read(2) & 0xF8, 0x80);
  chip.write(3, 0x09);
  chip.write(0, 0x31);
  chip.strobe_falls(a, 0x13);
  chip.strobe_rises(a);
  EXPECT_EQ(chip.read(2) & 0xF8, 0x38);
  EXPECT_EQ(chip.read(0), 0x13);
  EXPECT_EQ(chip.acknowledge_falls(a), 0x31);
  chip.acknowledge_rises(a);
  EXPECT_EQ(chip.read(2) & 0xF8, 0x90);
}

TEST(I8255, FreeLinesOfPortCStayOutputsBesideAHandshake) {
  I8255 chip;
  chip.write(3, 0xB0);  // A in, mode 1; PC6, PC7 and PC2-0 out
  chip.write(2, 0xFF);
  EXPECT_EQ(chip.read(2), 0xC7);
}

TEST(ParallelLink, HandshakeTranscript) {
  constexpr std::array<std::uint8_t, 2> bytes{0x0A, 0x80};
  ParallelLink link(three_megahertz, bytes);
  constexpr bool reads = true;
  struct PortAccess {
    std::uint8_t address;
    Access access;
  };
  const std::vector<PortAccess> transcript{
      {2, {90, reads, 0xFF}},    // not programmed: everything floats, the host waits
      {3, {100, !reads, 0xB0}},  // IBF falls; the host answers 6 T later
      {2, {105, reads, 0x00}},  {2, {106, reads, 0x20}}, {0, {120, reads, 0x0A}},  {2, {125, reads, 0x00}},
      {2, {126, reads, 0x20}},  {0, {130, reads, 0x80}}, {2, {1000, reads, 0x00}},  // nothing left to send
  };
  for (const auto& [address, access] : transcript) {
    if (access.reads)
      EXPECT_EQ(int{link.read(address, at_t_state(access.t))}, int{access.value}) << "T " << access.t;
    else
      link.write(address, access.value, at_t_state(access.t));
  }
  EXPECT_EQ(link.sent(), 2U);
}

TEST(ParallelLink, TheInterruptComesWhenStrobeRises) {
  constexpr std::array<std::uint8_t, 1> bytes{0x0A};
  ParallelLink link(three_megahertz, bytes);
  link.write(3, 0xB0, at_t_state(0));
  link.write(3, 0x09, at_t_state(1));
  EXPECT_EQ(link.deadline(), at_t_state(6));
  link.advance(at_t_state(6));
  EXPECT_FALSE(link.interrupt());
  EXPECT_EQ(link.deadline(), at_t_state(8));
  link.advance(at_t_state(8));
  EXPECT_TRUE(link.interrupt());
  EXPECT_EQ(link.deadline(), never_t);
  EXPECT_EQ(link.read(0, at_t_state(50)), 0x0A);
  EXPECT_FALSE(link.interrupt());
}

TEST(ParallelLink, AReadDuringTheStrobeLetsTheHostFinishItsPulseFirst) {
  constexpr std::array<std::uint8_t, 2> bytes{1, 2};
  ParallelLink link(three_megahertz, bytes);
  link.write(3, 0xB0, at_t_state(0));
  EXPECT_EQ(link.read(0, at_t_state(7)), 1);
  EXPECT_EQ(link.read(2, at_t_state(13)) & 0x20, 0x00);
  EXPECT_EQ(link.read(2, at_t_state(14)) & 0x20, 0x20);
  EXPECT_EQ(link.read(0, at_t_state(20)), 2);
}

TEST(ParallelLink, TheHostTakesWhatPortBPutsOut) {
  ParallelLink link(three_megahertz, {});
  link.write(3, 0xB4, at_t_state(0));
  link.write(1, 0x5A, at_t_state(10));
  EXPECT_EQ(link.read(2, at_t_state(15)) & 0x02, 0x00);
  EXPECT_EQ(link.read(2, at_t_state(16)) & 0x02, 0x02);
  link.write(1, 0xA5, at_t_state(100));
  link.advance(at_t_state(200));
  EXPECT_EQ(link.received(b).bytes(), (std::vector<std::uint8_t>{0x5A, 0xA5}));
}

}  // namespace
