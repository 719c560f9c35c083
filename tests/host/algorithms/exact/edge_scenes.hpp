// Small scenes made by hand and random cameras, for both makers of exact line pictures.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/geometry/interval_set.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms {

struct Maker {
  const char* name;
  picture::LinePicture (*draw)(const scene::PolyScene&, const scene::PolyCamera&);
};

inline const Maker exact_maker{"exact", exact::visible_edges};
inline const Maker oracle_maker{"oracle", oracle::visible_edges};

// Adds a sheet of one face; returns the index of its first vertex.
inline scene::VertexIndex add_sheet(scene::PolyScene& scene, const std::vector<scene::PolyPoint>& outline,
                                    const std::vector<scene::PolyPoint>& hole = {}) {
  const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
  scene::PolyFace face;
  const auto add = [&scene](const std::vector<scene::PolyPoint>& ring) {
    std::vector<scene::VertexIndex> indices;
    for (const scene::PolyPoint& point : ring) {
      indices.push_back(static_cast<scene::VertexIndex>(scene.vertices.size()));
      scene.vertices.push_back(point);
    }
    return indices;
  };
  face.outline = add(outline);
  if (!hole.empty()) face.holes.push_back(add(hole));
  scene.bodies.push_back({"", true, {face}});
  return first;
}

// A square parallel to the image plane, with |x| and |y| at most `half`.
inline std::vector<scene::PolyPoint> square(std::int32_t half, std::int32_t z) {
  return {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
}

// The visible parts of the edge between two vertices, the lower index first.
inline std::vector<geometry::Interval> seen_of(const picture::LinePicture& picture, scene::VertexIndex from,
                                               scene::VertexIndex to) {
  std::vector<geometry::Interval> seen;
  for (const picture::LinePiece& piece : picture.pieces) {
    if (piece.edge == picture::LineEdge{from, to}) seen.push_back({piece.low, piece.high});
  }
  return seen;
}

class RandomCameras {
 public:
  explicit RandomCameras(const scene::PolyScene& scene, std::uint32_t seed) : dice_(seed) {
    low_ = high_ = scene.vertices.front();
    for (const scene::PolyPoint& v : scene.vertices) {
      for (std::size_t a = 0; a < 3; ++a) {
        low_[a] = std::min(low_[a], v[a]);
        high_[a] = std::max(high_[a], v[a]);
      }
    }
  }

  // A camera outside the bounds of the scene with any line of sight: much may be behind the eye.
  scene::PolyCamera outside(bool perspective) {
    scene::PolyCamera camera = somewhere(perspective);
    while (inside_bounds(camera.eye)) camera = somewhere(perspective);
    return camera;
  }

  // A camera within the bounds; no coordinate is a multiple of `pitch` above them (there are walls).
  scene::PolyCamera inside(std::int32_t pitch) {
    scene::PolyCamera camera = somewhere(true);
    for (std::size_t a = 0; a < 3; ++a) {
      do {
        camera.eye[a] = number(low_[a], high_[a]);
      } while ((camera.eye[a] - low_[a]) % pitch == 0);
    }
    return camera;
  }

 private:
  std::int32_t number(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(dice_() % (static_cast<std::uint32_t>(high - low) + 1));
  }

  bool inside_bounds(const scene::PolyPoint& p) const {
    bool inside = true;
    for (std::size_t a = 0; a < 3; ++a) inside = inside && low_[a] <= p[a] && p[a] <= high_[a];
    return inside;
  }

  scene::PolyCamera somewhere(bool perspective) {
    scene::PolyCamera camera;
    camera.perspective = perspective;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int32_t size = high_[a] - low_[a] + 1;
      camera.eye[a] = number(low_[a] - size, high_[a] + size);
    }
    scene::PolyPoint& f = camera.forward;
    do {
      for (std::int32_t& part : f) part = number(-3, 3);
    } while (f[0] == 0 && f[1] == 0);
    const scene::PolyPoint& r = camera.right = {f[1], -f[0], 0};
    camera.up = {r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2], r[0] * f[1] - r[1] * f[0]};
    return camera;
  }

  std::mt19937 dice_;
  scene::PolyPoint low_{};
  scene::PolyPoint high_{};
};

}  // namespace sightline::algorithms
