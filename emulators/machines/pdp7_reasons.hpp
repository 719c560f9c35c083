// Why a run ends behind an instruction that did not just end.
#pragma once

#include "../pdp7/cpu.hpp"
#include "pdp7.hpp"

namespace sightline::pdp7 {

[[nodiscard]] constexpr StopReason reason_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::halted: return StopReason::halt;
    case Outcome::xct_chain: return StopReason::xct_chain;
    default: return StopReason::unanswered;
  }
}

}  // namespace sightline::pdp7
