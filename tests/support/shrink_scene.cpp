// See shrink_scene.hpp.
#include "tests/support/shrink_scene.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "host/scene/model/eye_place.hpp"
#include "host/scene/check/poly_scene.hpp"

namespace sightline::tests {

namespace {

using scene::PolyBody;
using scene::PolyCamera;
using scene::PolyFace;
using scene::PolyPoint;
using scene::PolyScene;
using scene::VertexIndex;

// The size of a scene, most important component first. Every accepted step decreases it, so the loop ends.
using Size = std::array<std::uint64_t, 7>;

std::uint64_t length(const PolyPoint& p) {
  std::uint64_t sum = 0;
  for (const std::int32_t c : p)
    sum += static_cast<std::uint64_t>(2 * std::abs(std::int64_t{c})) + (c < 0 ? 1U : 0U);
  return sum;
}

Size size_of(const PolyScene& scene) {
  std::uint64_t faces = 0;
  std::uint64_t solids = 0;
  std::uint64_t corners = 0;
  std::uint64_t coordinates = length(scene.camera.eye);
  for (const PolyBody& body : scene.bodies) {
    faces += body.faces.size();
    solids += body.sheet ? 0U : 1U;
    for (const PolyFace& face : body.faces) {
      corners += face.outline.size();
      for (const auto& hole : face.holes) corners += hole.size();
    }
  }
  for (const PolyPoint& p : scene.vertices) coordinates += length(p);
  const PolyCamera& camera = scene.camera;
  return {scene.bodies.size() + scene.wires.size(),
          faces,
          corners,
          solids,
          camera.perspective ? 1U : 0U,
          length(camera.forward) + length(camera.right) + length(camera.up),
          coordinates};
}

// Removes unused vertices, merges equal ones, and numbers the others in order of use.
void tidy_vertices(PolyScene& scene) {
  std::map<PolyPoint, VertexIndex> numbers;
  std::vector<PolyPoint> kept;
  const auto rename = [&](scene::Ring& ring) {
    for (VertexIndex& v : ring) {
      const auto [at, is_new] = numbers.try_emplace(scene.vertices[v], static_cast<VertexIndex>(kept.size()));
      if (is_new) kept.push_back(scene.vertices[v]);
      v = at->second;
    }
  };
  for (PolyBody& body : scene.bodies) {
    for (PolyFace& face : body.faces) {
      rename(face.outline);
      for (auto& hole : face.holes) rename(hole);
    }
  }
  for (scene::PolyWire& wire : scene.wires) {
    scene::Ring ends(wire.begin(), wire.end());
    rename(ends);
    wire = {ends[0], ends[1]};
  }
  scene.vertices = std::move(kept);
}

template <class List>
void erase(List& list, std::size_t first, std::size_t count) {
  const auto at = list.begin() + static_cast<std::ptrdiff_t>(first);
  list.erase(at, at + static_cast<std::ptrdiff_t>(count));
}

class Shrinker {
 public:
  Shrinker(PolyScene scene, const ShowsDefect& shows_defect)
      : best_(std::move(scene)), size_(size_of(best_)), shows_defect_(shows_defect) {}

  PolyScene run() {
    Size before{};
    do {
      before = size_;
      leave_out_bodies();
      leave_out_parts();
      simplify_camera();
      move_everything();
      move_shared_coordinates();
      move_single_coordinates();
    } while (before != size_);
    return std::move(best_);
  }

 private:
  // Accepts the scene that `change` makes of the best one if it is smaller, valid, and shows the defect.
  template <class Change>
  bool attempt(Change change) {
    PolyScene candidate = best_;
    change(candidate);
    tidy_vertices(candidate);
    const Size size = size_of(candidate);
    if (!(size < size_) || !scene::check_poly_scene(candidate).empty() ||
        scene::eye_error(candidate, candidate.camera) || !shows_defect_(candidate))
      return false;
    best_ = std::move(candidate);
    size_ = size;
    return true;
  }

  // Removes half of the elements at a time, then a quarter, and so on: large scenes shrink quickly.
  template <class List>
  void leave_out_of(List list) {
    for (std::size_t count = (list(best_).size() + 1) / 2; count > 0; count /= 2) {
      for (std::size_t first = 0; first + count <= list(best_).size();) {
        if (!attempt([&](PolyScene& scene) { erase(list(scene), first, count); })) first += count;
      }
    }
  }

  void leave_out_bodies() {
    leave_out_of([](PolyScene& scene) -> std::vector<PolyBody>& { return scene.bodies; });
    leave_out_of([](PolyScene& scene) -> std::vector<scene::PolyWire>& { return scene.wires; });
  }

