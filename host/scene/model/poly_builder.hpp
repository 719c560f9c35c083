// Puts a PolyScene together: equal points become one vertex, boxes become bodies.
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
  // The pool refers to the vertices of its own scene.
  PolyBuilder(const PolyBuilder& other) : scene_(other.scene_), pool_(scene_.vertices) { pool_.place_as(other.pool_); }
  PolyBuilder& operator=(const PolyBuilder& other) {
    scene_ = other.scene_;
    pool_.place_as(other.pool_);
    return *this;
  }

  // Room for so many bodies and vertices.
  void reserve(std::size_t bodies, std::size_t vertices) {
    scene_.bodies.reserve(bodies);
    scene_.vertices.reserve(vertices);
  }
  // The same index for the same point. Every |coordinate| below 2^20.
  VertexIndex vertex(const PolyPoint& p) { return pool_.add(p); }
  // A body with the six outward faces of low..high (low < high on every axis).
  void add_box(std::string name, const PolyPoint& low, const PolyPoint& high);
  // A sheet of one face.
  void add_sheet(std::string name, std::span<const PolyPoint> outline);

  [[nodiscard]] PolyScene& scene() { return scene_; }
  // Once.
  [[nodiscard]] PolyScene take() { return std::move(scene_); }

 private:
  PolyScene scene_;
  VertexPool<std::int32_t> pool_;
};

}  // namespace sightline::scene
