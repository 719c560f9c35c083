// Puts a PolyScene together: equal points become one vertex, boxes become bodies.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

class PolyBuilder {
 public:
  // The same index for the same point. Every |coordinate| below 2^20.
  VertexIndex vertex(const PolyPoint& p);
  // A body with the six outward faces of low..high (low < high on every axis).
  void add_box(std::string name, const PolyPoint& low, const PolyPoint& high);
  // A sheet of one face.
  void add_sheet(std::string name, std::span<const PolyPoint> outline);

  [[nodiscard]] PolyScene& scene() { return scene_; }
  // Once.
  [[nodiscard]] PolyScene take() { return std::move(scene_); }

 private:
  PolyScene scene_;
  std::unordered_map<std::uint64_t, VertexIndex> indices_;
};

}  // namespace sightline::scene
