// Transcripts of every display mode and of stop, edge, pen and data break, computed by hand: tests/data/type340/modes.txt.
// The last record of a hang is its request: nothing follows it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "tests/emulators/type340/golden_events.hpp"
#include "tests/emulators/type340/replay.hpp"

namespace sightline::type340::testing {
namespace {

[[nodiscard]] std::string listing(std::vector<Event> events) {
  std::ranges::sort(events);
  std::string text;
  for (const Event& e : events) text += std::to_string(e.time) + ' ' + e.text + '\n';
  return text;
}

TEST(DisplayModes, TranscriptsAgree) {
  const EventFiles read = read_event_files(std::filesystem::path(SIGHTLINE_TEST_DATA) / "type340/modes.txt");
  ASSERT_EQ(read.error, "");
  std::set<std::string> ids;
  for (const EventFile& file : read.files) {
    ids.insert(file.id);
    FlashEvents flashes;
    Replay replay(file, &flashes);
    std::vector<Event> found = replay.run(Stepping::ticks);
    std::ranges::copy(flashes.events, std::back_inserter(found));
    EXPECT_EQ(listing(file.events), listing(found)) << file.id;
    EXPECT_EQ(file.final_state, replay.final_state()) << file.id;
  }
  for (std::string name : {"parameter", "point", "slave", "character", "vector", "vector_continue", "increment",
                           "subroutine"}) {
    EXPECT_TRUE(ids.contains(name)) << name << " has no transcript";
  }
}

// Seven words of a Cambridge program: a box open to the left, 534.6 us without wait for a break.
TEST(DisplayModes, WorkedFile) {
  EventFile file;
  file.id = "worked";
  for (const std::uint32_t w : {0020117U, 0220400U, 0100400U, 0200144U, 0236000U, 0600344U, 0003000U}) {
    if (file.segments.empty()) file.segments.emplace_back();
    file.segments[0].emplace_back(w);
  }
  file.events = {{0, "G 0"}, {534'600, "S1"}};
  FlashEvents flashes;
  Replay replay(file, &flashes);
  const std::vector<Event> events = replay.run(Stepping::ticks);
  std::vector<std::int64_t> requests;
  for (const Event& e : events) {
    if (e.text[0] == 'Q') requests.push_back(e.time);
  }
  EXPECT_EQ(requests, (std::vector<std::int64_t>{0, 3300, 7100, 45900, 239'700, 337'500, 531'300}));
  EXPECT_EQ(events.back(), (Event{534'600, "T1"}));
  std::set<std::string> points;
  for (const Event& e : flashes.events) points.insert(e.text);
  EXPECT_EQ(points.size(), 260U);
  EXPECT_FALSE(points.contains("I 256 256 7"));
  EXPECT_TRUE(points.contains("I 356 316 7"));
  EXPECT_EQ(replay.display().counters().words, 7U);
  EXPECT_EQ(replay.display().counters().passes_started, 1U);
  EXPECT_EQ(replay.display().counters().passes_stopped, 1U);
}

// Without the repeated flash of a spot only pulses that move are visible; time and path stay.
TEST(DisplayModes, FlashAgainCanBeSwitchedOff) {
  EventFile file;
  file.id = "once";
  file.segments.push_back({core::Word18(0100117), core::Word18(0600003), core::Word18(0003000)});
  file.events = {{0, "G 0"}, {17'100, "Q 2 003000"}};
  FlashEvents flashes;
  Replay replay(file, &flashes, {.flash_again = false});
  const std::vector<Event> events = replay.run(Stepping::ticks);
  EXPECT_EQ(listing(flashes.events), "9100 I 1 0 7\n12100 I 2 0 7\n15100 I 3 0 7\n");
  EXPECT_TRUE(std::ranges::find(events, Event{17'100, "Q 2 003000"}) != events.end());
}

TEST(EventFileReader, NamesFileLineAndWhatItFound) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "sightline_bad_events.txt";
  const auto error_of = [&](const std::string& text) {
    {
      std::ofstream out(path);
      out << text;
    }
    return read_event_files(path).error;
  };
  const std::string place = path.string() + ":2: found ";
  EXPECT_EQ(error_of("FILE a lat=0\nQ x 0 0 000000\n"), place + "\"Q x 0 0 000000\", expected a record of FORMAT.md");
  EXPECT_EQ(error_of("FILE a lat=0\nW 1 0 000000\n"), place + "\"W 1 0 000000\", expected a record of FORMAT.md");
  EXPECT_EQ(error_of("FILE a lat=0\nW 0 0 009\n"), place + "\"W 0 0 009\", expected a record of FORMAT.md");
  EXPECT_EQ(error_of("FILE a lat=0\nZ\n"), place + "\"Z\", expected a record of FORMAT.md");
  EXPECT_NE(error_of("Q 0 0 0 000000\n"), "");
  EXPECT_EQ(error_of("# nothing\n"), "");
  std::filesystem::remove(path);
  EXPECT_NE(read_event_files(path).error, "");
}

}  // namespace
}  // namespace sightline::type340::testing
