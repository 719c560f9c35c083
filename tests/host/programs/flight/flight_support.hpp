// What the tests of both builds of the flight ask: damaged streams are refused, and so are programs with a wrong byte.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/programs/flight/check.hpp"
#include "host/programs/flight/flight.hpp"

namespace sightline::programs::flight {

struct DamagedStreams {
  using Bytes = std::vector<std::uint8_t>;

  bool facing = false;                    // the build
  std::function<Bytes(Precision)> whole;  // the stream that is damaged

  // The program reports the error, and shows only the frames before it.
  Status refused(const Bytes& stream, Precision precision, const std::string& what) const {
    const MachineFlight guest = run_machine(resident_program(facing), stream);
    EXPECT_EQ(difference_from_twin(guest, run_twin(stream, facing)), "") << what;
    EXPECT_NE(guest.status, Status::complete) << what;
    EXPECT_NE(guest.status, Status::running) << what;
    const TwinFlight right = run_twin(whole(precision), facing);
    for (std::size_t i = 0; i < guest.frames.size(); ++i) EXPECT_EQ(guest.frames[i].priorities, right.frames.at(i).priorities) << what;
    return guest.status;
  }

  void every_byte_changed(Precision precision) const {
    const Bytes right = whole(precision);
    for (std::size_t at = 0; at < right.size(); ++at) {
      for (const int change : {0x01, 0x80, 0xFF}) {
        Bytes stream = right;
        stream[at] = static_cast<std::uint8_t>(stream[at] ^ change);
        refused(stream, precision, "byte " + std::to_string(at) + " changed by " + std::to_string(change));
      }
    }
  }

  void every_byte_lost_or_doubled(Precision precision) const {
    const Bytes right = whole(precision);
    for (std::size_t at = 0; at < right.size(); ++at) {
      const auto place = static_cast<std::ptrdiff_t>(at);
      Bytes lost = right;
      lost.erase(lost.begin() + place);
      refused(lost, precision, "byte " + std::to_string(at) + " lost");
      Bytes doubled = right;
      doubled.insert(doubled.begin() + place, right[at]);
      // A superfluous last byte is never read.
      if (at + 1 < right.size() && right[at] != right[at + 1]) refused(doubled, precision, "byte " + std::to_string(at) + " doubled");
    }
  }

  void every_beginning(Precision precision) const {
    const Bytes right = whole(precision);
    for (std::size_t length = 0; length < right.size(); ++length) {
      const Bytes stream(right.begin(), right.begin() + static_cast<std::ptrdiff_t>(length));
      EXPECT_EQ(refused(stream, precision, std::to_string(length) + " bytes"), Status::host_silent);
    }
  }
};

// Programs with one wrong byte, every `step`-th from `first` on: a checked run either fails or has the priorities of the right program.
inline void expect_wrong_programs_fail(const Order& order, std::size_t first, std::size_t step) {
  const auto right = run(order);
  ASSERT_TRUE(right) << right.error().message();
  Program program = resident_program(order.facing);
  int differences = 0;
  for (std::size_t at = first; at < program.memory.size(); at += step) {
    program.memory[at] ^= 1U;
    const auto wrong = run(order, program);
    program.memory[at] ^= 1U;
    if (!wrong) {
      differences += wrong.error().kind == base::ErrorKind::differs ? 1 : 0;
      continue;
    }
    ASSERT_EQ(wrong->flight.frames.size(), right->flight.frames.size()) << "byte " << at;
    for (std::size_t i = 0; i < right->flight.frames.size(); ++i)
      EXPECT_EQ(wrong->flight.frames[i].priorities, right->flight.frames[i].priorities) << "byte " << at << ", frame " << i;
  }
  EXPECT_GT(differences, 0);
}

}  // namespace sightline::programs::flight
