#include "host/algorithms/montani_re/region_boundary.hpp"

#include <algorithm>
#include <cstddef>

#include "host/algorithms/montani_re/boundary_trace.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using Coefficient = Image::Coefficient;

// Maps directions to numbers that grow counterclockwise: east, upwards by slope, west, downwards by slope.
class Headings {
 public:
  Headings(const Image& image, const TrapezoidPcs& region) : image_(image) {
    for (const Side& side : region.sides) lines_.push_back(side.line);
    std::sort(lines_.begin(), lines_.end());
    lines_.erase(std::unique(lines_.begin(), lines_.end()), lines_.end());
    std::sort(lines_.begin(), lines_.end(),
              [this](std::uint32_t a, std::uint32_t b) { return leaning(a, b) > 0; });
    std::uint32_t highest = 0;
    for (const std::uint32_t line : lines_) highest = std::max(highest, line);
    ranks_.resize(lines_.empty() ? 0 : highest + std::size_t{1});
    for (std::size_t i = 1; i < lines_.size(); ++i) {
      const bool same = leaning(lines_[i - 1], lines_[i]) == 0;
      ranks_[lines_[i]] = ranks_[lines_[i - 1]] + (same ? 0 : 1);
    }
  }

  [[nodiscard]] static std::int64_t east() { return 0; }
  [[nodiscard]] std::int64_t up(std::uint32_t line) const { return 1 + ranks_[line]; }
  [[nodiscard]] std::int64_t west() const { return 1 + count(); }
  [[nodiscard]] std::int64_t down(std::uint32_t line) const { return 2 + count() + ranks_[line]; }

 private:
  [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(lines_.size()); }

  // Positive if the first line, going up, leads farther to the east. X = -(b Y + c) / a, a positive.
  [[nodiscard]] int leaning(std::uint32_t one, std::uint32_t other) const {
    const ImageLine& l = image_.lines()[one];
    const ImageLine& m = image_.lines()[other];
    return (Coefficient(m.b) * Coefficient(l.a) - Coefficient(l.b) * Coefficient(m.a)).sign();
  }

  const Image& image_;
  std::vector<std::uint32_t> lines_;  // lines in use, by upward direction
  std::vector<std::int64_t> ranks_;   // by line
};

class RegionPieces {
 public:
  RegionPieces(const Image& image, const TrapezoidPcs& region)
      : image_(image), region_(region), headings_(image, region), low_(region.sides.size()), high_(low_) {
    const Band* below = nullptr;
    for (const Band& band : region.bands) {
      if (below != nullptr && image.compare(below->high, band.low) != 0) {
        add_level(below->high, below, nullptr);
        below = nullptr;
      }
      add_level(band.low, below, &band);
      below = &band;
    }
    if (below != nullptr) add_level(below->high, below, nullptr);
    for (const Band& band : region.bands) add_sides(band);
  }

  [[nodiscard]] std::vector<RegionLoop> loops() const {
    std::vector<RegionLoop> result;
    for (const auto& loop : trace_boundary(pieces_)) result.push_back(joined(loop));
    return result;
  }

 private:
  struct End {
    std::uint32_t side = 0;  // of the region
    bool above = false;      // true: the lower end of a side above the level
  };

  [[nodiscard]] int order(const End& a, const End& b, const Ordinate& y) const {
    return image_.order_at(region_.sides[a.side].line, region_.sides[b.side].line, y);
  }

  // Numbers the points of a level and adds the horizontal pieces: those covered above but not below, or below but not
  // above.
  void add_level(const Ordinate& y, const Band* below, const Band* above) {
    ends_.clear();
    for (const Band* band : {below, above}) {
      if (band == nullptr) continue;
      for (std::uint32_t k = 0; k < band->count; ++k) ends_.push_back({band->first + k, band == above});
    }
    std::sort(ends_.begin(), ends_.end(), [&](const End& a, const End& b) { return order(a, b, y) < 0; });
    bool in_above = false;
    bool in_below = false;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (i == 0 || order(ends_[i - 1], ends_[i], y) != 0) {
        const auto point = static_cast<std::uint32_t>(points_.size());
        points_.push_back({region_.sides[ends_[i].side].line, y});
        if (in_above != in_below) add_horizontal(point - 1, point, in_above);
      }
      (ends_[i].above ? low_ : high_)[ends_[i].side] = static_cast<std::uint32_t>(points_.size() - 1);
      (ends_[i].above ? in_above : in_below) ^= true;
    }
  }

  void add_horizontal(std::uint32_t west, std::uint32_t east, bool covered_above) {
    if (covered_above) {
      pieces_.push_back({west, east, Headings::east(), headings_.west()});
    } else {
      pieces_.push_back({east, west, headings_.west(), Headings::east()});
    }
  }

  void add_sides(const Band& band) {
    for (std::uint32_t side = band.first; side < band.first + band.count; ++side) {
      const std::int64_t up = headings_.up(region_.sides[side].line);
      const std::int64_t down = headings_.down(region_.sides[side].line);
      if ((side - band.first) % 2 == 0) {
        pieces_.push_back({high_[side], low_[side], down, up});
      } else {
        pieces_.push_back({low_[side], high_[side], up, down});
      }
    }
  }

  [[nodiscard]] RegionLoop joined(const std::vector<std::uint32_t>& loop) const {
    RegionLoop result;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const BoundaryPiece& arriving = pieces_[loop[i == 0 ? loop.size() - 1 : i - 1]];
      const BoundaryPiece& leaving = pieces_[loop[i]];
      if (arriving.leaving != leaving.leaving) result.push_back(points_[leaving.from]);
    }
    return result;
  }

  const Image& image_;
  const TrapezoidPcs& region_;
  Headings headings_;
  std::vector<RegionCorner> points_;
  std::vector<std::uint32_t> low_;  // by side: number of the point
  std::vector<std::uint32_t> high_;
  std::vector<BoundaryPiece> pieces_;
  std::vector<End> ends_;
};

}  // namespace

std::vector<RegionLoop> boundary_of(const Image& image, const TrapezoidPcs& region) {
  return RegionPieces(image, region).loops();
}

std::array<double, 2> approximate_point(const Image& image, const RegionCorner& corner) {
  const double y = corner.y.middle();
  return {image.abscissa(corner.line, y), y};
}

double signed_area(const Image& image, const RegionLoop& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto p = approximate_point(image, loop[i]);
    const auto q = approximate_point(image, loop[i + 1 == loop.size() ? 0 : i + 1]);
    sum += p[0] * q[1] - q[0] * p[1];
  }
  return sum / 2;
}

TrapezoidPcs unite_regions(const Image& image, std::span<const std::uint32_t> faces,
                    std::span<const TrapezoidPcs> regions) {
  TrapezoidPcs result;
  for (const std::uint32_t face : faces) result = combine(image, result, regions[face], Operation::unite);
  return result;
}

}  // namespace sightline::algorithms::montani_re
