#include "host/algorithms/willis/frame.hpp"

#include <algorithm>
#include <tuple>

namespace sightline::algorithms::willis {

std::optional<std::string> plan_error(const Model& model, const scene::PolyCamera& camera) {
  if (!model.plan) return std::nullopt;
  if (!camera.perspective) {
    if (camera.forward[model.vertical] == 0) return std::nullopt;
    return "in plan the direction of view must be level";
  }
  const std::int32_t height = camera.eye[model.vertical];
  for (const Surface& wall : model.pieces) {
    if (height >= wall.low && height <= wall.high) continue;
    return std::string("in plan the eye must be between the feet and the tops of all walls: found ") +
           "xyz"[model.vertical] + " = " + std::to_string(height) + ", expected " + std::to_string(wall.low) +
           " to " + std::to_string(wall.high) + " of a wall";
  }
  return std::nullopt;
}

Frames::Frames(const Model& model) : model_(model) {
  plane_of_.reserve(model.pieces.size());
  firsts_.reserve(model.pieces.size());
  std::vector<std::uint32_t> numbers(model.pieces.size());
  for (std::uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
  // One test marks all pieces of a plane.
  const auto key = [&](std::uint32_t i) {
    const SurfacePlane& plane = model.pieces[i].plane;
    return std::tie(plane.normal, plane.offset);
  };
  std::sort(numbers.begin(), numbers.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  plane_of_.resize(numbers.size());
  for (const std::uint32_t i : numbers) {
    if (planes_.empty() || !(planes_.back() == model.pieces[i].plane))
      planes_.push_back(model.pieces[i].plane);
    plane_of_[i] = static_cast<std::uint32_t>(planes_.size() - 1);
  }
  for (const Surface& s : model.pieces) {
    firsts_.push_back(s.points[0]);
    cells_.push_back(s.cell);
  }
}

void Frames::mark_facing(const scene::PolyCamera& camera) {
  facing_.resize(planes_.size());
  const Vector3 eye = geometry::vector_of(camera.eye);
  const Vector3 forward = geometry::vector_of(camera.forward);
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    facing_[i] = camera.perspective ? geometry::dot(planes_[i].normal, eye) > planes_[i].offset
                                    : geometry::dot(planes_[i].normal, forward) < 0;
  }
}

template <class Nearness>
void Frames::make_keys(Representatives representatives, Nearness&& nearness) {
  keys_.clear();
  for (std::uint32_t i = 0; i < plane_of_.size(); ++i) {
    if (facing_[plane_of_[i]] == 0) continue;
    const Point& p = representatives.empty() ? firsts_[i] : model_.pieces[i].points[representatives[i]];
    keys_.push_back({nearness(p), ranks_[cells_[i]], i});
  }
}

std::span<const std::uint32_t> Frames::order(const scene::PolyCamera& camera,
                                             Representatives representatives) {
  mark_facing(camera);
  rank_cells(model_.cells, camera, ranks_);
  if (camera.perspective) {
    Point eye = on_lattice(camera.eye);
    if (model_.plan) eye[model_.vertical] = 0;
    make_keys(representatives, [&](const Point& p) { return ~squared_distance(eye, p); });
  } else {
    // The eye is infinitely far back: of two surfaces, the one less far along the view is nearer.
    const Vector3 forward = geometry::vector_of(camera.forward);
    make_keys(representatives, [&](const Point& p) {
      return ~(static_cast<std::uint64_t>(geometry::dot(forward, geometry::vector_of(p))) +
               (std::uint64_t{1} << 63));
    });
  }
  std::sort(keys_.begin(), keys_.end(), [](const Key& a, const Key& b) {
    return std::tie(a.cell, a.nearness, a.piece) < std::tie(b.cell, b.nearness, b.piece);
  });
  order_.clear();
  for (const Key& key : keys_) order_.push_back(key.piece);
  return order_;
}

}  // namespace sightline::algorithms::willis
