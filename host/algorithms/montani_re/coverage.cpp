#include "host/algorithms/montani_re/coverage.hpp"

#include <algorithm>

#include "host/geometry/integer.hpp"

namespace sightline::algorithms::montani_re {
namespace {

constexpr std::int64_t pixel = std::int64_t{1} << 20;  // as in StripeSide::at

std::int64_t floor_pixel(std::int64_t x) {
  return x >> 20;
}

// Twice the integral from -infinity to s of the part of a pixel, from 0 on, that is to the west of u.
geometry::Int128 twice_integral(std::int64_t s) {
  if (s <= 0) return 0;
  return s < pixel ? geometry::Int128{s} * s : geometry::Int128{2 * pixel} * s - geometry::Int128{pixel} * pixel;
}

// A side in a part of a row, straight between two abscissas.
struct Crossing {
  std::int64_t low = 0;   // the smaller abscissa
  std::int64_t high = 0;

  Crossing(std::int64_t one, std::int64_t other) : low(std::min(one, other)), high(std::max(one, other)) {}

  // How much of the pixel of a column is to the east of the side: at most `pixel`.
  [[nodiscard]] std::int64_t east_of(std::int64_t column) const {
    const std::int64_t end = (column + 1) * pixel;
    if (low == high || end <= low || end - pixel >= high) return std::clamp<std::int64_t>(end - low, 0, pixel);
    // An abscissa has at most 45 bits, so a product has at most 66.
    return static_cast<std::int64_t>((twice_integral(end - low) - twice_integral(end - high)) / (2 * (high - low)));
  }
};

class Parts {
 public:
  Parts(const StripeFrame& frame, std::int32_t units, const TakePart& take) : frame_(frame), units_(units), take_(take) {}

  void take(const StripePcs& pcs, std::uint32_t face) {
    face_ = face;
    for (std::size_t k = 0; k < pcs.stripes.size(); ++k) {
      const std::int32_t bottom = 16 * (pcs.first + static_cast<std::int32_t>(k));
      for (const StripeBand& band : pcs.stripes[k]) {
        for (std::int32_t from = bottom + band.low; from < bottom + band.high;) {
          const std::int32_t row = from / units_;
          const std::int32_t to = std::min((row + 1) * units_, bottom + band.high);
          if (row < frame_.height) take_row(band, row, from - bottom, to - bottom);
          from = to;
        }
      }
    }
  }

 private:
  void take_row(const StripeBand& band, std::int32_t row, std::int32_t from, std::int32_t to) {
    for (std::size_t k = 0; k + 1 < band.sides.size(); k += 2) {
      const Crossing west(band.sides[k].at(from), band.sides[k].at(to));
      const Crossing east(band.sides[k + 1].at(from), band.sides[k + 1].at(to));
      const std::int64_t first = std::max<std::int64_t>(floor_pixel(west.low), 0);
      const std::int64_t last = std::min<std::int64_t>(floor_pixel(east.high), frame_.width - 1);
      for (std::int64_t column = first; column <= last; ++column) {
        const std::int64_t part = west.east_of(column) - east.east_of(column);
        if (part != 0) take_(face_, static_cast<std::int32_t>(column), row, part * (to - from));
      }
    }
  }

  const StripeFrame& frame_;
  std::int32_t units_;
  const TakePart& take_;
  std::uint32_t face_ = 0;
};

}  // namespace

std::uint64_t coverage_by_difference(const Image& image, const PriorityList& list, std::span<const TrapezoidPcs> listed,
                                     const StripeFrame& frame, std::int32_t units, const TakePart& take) {
  Parts parts(frame, units, take);
  std::uint64_t sides = 0;
  for_each_visible(image, list, listed, frame, units, [&](const StripePcs& seen, std::uint32_t face) {
    parts.take(seen, face);
    sides += seen.side_count();
  });
  return sides;
}

}  // namespace sightline::algorithms::montani_re
