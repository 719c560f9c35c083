// The work that Willis's method does for every frame: finding the surfaces turned to the eye and their distances.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/algorithms/willis/model.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

// The corner of each piece to which its distance is measured. Empty span: the first vertex of each piece is used.
using Representatives = std::span<const std::uint32_t>;

// Why this camera cannot view a model in plan (a roof or a floor would be visible); nullopt if it can.
[[nodiscard]] std::optional<std::string> plan_error(const Model& model, const scene::PolyCamera& camera);

// Computes frames of one model. order() overwrites the result of the last call; several threads need a Frames each.
class Frames {
 public:
  // The model must outlive this object.
  explicit Frames(const Model& model);

  // The pieces turned to the eye, in ascending priority. Within a cell, priority decreases with distance; pieces at equal
  // distances are ordered by number, which is correct because they cannot overlap. Precondition: the coordinates of the
  // eye are below poly_coordinate_limit.
  [[nodiscard]] std::span<const std::uint32_t> order(const scene::PolyCamera& camera,
                                                     Representatives representatives = {});

 private:
  struct Key {
    std::uint64_t nearness = 0;  // greater if nearer
    std::uint32_t cell = 0;      // rank
    std::uint32_t piece = 0;
  };

  void mark_facing(const scene::PolyCamera& camera);
  template <class Nearness>
  void make_keys(Representatives representatives, Nearness&& nearness);

  const Model& model_;
  std::vector<SurfacePlane> planes_;
  std::vector<std::uint32_t> plane_of_;  // by piece
  std::vector<Point> firsts_;            // by piece
  std::vector<std::uint32_t> cells_;     // by piece
  std::vector<std::uint8_t> facing_;     // by plane
  std::vector<std::uint32_t> ranks_;     // by cell
  std::vector<Key> keys_;
  std::vector<std::uint32_t> order_;
};

}  // namespace sightline::algorithms::willis
