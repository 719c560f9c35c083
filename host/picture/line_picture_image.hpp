// The image of an exact line picture: where its pieces lie in the image plane, merged where they overlap.
//
// Two algorithms may draw the same image from different edges (an edge exactly behind another is seen through
// neither, or both, by convention): ImageSet is the set of points drawn, canonical, so that == compares it.
//
// Sizes: with coordinates below 2^18, camera vectors below 2^15 and parameters of 60 over 60 bits, an image
// coordinate is a fraction of 99 over 99 bits; such fractions are compared by their continued fractions,
// which need no wider products.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

// A fraction in lowest terms, the denominator positive; -1/0 and 1/0 are the ends of an image that runs out
// to infinity.
struct ImageRatio {
  geometry::Int128 numerator = 0;
  geometry::Int128 denominator = 1;

  friend bool operator==(const ImageRatio&, const ImageRatio&) = default;
};

// Negative, zero or positive as a is less than, equal to or greater than b.
[[nodiscard]] int compare(const ImageRatio& a, const ImageRatio& b);

struct ImageSegment {
  // The plane of all sight lines through the image line: normal and offset, in lowest terms, the first that
  // is not zero positive; relative to the eye in perspective (offset 0), to the origin otherwise.
  std::array<std::int64_t, 4> line{};
  // Along the line, as right / forward (or up / forward where right is constant), not scaled by lengths.
  ImageRatio low;
  ImageRatio high;

  friend bool operator==(const ImageSegment&, const ImageSegment&) = default;
};

struct ImageSet {
  std::vector<ImageSegment> segments;  // ascending by line, then low; segments of a line do not touch

  friend bool operator==(const ImageSet&, const ImageSet&) = default;
};

// The line of the image on which an edge lies: the plane that ImageSegment::line has in lowest terms. The normal is zero if the
// edge is seen as a point.
[[nodiscard]] std::array<std::int64_t, 4> image_plane(const LineEdge& edge, const scene::PolyScene& scene,
                                                      const scene::PolyCamera& camera);
// The same plane, its numbers without a common divisor, the first that is not zero positive.
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
// Where the point of an edge with this parameter lies along right (axis 0) or up (1), as ImageSegment::low, but not in lowest
// terms.
[[nodiscard]] ImageRatio image_coordinate(const LineEdge& edge, const geometry::Rational& parameter, std::size_t axis,
                                          const scene::PolyScene& scene, const scene::PolyCamera& camera);

// The picture is one of these vertices under this camera; pieces whose image is a point are left out.
[[nodiscard]] ImageSet image_set(const LinePicture& picture, const scene::PolyScene& scene,
                                 const scene::PolyCamera& camera);

// Total length of all pieces in the image plane at unit focal length (in perspective), as the definition of
// PolyCamera has it; in scene units otherwise. Overlapping pieces count each.
[[nodiscard]] double image_length(const LinePicture& picture, const scene::PolyScene& scene,
                                  const scene::PolyCamera& camera);

}  // namespace sightline::picture
