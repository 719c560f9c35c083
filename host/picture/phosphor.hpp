// A photograph of the P7 screen: what film in front of the tube would show after the shutter was open for a
// while.
//
// Every stroke is a flash of the beam at one point. The blue layer answers within microseconds, the
// yellow-green one glows on for seconds; the film adds up whatever falls on it between the shutter's opening
// and closing, so a stroke before the opening still leaves its afterglow. Light is added up per lattice point
// in whole 2^-32 of a flash: the order of the strokes cannot change a bit. Spot, cascade and halo are spread
// once, when the film is developed. Left out: saturation and burn of the phosphor, grain, geometry errors of
// tube and lens, reflections of the room. Sources: see phosphor_parameters.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "host/picture/image.hpp"
#include "host/picture/phosphor_parameters.hpp"
#include "host/picture/stroke_sinks.hpp"

namespace sightline::picture {

// Light on the film before it answers, in flashes of intensity 7 per area of one lattice point; rows from the
// top.
struct FilmLight {
  int width = 0;
  int height = 0;
  std::vector<float> blue;
  std::vector<float> yellow;
};

// A sink for strokes (emulators/core/stroke.hpp) in any order.
class PhosphorPhotograph {
 public:
  static constexpr bool consumes = true;

  // Strokes after the closing add nothing.
  PhosphorPhotograph(core::Instant shutter_open, core::Instant shutter_close,
                     const PhosphorParameters& parameters = {});

  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& stroke);
  void end_pass(core::Instant) {}
  void expose(std::span<const core::Stroke> strokes) {
    for (const core::Stroke& each : strokes) stroke(each);
  }

  // Without the ambient light. (1024 + 2 margins) * pixels_per_point each way.
  [[nodiscard]] FilmLight light() const;
  // 8-bit sRGB of the same size.
  [[nodiscard]] Image develop() const;

 private:
  enum Layer : std::size_t { blue, yellow, layers };
  using LatticeSums = std::vector<std::uint64_t>;  // 2^-32 flashes; row y * 1024 + x; empty: never lit

  [[nodiscard]] double share_on_film(double share, double tau_seconds, core::Instant flash) const;
  [[nodiscard]] double spot_sigma(int intensity, Layer layer) const;
  [[nodiscard]] std::vector<float> layer_light(Layer layer) const;

  core::Instant shutter_open_;
  core::Instant shutter_close_;
  PhosphorParameters parameters_;
  std::array<double, intensity_levels> luminance_{};
  std::array<std::array<LatticeSums, layers>, intensity_levels> sums_;
};

}  // namespace sightline::picture
