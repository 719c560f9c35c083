// Compares pictures of faces in Willis's order with the nearest face at every point (host/algorithms/oracle).
//
// Views are square and 90 degrees wide. The camera's vectors have one length, so that the sight line of every point
// has integer direction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

// Face number over all bodies + 1, 0 for none. The bottom row is first.
[[nodiscard]] picture::PixelGrid ordered_faces(const algorithms::willis::Model& model,
                                               const scene::PolyCamera& camera, int size,
                                               algorithms::willis::Representatives representatives = {});

// A random corner of each piece as its representative.
[[nodiscard]] std::vector<std::uint32_t> random_corners(const algorithms::willis::Model& model,
                                                        std::uint32_t seed);

// Numbers of points, and of those at which the order is wrong. Within 0.75 points of an edge rounding may choose
// either side, so these are counted separately.
struct FaceErrors {
  std::uint64_t points = 0;
  std::uint64_t inside = 0;  // farther than that from every edge
  std::uint64_t wrong_inside = 0;
  std::uint64_t wrong_on_edges = 0;

  void add(const FaceErrors& other);
  [[nodiscard]] double inside_per_cent() const;  // PMR of the interior
};

// The correct faces of some views, computed once.
class TrueFaces {
 public:
  TrueFaces(const scene::PolyScene& scene, std::vector<scene::PolyCamera> cameras, int size);

  [[nodiscard]] const std::vector<scene::PolyCamera>& cameras() const { return cameras_; }
  [[nodiscard]] const picture::PixelGrid& truth(std::size_t view) const { return truths_[view]; }
  [[nodiscard]] int size() const { return size_; }
  // Each view uses other representatives of the pieces.
  [[nodiscard]] FaceErrors errors_of(const algorithms::willis::Model& model) const;
  [[nodiscard]] picture::PixelGrid draw(const algorithms::willis::Model& model, std::size_t view) const;
  [[nodiscard]] FaceErrors errors_of(const picture::PixelGrid& drawn, std::size_t view) const;

 private:
  std::vector<scene::PolyCamera> cameras_;
  std::vector<picture::PixelGrid> truths_;
  std::vector<std::vector<picture::PixelSegment>> edges_;
  int size_;
};

// Level, along the two level axes both ways, from outside the scene at the given height: four cameras, without those
// whose eye would be out of range or not in free space.
[[nodiscard]] std::vector<scene::PolyCamera> cameras_around(const scene::PolyScene& scene,
                                                            std::int32_t height);

// Level, along the two level axes both ways in turn, from random positions in free space within the scene's bounds.
[[nodiscard]] std::vector<scene::PolyCamera> cameras_within(const scene::PolyScene& scene, std::size_t count);

}  // namespace sightline::compare
