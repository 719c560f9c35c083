#include "host/algorithms/montani_re/depth_relations.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sightline::algorithms::montani_re {
namespace {

using geometry::WideInteger;

// The region of the image where the first of two planes is nearer: the sign of a X + b Y + c, exactly.
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
    // The relative error of an ordinate is at most 2^-30, usually 2^-48.
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

  // 1: the second is nowhere nearer; -1: the first is nowhere nearer; 0: coplanar; 2: neither.
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

  // Tests 4 to 6 of a pair whose X, Y and Z extents overlap.
  void decide(std::uint32_t i, std::uint32_t j) {
    const Face& f = set_.faces[i];
    const Face& g = set_.faces[j];
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
  void relate(std::uint32_t near, std::uint32_t far, std::uint8_t test) {
    decided(test);
    result.relations.push_back({near, far, test});
  }

  DepthRelations result;

 private:
  const FaceSet& set_;
};

// The extents of all faces in separate arrays, by lowest X, for tests 1 to 3. Floating point decides nearly all pairs;
// only equal numbers are compared exactly.
struct Extents {
  explicit Extents(const FaceSet& set) {
    const std::size_t count = set.faces.size();
    struct Key {
      double low_x = 0;
      std::uint32_t face = 0;
    };
    std::vector<Key> keys(count);
    for (std::uint32_t i = 0; i < count; ++i) keys[i] = {set.faces[i].low[0].approximate, i};
    std::sort(keys.begin(), keys.end(), [&set](const Key& a, const Key& b) {
      if (a.low_x != b.low_x) return a.low_x < b.low_x;
      const int x = compare(set.faces[a.face].low[0], set.faces[b.face].low[0]);
      return x != 0 ? x < 0 : a.face < b.face;
    });
    face.resize(count);
    for (auto* numbers : {&low_x, &high_x, &low_y, &high_y}) numbers->resize(count);
    for (auto* depths : {&nearest, &farthest}) depths->resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Face& of = set.faces[keys[i].face];
      face[i] = keys[i].face;
      low_x[i] = of.low[0].approximate;
      high_x[i] = of.high[0].approximate;
      low_y[i] = of.low[1].approximate;
      high_y[i] = of.high[1].approximate;
      nearest[i] = of.nearest;
      farthest[i] = of.farthest;
    }
  }

  std::vector<std::uint32_t> face;
  std::vector<double> low_x;
  std::vector<double> high_x;
  std::vector<double> low_y;
  std::vector<double> high_y;
  std::vector<std::int64_t> nearest;
  std::vector<std::int64_t> farthest;
};

}  // namespace

Overlap overlap_of(const FaceSet& set, std::uint32_t first, std::uint32_t second) {
  Overlap overlap;
  const Face& f = set.faces[first];
  const Face& g = set.faces[second];
  if (placement_of(set, f, g) == Placement::apart) return overlap;
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
  const Extents extents(set);
  const std::size_t count = extents.face.size();
  // The first ends on an axis where the second begins, or before. Equal numbers are equal in floating point, too.
  const auto ends_before = [&](std::size_t first, std::size_t second, std::size_t axis) {
    return compare(set.faces[extents.face[first]].high[axis], set.faces[extents.face[second]].low[axis]) <= 0;
  };
  PairTests tests(set);
  std::vector<std::uint32_t> near_in_y(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    // Most pairs are disjoint in Y; this is computed without a branch.
    const double high_x = extents.high_x[i];
    const double low_y = extents.low_y[i];
    const double high_y = extents.high_y[i];
    std::size_t found = 0;
    std::size_t j = i + 1;
    const auto keep_if_near = [&] {
      near_in_y[found] = static_cast<std::uint32_t>(j);
      found += static_cast<std::size_t>(static_cast<unsigned>(extents.low_y[j] <= high_y) &
                                        static_cast<unsigned>(extents.high_y[j] >= low_y));
    };
    for (; j < count && extents.low_x[j] < high_x; ++j) keep_if_near();
    for (; j < count && extents.low_x[j] == high_x && !ends_before(i, j, 0); ++j) keep_if_near();
    if (j < count) tests.decided(1);  // and with it all that follow
    std::uint64_t together = 0;
    for (std::size_t k = 0; k < found; ++k) {
      const std::size_t other = near_in_y[k];
      if (extents.low_y[other] == high_y && ends_before(i, other, 1)) continue;
      if (extents.high_y[other] == low_y && ends_before(other, i, 1)) continue;
      ++together;
      const std::uint32_t face = extents.face[i];
      const std::uint32_t with = extents.face[other];
      if (extents.nearest[i] > extents.farthest[other]) {
        tests.relate(with, face, 3);
      } else if (extents.farthest[i] < extents.nearest[other]) {
        tests.relate(face, with, 3);
      } else {
        tests.decide(face, with);
      }
    }
    tests.decided(2, j - i - 1 - together);
  }
  return std::move(tests.result);
}

}  // namespace sightline::algorithms::montani_re
