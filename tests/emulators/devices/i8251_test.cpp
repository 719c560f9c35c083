// The 8251: the sequence of control words, the timing of characters (9600 baud 8N1 at 3 MHz: a bit is 312.5 T-states, a character
// 3,125, in the receiver after 9.5 bits = 2,968.75, rounded up), and every error.
#include "emulators/devices/i8251.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "emulators/devices/serial_link.hpp"
#include "tests/emulators/devices/device_test.hpp"

namespace {

using sightline::core::at_t_state;
using sightline::core::Duration;
using sightline::devices::SerialFormat;
using sightline::devices::SerialHost;
using sightline::devices::SerialLink;
using sightline::tests::three_megahertz;

constexpr std::array<std::uint8_t, 3> three_bytes{0x41, 0x96, 0xFF};

SerialHost blind(std::int64_t starts) {
  SerialHost host;
  host.watches_rts = false;
  host.starts = at_t_state(starts);
  return host;
}

// Mode and command at T 0 and 10.
void programme(SerialLink& link, int mode = 0x4E, int command = 0x37) {
  link.write(1, static_cast<std::uint8_t>(mode), at_t_state(0));
  link.write(1, static_cast<std::uint8_t>(command), at_t_state(10));
}
int status(SerialLink& link, std::int64_t t) {
  return link.read(1, at_t_state(t));
}
int data(SerialLink& link, std::int64_t t) {
  return link.read(0, at_t_state(t));
}

TEST(I8251, ReceivesInItsTime) {
  SerialLink link(three_megahertz, three_bytes);
  EXPECT_EQ(status(link, 0), 0x85);
  programme(link);  // RTS at T 10: the start bit
  EXPECT_EQ(status(link, 10 + 2968), 0x85);
  EXPECT_EQ(status(link, 10 + 2969), 0x87);
  EXPECT_EQ(data(link, 3000), 0x41);
  EXPECT_EQ(status(link, 3010), 0x85);
  EXPECT_EQ(status(link, 10 + 3125 + 2968), 0x85);
  EXPECT_EQ(status(link, 10 + 3125 + 2969), 0x87);
  EXPECT_EQ(data(link, 6200), 0x96);
  EXPECT_EQ(data(link, 10 + 2 * 3125 + 2969), 0xFF);
  EXPECT_EQ(link.chip().counts().received, 3U);
  EXPECT_EQ(link.chip().counts().overruns, 0U);
  EXPECT_EQ(link.deadline(), sightline::core::never_t);
}

TEST(I8251, OverrunWhenTheProcessorIsLate) {
  SerialLink link(three_megahertz, three_bytes, blind(10));
  programme(link);
  EXPECT_EQ(status(link, 10 + 3125 + 2968), 0x87);
  EXPECT_EQ(status(link, 10 + 3125 + 2969), 0x97);
  EXPECT_EQ(data(link, 6200), 0x96);
  EXPECT_EQ(status(link, 6210), 0x95);  // the error flag stays set
  link.write(1, 0x37, at_t_state(6220));
  EXPECT_EQ(status(link, 6230), 0x85);
  EXPECT_EQ(link.chip().counts().overruns, 1U);
}

TEST(I8251, TheHostWaitsForRts) {
  SerialLink link(three_megahertz, three_bytes);
  programme(link, 0x4E, 0x07);  // RTS off
  EXPECT_EQ(status(link, 1'000'000), 0x85);
  EXPECT_EQ(link.sent(), 0U);
  link.write(1, 0x27, at_t_state(1'000'000));
  link.write(1, 0x07, at_t_state(1'000'100));  // the character on the line is completed
  EXPECT_EQ(status(link, 1'002'969), 0x87);
  EXPECT_EQ(data(link, 1'003'000), 0x41);
  EXPECT_EQ(status(link, 2'000'000), 0x85);
  EXPECT_EQ(link.sent(), 1U);
}

TEST(I8251, CharactersAreLostBeforeTheReceiverIsOn) {
  SerialLink link(three_megahertz, three_bytes, blind(0));
  link.write(1, 0x4E, at_t_state(5000));
  link.write(1, 0x27, at_t_state(5010));
  EXPECT_EQ(data(link, 6250), 0x96);
  EXPECT_EQ(link.chip().counts().received_lost, 1U);
}

TEST(I8251, ParityAndLengthFollowTheMode) {
  SerialHost host = blind(10);
  host.format = {7, true, true, 4};
  SerialLink good(three_megahertz, three_bytes, host);
  programme(good, 0xFA);  // x16, 7 bits, even parity, 2 stop bits: 11 bits = 3,437.5 T
  EXPECT_EQ(status(good, 3000), 0x87);
  EXPECT_EQ(data(good, 3010), 0x41);
  EXPECT_EQ(status(good, 10 + 3438 + 2968), 0x85);
  EXPECT_EQ(data(good, 10 + 3438 + 2969), 0x16);
  SerialLink bad(three_megahertz, three_bytes, host);
  programme(bad, 0xDA);  // odd
  EXPECT_EQ(status(bad, 3000), 0x8F);
  EXPECT_EQ(bad.chip().counts().parity_errors, 1U);
}

// Eight bits sent, five expected: the sixth is in the position of the stop bit.
TEST(I8251, FramingErrorWhenTheFormatsDiffer) {
  constexpr std::array<std::uint8_t, 1> bytes{0x15};
  SerialLink link(three_megahertz, bytes);
  programme(link, 0x42);
  EXPECT_EQ(status(link, 10 + 2032), 0xA7);  // 6.5 bits = 2,031.25 T
  EXPECT_EQ(data(link, 3000), 0x15);
  EXPECT_EQ(link.chip().counts().framing_errors, 1U);
}

// A receiver at 2400 baud samples its first data bit during the host's bit time 6, data bit 5; then the line is mark.
TEST(I8251, AReceiverAtAQuarterOfTheSpeed) {
  constexpr std::array<std::uint8_t, 2> bytes{0xDF, 0x55};
  SerialLink link(three_megahertz, bytes);
  programme(link, 0x4F);
  EXPECT_EQ(status(link, 10 + 9 * 1250 + 625) & 0x02, 0x02);
  EXPECT_EQ(data(link, 13'000), 0xFE);
  EXPECT_EQ(link.sent(), 2U);
  EXPECT_EQ(link.unseen(), 1U);
}

TEST(I8251, TransmitterHasAHoldingPlaceAndAShifter) {
  SerialLink link(three_megahertz, {});
  programme(link);
  link.write(0, 0x31, at_t_state(100));
  EXPECT_EQ(status(link, 110), 0x81);  // moved to the shifter at once: room for one more, not empty
  link.write(0, 0x32, at_t_state(120));
  EXPECT_EQ(status(link, 130), 0x80);
  EXPECT_EQ(status(link, 100 + 3124), 0x80);
  EXPECT_EQ(status(link, 100 + 3125), 0x81);
  EXPECT_EQ(status(link, 100 + 6249), 0x81);
  EXPECT_EQ(status(link, 100 + 6250), 0x85);
  EXPECT_EQ(link.chip().sent().bytes(), (std::vector<std::uint8_t>{0x31, 0x32}));
}

TEST(I8251, ACharacterWrittenTooSoonReplacesTheWaitingOne) {
  SerialLink link(three_megahertz, {});
  programme(link);
  for (const std::uint8_t value : three_bytes) link.write(0, value, at_t_state(100));
  link.advance(at_t_state(100'000));
  EXPECT_EQ(link.chip().sent().bytes(), (std::vector<std::uint8_t>{0x41, 0xFF}));
  EXPECT_EQ(link.chip().counts().transmit_overwritten, 1U);
}

TEST(I8251, TheRecordOfBytesSentIsBounded) {
  sightline::devices::KeptBytes kept(2);
  for (const std::uint8_t value : three_bytes) kept.push_back(value);
  EXPECT_EQ(kept.bytes(), (std::vector<std::uint8_t>{three_bytes[0], three_bytes[1]}));
  EXPECT_EQ(kept.left_out(), 1U);
}

TEST(I8251, TransmitterOffHoldsTheCharacter) {
  SerialLink link(three_megahertz, {});
  programme(link, 0x4E, 0x00);
  link.write(0, 0x31, at_t_state(100));
  EXPECT_EQ(status(link, 100'000), 0x80);
  link.write(1, 0x01, at_t_state(200'000));
  EXPECT_EQ(status(link, 203'125), 0x85);
  EXPECT_EQ(link.chip().sent().bytes().size(), 1U);
}

TEST(I8251, InternalResetAsksForAModeAgain) {
  SerialLink link(three_megahertz, {});
  programme(link);
  link.write(1, 0x40, at_t_state(20));
  EXPECT_FALSE(link.chip().programmed());
  link.write(1, 0x4A, at_t_state(30));
  EXPECT_TRUE(link.chip().programmed());
  EXPECT_EQ(link.chip().format().data_bits, 7);
}

TEST(I8251, SynchronousModesKeepTheSequenceOfControlWords) {
  for (const auto& [mode, sync_words] : {std::pair{0x0C, 2}, std::pair{0x8C, 1}}) {
    SerialLink link(three_megahertz, {});
    link.write(1, static_cast<std::uint8_t>(mode), at_t_state(0));
    for (int n = 0; n < sync_words; ++n) link.write(1, 0x16, at_t_state(10));
    EXPECT_FALSE(link.chip().request_to_send());
    link.write(1, 0x27, at_t_state(20));
    EXPECT_TRUE(link.chip().request_to_send()) << mode;
    link.write(0, 0x31, at_t_state(30));
    EXPECT_EQ(link.chip().counts().unanswered, 2U);
  }
}

TEST(I8251, GapsSlowTheHostDown) {
  SerialHost host;
  host.gap = Duration(1'000'000);
  SerialLink link(three_megahertz, three_bytes, host);
  programme(link);
  EXPECT_EQ(data(link, 3000), 0x41);
  EXPECT_EQ(status(link, 10 + 6125 + 2968), 0x85);
  EXPECT_EQ(status(link, 10 + 6125 + 2969), 0x87);
}

}  // namespace
