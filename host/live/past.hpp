// The past of a machine: goes back to any earlier instruction, and answers questions about the past.
//
// It stores snapshots, about a million instructions apart, and the keys that were typed. To answer a question it repeats the run
// from the preceding snapshot, which gives the same instructions at the same times. A run therefore only pays for its snapshots;
// the history and the last writer of a word are computed on request.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/machines/machine.hpp"

namespace sightline::live {

class Past {
 public:
  static constexpr std::size_t most_history = 65536;

  // The machine has a probe and must outlive this object; `name` is that of its description.
  Past(std::string_view name, machines::Machine& machine);

  // The distance between snapshots. To repeat so many instructions takes some milliseconds, with a display some tens.
  [[nodiscard]] std::uint64_t instructions_apart() const;

  // Called at the beginning of a run, and at least every instructions_apart() instructions during it.
  void remember();
  // Called if the machine was changed from outside since the last run: a word deposited, a tape attached.
  void changed() { changed_ = true; }
  // Removes the whole past.
  void forget();

  // The number of instructions that the past reaches back.
  [[nodiscard]] std::uint64_t reach() const;
  // Goes back to the boundary after `instructions` executed instructions, at most reach() before the current one.
  [[nodiscard]] base::Result<base::Done> go_back_to(std::uint64_t instructions);

  // Goes back to the last boundary at which a run with these marks would have stopped. False: there is none, and the machine is at
  // the beginning of the past. nullopt: `interrupted`, which is polled, returned true, and the machine is unchanged.
  [[nodiscard]] base::Result<std::optional<bool>> go_back_to_event(const std::function<void(machines::Probe&)>& mark,
                                                                   const std::function<bool()>& interrupted);

  using Cycle = machines::Probe::Cycle;
  // Goes back to the boundary before the last instruction; returns the cycles of that instruction.
  [[nodiscard]] base::Result<std::vector<Cycle>> go_back_into_instruction();

  using Entry = machines::Probe::Entry;
  // The last `n` instructions, the oldest first; fewer if the past is shorter. This and last_writer() discard output that has been
  // printed and not been taken.
  [[nodiscard]] std::vector<Entry> history(std::size_t n);

  struct Writer {
    machines::Probe::Event event;  // what was written, when, and by what kind of cycle
    std::uint32_t pc = 0;             // of the instruction; for a data break or an interrupt, of the next instruction
  };
  // The last writer of a word of memory; nullopt: nothing has written it, or `interrupted`, which is polled, returned true.
  [[nodiscard]] std::optional<Writer> last_writer(std::uint32_t address, std::size_t pc_register,
                                                  const std::function<bool()>& interrupted);

 private:
  // Two boundaries may follow the same number of instructions, with the cycle of an interrupt between them.
  struct Boundary {
    std::uint64_t instructions;
    std::int64_t ticks = 0;  // at this time or later
  };
  struct Place {
    std::uint64_t instructions;
    std::int64_t ticks;
    std::size_t keys;  // number of keys typed before
    bool changed;      // cannot be reached by a run from the previous place
    machines::Bytes snapshot;
  };

  void thin_out();
  void restore(const Place& place);
  void run_again(Boundary end, const std::function<void()>& at_event = {});
  // Calls `work`, which repeats runs, and then restores the present state.
  template <class Work>
  void look_back(Work work);
  [[nodiscard]] std::size_t segment_of(std::uint64_t instructions) const;
  [[nodiscard]] Boundary here() const { return {machine_.instructions(), machine_.ticks()}; }
  [[nodiscard]] Boundary end_of(std::size_t segment, Boundary here) const;

  std::string_view name_;
  machines::Machine& machine_;
  std::vector<Place> places_;  // in order of instructions
  std::size_t next_key_ = 0;   // of the repeated run
  bool changed_ = true;
};

}  // namespace sightline::live
