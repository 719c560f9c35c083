#include "host/algorithms/montani_re/stripes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace sightline::algorithms::montani_re {
namespace {

constexpr double fraction = 65536;
constexpr double farthest = 0x1p40;  // abscissas are clamped to this magnitude

// Whether the first of two sides, from `low` to `high`, is to the west.
bool west_of(const StripeSide& a, const StripeSide& b, std::int32_t low, std::int32_t high) {
  return a.at(low) != b.at(low) ? a.at(low) < b.at(low) : a.at(high) < b.at(high);
}

void append_band(std::vector<StripeBand>& bands, StripeBand band) {
  if (band.sides.empty() || band.low >= band.high) return;
  if (!bands.empty() && bands.back().high == band.low && bands.back().sides == band.sides) {
    bands.back().high = band.high;
  } else {
    bands.push_back(std::move(band));
  }
}

// Combines one stripe of two regions.
class StripeCombination {
 public:
  StripeCombination(Operation operation, std::vector<StripeBand>& result)
      : operation_(operation), result_(result) {}

  void run(std::span<const StripeBand> a, std::span<const StripeBand> b) {
    static constexpr std::span<const StripeSide> nothing;
    std::size_t i = 0;
    std::size_t j = 0;
    for (std::int32_t low = 0; low < 16;) {
      while (i < a.size() && a[i].high <= low) ++i;
      while (j < b.size() && b[j].high <= low) ++j;
      const bool in_a = i < a.size() && a[i].low <= low;
      const bool in_b = j < b.size() && b[j].low <= low;
      std::int32_t high = 16;
      if (i < a.size()) high = std::min(high, in_a ? a[i].high : a[i].low);
      if (j < b.size()) high = std::min(high, in_b ? b[j].high : b[j].low);
      append(low, high, in_a ? std::span<const StripeSide>(a[i].sides) : nothing,
             in_b ? std::span<const StripeSide>(b[j].sides) : nothing);
      low = high;
    }
  }

 private:
  struct Member {
    StripeSide side;
    bool of_a = false;
  };

  void append(std::int32_t low, std::int32_t high, std::span<const StripeSide> a,
              std::span<const StripeSide> b) {
    while (low < high) {
      merge(low, high, a, b);
      const std::int32_t end = first_crossing(low, high);
      append_band(result_, {low, end, toggled()});
      low = end;
    }
  }

  void merge(std::int32_t low, std::int32_t high, std::span<const StripeSide> a,
             std::span<const StripeSide> b) {
    row_.clear();
    for (const StripeSide& side : a) row_.push_back({side, true});
    for (const StripeSide& side : b) row_.push_back({side, false});
    std::stable_sort(row_.begin(), row_.end(), [low, high](const Member& p, const Member& q) {
      return west_of(p.side, q.side, low, high);
    });
  }

  // The first sixteenth at or above the lowest crossing, or `high`. Sides are straight, so sides that are in order at
  // both ends are in order between.
  [[nodiscard]] std::int32_t first_crossing(std::int32_t low, std::int32_t high) const {
    if (ordered_at(high - 1)) return high;
    std::int32_t y = low + 1;
    while (ordered_at(y)) ++y;
    return y;
  }
  [[nodiscard]] bool ordered_at(std::int32_t y) const {
    return std::is_sorted(row_.begin(), row_.end(),
                          [y](const Member& p, const Member& q) { return p.side.at(y) < q.side.at(y); });
  }

  [[nodiscard]] std::vector<StripeSide> toggled() const {
    std::vector<StripeSide> sides;
    bool in_a = false;
    bool in_b = false;
    for (std::size_t k = 0; k < row_.size();) {
      const bool before = in_result(operation_, in_a, in_b);
      const StripeSide& side = row_[k].side;
      for (; k < row_.size() && row_[k].side == side; ++k) (row_[k].of_a ? in_a : in_b) ^= true;
      if (in_result(operation_, in_a, in_b) != before) sides.push_back(side);
    }
    return sides;
  }

  Operation operation_;
  std::vector<StripeBand>& result_;
  std::vector<Member> row_;
};

class Filler {
 public:
  Filler(StripeRaster& raster, std::int32_t units) : raster_(raster), units_(units) {}

