#include "host/algorithms/montani_re/depth_relations.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sightline::algorithms::montani_re {
namespace {

using geometry::WideInteger;

// Where in the image the first of two planes is nearer: the sign of a X + b Y + c, exactly.
class NearnessDifference {
 public:
  NearnessDifference(const Image& image, const Face& first, const Face& second) : image_(image) {
    using Normal = WideInteger<Face::normal_bits>;
    using Offset = WideInteger<Face::offset_bits>;
    if (image.perspective()) {
      // 1 / z = normal . (X, Y, 1) / offset, offsets positive
      for (std::size_t k = 0; k < 3; ++k) {
        exact_[k] =
            Offset(second.offset) * Normal(first.normal[k]) - Offset(first.offset) * Normal(second.normal[k]);
      }
    } else {
      // z = (offset - normal . (X, Y)) / normal_z, normal_z positive; nearer is less
      const Normal one(first.normal[2]);
      const Normal other(second.normal[2]);
      for (std::size_t k = 0; k < 2; ++k) {
        exact_[k] = Normal(first.normal[k]) * other - Normal(second.normal[k]) * one;
      }
      exact_[2] = Offset(second.offset) * one - Offset(first.offset) * other;
    }
    for (std::size_t k = 0; k < 3; ++k) approximate_[k] = exact_[k].to_double();
  }

  [[nodiscard]] int sign_at(std::uint32_t line, const Ordinate& y) const {
    const auto& l = image_.lines()[line].approximate;
    const double y_part = (l[0] * approximate_[1] - approximate_[0] * l[1]) * y.middle();
    const double value = y_part + (l[0] * approximate_[2] - approximate_[0] * l[2]);
    const double size = (std::abs(l[0] * approximate_[1]) + std::abs(approximate_[0] * l[1])) *
                            (std::abs(y.low) + std::abs(y.high)) +
                        std::abs(l[0] * approximate_[2]) + std::abs(approximate_[0] * l[2]);
    // An ordinate is known to 2^-30 of itself or better, usually to 2^-48.
    const double error =
        size * (0x1p-48 + (y.high - y.low) / std::max(std::abs(y.low) + std::abs(y.high), 0x1p-900));
    if (std::abs(value) > error) return value > 0 ? 1 : -1;
    const ImageLine& exact_line = image_.lines()[line];
    const Image::Quotient at = image_.exact(y);
    const Image::Coefficient a(exact_line.a);
    return ((a * exact_[1] - exact_[0] * Image::Coefficient(exact_line.b)) * at.numerator +
            (a * exact_[2] - exact_[0] * Image::Coefficient(exact_line.c)) * at.denominator)
        .sign();
  }

  // 1: nowhere nearer is the second, -1: nowhere the first, 0: coplanar, 2: it differs.
  [[nodiscard]] int sign_on(const TrapezoidPcs& pcs) const {
    bool positive = false;
    bool negative = false;
    for (const Band& band : pcs.bands) {
      for (const Side& side : pcs.sides_of(band)) {
        for (const Ordinate* y : {&band.low, &band.high}) {
          const int sign = sign_at(side.line, *y);
          positive = positive || sign > 0;
          negative = negative || sign < 0;
        }
      }
    }
    return positive && negative ? 2 : (positive ? 1 : 0) - (negative ? 1 : 0);
  }

 private:
  const Image& image_;
  std::array<double, 3> approximate_{};
  std::array<WideInteger<Face::normal_bits + Face::offset_bits + 1>, 3> exact_;
};

struct Sides {
  bool near = true;  // all vertices on the near side of a plane, or in it
  bool far = true;
};

Sides sides_of(const Image& image, const Face& face, const Face& plane) {
  Sides sides;
  for (const std::uint32_t v : face.vertices) {
    const int side = plane.side(image.vertices()[v]);
    sides.near = sides.near && side <= 0;
    sides.far = sides.far && side >= 0;
    if (!sides.near && !sides.far) break;
  }
  return sides;
}

class PairTests {
 public:
  explicit PairTests(const FaceSet& set) : set_(set) {}

