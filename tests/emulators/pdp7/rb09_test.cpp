// The RB09 alone: every IOT pulse, addresses, when words pass, and each error. The numbers follow from 80 sectors of 64 words
// per revolution; one word takes 1,000 ns here.
#include "emulators/pdp7/rb09.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace sightline {
namespace {

using core::at_nanoseconds;
using core::Word18;
namespace status = pdp7::rb09::status;

constexpr std::uint32_t dbcf = 0707101, dbsf = 0707121, dbcs = 0707141, dbrd = 0707102, dbrs = 0707122, dblm = 0707142,
                        dbld = 0707104, dblw = 0707124, dbls = 0707144;
constexpr std::int64_t turn = 5120 * 1000;

// Each word of the disk is its own address, truncated to 18 bits.
std::vector<Word18> numbered_words() {
  std::vector<Word18> words;
  for (std::uint32_t n = 0; n < 1024000; ++n) words.emplace_back(n & 0777777U);
  return words;
}

class Rb09 : public testing::Test {
 protected:
  std::uint32_t iot(std::int64_t ns, std::uint32_t word, std::uint32_t ac = 0) {
    last_ = {Word18(ac)};
    disk_->iot(at_nanoseconds(ns), word, last_);
    return last_.ac.value();
  }
  bool skips() {
    iot(0, dbsf);
    return last_.skip;
  }
  std::uint32_t state() { return iot(0, dbrs); }
  // Starts a transfer of `count` words at core address `core`; the disk address is in BCD.
  void begin(std::int64_t ns, std::uint32_t bcd, std::uint32_t core, std::uint32_t count, std::uint32_t command) {
    iot(ns, dbcs);
    iot(ns, dbld, bcd);
    iot(ns, dblm, core);
    iot(ns, dblw, (0200000 - count) & 0177777);
    iot(ns, dbls, command);
  }
  const core::DataBreak* break_at(core::Instant now) {
    disk_->advance(now);
    return disk_->data_break();
  }
  // Grants each break as soon as it is requested; returns the words that went to core, by address.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> serve(std::int64_t late = 0, std::uint32_t from_core = 0) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> words;
    while (disk_->deadline() != core::never && words.size() < 70000) {
      const core::Instant now = disk_->deadline() + core::Duration(late);
      const core::DataBreak* const request = break_at(now);
      if (request == nullptr) break;
      words.emplace_back(request->address, request->word.value());
      disk_->end_break(now + pdp7::machine_cycle, Word18(from_core++));
    }
    return words;
  }

  static std::unique_ptr<pdp7::Rb09> made(const pdp7::rb09::Choices& choices) {
    auto disk = std::make_unique<pdp7::Rb09>(choices);
    disk->attach(numbered_words(), 0);
    return disk;
  }

  std::unique_ptr<pdp7::Rb09> disk_ = made({.word = core::Duration(1000)});
  core::IotReply last_;
};

TEST_F(Rb09, AddressesAreBcd) {
  // Every track and sector, and the address that is read back.
  for (std::uint32_t track = 0; track < 200; ++track) {
    for (std::uint32_t sector = 0; sector < 80; ++sector) {
      const std::uint32_t bcd =
          (track / 100) << 16 | (track / 10 % 10) << 12 | (track % 10) << 8 | (sector / 10) << 4 | sector % 10;
      ASSERT_EQ(pdp7::rb09::address_of_bcd(bcd), (track * 80 + sector) * 64);
      ASSERT_EQ(pdp7::rb09::bcd_of_address((track * 80 + sector) * 64 + 63), bcd);
    }
  }
  iot(0, dbld, 0300000);  // the boot program's track
  EXPECT_EQ(disk_->address(), 180U * 80 * 64);
  // AC bit 0 is not part of the address.
  iot(0, dbld, 0700001);
  EXPECT_EQ(disk_->address(), (180U * 80 + 1) * 64);
  EXPECT_EQ(state(), 0U);
}

