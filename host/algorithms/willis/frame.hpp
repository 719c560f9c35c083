// What Willis leaves to be done for every frame: which surfaces are turned to the eye, and how far they are.
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

// Which corner of each piece its distance is measured to. Empty span: the first vertex of each.
using Representatives = std::span<const std::uint32_t>;

// Why this camera cannot view a model in plan: a roof or a floor would be visible. Empty if it can.
[[nodiscard]] std::optional<std::string> plan_error(const Model& model, const scene::PolyCamera& camera);

// One model, many frames. A frame's order is written over the last one's; several threads need one each.
class Frames {
 public:
  // The model outlives this.
  explicit Frames(const Model& model);

  // The pieces turned to the eye, the least priority first: the place in the order is the priority. Within a
  // cell the priority falls as the distance grows; pieces that are equally far are ordered by number,
  // which may be done as they cannot overlap. The camera's eye is below poly_coordinate_limit.
  [[nodiscard]] std::span<const std::uint32_t> order(const scene::PolyCamera& camera,
                                                     Representatives representatives = {});

 private:
  struct Key {
    std::uint64_t nearness = 0;  // larger if nearer
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
