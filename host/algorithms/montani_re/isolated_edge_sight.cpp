#include "host/algorithms/montani_re/isolated_edge_sight.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "host/algorithms/montani_re/edge_parameter.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Int128;
using geometry::Interval;
using geometry::Rational;

class IsolatedEdge {
 public:
  IsolatedEdge(const FaceSet& set, std::uint32_t line)
      : set_(set), image_(set.image), line_(line), edge_(set.image.lines()[line]) {
    std::optional<Interval> part = Interval{0, 1};
    if (set.window) part = on_border(*set.window) ? std::nullopt : part_within(image_, line, *set.window);
    if (part) seen_ = {part->low, part->high};
    if (edge_.horizontal()) {
      extent_.low = extent_.high = image_.ordinate_of(image_.end_before_eye(line));
    } else {
      extent_ = extent_of(image_, line, set.window ? &*set.window : nullptr);
    }
  }

  geometry::IntervalSet seen() {
    for (const Face& face : set_.faces) {
      if (seen_.empty()) break;
      if (face.low[1].approximate > extent_.high.high || face.high[1].approximate < extent_.low.low) continue;
      if (edge_.horizontal()) {
        hide_along_stripes(face);
      } else {
        hide_across_stripes(face);
      }
    }
    return std::move(seen_);
  }

 private:
  // Only one side of a window's border is known.
  [[nodiscard]] bool on_border(const Window& window) const {
    const auto same = [this](std::uint32_t border) {
      return image_.side_of(border, edge_.from) == 0 && image_.side_of(border, edge_.to) == 0;
    };
    if (same(window.west) || same(window.east)) return true;
    if (!edge_.horizontal()) return false;
    const Ordinate y = image_.ordinate_of(image_.end_before_eye(line_));
    return image_.compare(y, window.bottom) == 0 || image_.compare(y, window.top) == 0;
  }

  // Removes the part of an interval that lies beyond the face's plane. The edge may pierce the face: a sheet seen edge-on
  // can intersect anything.
  void hide(const Face& face, Interval part) {
    const auto height = [&](std::uint32_t v) {
      const Vertex& p = image_.vertices()[v];
      return face.normal[0] * p.x + face.normal[1] * p.y + face.normal[2] * p.z - face.offset;
    };
    const Int128 from = height(edge_.from);
    const Int128 to = height(edge_.to);
    if (from <= 0 && to <= 0) return;
    if (from < 0) part.low = std::max(part.low, zero_between(from, to));
    if (to < 0) part.high = std::min(part.high, zero_between(from, to));
    seen_.subtract(part.low, part.high);
  }

  // The part of the edge inside a trapezoid, as ordinates.
  [[nodiscard]] std::optional<Extent> stretch(Extent within, std::uint32_t west, std::uint32_t east) const {
    if (!keep_east_of(west, 1, within) || !keep_east_of(east, -1, within)) return std::nullopt;
    if (image_.compare(within.low, within.high) >= 0) return std::nullopt;
    return within;
  }
  // With `side` -1, keeps what is to the west instead.
  [[nodiscard]] bool keep_east_of(std::uint32_t line, int side, Extent& within) const {
    if (image_.compare(within.low, within.high) >= 0) return false;
    const int low = side * image_.order_at(line_, line, within.low);
    const int high = side * image_.order_at(line_, line, within.high);
    if (low < 0 && high < 0) return false;
    if (low < 0) within.low = image_.crossing(line_, line);
    if (high < 0) within.high = image_.crossing(line_, line);
    return true;
  }

  void hide_across_stripes(const Face& face) {
    inside_.clear();
    for (const Band& band : face.pcs.bands) {
      const Extent within{image_.compare(band.low, extent_.low) < 0 ? extent_.low : band.low,
                          image_.compare(band.high, extent_.high) > 0 ? extent_.high : band.high};
      if (image_.compare(within.low, within.high) >= 0) continue;
      const auto sides = face.pcs.sides_of(band);
      for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
        const auto part = stretch(within, sides[k].line, sides[k + 1].line);
        if (!part) continue;
        if (!inside_.empty() && image_.compare(inside_.back().high, part->low) == 0) {
          inside_.back().high = part->high;
        } else {
          inside_.push_back(*part);
        }
      }
    }
    // Joined parts end where the edge meets an outline, which keeps parameters short.
    for (const Extent& part : inside_) {
      const Rational low = parameter_at(image_, line_, part.low);
      const Rational high = parameter_at(image_, line_, part.high);
      hide(face, {std::min(low, high), std::max(low, high)});
    }
  }

  [[nodiscard]] std::vector<Interval> parts_in(const TrapezoidPcs& pcs, const Band& band) const {
    std::vector<Interval> parts;
    const auto sides = pcs.sides_of(band);
    for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
      if (const auto part = part_between(image_, line_, sides[k].line, sides[k + 1].line))
        parts.push_back(*part);
    }
    return parts;
  }

  void hide_along_stripes(const Face& face) {
    for (const Band& band : face.pcs.bands) {
      if (image_.compare(band.low, extent_.low) > 0 || image_.compare(band.high, extent_.low) < 0) continue;
      for (const Interval& part : parts_in(face.pcs, band))
        if (part.low < part.high) hide(face, part);
    }
  }

  const FaceSet& set_;
  const Image& image_;
  std::uint32_t line_;
  const ImageLine& edge_;
  Extent extent_;
  geometry::IntervalSet seen_;
  std::vector<Extent> inside_;  // the parts inside the current face
};

}  // namespace

geometry::IntervalSet seen_of_isolated_edge(const FaceSet& set, std::uint32_t line) {
  return IsolatedEdge(set, line).seen();
}

}  // namespace sightline::algorithms::montani_re
