#include "host/algorithms/montani_re/outline.hpp"

#include <bit>
#include <cstring>

namespace sightline::algorithms::montani_re {
namespace {

// Two doubles at a time: every compiler has instructions for this or emulates them.
using Doubles = double __attribute__((vector_size(16)));
using Masks = std::int64_t __attribute__((vector_size(16)));

Doubles load(const double* from) {
  Doubles values;
  std::memcpy(&values, from, sizeof values);
  return values;
}
unsigned bits_of(Masks masks) {
  const auto parts = std::bit_cast<std::array<std::uint64_t, 2>>(masks);
  return static_cast<unsigned>((parts[0] & 1) | (parts[1] & 2));
}

}  // namespace

void OutlineQuad::set_corner(std::size_t k, const Image& image, std::uint32_t vertex) {
  const Vertex& v = image.vertices()[vertex];
  x[k] = static_cast<double>(v.x);
  y[k] = static_cast<double>(v.y);
  weight[k] = static_cast<double>(image.weight(vertex));
}

void OutlineQuad::set_line(std::size_t k, const Image& image, std::uint32_t line, double turned) {
  const auto& coefficients = image.lines()[line].approximate;
  a[k] = turned * coefficients[0];
  b[k] = turned * coefficients[1];
  c[k] = turned * coefficients[2];
  error[k] = image.error_of(line);
}

LineSides sides_of_lines(const OutlineQuad& lines, std::span<const OutlineQuad> corners) {
  LineSides sides;
  for (std::size_t k = 0; k < 4; k += 2) {
    const Doubles a = load(&lines.a[k]);
    const Doubles b = load(&lines.b[k]);
    const Doubles c = load(&lines.c[k]);
    const Doubles error = load(&lines.error[k]);
    Masks any_inside{};
    Masks any_outside{};
    Masks all_outside{-1, -1};
    for (const OutlineQuad& quad : corners) {
      for (std::size_t i = 0; i < 4; ++i) {
        const Doubles at = a * quad.x[i] + b * quad.y[i] + c * quad.weight[i];
        const Masks outside = at < -error;
        any_inside |= at > error;
        any_outside |= outside;
        all_outside &= outside;
      }
    }
    sides.any_inside |= bits_of(any_inside) << k;
    sides.any_outside |= bits_of(any_outside) << k;
    sides.all_outside |= bits_of(all_outside) << k;
  }
  return sides;
}

}  // namespace sightline::algorithms::montani_re