  void fill(const StripePcs& pcs, std::uint32_t face) {
    const std::int32_t rows_from = std::max(pcs.first * 16 / units_ - 1, 0);
    const std::int32_t end = pcs.first + static_cast<std::int32_t>(pcs.stripes.size());
    const std::int32_t rows_to = std::min(end * 16 / units_ + 1, raster_.height);
    for (std::int32_t row = rows_from; row < rows_to; ++row) {
      const std::int32_t centre = units_ * row + units_ / 2;
      const std::int32_t stripe = centre / 16 - pcs.first;
      if (stripe < 0 || stripe >= static_cast<std::int32_t>(pcs.stripes.size())) continue;
      for (const StripeBand& band : pcs.stripes[static_cast<std::size_t>(stripe)]) {
        if (band.low <= centre % 16 && centre % 16 < band.high) fill(band, row, centre % 16, face);
      }
    }
  }

 private:
  // The first pixel whose centre is not to the west of x.
  static std::int64_t pixel_from(std::int64_t x) {
    constexpr std::int64_t pixel = 16 * 65536;
    const std::int64_t shifted = x - pixel / 2 + pixel - 1;
    return shifted >= 0 ? shifted / pixel : -((pixel - 1 - shifted) / pixel);
  }

  void fill(const StripeBand& band, std::int32_t row, std::int32_t height, std::uint32_t face) {
    for (std::size_t k = 0; k + 1 < band.sides.size(); k += 2) {
      const std::int64_t west = std::max<std::int64_t>(pixel_from(band.sides[k].at(height)), 0);
      const std::int64_t east =
          std::min<std::int64_t>(pixel_from(band.sides[k + 1].at(height)), raster_.width);
      for (std::int64_t x = west; x < east; ++x) {
        raster_.faces[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster_.width) +
                      static_cast<std::size_t>(x)] = face;
      }
    }
  }

  StripeRaster& raster_;
  std::int32_t units_;
};

// Unites the silhouette, which covers the whole frame, with `part`, changing only the stripes of the part.
void grow(StripePcs& silhouette, const StripePcs& part) {
  for (std::size_t k = 0; k < part.stripes.size(); ++k) {
    auto& stripe = silhouette.stripes[static_cast<std::size_t>(part.first) + k];
    std::vector<StripeBand> united;
    StripeCombination(Operation::unite, united).run(stripe, part.stripes[k]);
    stripe = std::move(united);
  }
}

StripeRaster blank(const StripeFrame& frame) {
  StripeRaster raster{frame.width, frame.height, {}, 0, 0};
  raster.faces.assign(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), none);
  return raster;
}

// Ordinates of an edge's ends. An end that is not in front of the eye has none; the edge is then extended along its line.
std::pair<double, std::optional<double>> ends_of(const Image& image, const ImageLine& line) {
  const bool whole = image.weight(line.from) > 0 && image.weight(line.to) > 0;
  if (whole) return {image.ordinate_of(line.from).middle(), image.ordinate_of(line.to).middle()};
  return {image.ordinate_of(image.weight(line.from) > 0 ? line.from : line.to).middle(), std::nullopt};
}

}  // namespace

std::array<double, 2> pixels_per_unit(const scene::PolyCamera& camera, double size) {
  const auto length = [](const scene::PolyPoint& v) {
    const double x = v[0];
    const double y = v[1];
    const double z = v[2];
    return std::sqrt(x * x + y * y + z * z);
  };
  const double focal = camera.perspective ? length(camera.forward) : 1;
  return {size * focal / length(camera.right), size * focal / length(camera.up)};
}

std::uint64_t StripePcs::side_count() const {
  std::uint64_t count = 0;
  for (const auto& stripe : stripes) {
    for (const StripeBand& band : stripe) count += band.sides.size();
  }
  return count;
}

