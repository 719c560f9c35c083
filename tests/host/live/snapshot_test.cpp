// The file of a snapshot: its errors, the detection of damage, and that a failed restore changes nothing.
#include "host/live/snapshot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "host/base/crc32.hpp"
#include "host/machines/pdp7.hpp"
#include "tests/host/live/small_pdp7.hpp"
#include "tests/support/approve.hpp"
#include "tests/support/effort.hpp"

namespace sightline::test {
namespace {


std::unique_ptr<machines::Machine> small_machine(std::uint64_t steps) {
  auto machine = small_pdp7();
  const machines::Limits limits{steps};
  while (!machine->run(limits, true)) {
  }
  return machine;
}

machines::Bytes save_state(machines::Machine& machine) {
  return live::save_snapshot("pdp7", machine);
}

std::string refusal(const machines::Bytes& bytes, machines::Machine& machine, std::string_view name = "pdp7") {
  const auto done = live::restore_snapshot(name, machine, bytes, "a.snap");
  return done ? "nothing was refused" : done.error().message();
}

// With the correct checksum of the bytes.
machines::Bytes correct_checksum(machines::Bytes bytes) {
  const std::size_t content = bytes.size() - 4;
  const std::uint32_t crc = base::crc32(std::span(bytes).first(content));
  for (std::size_t i = 0; i < 4; ++i) bytes[content + i] = static_cast<std::uint8_t>(crc >> (8 * i));
  return bytes;
}

TEST(Crc32, HasThePublishedCheckValue) {
  const std::string text = "123456789";
  const machines::Bytes bytes(text.begin(), text.end());
  EXPECT_EQ(base::crc32(bytes), 0xCBF43926U);
  EXPECT_EQ(base::crc32({}), 0U);
  // The eight-byte steps and the single ones agree.
  for (std::size_t length = 0; length < 40; ++length) {
    std::uint32_t crc = 0xFFFFFFFFU;
    machines::Bytes more;
    for (std::size_t i = 0; i < length; ++i) {
      more.push_back(static_cast<std::uint8_t>(i * 29 + 7));
      crc ^= more.back();
      for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? 0xEDB88320U ^ (crc >> 1) : crc >> 1;
    }
    ASSERT_EQ(base::crc32(more), ~crc) << length;
  }
}

TEST(Snapshot, ReadsWhatItWrites) {
  const auto machine = small_machine(40);
  const machines::Bytes bytes = save_state(*machine);
  const auto snapshot = live::decode_snapshot(bytes, "a.snap");
  ASSERT_TRUE(snapshot.has_value());
  EXPECT_EQ(snapshot->machine, "pdp7");
  EXPECT_EQ(snapshot->configuration.front(), "--memory 4k");
  EXPECT_EQ(live::encode_snapshot(*snapshot), bytes);
  EXPECT_LT(bytes.size(), 20'000U);
}

// A file of the current version, the same from every compiler, and its state after 500 instructions. Another format needs another
// version
// and another file: SIGHTLINE_APPROVE=1 writes it.
TEST(Snapshot, ReadsAFileOfThisVersion) {
  const std::string name = "snapshot/pdp7-4k.snap";
  const auto machine = small_machine(40);
  const machines::Bytes now = save_state(*machine);
  EXPECT_TRUE(tests::matches_approved({reinterpret_cast<const char*>(now.data()), now.size()}, name));
  const auto file = base::read_file(tests::approved_path(name).string());
  ASSERT_TRUE(file.has_value());
  const auto other = small_machine(3);
  EXPECT_EQ(refusal(*file, *other), "nothing was refused");
  static_cast<void>(other->run({540}, true));
  static_cast<void>(machine->run({540}, true));
  EXPECT_TRUE(save_state(*other) == save_state(*machine));
  EXPECT_EQ(other->ticks(), 1'018'500);
}

TEST(Snapshot, EveryDamagedByteIsFound) {
  const auto machine = small_machine(40);
  const machines::Bytes bytes = save_state(*machine);
  for (std::size_t at = 0; at < bytes.size(); at += tests::effort(1U, 7U)) {
    machines::Bytes damaged = bytes;
    damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ (1U << (at % 8)));
    const auto snapshot = live::decode_snapshot(damaged, "a.snap");
    ASSERT_FALSE(snapshot.has_value()) << at;
    ASSERT_EQ(snapshot.error().file, "a.snap");
    ASSERT_FALSE(snapshot.error().place.empty() || snapshot.error().expected.empty()) << at;
  }
}

TEST(Snapshot, EveryTruncationIsFound) {
  const auto machine = small_machine(40);
  machines::Bytes bytes = save_state(*machine);
  bytes.push_back(0);
  EXPECT_FALSE(live::decode_snapshot(bytes, "a.snap").has_value());
  bytes.pop_back();
  for (std::size_t length = 0; length < bytes.size(); ++length)
    ASSERT_FALSE(live::decode_snapshot(std::span(bytes).first(length), "a.snap").has_value()) << length;
}

// Hostile files have a correct checksum. Either they are rejected and the machine is unchanged, or they are states of a machine.
TEST(Snapshot, ChangedFieldsWithACorrectChecksumAreRejectedOrRun) {
  const auto machine = small_machine(40);
  const auto other = small_machine(17);
  const machines::Bytes bytes = save_state(*machine);
  machines::Bytes before = save_state(*other);
  int refused = 0;
  int accepted = 0;
  // Core is in the middle: any words are valid there.
  for (std::size_t at = 0; at < bytes.size(); at += (at > 1000 && at + 1000 < bytes.size() ? 331U : tests::effort(1U, 3U))) {
    for (const unsigned change : {0x01U, 0x80U, 0xFFU}) {
      machines::Bytes damaged = bytes;
      damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ change);
      if (refusal(correct_checksum(damaged), *other) == "nothing was refused") {
        ++accepted;
        static_cast<void>(other->run({other->instructions() + 50, other->ticks() + 1'000'000}, true));
        before = save_state(*other);
      } else {
        ++refused;
        ASSERT_EQ(save_state(*other), before) << "byte " << at;
      }
    }
  }
  EXPECT_GT(refused, 500);
  EXPECT_GT(accepted, 500);
}

TEST(Snapshot, ErrorsSayWhatToDo) {
  const auto machine = small_machine(40);
  const machines::Bytes bytes = save_state(*machine);
  EXPECT_EQ(refusal({1, 2, 3}, *machine),
            "a.snap: byte 0: found no signature of a snapshot, expected a file that --save has written");
  machines::Bytes changed = bytes;
  changed[8] = 3;
  EXPECT_EQ(refusal(changed, *machine),
            "a.snap: byte 8: found version 3, expected version 6; make the snapshot again with the --save of "
            "this version");
  EXPECT_EQ(
      refusal(bytes, *machine, "i8080"),
      "a.snap: the machine's name: found a snapshot of pdp7, expected one of i8080; use sightline run pdp7");
  auto snapshot = *live::decode_snapshot(bytes, "a.snap");
  snapshot.configuration = {"--memory 8k", "--eae", "--display", "--timing reader_line=1"};
  EXPECT_EQ(refusal(live::encode_snapshot(snapshot), *machine),
            "a.snap: configuration: found a machine with --memory 4k and without --memory 8k --timing "
            "reader_line=1, "
            "expected that of the snapshot; add --memory 8k --timing reader_line=1");
  snapshot = *live::decode_snapshot(bytes, "a.snap");
  snapshot.state.push_back({"rb09", {}});
  EXPECT_EQ(refusal(live::encode_snapshot(snapshot), *machine),
            "a.snap: section \"rb09\": found a section that this machine does not have, expected none of "
            "that name; "
            "make the snapshot again with --save");
  snapshot.state.erase(snapshot.state.begin(), snapshot.state.begin() + 1);
  EXPECT_EQ(refusal(live::encode_snapshot(snapshot), *machine),
            "a.snap: section \"processor\": found no such section, expected one, because this machine has "
            "that part; make "
            "the snapshot again with --save");
}

TEST(Snapshot, AnotherTapeIsAnError) {
  const auto machine = small_machine(40);
  machines::Pdp7Setup setup;
  setup.machine.core_words = 4096;
  setup.display = type340::Options{true, true, true};
  setup.configuration = {"--memory 4k", "--eae"};
  const auto other = machines::make_pdp7(std::move(setup)).value();
  EXPECT_EQ(refusal(save_state(*machine), *other),
            "a.snap: section \"reader\", byte 12, tape: found another input: none, expected 40 bytes with "
            "the CRC-32 "
            "90C54618; name the file that the snapshot was made with");
}

}  // namespace
}  // namespace sightline::test
