#include "host/picture/phosphor.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host/picture/light_spread.hpp"
#include "host/picture/repeatable_math.hpp"

namespace sightline::picture {

namespace {

constexpr double units_per_flash = 4294967296.0;  // 2^32: a point may flash for an hour before a sum overflows

double seconds(core::Duration duration) {
  return static_cast<double>(duration.count()) * 1e-9;
}

// The film's response to v is v / (1 + v); entry c is the least v that is encoded as sRGB code c or higher.
std::array<double, 256> film_thresholds() {
  std::array<double, 256> thresholds{};
  for (std::size_t code = 1; code < thresholds.size(); ++code) {
    const double answer = srgb_to_linear((static_cast<double>(code) - 0.5) / 255.0);
    thresholds[code] = answer / (1.0 - answer);
  }
  return thresholds;
}

std::uint8_t film_code(const std::array<double, 256>& thresholds, double v) {
  const auto above = std::upper_bound(thresholds.begin() + 1, thresholds.end(), v);
  return static_cast<std::uint8_t>(above - thresholds.begin() - 1);
}

PhosphorParameters within_limits(PhosphorParameters parameters) {
  parameters.pixels_per_point = std::clamp(parameters.pixels_per_point, 1, 2);
  parameters.margin_points = std::clamp(parameters.margin_points, 0, 64);
  return parameters;
}

}  // namespace

PhosphorPhotograph::PhosphorPhotograph(core::Instant shutter_open, core::Instant shutter_close,
                                       const PhosphorParameters& parameters)
    : shutter_open_(shutter_open), shutter_close_(shutter_close), parameters_(within_limits(parameters)) {
  for (std::size_t i = 0; i < luminance_.size(); ++i) {
    const double level = static_cast<double>(i) / (intensity_levels - 1);
    luminance_[i] =
        parameters_.luminance_floor + (1.0 - parameters_.luminance_floor) * level * std::sqrt(level);
  }
}

// The part of a decaying light that is emitted while the shutter is open.
double PhosphorPhotograph::share_on_film(double share, double tau_seconds, core::Instant flash) const {
  if (flash >= shutter_open_) return share * (1.0 - decay(seconds(shutter_close_ - flash) / tau_seconds));
  return share * decay(seconds(shutter_open_ - flash) / tau_seconds) *
         (1.0 - decay(seconds(shutter_close_ - shutter_open_) / tau_seconds));
}

void PhosphorPhotograph::stroke(const core::Stroke& stroke) {
  if (stroke.time >= shutter_close_ || shutter_open_ >= shutter_close_ || !on_screen(stroke)) return;
  std::array<double, layers> shares{};
  shares[blue] = share_on_film(parameters_.blue_share, parameters_.blue_tau_seconds, stroke.time);
  for (const DecayPart& part : parameters_.yellow) {
    shares[yellow] +=
        share_on_film((1.0 - parameters_.blue_share) * part.share, part.tau_seconds, stroke.time);
  }
  const std::size_t point = static_cast<std::size_t>(stroke.y) * screen_points + stroke.x;
  for (std::size_t layer = 0; layer < layers; ++layer) {
    LatticeSums& sums = sums_[stroke.intensity][layer];
    if (sums.empty()) sums.resize(std::size_t{screen_points} * screen_points);
    sums[point] +=
        static_cast<std::uint64_t>(luminance_[stroke.intensity] * shares[layer] * units_per_flash + 0.5);
  }
}

double PhosphorPhotograph::spot_sigma(int intensity, Layer layer) const {
  const double beam = parameters_.spot_sigma_base +
                      parameters_.spot_sigma_growth * static_cast<double>(intensity) / (intensity_levels - 1);
  if (layer == blue) return beam;
  return std::sqrt(beam * beam + parameters_.cascade_sigma * parameters_.cascade_sigma);
}

std::vector<float> PhosphorPhotograph::layer_light(Layer layer) const {
  const FilmSize size{parameters_.pixels_per_point, parameters_.margin_points};
  const auto side = static_cast<std::size_t>(size.pixels());
  std::vector<float> film(side * side);
  // Converts light per pixel to light per area of a point.
  const double area_of_point = parameters_.pixels_per_point * parameters_.pixels_per_point;
  const double scale = area_of_point / units_per_flash;
  Halo halo;
  for (int intensity = 0; intensity < intensity_levels; ++intensity) {
    const LatticeSums& sums = sums_[static_cast<std::size_t>(intensity)][layer];
    if (sums.empty()) continue;
    const auto profile = spot_profile(spot_sigma(intensity, layer), parameters_.pixels_per_point);
    spread_spots(sums, scale * (1.0 - parameters_.halo_share), profile, size, film);
    halo.add(sums, scale * parameters_.halo_share);
  }
  halo.spread(parameters_.halo_sigma, size, film);
  return film;
}

FilmLight PhosphorPhotograph::light() const {
  const int side = FilmSize{parameters_.pixels_per_point, parameters_.margin_points}.pixels();
  return {side, side, layer_light(blue), layer_light(yellow)};
}

Image PhosphorPhotograph::develop() const {
  const FilmLight film = light();
  const auto thresholds = film_thresholds();
  Image image(film.width, film.height, 3);
  for (std::size_t pixel = 0; pixel < film.blue.size(); ++pixel) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double lit = parameters_.blue_colour[channel] * static_cast<double>(film.blue[pixel]) +
                         parameters_.yellow_colour[channel] * static_cast<double>(film.yellow[pixel]);
      image.pixels[pixel * 3 + channel] =
          film_code(thresholds, parameters_.ambient[channel] + parameters_.exposure * lit);
    }
  }
  return image;
}

}  // namespace sightline::picture