StripePcs stripe_pcs(const Image& image, const TrapezoidPcs& region, const StripeFrame& frame,
                     std::int32_t units) {
  const std::int32_t stripe_count = (frame.height * units + 15) / 16;
  const double stripes_per_pixel = units / 16.0;
  // Lines beyond the frame are moved to just outside it; nothing of them is kept.
  const auto line_at = [&](double y) {
    const double at = std::floor((frame.centre[1] + frame.scale[1] * y) * stripes_per_pixel + 0.5);
    return std::clamp(at, -0x1p30, 0x1p30);
  };
  const auto abscissa = [&](std::uint32_t line, double y) {
    return std::clamp((frame.centre[0] + frame.scale[0] * image.abscissa(line, y)) * fraction, -farthest,
                      farthest);
  };
  const double stripe_height = 1 / (frame.scale[1] * stripes_per_pixel);  // height of a stripe in image units
  StripePcs pcs;
  if (region.empty()) return pcs;
  const auto within = [&](double line) {
    return static_cast<std::int32_t>(std::clamp<double>(line, 0, stripe_count));
  };
  pcs.first = within(line_at(region.bands.front().low.middle()));
  const std::int32_t last = within(line_at(region.bands.back().high.middle()));
  pcs.stripes.resize(static_cast<std::size_t>(last - pcs.first));
  for (const Band& band : region.bands) {
    const double low = line_at(band.low.middle());
    const double high = line_at(band.high.middle());
    for (const Side& side : region.sides_of(band)) {
      // Uses the whole edge between its moved corners, so that the faces on both sides of it agree.
      const auto [y, end] = ends_of(image, image.lines()[side.line]);
      const double from = abscissa(side.line, y);
      const double start = line_at(y);
      const double slope = end ? (abscissa(side.line, *end) - from) / (line_at(*end) - start)
                               : (abscissa(side.line, y + 1) - from) * stripe_height;
      for (std::int32_t k = within(low); k < within(high); ++k) {
        auto& stripe = pcs.stripes[static_cast<std::size_t>(k - pcs.first)];
        if (stripe.empty()) stripe.emplace_back();
        stripe[0].sides.push_back(
            {std::llround(from + slope * (k - start)), std::llround(from + slope * (k + 1 - start))});
      }
    }
  }
  // Sides between moved corners may cross.
  for (auto& stripe : pcs.stripes) {
    std::vector<StripeBand> ordered;
    StripeCombination(Operation::subtract, ordered).run(stripe, {});
    stripe = std::move(ordered);
  }
  return pcs;
}

StripePcs combine(const StripePcs& a, const StripePcs& b, Operation operation) {
  StripePcs result;
  const auto end = [](const StripePcs& p) { return p.first + static_cast<std::int32_t>(p.stripes.size()); };
  const bool only_a = operation == Operation::subtract || b.stripes.empty();
  const bool only_b = !only_a && a.stripes.empty();
  result.first = only_a ? a.first : only_b ? b.first : std::min(a.first, b.first);
  const std::int32_t last = only_a ? end(a) : only_b ? end(b) : std::max(end(a), end(b));
  result.stripes.resize(static_cast<std::size_t>(last - result.first));
  const auto at = [](const StripePcs& p, std::int32_t k) -> std::span<const StripeBand> {
    const std::int32_t index = k - p.first;
    if (index < 0 || index >= static_cast<std::int32_t>(p.stripes.size())) return {};
    return p.stripes[static_cast<std::size_t>(index)];
  };
  for (std::int32_t k = result.first; k < last; ++k) {
    StripeCombination(operation, result.stripes[static_cast<std::size_t>(k - result.first)])
        .run(at(a, k), at(b, k));
  }
  return result;
}

StripePcs for_each_visible(const Image& image, const PriorityList& list, std::span<const TrapezoidPcs> listed,
                           const StripeFrame& frame, std::int32_t units,
                           const std::function<void(const StripePcs&, std::uint32_t)>& take) {
  StripePcs silhouette;
  silhouette.stripes.resize(static_cast<std::size_t>((frame.height * units + 15) / 16));
  for (const PriorityClass& members : list.classes()) {
    for (const std::uint32_t face : members) {
      const StripePcs seen =
          combine(stripe_pcs(image, listed[face], frame, units), silhouette, Operation::subtract);
      take(seen, face);
      grow(silhouette, seen);
    }
  }
  return silhouette;
}

StripeRaster raster_by_difference(const Image& image, const PriorityList& list,
                                  std::span<const TrapezoidPcs> listed, const StripeFrame& frame,
                                  std::int32_t units) {
  StripeRaster raster = blank(frame);
  Filler filler(raster, units);
  const StripePcs silhouette =
      for_each_visible(image, list, listed, frame, units, [&](const StripePcs& seen, std::uint32_t face) {
        filler.fill(seen, face);
        raster.sides += seen.side_count();
      });
  raster.silhouette_sides = silhouette.side_count();
  return raster;
}

}  // namespace sightline::algorithms::montani_re
