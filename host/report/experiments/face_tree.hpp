// A BSP tree of the faces of a scene, after H. Fuchs, Z. M. Kedem and B. F. Naylor, "On visible surface generation by a priori tree
// structures", Computer Graphics 14(3), 1980: the method with which Plantinga, Seales and Dyer (1990) compare theirs. The trees of
// Schumacker, which Willis (1977) calls time-consuming to scan, have planes between clusters of faces.
//
// The tree is made once, of the planes of faces, which cut other faces (host/scene/cells/bsp). Each view scans the whole tree and
// paints every polygon that is turned to the eye, the farthest first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/scene/cells/bsp/tree.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::report {

class FaceTree {
 public:
  // x, y, z, 1; in parallel projection the direction towards the eye, and 0.
  using Eye = std::array<double, 4>;

  // The scene is a checked one with at least one face.
  explicit FaceTree(const scene::PolyScene& scene);

  // Each has a plane, which every view compares with the eye.
  [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }
  // Convex parts of faces.
  [[nodiscard]] const std::vector<scene::FacePiece>& polygons() const { return polygons_; }
  [[nodiscard]] const scene::Planes& planes() const { return planes_; }

  // Replaces `order` by the numbers of the polygons turned to the eye, the farthest first. A sheet has two sides.
  void paint(const Eye& eye, std::vector<std::uint32_t>& order) const;

 private:
  static constexpr std::uint32_t leaf = scene::no_node;

  // Everything that a scan reads, in the order of the tree.
  struct Node {
    std::array<double, 4> plane{};            // normal, and -offset
    std::array<std::uint32_t, 2> children{};  // behind, in front; or `leaf`
    std::uint32_t first = 0;                  // of its polygons, of those seen from the front
    std::uint32_t first_behind = 0;           // of those seen from behind
    std::uint32_t end = 0;
  };

  scene::Planes planes_;
  std::vector<scene::FacePiece> polygons_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> seen_;  // polygons by node and side; those of sheets twice
};

}  // namespace sightline::report
