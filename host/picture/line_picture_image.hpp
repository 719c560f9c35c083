// The image of an exact line picture: its pieces in the image plane, merged where they overlap.
//
// Two algorithms may draw the same image from different edges (whether an edge exactly behind another is visible is a
// convention). ImageSet is the set of points drawn, in a canonical form that == compares.
//
// Sizes: with coordinates below 2^18, camera vectors below 2^15 and parameters of 60 over 60 bits, an image coordinate is
// a fraction of 99 over 99 bits. Such fractions are compared by their continued fractions, which need no wider products.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

// A fraction in lowest terms with a positive denominator; -1/0 and 1/0 are the ends of an image that runs to infinity.
struct ImageRatio {
  geometry::Int128 numerator = 0;
  geometry::Int128 denominator = 1;

  friend bool operator==(const ImageRatio&, const ImageRatio&) = default;
};

// Negative, zero or positive: a is less than, equal to, greater than b.
[[nodiscard]] int compare(const ImageRatio& a, const ImageRatio& b);

struct ImageSegment {
  // The plane of all sight lines through the image line: normal and offset in lowest terms, the first nonzero number
  // positive; relative to the eye in perspective (offset 0), otherwise to the origin.
  std::array<std::int64_t, 4> line{};
  // The position along the line, as right / forward (or up / forward if right is constant), not scaled by lengths.
  ImageRatio low;
  ImageRatio high;

  friend bool operator==(const ImageSegment&, const ImageSegment&) = default;
};

struct ImageSet {
  std::vector<ImageSegment> segments;  // ascending by line, then low; segments of a line do not touch

  friend bool operator==(const ImageSet&, const ImageSet&) = default;
};

// The plane through the eye and an edge, which determines its line in the image, but not in lowest terms (see
// ImageSegment::line). The normal is zero if the edge is seen as a point.
[[nodiscard]] std::array<std::int64_t, 4> image_plane(const LineEdge& edge, const scene::PolyScene& scene,
                                                      const scene::PolyCamera& camera);
// The same plane with coprime numbers, the first nonzero number positive.
template <class Integer>
[[nodiscard]] std::array<Integer, 4> in_lowest_terms(std::array<Integer, 4> plane) {
  geometry::Int128 common = 0;
  for (const Integer part : plane)
    if (common != 1) common = geometry::common_divisor(common, geometry::Int128{part});
  if (common == 0) return plane;
  auto divisor = static_cast<Integer>(common);
  for (const Integer part : plane) {
    if (part == 0) continue;
    if (part < 0) divisor = -divisor;
    break;
  }
  for (Integer& part : plane) part /= divisor;
  return plane;
}
// The position along right (axis 0) or up (1) of the point of an edge with this parameter, like ImageSegment::low, but
// not in lowest terms.
[[nodiscard]] ImageRatio image_coordinate(const LineEdge& edge, const geometry::Rational& parameter, std::size_t axis,
                                          const scene::PolyScene& scene, const scene::PolyCamera& camera);

// Pieces whose image is a point are left out. Precondition: the picture is of this scene from this camera.
[[nodiscard]] ImageSet image_set(const LinePicture& picture, const scene::PolyScene& scene,
                                 const scene::PolyCamera& camera);

// Total length of all pieces in the image plane: in perspective at unit focal length, as PolyCamera defines it; otherwise
// in scene units. Overlapping pieces are counted separately.
[[nodiscard]] double image_length(const LinePicture& picture, const scene::PolyScene& scene,
                                  const scene::PolyCamera& camera);

}  // namespace sightline::picture
