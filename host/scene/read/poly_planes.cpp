// See poly_planes.hpp.
#include "host/scene/read/poly_planes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "host/geometry/vector.hpp"
#include "host/scene/model/edge_table.hpp"

namespace sightline::scene {
namespace {

using Vector = geometry::RealVector;

constexpr std::uint32_t no_group = std::numeric_limits<std::uint32_t>::max();

// A face of the file: its plane, and how wide it is across its longest side.
struct FilePlane {
  Vector normal{};  // of length 1, as the scene has the face turned; zero if it has no area
  Vector on{};
  double area = 0;   // twice
  double height = 0;  // twice the area over the longest side
};

class Surfaces {
 public:
  Surfaces(PolyScene& scene, const std::vector<MendedFace>& mended, const FileFaces& file, double tolerance)
      : scene_(scene), mended_(mended), file_(file), tolerance_(tolerance) {}

  void run() {
    measure();
    link();
    std::vector<std::uint32_t> order;
    for (std::uint32_t s = 0; s < planes_.size(); ++s)
      if (in_scene_[s]) order.push_back(s);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return planes_[a].area > planes_[b].area; });
    group_of_.assign(planes_.size(), no_group);
    reached_.assign(planes_.size(), 0);
    for (const std::uint32_t source : order)
      if (group_of_[source] == no_group) gather(source);
    scene_.surface_of.resize(mended_.size());
    for (std::size_t f = 0; f < mended_.size(); ++f) scene_.surface_of[f] = group_of_[mended_[f].source];
  }

 private:
  void measure() {
    planes_.resize(file_.size());
    in_scene_.assign(planes_.size(), false);
    std::vector<bool> turned(planes_.size(), false);
    for (const MendedFace& face : mended_) {
      in_scene_[face.source] = true;
      turned[face.source] = face.turned;
    }
    for (std::size_t s = 0; s < planes_.size(); ++s)
      if (in_scene_[s]) planes_[s] = plane_of(file_.outline(s), turned[s]);
  }

