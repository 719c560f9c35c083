// Times of the Type 340 between one pulse and the next, each with its status.
//
// Source: delay times of the logic drawings as modelled pulse by pulse; the whole-word times they add up to agree with
// every word of 501 display files. A word costs the sum along its path: parameter 3.3 us, point 38.8 us (a dark Y
// word 3.8), vector 2.8 + 1.5 N + 0.5, increment 9.3, character 0.5 + 1.5 for each of its strokes.
#pragma once

#include "emulators/core/time.hpp"

namespace sightline::type340::timing {

inline constexpr core::Duration strobe{2800};       // word at the inputs -> word in BR (confirmed)
inline constexpr core::Duration intensify{500};     // beam on time, spent lit or not -> operate pulse (confirmed)
inline constexpr core::Duration settle{1000};       // step of the beam -> intensify (confirmed)
inline constexpr core::Duration pulse = settle + intensify;
inline constexpr core::Duration load{200};          // coordinate cleared -> coordinate loaded (confirmed)
inline constexpr core::Duration deflection{35000};  // random point -> intensify (confirmed)

}  // namespace sightline::type340::timing
