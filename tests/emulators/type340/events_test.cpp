// Every request, flash, flag change and final state of 241 display files, to the nanosecond, in three ways: in small steps of
// time, from deadline to deadline as a machine does, and the latter without a taker of flashes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tests/emulators/type340/golden_events.hpp"
#include "tests/emulators/type340/replay.hpp"

namespace sightline::type340::testing {
namespace {

constexpr std::size_t expected_files = 241;

struct Totals {
  std::size_t files = 0;
  std::size_t events = 0;
};

[[nodiscard]] std::string describe(const std::vector<Event>& events, std::size_t i) {
  return i < events.size() ? std::to_string(events[i].time) + " ns " + events[i].text : "nothing";
}

void expect_equal(const std::string& id, const std::vector<Event>& expected, const std::vector<Event>& found) {
  const auto differ = std::ranges::mismatch(expected, found);
  if (differ.in1 == expected.end() && differ.in2 == found.end()) return;
  const auto i = static_cast<std::size_t>(differ.in1 - expected.begin());
  ADD_FAILURE() << id << ", record " << i << ": expected " << describe(expected, i) << ", found " << describe(found, i);
}

// `run` returns the events of a file; kinds whose first letter is in `unseen` are not compared.
void compare_all(const std::string& unseen, const std::function<std::vector<Event>(const EventFile&)>& run,
                 const std::function<bool(const EventFile&)>& take = [](const EventFile&) { return true; }) {
  Totals totals;
  const auto drop = [&](std::vector<Event>& events) {
    std::erase_if(events, [&](const Event& e) { return unseen.find(e.text[0]) != std::string::npos; });
    std::ranges::sort(events);
  };
  for (const char* name : {"dir", "edge", "inc", "lat", "mix", "pen", "pts", "vcont", "vec"}) {
    const EventFiles read =
        read_event_files(std::filesystem::path(SIGHTLINE_TEST_DATA) / "type340/events" / (std::string(name) + ".txt"));
    ASSERT_EQ(read.error, "");
    totals.files += read.files.size();
    for (const EventFile& file : read.files) {
      if (!take(file)) continue;
      std::vector<Event> expected = file.events;
      std::vector<Event> found = run(file);
      drop(expected);
      drop(found);
      totals.events += expected.size();
      expect_equal(file.id, expected, found);
    }
  }
  EXPECT_EQ(totals.files, expected_files);
  EXPECT_GT(totals.events, 4000U);
}

[[nodiscard]] std::vector<Event> run_watched(const EventFile& file, Stepping stepping) {
  FlashEvents flashes;
  Replay replay(file, &flashes);
  std::vector<Event> found = replay.run(stepping);
  EXPECT_EQ(replay.final_state(), file.final_state) << file.id;
  EXPECT_TRUE(std::ranges::is_sorted(flashes.events, {}, &Event::time)) << file.id;
  found.insert(found.end(), flashes.events.begin(), flashes.events.end());
  return found;
}

TEST(DisplayEvents, AgreeWithTheModelInSmallTicks) {
  compare_all("", [](const EventFile& file) { return run_watched(file, Stepping::ticks); });
}

// FIND is not visible outside the display, so it has no deadline.
TEST(DisplayEvents, AgreeWithTheModelFromDeadlineToDeadline) {
  compare_all("F", [](const EventFile& file) { return run_watched(file, Stepping::deadlines); });
}

TEST(DisplayEvents, AgreeWithTheModelWithoutATaker) {
  compare_all(
      "FI",
      [](const EventFile& file) {
        Replay replay(file, nullptr);
        std::vector<Event> found = replay.run(Stepping::deadlines);
        EXPECT_EQ(replay.final_state(), file.final_state) << file.id;
        return found;
      });
}

}  // namespace
}  // namespace sightline::type340::testing