  [[nodiscard]] FilePlane plane_of(std::span<const VertexIndex> outline, bool turned) const {
    FilePlane plane;
    const Vector& first = file_.vertices[outline[0]];
    Vector sum{};
    Vector shift{};
    double longest = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector a = geometry::difference(file_.vertices[outline[i]], first);
      const Vector b = geometry::difference(file_.vertices[outline[i + 1 == outline.size() ? 0 : i + 1]], first);
      const Vector part = geometry::cross(a, b);
      for (std::size_t k = 0; k < 3; ++k) {
        sum[k] += part[k];
        shift[k] += a[k] / static_cast<double>(outline.size());
      }
      longest = std::max(longest, geometry::length(geometry::difference(b, a)));
    }
    plane.area = geometry::length(sum);
    plane.height = longest > 0 ? plane.area / longest : 0;
    for (std::size_t k = 0; k < 3; ++k) {
      plane.on[k] = first[k] + (outline.size() > 3 ? shift[k] : 0);
      if (plane.area > 0) plane.normal[k] = (turned ? -sum[k] : sum[k]) / plane.area;
    }
    return plane;
  }

  // Faces of the file next to each other: by an edge of the scene that has two faces, both of one body.
  void link() {
    const EdgeTable edges(scene_);
    std::vector<std::uint32_t> body_of;
    body_of.reserve(mended_.size());
    for (std::uint32_t b = 0; b < scene_.bodies.size(); ++b) body_of.insert(body_of.end(), scene_.bodies[b].faces.size(), b);
    const auto for_pairs = [&](auto visit) {
      for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto uses = edges.uses(e);
        if (uses.size() != 2 || body_of[uses[0].face] != body_of[uses[1].face]) continue;
        const std::uint32_t a = mended_[uses[0].face].source;
        const std::uint32_t b = mended_[uses[1].face].source;
        if (a != b) visit(a, b);
      }
    };
    starts_.assign(planes_.size() + 1, 0);
    for_pairs([&](std::uint32_t a, std::uint32_t b) {
      ++starts_[a + 1];
      ++starts_[b + 1];
    });
    for (std::size_t s = 1; s < starts_.size(); ++s) starts_[s] += starts_[s - 1];
    next_to_.resize(starts_.back());
    std::vector<std::uint32_t> fill(starts_.begin(), starts_.end() - 1);
    for_pairs([&](std::uint32_t a, std::uint32_t b) {
      next_to_[fill[a]++] = b;
      next_to_[fill[b]++] = a;
    });
  }

  [[nodiscard]] bool joins(std::uint32_t source, const FilePlane& plane) const {
    const FilePlane& mine = planes_[source];
    if (mine.height > tolerance_ && geometry::dot(mine.normal, plane.normal) <= 0) return false;
    for (const VertexIndex v : file_.outline(source))
      if (std::abs(geometry::dot(plane.normal, geometry::difference(file_.vertices[v], plane.on))) > tolerance_) return false;
    return true;
  }

  // Those of no group that `plane` takes in, from the seed on, into `members`.
  void flood(std::uint32_t seed, const FilePlane& plane, std::vector<std::uint32_t>& members) {
    ++round_;
    reached_[seed] = round_;
    members.assign(1, seed);
    for (std::size_t m = 0; m < members.size(); ++m) {
      const std::uint32_t source = members[m];
      for (std::uint32_t n = starts_[source]; n < starts_[source + 1]; ++n) {
        const std::uint32_t other = next_to_[n];
        if (group_of_[other] != no_group || reached_[other] == round_ || !joins(other, plane)) continue;
        reached_[other] = round_;
        members.push_back(other);
      }
    }
  }

  // The plane of all of them: the sum of their areas, through the middle of their corners.
  [[nodiscard]] FilePlane mean_plane(const std::vector<std::uint32_t>& members) const {
    FilePlane mean;
    std::size_t corners = 0;
    const Vector& first = planes_[members[0]].on;
    for (const std::uint32_t source : members) {
      for (std::size_t k = 0; k < 3; ++k) mean.normal[k] += planes_[source].area * planes_[source].normal[k];
      for (const VertexIndex v : file_.outline(source)) {
        for (std::size_t k = 0; k < 3; ++k) mean.on[k] += file_.vertices[v][k] - first[k];
        ++corners;
      }
    }
    mean.area = geometry::length(mean.normal);
    for (std::size_t k = 0; k < 3; ++k) {
      if (mean.area > 0) mean.normal[k] /= mean.area;
      mean.on[k] = first[k] + mean.on[k] / static_cast<double>(corners);
    }
    return mean;
  }

  // A small face says its plane badly far away, so that the group's own plane may take in more than it began with.
  void gather(std::uint32_t seed) {
    const auto group = static_cast<std::uint32_t>(scene_.surfaces.size());
    FilePlane plane = planes_[seed];
    members_.assign(1, seed);
    if (plane.area > 0) {
      flood(seed, plane, members_);
      constexpr int most_rounds = 16;
      for (int i = 0; i < most_rounds && members_.size() > 1; ++i) {
        const FilePlane mean = mean_plane(members_);
        if (mean.area <= 0 || !joins(seed, mean)) break;
        flood(seed, mean, more_);
        if (more_.size() <= members_.size()) break;
        members_.swap(more_);
        plane = mean;
      }
    }
    for (const std::uint32_t source : members_) group_of_[source] = group;
    scene_.surfaces.push_back({plane.normal});
  }

  PolyScene& scene_;
  const std::vector<MendedFace>& mended_;
  const FileFaces& file_;
  double tolerance_;
  std::vector<FilePlane> planes_;  // of the faces of the file
  std::vector<bool> in_scene_;
  std::vector<std::uint32_t> starts_;  // of each face of the file in next_to_
  std::vector<std::uint32_t> next_to_;
  std::vector<std::uint32_t> group_of_;
  std::vector<std::uint32_t> reached_;  // by each face of the file: in which round
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> members_;
  std::vector<std::uint32_t> more_;
};

}  // namespace

void find_surfaces(PolyScene& scene, const std::vector<MendedFace>& mended, const FileFaces& file, double tolerance) {
  Surfaces(scene, mended, file, tolerance).run();
}

}  // namespace sightline::scene