  // Tests 3 to 6 of a pair whose X and Y overlap.
  void decide(std::uint32_t i, std::uint32_t j) {
    const Face& f = set_.faces[i];
    const Face& g = set_.faces[j];
    if (f.nearest > g.farthest) return relate(j, i, 3);
    if (f.farthest < g.nearest) return relate(i, j, 3);
    const Sides f_of_g = sides_of(set_.image, f, g);
    if (f_of_g.near && f_of_g.far) return decided(4);  // coplanar
    const Sides g_of_f = sides_of(set_.image, g, f);
    if (f_of_g.near || g_of_f.far) return relate(i, j, 4);
    if (f_of_g.far || g_of_f.near) return relate(j, i, 5);
    decided(6);
    Overlap overlap = overlap_of(set_, i, j);
    if (overlap.interpenetrating) {
      if (!result.interpenetrating) result.interpenetrating = {i, j};
    } else if (overlap.order != 0) {
      result.relations.push_back({overlap.order < 0 ? i : j, overlap.order < 0 ? j : i, 6});
    }
    for (HiddenPart& part : overlap.parts) result.hidden.push_back(std::move(part));
  }
  void decided(std::size_t test, std::uint64_t pairs = 1) { result.decided_by[test] += pairs; }

  DepthRelations result;

 private:
  void relate(std::uint32_t near, std::uint32_t far, std::uint8_t test) {
    decided(test);
    result.relations.push_back({near, far, test});
  }

  const FaceSet& set_;
};

// Tests 1 and 2 in floating point, side by side: they decide nearly all pairs. Where they find numbers equal
// the exact ones are looked up.
struct Extents {
  std::uint32_t face = 0;
  std::array<double, 2> low{};
  std::array<double, 2> high{};
};

std::vector<Extents> extents_by_lowest_x(const FaceSet& set) {
  std::vector<Extents> extents;
  extents.reserve(set.faces.size());
  for (std::uint32_t i = 0; i < set.faces.size(); ++i) {
    const Face& face = set.faces[i];
    extents.push_back({i,
                       {face.low[0].approximate, face.low[1].approximate},
                       {face.high[0].approximate, face.high[1].approximate}});
  }
  std::sort(extents.begin(), extents.end(), [&set](const Extents& a, const Extents& b) {
    if (a.low[0] != b.low[0]) return a.low[0] < b.low[0];
    const int x = compare(set.faces[a.face].low[0], set.faces[b.face].low[0]);
    return x != 0 ? x < 0 : a.face < b.face;
  });
  return extents;
}

}  // namespace

Overlap overlap_of(const FaceSet& set, std::uint32_t first, std::uint32_t second) {
  Overlap overlap;
  const Face& f = set.faces[first];
  const Face& g = set.faces[second];
  if (placement_of(set.image, f, g) == Placement::apart) return overlap;
  const TrapezoidPcs common = combine(set.image, f.pcs, g.pcs, Operation::intersect);
  if (common.empty()) return overlap;
  overlap.overlaps = true;
  overlap.area = area(set.image, common);
  const NearnessDifference difference(set.image, f, g);
  const int sign = difference.sign_on(common);
  if (sign != 2) {
    overlap.order = -sign;
    return overlap;
  }
  for (TrapezoidPcs& part : components(set.image, common)) {
    const int here = difference.sign_on(part);
    overlap.interpenetrating = overlap.interpenetrating || here == 2;
    if (here != 0) overlap.parts.push_back({here > 0 ? second : first, std::move(part)});
  }
  return overlap;
}

DepthRelations depth_relations(const FaceSet& set) {
  const std::vector<Extents> extents = extents_by_lowest_x(set);
  // The first ends on an axis before the second begins.
  const auto before = [&set](const Extents& a, const Extents& b, std::size_t axis) {
    if (a.high[axis] != b.low[axis]) return a.high[axis] < b.low[axis];
    return compare(set.faces[a.face].high[axis], set.faces[b.face].low[axis]) <= 0;
  };
  PairTests tests(set);
  for (std::size_t i = 0; i < extents.size(); ++i) {
    const Extents& a = extents[i];
    std::uint64_t apart_in_y = 0;
    for (std::size_t j = i + 1; j < extents.size(); ++j) {
      const Extents& b = extents[j];
      if (before(a, b, 0)) {
        tests.decided(1);
        break;  // and so for all that follow
      }
      if (before(a, b, 1) || before(b, a, 1)) {
        ++apart_in_y;
      } else {
        tests.decide(a.face, b.face);
      }
    }
    tests.decided(2, apart_in_y);
  }
  return std::move(tests.result);
}

}  // namespace sightline::algorithms::montani_re
