// Spreads the light of lattice points over pixels: Gaussian spots, and the wide halo of the faceplate.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sightline::picture {

// A Gaussian divided into pixels. weights[i] is the part of the light that falls on pixel first + i, where pixel 0 is the
// lattice point's first (left or upper) pixel. The weights add up to 1.
struct SpotProfile {
  int first = 0;
  std::vector<double> weights;
};

// sigma is in points. With two pixels per point, the point's middle is between pixels 0 and 1.
[[nodiscard]] SpotProfile spot_profile(double sigma, int pixels_per_point);

struct FilmSize {
  int pixels_per_point = 1;
  int margin_points = 0;
  [[nodiscard]] int pixels() const;  // along one side
};

// `sums` holds 1024 x 1024 lattice points, row y from the bottom. Adds scale * sum, spread by the profile in both
// directions, to the film (rows from the top), as light per pixel. Light beside the film is lost.
void spread_spots(std::span<const std::uint64_t> sums, double scale, const SpotProfile& profile,
                  FilmSize size, std::vector<float>& film);

// The halo is so wide that it is computed on cells of 4 x 4 points and interpolated between their middles.
class Halo {
 public:
  Halo();
  void add(std::span<const std::uint64_t> sums, double scale);
  // Adds the light, blurred by a Gaussian of `sigma` points, to the film, as light per pixel.
  void spread(double sigma, FilmSize size, std::vector<float>& film) const;

 private:
  std::vector<double> cells_;  // rows from the top
};

}  // namespace sightline::picture
