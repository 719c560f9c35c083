// A photograph of the P7 screen: what film in front of the tube shows after an exposure.
//
// Every stroke is a flash of the beam at one point. The blue layer responds within microseconds, the yellow-green layer
// glows for seconds. The film adds up the light between the opening and the closing of the shutter, so a stroke before
// the opening still leaves its afterglow. Light is added per lattice point in whole 2^-32 of a flash, so the order of the
// strokes does not change any bit. Spot, cascade and halo are computed once, when the film is developed. Not modelled:
// saturation and burn of the phosphor, grain, geometric errors of tube and lens, reflections of the room. Sources: see
// phosphor_parameters.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "host/picture/image.hpp"
#include "host/picture/stroke_recorders.hpp"

namespace sightline::picture {

// All parameters of the P7 photograph's appearance.
//
// Known: a spot of about 0.015 in on a lattice of 0.00916 in (Type 30 manual, DEC-340 manual); the P7 screen is a cascade
// of two layers, a blue-white flash (10 % after 25-75 us) over a yellow-green layer excited by it (10 % after 0.4 s, then
// a power-law tail; RCA TPM-1508A). Chosen by eye, because no measurements are known: the intensity curve, the split of
// the light between the layers, colours, halo, face and exposure.

using LinearColour = std::array<double, 3>;  // linear light, sRGB primaries

// Light that decays as e^(-t/tau), as a part of all the light that its layer emits after one flash.
struct DecayPart {
  double share;  // of the layer's light; the shares of a layer add up to 1
  double tau_seconds;
};

struct PhosphorParameters {
  int pixels_per_point = 1;  // 1 or 2
  int margin_points = 24;    // glass around the lattice, 0..64 points

  // Light of one flash of intensity i, relative to intensity 7: floor + (1 - floor) * (i/7)^1.5.
  double luminance_floor = 0.15;
  // Spot of intensity i: a Gaussian, sigma = base + growth * i/7, in points.
  double spot_sigma_base = 0.60;
  double spot_sigma_growth = 0.20;
  // Further blur of the yellow layer, which the blue one excites; added in squares, in points.
  double cascade_sigma = 1.9;

  double blue_share = 0.25;  // of a flash's light; the rest is yellow-green
  double blue_tau_seconds = 20e-6;
  // 0.29 e^(-t/0.04) + 0.48 e^(-t/0.16) + 0.06 e^(-t/2.4) is within 25 % of 1/(1 + t/0.0444 s) from 0 to 6 s; each part's
  // share of the light is its amplitude times its tau.
  std::array<DecayPart, 3> yellow{{{0.0116 / 0.2324, 0.04}, {0.0768 / 0.2324, 0.16}, {0.144 / 0.2324, 2.4}}};

  LinearColour blue_colour{0.10, 0.22, 1.0};
  LinearColour yellow_colour{0.55, 0.80, 0.10};

  // The part of every spot that is scattered in the faceplate, as a wide Gaussian.
  double halo_share = 0.03;
  double halo_sigma = 12.0;  // points

  LinearColour ambient{0.011, 0.017, 0.012};  // the unlit face, dark green-grey
  // The exposure that one full flash, spread over the area of one lattice point, adds to the film, whose response is then
  // v / (1 + v). Chosen for a line drawing refreshed 40 times a second with an exposure of 0.2 s.
  double exposure = 3.5;
};

// Light on the film before its response, in flashes of intensity 7 per area of one lattice point; rows from the top.
struct FilmLight {
  int width = 0;
  int height = 0;
  std::vector<float> blue;
  std::vector<float> yellow;
};

// Accepts strokes in any order.
class PhosphorPhotograph {
 public:
  // Strokes after the closing add nothing.
  PhosphorPhotograph(core::Instant shutter_open, core::Instant shutter_close,
                     const PhosphorParameters& parameters = {});

  void stroke(const core::Stroke& stroke);
  void expose(std::span<const core::Stroke> strokes) {
    for (const core::Stroke& each : strokes) stroke(each);
  }

  // Without ambient light. Each side has (1024 + 2 margins) * pixels_per_point pixels.
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