  void leave_out_parts() {
    for (std::size_t b = 0; b < best_.bodies.size(); ++b) {
      if (!best_.bodies[b].sheet) leave_out_solid(b);
      leave_out_of([b](PolyScene& scene) -> std::vector<PolyFace>& { return scene.bodies[b].faces; });
      for (std::size_t f = 0; f < best_.bodies[b].faces.size(); ++f) leave_out_corners(b, f);
    }
  }

  // Tries a sheet with one face less, which may lose more later; if none works, a sheet with all faces.
  void leave_out_solid(std::size_t b) {
    for (std::size_t f = 0; f < best_.bodies[b].faces.size(); ++f) {
      if (attempt([&](PolyScene& scene) {
            scene.bodies[b].sheet = true;
            erase(scene.bodies[b].faces, f, 1);
          }))
        return;
    }
    attempt([&](PolyScene& scene) { scene.bodies[b].sheet = true; });
  }

  void leave_out_corners(std::size_t b, std::size_t f) {
    const auto face_of = [b, f](PolyScene& scene) -> PolyFace& { return scene.bodies[b].faces[f]; };
    leave_out_of(
        [&](PolyScene& scene) -> std::vector<scene::Ring>& { return face_of(scene).holes; });
    leave_out_of([&](PolyScene& scene) -> scene::Ring& { return face_of(scene).outline; });
    for (std::size_t h = 0; h < face_of(best_).holes.size(); ++h)
      leave_out_of([&](PolyScene& scene) -> scene::Ring& { return face_of(scene).holes[h]; });
  }

  void simplify_camera() {
    attempt([](PolyScene& scene) { scene.camera.perspective = false; });
    for (std::size_t forward = 0; forward < 3; ++forward) {
      for (const std::int32_t sign : {1, -1}) {
        attempt([&](PolyScene& scene) {
          PolyCamera& camera = scene.camera;
          camera.forward = camera.right = camera.up = PolyPoint{};
          camera.forward[forward] = sign;
          camera.right[(forward + 1) % 3] = 1;
          camera.up[(forward + 2) % 3] = 1;
        });
      }
    }
  }

  void move_everything() {
    while (attempt([](PolyScene& scene) {
      for (PolyPoint& p : scene.vertices)
        for (std::int32_t& c : p) c /= 2;
      for (std::int32_t& c : scene.camera.eye) c /= 2;
    })) {
    }
    for (std::size_t a = 0; a < 3; ++a) {
      std::vector<std::int32_t> values = values_on(a);
      if (values.empty()) continue;
      for (const std::int32_t origin : {values.front(), values[values.size() / 2]}) {
        attempt([&](PolyScene& scene) {
          for (PolyPoint& p : scene.vertices) p[a] -= origin;
          scene.camera.eye[a] -= origin;
        });
      }
    }
  }

  // Ascending, each once.
  [[nodiscard]] std::vector<std::int32_t> values_on(std::size_t axis) const {
    std::set<std::int32_t> values;
    for (const PolyPoint& p : best_.vertices) values.insert(p[axis]);
    return {values.begin(), values.end()};
  }

  // Planes perpendicular to an axis stay planes when all their vertices move together.
  void move_shared_coordinates() {
    for (std::size_t a = 0; a < 3; ++a) {
      for (const std::int32_t value : values_on(a)) {
        make_smaller(value, [&](PolyScene& scene, std::int32_t smaller) {
          for (PolyPoint& p : scene.vertices)
            if (p[a] == value) p[a] = smaller;
          if (scene.camera.eye[a] == value) scene.camera.eye[a] = smaller;
        });
      }
    }
  }

  void move_single_coordinates() {
    for (std::size_t a = 0; a < 3; ++a) {
      make_smaller(best_.camera.eye[a],
                   [a](PolyScene& scene, std::int32_t smaller) { scene.camera.eye[a] = smaller; });
      for (std::size_t v = 0; v < best_.vertices.size(); ++v) {
        make_smaller(best_.vertices[v][a],
                     [a, v](PolyScene& scene, std::int32_t smaller) { scene.vertices[v][a] = smaller; });
      }
    }
  }

  // Tries the smallest first: 0, half, one less, and the opposite sign of a negative value.
  template <class Change>
  void make_smaller(std::int32_t value, Change change) {
    const std::int32_t step = value > 0 ? -1 : 1;
    for (const std::int32_t smaller : {0, value / 2, value + step, -value}) {
      if (attempt([&](PolyScene& scene) { change(scene, smaller); })) return;
    }
  }

  PolyScene best_;
  Size size_;
  const ShowsDefect& shows_defect_;
};

}  // namespace

PolyScene shrink_scene(PolyScene scene, const ShowsDefect& shows_defect) {
  scene.name.clear();
  scene.wires_on.clear();
  scene.step = 1;
  scene.origin = {};
  for (PolyBody& body : scene.bodies) body.name.clear();
  return Shrinker(std::move(scene), shows_defect).run();
}

}  // namespace sightline::tests
