// The visible pieces of edges, collected as the search enters cells, and the picture made from them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "host/algorithms/jones/sight_plane.hpp"
#include "host/algorithms/jones/stretch.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/cell_complex.hpp"

namespace sightline::algorithms::jones {

// In lowest terms; nullopt if that does not fit in 64 bits.
[[nodiscard]] inline std::optional<geometry::Rational> reduce(const Fraction<std::int64_t>& fraction) {
  return geometry::Rational(fraction.numerator, fraction.denominator);
}
[[nodiscard]] inline std::optional<geometry::Rational> reduce(const Fraction<geometry::Int128>& fraction) {
  const geometry::Int128 divisor = geometry::common_divisor(fraction.denominator, fraction.numerator);
  const geometry::Int128 denominator = fraction.denominator / divisor;
  if (denominator > std::numeric_limits<std::int64_t>::max()) return std::nullopt;
  return geometry::Rational(static_cast<std::int64_t>(fraction.numerator / divisor),
                            static_cast<std::int64_t>(denominator));
}

template <class Number>
class Fragments {
 public:
  void clear() {
    fragments_.clear();
    limit_ = first_limit;
  }
  // Precondition: low < high.
  void add(std::uint32_t edge, const Stretch<Number>& stretch) {
    if (fragments_.size() >= limit_) {
      unite();
      limit_ = std::max(first_limit, 2 * fragments_.size());
    }
    fragments_.push_back({edge, stretch});
  }

  // The union of the fragments, without edges that are seen end-on or are nowhere in front of the eye. nullopt if a reduced
  // end has more bits than where two edges, or an edge and a plane, can cross. A closed mask still admits edges exactly
  // beside the eye; they are removed here.
  [[nodiscard]] std::optional<picture::LinePicture> picture(const scene::CellComplex& complex,
                                                            const Sight& sight) {
    unite();
    picture::LinePicture picture;
    picture.pieces.reserve(fragments_.size());
    for (const Fragment& fragment : fragments_) {
      const scene::ComplexEdge& edge = complex.edges[fragment.edge];
      const geometry::Vector3 from = sight.from_eye(complex.vertices[edge.from]);
      const geometry::Vector3 to = sight.from_eye(complex.vertices[edge.to]);
      if (sight.seen_end_on(from, to)) continue;
      if (sight.perspective() && geometry::dot(sight.forward(), from) <= 0 &&
          geometry::dot(sight.forward(), to) <= 0)
        continue;
      const auto low = reduce(fragment.stretch.low);
      const auto high = reduce(fragment.stretch.high);
      if (!low || !high) return std::nullopt;
      picture.pieces.push_back({{edge.from, edge.to}, *low, *high});
    }
    return picture;
  }

 private:
  struct Fragment {
    std::uint32_t edge = 0;
    Stretch<Number> stretch;
  };
  static constexpr std::size_t first_limit = std::size_t{1} << 18;

  // Joins fragments that overlap or touch, and sorts them by edge and position.
  void unite() {
    std::sort(fragments_.begin(), fragments_.end(), [](const Fragment& a, const Fragment& b) {
      return a.edge != b.edge ? a.edge < b.edge : less(a.stretch.low, b.stretch.low);
    });
    std::size_t kept = 0;
    for (std::size_t i = 1; i < fragments_.size(); ++i) {
      Fragment& last = fragments_[kept];
      const Fragment& next = fragments_[i];
      if (next.edge != last.edge || less(last.stretch.high, next.stretch.low)) {
        fragments_[++kept] = next;
      } else if (less(last.stretch.high, next.stretch.high)) {
        last.stretch.high = next.stretch.high;
      }
    }
    if (!fragments_.empty()) fragments_.resize(kept + 1);
  }

  std::vector<Fragment> fragments_;
  std::size_t limit_ = first_limit;
};

}  // namespace sightline::algorithms::jones
