// Builds a PolyScene: equal points become one vertex, boxes become bodies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "host/scene/model/poly_scene.hpp"
#include "host/scene/model/vertex_pool.hpp"

namespace sightline::scene {

class PolyBuilder {
 public:
  PolyBuilder() : pool_(scene_.vertices) {}
  // The pool refers to the vertices of this builder's scene.
  PolyBuilder(const PolyBuilder& other) : scene_(other.scene_), pool_(scene_.vertices) { pool_.copy_table_of(other.pool_); }
  PolyBuilder& operator=(const PolyBuilder& other) {
    scene_ = other.scene_;
    pool_.copy_table_of(other.pool_);
    return *this;
  }

  // Reserves memory for so many bodies and vertices.
  void reserve(std::size_t bodies, std::size_t vertices) {
    scene_.bodies.reserve(bodies);
    scene_.vertices.reserve(vertices);
  }
  // Equal points have the same index. Every |coordinate| is below 2^20 (precondition).
  VertexIndex vertex(const PolyPoint& p) { return pool_.add(p); }
  // Adds a body with the six outward faces of low..high (low < high on every axis).
  void add_box(std::string name, const PolyPoint& low, const PolyPoint& high);
  // Adds a sheet of one face.
  void add_sheet(std::string name, std::span<const PolyPoint> outline);

  [[nodiscard]] PolyScene& scene() { return scene_; }
  // To be called once.
  [[nodiscard]] PolyScene take() { return std::move(scene_); }

 private:
  PolyScene scene_;
  VertexPool<std::int32_t> pool_;
};

}  // namespace sightline::scene
