// Intel HEX and raw bytes: records from Intel's description, round trips, and every error.
#include "tools/image/intel_hex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace sightline::image {
namespace {

std::string read_error(std::string_view text) {
  const auto read = read_intel_hex(text, "f.hex");
  return read ? "no error" : read.error().message(base::MessageStyle::compiler);
}

ByteImage image_of(std::uint16_t address, const std::vector<std::uint8_t>& bytes) {
  ByteImage image;
  for (const std::uint8_t byte : bytes) image.put(address++, byte);
  return image;
}

// Sixteen bytes at 0100; the checksum 40 was computed by hand.
constexpr std::string_view known_record = ":10010000214601360121470136007EFE09D2190140\n";

std::string known_file(std::string_view end) {
  std::string text;
  text.append(known_record).append(end);
  return text;
}

TEST(IntelHex, KnownRecord) {
  const auto read = read_intel_hex(known_file(":00000001FF\n"), "f.hex");
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value().lowest(), 0x0100);
  EXPECT_EQ(read.value().highest(), 0x010F);
  EXPECT_EQ(read.value()[0x0101], 0x46);
  EXPECT_EQ(read.value().start, std::nullopt);
  EXPECT_EQ(write_intel_hex(read.value()), known_file(":00000001FF\n"));
}

TEST(IntelHex, StartAddressIsInTheEndRecord) {
  ByteImage image = image_of(0x0100, {0xC9});
  image.start = 0x0100;
  EXPECT_EQ(write_intel_hex(image), ":01010000C935\n:00010001FE\n");
  EXPECT_EQ(read_intel_hex(write_intel_hex(image), "f").value(), image);
}

TEST(IntelHex, RunsAndRecordsOfSixteen) {
  ByteImage image = image_of(0x0200, std::vector<std::uint8_t>(17, 1));
  image.put(0xFFFF, 7);
  const std::string text = write_intel_hex(image);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  EXPECT_NE(text.find(":01021000"), std::string::npos);
  EXPECT_NE(text.find(":01FFFF0007FA"), std::string::npos);
}

TEST(IntelHex, RandomImagesComeBack) {
  std::mt19937 random(8080);
  for (int round = 0; round < 20; ++round) {
    ByteImage image;
    for (int i = 0; i < 3000; ++i)
      image.put(static_cast<std::uint16_t>(random()), static_cast<std::uint8_t>(random()));
    image.start = static_cast<std::uint16_t>(random() | 1U);
    const auto read = read_intel_hex(write_intel_hex(image), "f");
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value(), image);
  }
}

TEST(IntelHex, AcceptedVariants) {
  for (const char* text :
       {":01000000AA55\r\n:00000001FF\r\n", ":01000000aa55\n\n:00000001ff",
        ":01000000AA55\n:0000000000\n\x1A\x1A", ":020000020000FC\n:01000000AA55\n:00000001FF",
        ":020000040000FA\n:01000000AA55\n:00000001FF",
        ":0400000300000000F9\n:01000000AA55\n:01000000AA55\n:00000001FF\n \n"}) {
    const auto read = read_intel_hex(text, "f");
    ASSERT_TRUE(read) << text << read.error().message(base::MessageStyle::compiler);
    EXPECT_EQ(read.value().count(), 1U) << text;
    EXPECT_EQ(read.value()[0], 0xAA) << text;
  }
}

TEST(IntelHex, Errors) {
  EXPECT_EQ(read_error(""),
            "f.hex:1:1: error: found the end of the file, expected an end record, :00000001FF");
  EXPECT_EQ(read_error(":01000000AA55\n"),
            "f.hex:1:1: error: found the end of the file, expected an end record, :00000001FF");
  EXPECT_EQ(read_error("hello"), "f.hex:1:1: error: found 'h', expected ':' at the start of a record");
  EXPECT_EQ(read_error("\n:01000000AA56"), "f.hex:2:12: error: found checksum 56, expected 55");
  EXPECT_EQ(read_error(":0100000ZAA55"), "f.hex:1:9: error: found 'Z', expected a hexadecimal digit");
  EXPECT_EQ(read_error(":01000000AA5"),
            "f.hex:1:12: error: found half a byte at the end of the line, expected two digits");
  EXPECT_EQ(read_error(":02000000AA54"),
            "f.hex:1:2: error: found 6 bytes in the record, expected 7 as its length 02 says");
  EXPECT_EQ(
      read_error(":0000"),
      "f.hex:1:1: error: found a record of 2 bytes, expected at least 5: length, address, type, checksum");
  EXPECT_EQ(read_error(":00000006FA"),
            "f.hex:1:8: error: found record type 06, expected 00 data, 01 end, or 02 to 05");
  EXPECT_EQ(read_error(":02FFFF00010200FD").substr(0, 9), "f.hex:1:2");
  EXPECT_EQ(read_error(":02FFFF000102FD"),
            "f.hex:1:4: error: found 2 bytes from FFFF, expected none past FFFF: an 8080 has 64K");
  EXPECT_EQ(read_error(":020000040001F9"),
            "f.hex:1:10: error: found base address 00010000, expected one below 10000: an 8080 has 64K");
  EXPECT_EQ(read_error(":020000021000EC"),
            "f.hex:1:10: error: found base address 00010000, expected one below 10000: an 8080 has 64K");
  EXPECT_EQ(read_error(":0400000500010000F6"),
            "f.hex:1:10: error: found a start address above FFFF, expected one within the 64K of an 8080");
  EXPECT_EQ(read_error(":00000001FF\n:01000000AA55"),
            "f.hex:2:1: error: found ':' after the end record, expected the end of the file");
  EXPECT_EQ(read_error(":01000001AA54"), "f.hex:1:2: error: found data in an end record, expected length 00");
}

