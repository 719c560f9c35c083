#include "host/scene/heights/function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sightline::scene {
namespace {

double square(double value) {
  return value * value;
}

double sinc(double x, double z) {
  const double r = std::hypot(x, z);
  return r == 0 ? 1.0 : std::sin(r) / r;
}

double rogers(double x, double z) {
  const double a = square(x - std::numbers::pi) + square(z - std::numbers::pi);
  return 0.2 * std::sin(x) * std::cos(z) - 1.5 * std::cos(7 * a / 4) * std::exp(-a);
}

double peaks(double x, double z) {
  return 3 * square(1 - x) * std::exp(-x * x - square(z + 1)) -
         10 * (x / 5 - x * x * x - z * z * z * z * z) * std::exp(-x * x - z * z) -
         std::exp(-square(x + 1) - z * z) / 3;
}

double franke(double x, double z) {
  return 0.75 * std::exp(-(square(9 * x - 2) + square(9 * z - 2)) / 4) +
         0.75 * std::exp(-square(9 * x + 1) / 49 - (9 * z + 1) / 10) +
         0.5 * std::exp(-(square(9 * x - 7) + square(9 * z - 3)) / 4) -
         0.2 * std::exp(-square(9 * x - 4) - square(9 * z - 7));
}

double saddle(double x, double z) {
  return x * z;
}

double cosine_of_radius(double x, double z) {
  return std::cos(std::hypot(x, z));
}

double step(double x, double z) {
  return x * x + z * z < 1 ? 1.0 : 0.0;
}

double rosenbrock(double x, double z) {
  return std::log(1 + 100 * square(z - x * x) + square(1 - x));
}

double flat(double, double) {
  return 0;
}

double gauss(double x, double z) {
  return std::exp(-(x * x + z * z));
}

constexpr std::array<HeightFunction, 12> functions{{
    {"sinc", {-10, 10}, "sin(r) / r", "the sombrero: rings falling off from a peak", sinc},
    {"rogers",
     {0, 2 * std::numbers::pi},
     "0.2 sin(x) cos(z) - 1.5 cos(7a/4) exp(-a), a = (x-pi)^2 + (z-pi)^2",
     "the floating horizon example of Rogers's textbook",
     rogers},
    {"peaks",
     {-3, 3},
     "3 (1-x)^2 exp(-x^2-(z+1)^2) - 10 (x/5-x^3-z^5) exp(-x^2-z^2) - exp(-(x+1)^2-z^2) / 3",
     "three hills and two hollows",
     peaks},
    {"franke",
     {0, 1},
     "0.75 exp(-((9x-2)^2+(9z-2)^2)/4) + 0.75 exp(-(9x+1)^2/49-(9z+1)/10) + "
     "0.5 exp(-((9x-7)^2+(9z-3)^2)/4) - 0.2 exp(-(9x-4)^2-(9z-7)^2)",
     "Franke's surface of scattered data fitting: two hills, a hollow, a slope",
     franke},
    {"saddle", {-1, 1}, "x z", "the hyperbolic paraboloid", saddle},
    {"cosr", {-12, 12}, "cos(r)", "rings of equal height out to the border", cosine_of_radius},
    {"step", {-2, 2}, "1 if r < 1, else 0", "a round table: a cliff between neighbouring points", step},
    {"rosen",
     {-2, 2},
     "log(1 + 100 (z-x^2)^2 + (1-x)^2)",
     "Rosenbrock's bent valley, flattened by the logarithm",
     rosenbrock},
    {"flat", {-1, 1}, "0", "no height at all", flat},
    {"spike", {-1, 1}, "1 at the middle grid point, else 0", "a needle one sample wide", nullptr},
    {"gauss", {-3, 3}, "exp(-r^2)", "the bell", gauss},
    {"terrain",
     {0, 1},
     "(37 i + 91 j + (i j mod 53)) mod 64 + (40 if i > n/2), i the slice of n, j the point",
     "integer heights without any smoothness, and a cliff",
     nullptr},
}};

double spike(std::size_t point, std::size_t slice, GridSize size) {
  return point == size.points / 2 && slice == size.slices / 2 ? 1.0 : 0.0;
}

double terrain(std::size_t point, std::size_t slice, GridSize size) {
  const std::size_t rough = (37 * slice + 91 * point + slice * point % 53) % 64;
  return static_cast<double>(rough + (slice > size.slices / 2 ? 40 : 0));
}

}  // namespace

std::span<const HeightFunction> height_functions() {
  return functions;
}

std::optional<HeightFunction> height_function(std::string_view name) {
  const auto found = std::find_if(functions.begin(), functions.end(),
                                  [&](const HeightFunction& function) { return function.name == name; });
  if (found == functions.end()) return std::nullopt;
  return *found;
}

std::string height_function_names() {
  std::string names;
  for (const HeightFunction& function : functions)
    names += (names.empty() ? "" : ", ") + std::string(function.name);
  return names;
}

HeightGrid sample(const HeightFunction& function, const HeightDomain& domain, GridSize size) {
  return sample_values(function.value, domain, size);
}

HeightGrid sample(const HeightFunction& function, GridSize size) {
  if (function.value != nullptr) return sample(function, {function.domain, function.domain}, size);
  const auto of_index = function.name == "spike" ? spike : terrain;
  HeightGrid grid{
      even_positions(size.points), even_positions(size.slices), {}, function.domain, function.domain, {}};
  for (std::size_t slice = 0; slice < size.slices; ++slice) {
    for (std::size_t point = 0; point < size.points; ++point)
      grid.heights.push_back(of_index(point, slice, size));
  }
  grid.range = finite_range(grid.heights);
  return grid;
}

}  // namespace sightline::scene