TEST_F(Rb09, ADigitAboveNineOrASectorAboveSeventyNineIsIllegal) {
  iot(0, dbld, 0x105);
  for (const std::uint32_t bad : {0xA00U, 0xA000U, 0x80U, 0x0AU, 0xF0U, 0x7FU}) {
    iot(0, dbcf);
    iot(0, dbld, bad);
    EXPECT_EQ(state(), status::error | status::illegal) << std::hex << bad;
    EXPECT_TRUE(skips());
    EXPECT_EQ(iot(0, dbrd), 0x105U);
  }
}

TEST_F(Rb09, ReadsWhenTheWordPassesNext) {
  // Sector 1 of track 2 passes at word 64 of each revolution; at 100,000 ns it has passed in this revolution.
  begin(100'000, 0x201, 0500, 3, status::busy);
  EXPECT_EQ(state(), status::busy);
  EXPECT_EQ(disk_->deadline(), at_nanoseconds(turn + 64'000));
  EXPECT_EQ(break_at(at_nanoseconds(turn + 63'999)), nullptr);
  const std::uint32_t first = (2 * 80 + 1) * 64;
  const auto words = serve();
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> expected{
      {0500, first & 0777777}, {0501, (first + 1) & 0777777}, {0502, (first + 2) & 0777777}};
  EXPECT_EQ(words, expected);
  EXPECT_EQ(state(), status::done);
  EXPECT_TRUE(skips());
  EXPECT_EQ(disk_->deadline(), core::never);
  iot(0, dbcf);
  EXPECT_FALSE(skips());
}

TEST_F(Rb09, ContinuesAcrossSectorsTracksAndTheEndOfTheDisk) {
  begin(0, 0x1'99'79, 07776, 130, status::busy);
  const auto words = serve();
  ASSERT_EQ(words.size(), 130U);
  EXPECT_EQ(words[63].second, 1023999U & 0777777);
  EXPECT_EQ(words[64], (std::pair<std::uint32_t, std::uint32_t>{010076, 0}));
  EXPECT_EQ(words[129].second, 65U);
  // The address is where the transfer ended: sector 1 of track 0.
  EXPECT_EQ(iot(0, dbrd), 1U);
}

// Where the documents are silent: the non-default choices.
TEST_F(Rb09, ObeysItsChoices) {
  disk_ = made({.word = core::Duration(1000), .clear_stops = false});
  begin(0, 0, 0100, 3, status::busy);
  iot(1, dbcs);
  EXPECT_EQ(serve().size(), 3U);

  disk_ = made({.word = core::Duration(1000), .late_stops = false});
  begin(0, 0, 0100, 3, status::busy);
  EXPECT_EQ(serve(1001).size(), 3U);
  EXPECT_EQ(state(), status::error | status::timing | status::done);
  EXPECT_EQ(disk_->counters().timing_errors, 3U);

  disk_ = made({.word = core::Duration(1000), .after_last = 64});
  begin(0, 0x1'99'79, 0100, 65, status::busy);
  EXPECT_EQ(serve()[64].second, 64U);
}

TEST_F(Rb09, TheCoreAddressWraps) {
  begin(0, 0, 017777, 2, status::busy);
  EXPECT_EQ(serve()[1].first, 0U);
  pdp7::Rb09 extended{pdp7::rb09::Choices{.word = core::Duration(1000)}, pdp7::address_mask};
  core::IotReply reply{Word18(0757777)};
  extended.iot(at_nanoseconds(0), dblm, reply);
  EXPECT_EQ(extended.core_address(), 057777U);
}

TEST_F(Rb09, AWordCountOfZeroIsTheMaximum) {
  begin(0, 0, 0, 0, status::busy);
  EXPECT_EQ(serve().size(), 65536U);
}

TEST_F(Rb09, WritesAreKeptApartFromTheImage) {
  EXPECT_FALSE(disk_->changed());
  begin(0, 0x100, 0, 2, status::busy | status::write);
  EXPECT_EQ(break_at(disk_->deadline())->direction, core::DataBreak::Direction::from_core);
  static_cast<void>(serve(0, 0123));
  EXPECT_EQ(state(), status::done | status::write);
  EXPECT_EQ(disk_->word(5120).value(), 0123U);
  EXPECT_EQ(disk_->word(5121).value(), 0124U);
  EXPECT_EQ(disk_->word(5122).value(), 5122U);
  EXPECT_TRUE(disk_->changed());
  begin(0, 0x100, 0, 3, status::busy);
  EXPECT_EQ(serve()[1].second, 0124U);
  EXPECT_EQ(disk_->counters().words_written, 2U);
  EXPECT_EQ(disk_->counters().words_read, 3U);
}

TEST_F(Rb09, ALockedTrackCannotBeWritten) {
  disk_->attach(numbered_words(), 1U << 3);  // tracks 30 to 39
  begin(0, 0x2979, 0, 66, status::busy | status::write);
  EXPECT_EQ(serve().size(), 64U);
  EXPECT_EQ(state(), status::error | status::illegal | status::done | status::write);
  EXPECT_EQ(disk_->word(30 * 5120).value(), 30U * 5120);
  begin(0, 0x3000, 0, 1, status::busy);
  EXPECT_EQ(serve().size(), 1U);
}

TEST_F(Rb09, ABreakThatComesAfterTheNextWordIsATimingError) {
  begin(0, 0, 0, 10, status::busy);
  EXPECT_EQ(serve(1000).size(), 10U);
  begin(0, 0, 0, 10, status::busy);
  EXPECT_EQ(serve(1001).size(), 0U);
  EXPECT_EQ(state(), status::error | status::timing);
  EXPECT_EQ(disk_->counters().timing_errors, 1U);
  EXPECT_EQ(disk_->deadline(), core::never);
}

TEST_F(Rb09, StatusTogglesThreeBitsAndTakesTheOthers) {
  iot(0, dbls, status::interrupts | status::write);
  EXPECT_EQ(state(), status::interrupts | status::write);
  iot(0, dbls, status::write | status::done);
  EXPECT_EQ(state(), status::interrupts | status::done);
  EXPECT_TRUE(disk_->interrupt_request());
  iot(0, dbls, status::interrupts | 0777);
  EXPECT_EQ(state(), 0U);
  EXPECT_FALSE(disk_->interrupt_request());
  // Setting busy starts a transfer, clearing it ends one.
  iot(0, dbls, status::busy);
  EXPECT_NE(disk_->deadline(), core::never);
  iot(0, dbls, status::busy);
  EXPECT_EQ(disk_->deadline(), core::never);
  EXPECT_EQ(state(), 0U);
}

TEST_F(Rb09, InterruptsAreDoneOrAnErrorWhileEnabled) {
  begin(0, 0, 0, 1, status::busy | status::interrupts);
  EXPECT_FALSE(disk_->interrupt_request());
  static_cast<void>(serve());
  EXPECT_TRUE(disk_->interrupt_request());
  iot(0, dbcf);
  EXPECT_FALSE(disk_->interrupt_request());
  iot(0, dbld, 0xF);
  EXPECT_TRUE(disk_->interrupt_request());
}

TEST_F(Rb09, WithoutADiskItIsNotReady) {
  disk_->detach();
  begin(0, 0, 0, 1, status::busy);
  EXPECT_EQ(state(), status::error | status::not_ready | status::done);
  EXPECT_EQ(disk_->deadline(), core::never);
}

TEST_F(Rb09, PulsesOfOneCodeActInOrder) {
  // DBSF and DBRS: the skip before the read; DBCF and DBRD.
  iot(0, dbls, status::done);
  EXPECT_EQ(iot(0, dbsf | 2U), status::done);
  EXPECT_TRUE(last_.skip);
  EXPECT_EQ(last_.answered, 3U);
  // Subdevice 060 is unused.
  iot(0, 0707161);
  EXPECT_EQ(last_.answered, 0U);
}

}  // namespace
}  // namespace sightline
