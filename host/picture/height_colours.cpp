#include "host/picture/height_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sightline::picture {
namespace {

// At equal distances; colours between them are interpolated linearly.
constexpr std::array<Colour, 6> colours{{{50, 38, 116}, {44, 90, 158}, {32, 138, 152}, {72, 180, 112}, {168, 210, 74}, {252, 232, 64}}};

std::uint8_t between(std::uint8_t a, std::uint8_t b, double part) {
  return static_cast<std::uint8_t>(std::floor(a + part * (b - a) + 0.5));
}

}  // namespace

Colour height_colour(double part) {
  const double at = (part > 0 ? std::min(part, 1.0) : 0.0) * (colours.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(at), colours.size() - 2);
  const double rest = at - static_cast<double>(below);
  const Colour a = colours[below];
  const Colour b = colours[below + 1];
  return {between(a.red, b.red, rest), between(a.green, b.green, rest), between(a.blue, b.blue, rest)};
}

Colour height_line_colour(double part) {
  const Colour colour = height_colour(part);
  const auto darker = [](std::uint8_t value) { return static_cast<std::uint8_t>(value * 3 / 4); };
  return {darker(colour.red), darker(colour.green), darker(colour.blue)};
}

}  // namespace sightline::picture
