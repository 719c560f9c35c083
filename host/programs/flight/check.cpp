#include "host/programs/flight/check.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace sightline::programs::flight {

std::string first_wrong_frame(const MachineFlight& machine, const TwinFlight& twin) {
  for (std::size_t frame = 0; frame < std::min(machine.frames.size(), twin.frames.size()); ++frame) {
    const Priorities& here = machine.frames[frame].priorities;
    const Priorities& there = twin.frames[frame].priorities;
    const auto [at, other] = std::mismatch(here.begin(), here.end(), there.begin());
    if (at != here.end())
      return fmt::format("frame {}: piece {} has the priority {}, the twin's {}", frame, at - here.begin(), *at, *other);
    const MachineFrame& made = machine.frames[frame];
    const TwinFrame& wanted = twin.frames[frame];
    if (made.listed != wanted.listed || made.turned != wanted.turned)
      return fmt::format("frame {}: {} pieces in the order, {} appeared, {} vanished, the twin's {}, {} and {}", frame, made.listed, made.turned.appeared,
                         made.turned.vanished, wanted.listed, wanted.turned.appeared, wanted.turned.vanished);
    if (made.moved != wanted.moved || made.exchanges != wanted.exchanges)
      return fmt::format("frame {}: {} pieces moved and {} pairs exchanged, the twin's {} and {}", frame, made.moved, made.exchanges,
                         wanted.moved, wanted.exchanges);
  }
  return "";
}

std::string difference_from_twin(const MachineFlight& machine, const TwinFlight& twin) {
  if (std::string wrong = first_wrong_frame(machine, twin); !wrong.empty()) return wrong;
  if (machine.frames.size() != twin.frames.size())
    return fmt::format("{} frames, the twin's {}", machine.frames.size(), twin.frames.size());
  if (machine.status != twin.status) return fmt::format("status \"{}\", the twin's \"{}\"", text_of(machine.status), text_of(twin.status));
  if (!machine.ended) return "the program did not end";
  if (machine.writes_lost + machine.unanswered > 0)
    return fmt::format("{} writes to the display lost, {} accesses unanswered", machine.writes_lost, machine.unanswered);
  return "";
}

}  // namespace sightline::programs::flight
