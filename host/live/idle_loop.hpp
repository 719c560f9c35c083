// Finds out whether a program that asks for a key does nothing but wait for one.
//
// A program that polls may also compute, and then a poll says nothing. But if registers and memory are the same at two
// polls, and nothing has gone out or come in between them, the program has gone round a loop in which nothing happens. It
// stays there until a key comes or something outside the processor changes. A program that takes keys only by interrupt
// does not poll: it is examined instruction by instruction.
//
// A look lasts for some polls, during which the machine runs as usual. While a program computes, looks become rarer, so that
// they take less than a hundredth of the host's time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/machines/machine.hpp"

namespace sightline::live {

class IdleLoop {
 public:
  // In seconds of emulated time. A program that has only waited for so long, while a clock or a display ran, waits in vain.
  // The time begins again if registers or memory have changed since the look before: interrupts may count.
  static constexpr std::int64_t patience = 60;

  // The machine must outlive it.
  explicit IdleLoop(machines::Machine& machine) : machine_(machine) {}

  // Runs on, at most to the limits, if the program asks for a key and a look is due. A stop of the machine, also one at the
  // limits, is passed on.
  [[nodiscard]] std::optional<machines::Stop> look(const machines::Limits& limits);
  // The last look found the loop, and nothing outside is about to change.
  [[nodiscard]] bool idles() const { return result_.found && !machine_.has_deadline(); }
  // Without a key the program will never do anything else: it cannot continue, or it was in the same state a second apart
  // while nothing was about to change. The second is for boards that are busy without telling when they will be ready.
  [[nodiscard]] bool waits_for_ever() const {
    return machine_.waits_for_key() || (machine_.wants_key() && result_.for_ever);
  }
  // It waits for ever, or has only waited for `patience` seconds.
  [[nodiscard]] bool waits_in_vain(std::int64_t seconds = patience) const;
  // The program has got a key, or has printed.
  void forget() {
    look_ = {};
    result_ = {};
    remembered_.valid = false;
    last_look_ = {};
  }

 private:
  // The state at an earlier boundary.
  struct Remembered {
    bool valid = false;
    std::array<std::uint64_t, 2> registers{};
    std::vector<std::byte> memory;
    std::uint64_t traffic = 0;
    std::int64_t time = 0;
    bool deadline = false;
  };
  struct Look {
    static constexpr int shortest = 16;
    bool under_way = false;
    std::int64_t begun = 0;
    bool polled = false;
    bool unchanged = false;  // the state at the end of the last look has come again
    int compared = 0;  // states
    // After so many, twice as many each time, the state of the moment is remembered: so a loop of any length is found
    // (R. P. Brent, "An improved Monte Carlo factorization algorithm", 1980). A loop that was found before is given the time
    // to come to the remembered state again.
    int remember_at = 1;
    int most = shortest;  // states to compare
    std::int64_t next = 0;  // when the next look is due
    std::int64_t gap = 0;   // from the end of one to the next
  };
  // The state at the end of the last look that found the loop.
  struct LastLook {
    std::array<std::uint64_t, 2> registers{};
    std::vector<std::byte> memory;  // empty: there was none
  };
  struct Result {
    bool found = false;
    bool for_ever = false;
    std::int64_t since = 0;
  };

  [[nodiscard]] std::optional<machines::Stop> step(const machines::Limits& limits);
  // Whether the state of this moment is the one remembered.
  [[nodiscard]] bool is_back();
  [[nodiscard]] bool has_same_memory();
  [[nodiscard]] bool is_as_at_last_look() const;
  void remember();
  void end_look(bool found);

  machines::Machine& machine_;
  Remembered remembered_;
  std::size_t different_at_ = 0;  // where memory was different last: a counter is different there again
  LastLook last_look_;
  Look look_;
  Result result_;
};

}  // namespace sightline::live
