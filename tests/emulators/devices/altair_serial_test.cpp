// The Altair's serial boards, register by register. At 3 MHz and 9600 baud a character is ten bits, 3125 T-states. Expected flags
// are
// those in MITS's register tables and in the MC6850 data sheet.
#include "emulators/devices/altair_serial.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <tuple>

namespace sightline {
namespace {

using devices::AltairBoard;
using devices::AltairSerial;

constexpr std::int64_t character = 3125;
constexpr std::uint8_t status = 0, data = 1;

struct Line {
  AltairSerial serial;
  explicit Line(AltairBoard board, devices::AltairLine line = {}) : serial(core::ClockRate{}, board, line) {}
  int in(std::uint8_t port, std::int64_t t) { return serial.read(port, core::at_t_state(t)); }
  void out(std::uint8_t port, int value, std::int64_t t) { serial.write(port, static_cast<std::uint8_t>(value), core::at_t_state(t)); }
  std::string printed() {
    const auto bytes = serial.take_printed();
    return {bytes.begin(), bytes.end()};
  }
};

TEST(AltairSerial, TheSioSaysReadyWithZeros) {
  Line line(AltairBoard::sio);
  EXPECT_EQ(line.in(status, 0), 0x01);
  line.serial.type('k');
  EXPECT_EQ(line.in(status, 10), 0x00);
  EXPECT_EQ(line.in(data, 20), 'k');
  EXPECT_EQ(line.in(status, 30), 0x01);
  line.out(data, 'A', 100);
  EXPECT_EQ(line.in(status, 110), 0x01) << "the first character is sent at once, another can be written";
  line.out(data, 'B', 120);
  EXPECT_EQ(line.in(status, 130), 0x81);
  EXPECT_EQ(line.in(status, 100 + character - 1), 0x81);
  EXPECT_EQ(line.in(status, 100 + character), 0x01);
  EXPECT_EQ(line.printed(), "AB");
}

TEST(AltairSerial, The2SioSaysReadyWithOnes) {
  Line line(AltairBoard::two_sio);
  line.out(status, 0x03, 0);
  line.out(status, 0x15, 5);
  EXPECT_EQ(line.in(status, 10), 0x02);
  line.serial.type('x');
  EXPECT_EQ(line.in(status, 20), 0x03);
  EXPECT_EQ(line.in(data, 30), 'x');
  EXPECT_EQ(line.in(status, 40), 0x02);
}

TEST(AltairSerial, TheNextKeyComesNoSoonerThanTheLineAllows) {
  Line line(AltairBoard::two_sio);
  line.serial.type('a');
  line.serial.type('b');
  EXPECT_EQ(line.in(data, 1000), 'a');
  EXPECT_EQ(line.in(status, 1000 + character - 1), 0x02);
  EXPECT_EQ(line.in(status, 1000 + character), 0x03);
  EXPECT_EQ(line.in(data, 1000 + character), 'b');
  EXPECT_FALSE(line.serial.wants_key());
  EXPECT_EQ(line.in(status, 2 * character + 1000), 0x02);
  EXPECT_TRUE(line.serial.wants_key());
  line.serial.type('c');
  EXPECT_FALSE(line.serial.wants_key());
}

class PollCounter final : public core::KeyPollListener {
 public:
  void key_polled() override { ++polls; }
  int polls = 0;
};

// A poll is a look at the status or the data that finds no key although none is on its way.
TEST(AltairSerial, TellsOfPollsInVain) {
  Line line(AltairBoard::two_sio);
  PollCounter counter;
  line.serial.tell_polls(&counter);
  EXPECT_EQ(line.in(status, 10), 0x02);
  EXPECT_EQ(line.in(data, 20), 0);
  EXPECT_EQ(counter.polls, 2);
  line.serial.type('a');
  line.serial.type('b');
  EXPECT_EQ(line.in(status, 30), 0x03);
  EXPECT_EQ(line.in(data, 40), 'a');
  EXPECT_EQ(line.in(status, 50), 0x02);  // b is on its way
  EXPECT_EQ(counter.polls, 2);
  EXPECT_EQ(line.in(data, 40 + character), 'b');
  EXPECT_EQ(line.in(status, 50 + character), 0x02);
  EXPECT_EQ(counter.polls, 3);
}

TEST(AltairSerial, AnEnabledReceiveInterruptAsksForKeys) {
  for (const auto& [board, on, off] : {std::tuple{AltairBoard::two_sio, 0x95, 0x15}, std::tuple{AltairBoard::sio, 1, 2}}) {
    Line line(board);
    EXPECT_FALSE(line.serial.interrupts_for_key());
    line.out(status, on, 10);
    EXPECT_TRUE(line.serial.interrupts_for_key());
    EXPECT_FALSE(line.serial.wants_key());
    line.serial.type('a');
    EXPECT_FALSE(line.serial.interrupts_for_key());
    EXPECT_EQ(line.in(data, 100), 'a');
    EXPECT_TRUE(line.serial.interrupts_for_key());
    EXPECT_EQ(line.serial.quiet_since(), core::at_t_state(100 + character));
    line.out(data, 'x', 500 + character);
    line.out(data, 'y', 501 + character);
    EXPECT_EQ(line.serial.quiet_since(), core::at_t_state(500 + 3 * character));
    line.out(status, off, 600 + character);
    EXPECT_FALSE(line.serial.interrupts_for_key());
  }
}

TEST(AltairSerial, ACharacterWrittenTooSoonReplacesTheWaitingOne) {
  Line line(AltairBoard::two_sio);
  for (const char c : {'1', '2', '3'}) line.out(data, c, 0);
  line.serial.advance(core::at_t_state(10 * character));
  EXPECT_EQ(line.printed(), "13");
  EXPECT_EQ(line.serial.totals().overwritten, 1U);
  EXPECT_EQ(line.serial.totals().sent, 2U);
}

TEST(AltairSerial, TenCharactersASecondAt110Baud) {
  Line line(AltairBoard::sio, {.baud = 110});
  line.out(data, 'A', 0);
  line.out(data, 'B', 1);
  EXPECT_EQ(line.in(status, 300'000 - 1) & 0x80, 0x80);  // eleven bits are a tenth of a second
  EXPECT_EQ(line.in(status, 300'000) & 0x80, 0);
}

// The tape comes before the keys, a character at a time, with all its bits; the punch gets what is sent.
TEST(AltairSerial, ATapeIsReadBeforeTheKeysAndAllIsPunched) {
  constexpr std::array<std::uint8_t, 2> tape{0x00, 0xFF};
  Line line(AltairBoard::two_sio);
  EXPECT_EQ(line.serial.link_host(), nullptr);
  Line teletype(AltairBoard::two_sio, {9600, true, true});
  teletype.serial.send(tape);
  teletype.serial.type('k');
  EXPECT_EQ(teletype.in(data, 0), 0x00);
  EXPECT_EQ(teletype.in(status, character - 1), 0x02);
  EXPECT_EQ(teletype.in(data, character), 0xFF);
  EXPECT_FALSE(teletype.serial.wants_key());
  EXPECT_EQ(teletype.in(data, 2 * character), 'k');
  EXPECT_EQ(teletype.in(status, 3 * character), 0x02);
  EXPECT_TRUE(teletype.serial.wants_key());
  teletype.out(data, 0x8A, 4 * character);
  EXPECT_EQ(teletype.printed(), "\x8A");
  EXPECT_EQ(teletype.serial.received(), (std::vector<std::uint8_t>{0x8A}));
  Line alone(AltairBoard::sio, {9600, false, true});
  EXPECT_EQ(alone.serial.terminal(), nullptr);
  EXPECT_EQ(alone.in(status, 0), 0x01) << "an empty reader";
  alone.out(data, 'A', 1);
  EXPECT_EQ(alone.printed(), "");
  EXPECT_EQ(alone.serial.received(), (std::vector<std::uint8_t>{'A'}));
}

TEST(AltairSerial, InterruptsAsTheControlSays) {
  Line line(AltairBoard::two_sio);
  EXPECT_FALSE(line.serial.interrupt());
  line.out(status, 0x20, 0);  // send
  EXPECT_TRUE(line.serial.interrupt());
  EXPECT_EQ(line.in(status, 1), 0x82);
  line.out(data, 'A', 2);
  line.out(data, 'B', 3);
  EXPECT_FALSE(line.serial.interrupt());
  EXPECT_EQ(line.serial.deadline(), core::at_t_state(2 + character));
  line.serial.advance(line.serial.deadline());
  EXPECT_TRUE(line.serial.interrupt());
  line.out(status, 0x80, 2 * character);  // receive
  EXPECT_FALSE(line.serial.interrupt());
  line.serial.type('k');
  EXPECT_TRUE(line.serial.interrupt());
  EXPECT_EQ(line.in(data, 2 * character + 1), 'k');
  line.serial.type('l');
  EXPECT_FALSE(line.serial.interrupt());
  EXPECT_EQ(line.serial.deadline(), core::at_t_state(3 * character + 1));
  Line sio(AltairBoard::sio);
  sio.out(status, 0x02, 0);
  EXPECT_TRUE(sio.serial.interrupt());
  sio.out(status, 0x01, 1);
  EXPECT_FALSE(sio.serial.interrupt());
  sio.serial.type('k');
  EXPECT_TRUE(sio.serial.interrupt());
}

}  // namespace
}  // namespace sightline