// LOAD and a paper tape loader store each byte as they read it.
TEST(IntelHex, OverlappingRecordsAreStoredInTheirOrder) {
  std::vector<std::string> warnings;
  const auto read = read_intel_hex(":030100003E017647\n:0101010002FB\n:00000001FF\n", "overlap.hex", &warnings);
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value()[0x100], 0x3E);
  EXPECT_EQ(read.value()[0x101], 0x02);
  EXPECT_EQ(read.value()[0x102], 0x76);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0],
            "overlap.hex:2:10: found byte 02 for address 0101, expected 01 as in an earlier record: this address has the byte of the "
            "later record, as after a loader");
  const auto twice = read_intel_hex(":02000000AABB99\n:02000000BBCC77\n:00000001FF\n", "f", &warnings);
  ASSERT_TRUE(twice);
  EXPECT_EQ(twice.value()[1], 0xCC);
  ASSERT_EQ(warnings.size(), 1U) << "one line for a file";
  EXPECT_NE(warnings[0].find("2 addresses have"), std::string::npos) << warnings[0];
}

TEST(IntelHex, EverySingleDamageIsDetected) {
  const std::string good = known_file(":00010001FE\n");
  const auto whole = read_intel_hex(good, "f").value();
  for (std::size_t i = 0; i < good.size() - 1; ++i) {
    for (const char c : {'0', 'F', 'x', '\n'}) {
      std::string damaged = good;
      damaged[i] = c;
      const auto read = read_intel_hex(damaged, "f");
      EXPECT_FALSE(read && !(read.value() == whole)) << damaged;
    }
    const auto cut = read_intel_hex(good.substr(0, i), "f");
    EXPECT_FALSE(cut) << i;
  }
}

TEST(Binary, ReadAndWritten) {
  const std::vector<std::uint8_t> bytes{1, 2, 3};
  const auto raw = read_binary(bytes, "f.bin", 0xFFFD);
  ASSERT_TRUE(raw);
  EXPECT_EQ(raw.value().lowest(), 0xFFFD);
  EXPECT_EQ(write_binary(raw.value(), "f").value(), bytes);
  EXPECT_EQ(read_binary(bytes, "f.bin", 0xFFFE).error().found, "3 bytes");
  EXPECT_FALSE(read_binary({}, "f.bin", 0));
  const auto com = read_com(bytes, "f.com");
  ASSERT_TRUE(com);
  EXPECT_EQ(com.value().lowest(), 0x0100);
  EXPECT_EQ(com.value().start, 0x0100);
  EXPECT_EQ(write_com(com.value(), "f").value(), bytes);
  EXPECT_TRUE(read_com(std::vector<std::uint8_t>(0xFF00), "f"));
  EXPECT_EQ(
      read_com(std::vector<std::uint8_t>(0xFF01), "f.com").error().message(base::MessageStyle::compiler),
      "f.com: error: found 65281 bytes, expected at most 65280 from address 0100 to FFFF");
}

TEST(Binary, ComStartsAt0100) {
  EXPECT_EQ(write_com(image_of(0x0102, {5}), "f").value(), (std::vector<std::uint8_t>{0, 0, 5}));
  EXPECT_EQ(write_com(image_of(0x00FF, {5}), "f.com").error().message(base::MessageStyle::compiler),
            "f.com: error: found a byte at 00FF, expected a .com program from 0100 up");
  ByteImage elsewhere = image_of(0x0100, {5});
  elsewhere.start = 0x0200;
  EXPECT_FALSE(write_com(elsewhere, "f.com"));
  EXPECT_FALSE(write_com(ByteImage(), "f.com"));
  EXPECT_FALSE(write_binary(ByteImage(), "f.bin"));
  EXPECT_EQ(write_binary(image_of(0x0010, {5, 6}), "f").value(), (std::vector<std::uint8_t>{5, 6}));
}

}  // namespace
}  // namespace sightline::image
