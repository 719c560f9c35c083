// The past of a machine: any instruction of it can be gone back to, and asked about.
//
// Kept are snapshots, some million instructions apart, and the keys typed; all else is found by running again from the
// snapshot before it, which gives the same instructions at the same times. So a run pays for its snapshots and for nothing
// else, and the history of the instructions and who wrote a word are worked out when they are asked for.
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

  // The machine has a probe and outlives the past; `name` is that of its description.
  Past(std::string_view name, machines::Machine& machine);

  // How far snapshots lie apart: it runs again in some milliseconds, beside a display, which may be plugged in by the program, in some tens.
  [[nodiscard]] std::uint64_t instructions_apart() const;

  // To be called where a run begins, and at least every instructions_apart() while it lasts.
  void remember();
  // Something that is not the machine's own doing has changed it since the last run: words deposited, a tape put in.
  void changed() { changed_ = true; }
  // Another machine begins here.
  void forget();

  // How many instructions lie between the earliest place that can be gone back to and here.
  [[nodiscard]] std::uint64_t reach() const;
  // To the boundary at which so many instructions had been obeyed; at most reach() before here.
  [[nodiscard]] base::Result<base::Done> go_back_to(std::uint64_t instructions);

  // To the last boundary before here at which a run watched by these marks would have stopped; false: there is none, and the
  // machine is where the past begins.
  // nullopt: `interrupted`, which is asked now and then, said so, and the machine is where it was.
  [[nodiscard]] base::Result<std::optional<bool>> go_back_to_event(const std::function<void(machines::Probe&)>& mark,
                                                                   const std::function<bool()>& interrupted);

  using Cycle = machines::Probe::Cycle;
  // To the boundary before the last instruction; the cycles from there to here.
  [[nodiscard]] base::Result<std::vector<Cycle>> go_back_into_instruction();

  using Entry = machines::Probe::Entry;
  // The last `n` instructions, the oldest first; fewer if the past does not reach so far. Here and for the next: what has been
  // printed is taken before, or it is lost.
  [[nodiscard]] std::vector<Entry> history(std::size_t n);

  struct Writer {
    machines::Probe::Event event;  // what was written, when, and by what kind of cycle
    std::uint32_t pc = 0;             // of the instruction; for a data break or an interrupt, of the one that followed
  };
  // Who last wrote a word of memory. Asked now and then, `interrupted` ends the search: nullopt, as for a word that nothing has
  // written.
  [[nodiscard]] std::optional<Writer> last_writer(std::uint32_t address, std::size_t pc_register,
                                                  const std::function<bool()>& interrupted);

 private:
  // Two boundaries may follow the same number of instructions: the cycle of an interrupt lies between them.
  struct Boundary {
    std::uint64_t instructions;
    std::int64_t ticks = 0;  // not before this
  };
  struct Place {
    std::uint64_t instructions;
    std::int64_t ticks;
    std::size_t keys;  // that had been typed
    bool changed;      // cannot be come to from the place before
    machines::Bytes snapshot;
  };

  void thin_out();
  void restore(const Place& place);
  void run_again(Boundary end, const std::function<void()>& at_event = {});
  // Whatever `work` runs again, the machine is then where it was.
  template <class Work>
  void look_back(Work work);
  [[nodiscard]] std::size_t segment_of(std::uint64_t instructions) const;
  [[nodiscard]] Boundary here() const { return {machine_.instructions(), machine_.ticks()}; }
  [[nodiscard]] Boundary end_of(std::size_t segment, Boundary here) const;

  std::string_view name_;
  machines::Machine& machine_;
  std::vector<Place> places_;  // in order of instructions
  std::size_t next_key_ = 0;   // of a run that is repeated
  bool changed_ = true;
};

}  // namespace sightline::live
