// A solid turning on the PDP-7 (host/guests/turn), held at one angle and compared: with its twin word for word, and with the exact
// visible lines at the machine's own angle in points of its display.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "emulators/core/time.hpp"
#include "host/base/result.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

struct TurnCheck {
  std::uint32_t angle = 0;  // of the machine: 2^18 a turn
  std::size_t words = 0;    // of the display file
  core::Duration time{};    // that the machine took for the picture
  std::size_t flashes = 0;  // of its first pass
  picture::HausdorffDistance distance;  // of the flashes and the exact lines, in points of the display
  std::string difference;   // from the twin; empty: identical
};

// The angle of the machine at which a camera in parallel projection sees the scene; nothing for another camera, or one that does not
// look along the plane of the turn.
[[nodiscard]] std::optional<std::uint32_t> turn_angle_of(const scene::PolyCamera& camera);

// Upright, with the EAE, in 8K of core or else in 32K. Errors: those of stand_on_axis, of the events and of
// guests::turn::encode; more edges than fit; the machine made no such picture.
[[nodiscard]] base::Result<TurnCheck> check_turn(const scene::PolyScene& scene, std::uint32_t angle);

}  // namespace sightline::compare
