// See poly_planes.hpp.
#include "host/scene/read/poly_planes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "host/base/radix_sort.hpp"
#include "host/base/threads.hpp"
#include "host/geometry/vector.hpp"

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
  Surfaces(PolyScene& scene, const MendResult& mended, const FileFaces& file, double tolerance, unsigned jobs)
      : scene_(scene), mended_(mended), file_(file), tolerance_(tolerance), jobs_(jobs) {}

  void run() {
    measure();
    link();
    group_of_.assign(planes_.size(), no_group);
    reached_.assign(planes_.size(), 0);
    scene_.surfaces.reserve(planes_.size());
    std::vector<std::uint32_t> seeds;  // of the surfaces
    seeds.reserve(planes_.size());
    for (const std::uint32_t source : by_area()) {
      if (group_of_[source] != no_group) continue;
      gather(source);
      seeds.push_back(source);
    }
    base::for_parts(jobs_, seeds.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s)
        if (may_grow_[seeds[s]] == 0) scene_.surfaces[s].normal = planes_[seeds[s]].normal;
    });
    scene_.surfaces.shrink_to_fit();
    scene_.surface_of.resize(mended_.faces.size());
    for (std::size_t f = 0; f < mended_.faces.size(); ++f) scene_.surface_of[f] = group_of_[mended_.faces[f].source];
  }

 private:
  void measure() {
    planes_.resize(file_.size());
    in_scene_.assign(planes_.size(), false);
    std::vector<bool> turned(planes_.size(), false);
    for (const MendedFace& face : mended_.faces) {
      in_scene_[face.source] = true;
      turned[face.source] = face.turned;
    }
    base::for_parts(jobs_, planes_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s)
        if (in_scene_[s]) planes_[s] = plane_of(file_.outline(s), turned[s]);
    });
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

  // The faces of the scene, the largest first; of equal ones the first in the file. Areas are not negative, so their bits have the
  // same order. The upper 32 bits are sorted by digits; a comparison sort orders the few faces that agree in these.
  [[nodiscard]] std::vector<std::uint32_t> by_area() const {
    struct Entry {
      std::uint32_t key = 0;
      std::uint32_t source = 0;
    };
    std::vector<Entry> entries;
    entries.reserve(planes_.size());
    const auto bits_of = [this](std::uint32_t source) { return ~std::bit_cast<std::uint64_t>(planes_[source].area); };
    for (std::uint32_t s = 0; s < planes_.size(); ++s)
      if (in_scene_[s]) entries.push_back({static_cast<std::uint32_t>(bits_of(s) >> 32U), s});
    base::radix_sort(entries, 0, 32, [](const Entry& entry) { return entry.key; }, jobs_);
    std::vector<std::uint32_t> order;
    order.reserve(entries.size());
    for (const Entry& entry : entries) order.push_back(entry.source);
    for (std::size_t first = 0; first < entries.size();) {
      std::size_t last = first + 1;
      while (last < entries.size() && entries[last].key == entries[first].key) ++last;
      const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = order.begin() + static_cast<std::ptrdiff_t>(last);
      const auto larger = [&](std::uint32_t a, std::uint32_t b) { return bits_of(a) != bits_of(b) ? bits_of(a) < bits_of(b) : a < b; };
      if (last - first > 1 && !std::is_sorted(begin, end, larger)) std::sort(begin, end, larger);
      first = last;
    }
    return order;
  }

  // Which faces of the file are next to each other.
  void link() {
    starts_.assign(planes_.size() + 1, 0);
    for (const auto& [a, b] : mended_.neighbours) {
      if (a == b) continue;
      ++starts_[a + 1];
      ++starts_[b + 1];
    }
    for (std::size_t s = 1; s < starts_.size(); ++s) starts_[s] += starts_[s - 1];
    next_to_.resize(starts_.back());
    std::vector<std::uint32_t> fill(starts_.begin(), starts_.end() - 1);
    for (const auto& [a, b] : mended_.neighbours) {
      if (a == b) continue;
      next_to_[fill[a]++] = b;
      next_to_[fill[b]++] = a;
    }
    // Tested here and not in gather(): in the order of the edges, neighbours are near each other in memory.
    std::vector<std::vector<std::uint8_t>> may_grow(jobs_, std::vector<std::uint8_t>(planes_.size(), 0));
    base::for_parts(jobs_, mended_.neighbours.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      std::vector<std::uint8_t>& grows = may_grow[part];
      for (std::size_t n = begin; n < end; ++n) {
        const auto [a, b] = mended_.neighbours[n];
        if (a == b) continue;
        if (grows[a] == 0 && joins(b, planes_[a])) grows[a] = 1;
        if (grows[b] == 0 && joins(a, planes_[b])) grows[b] = 1;
      }
    });
    may_grow_ = std::move(may_grow[0]);
    for (std::size_t part = 1; part < may_grow.size(); ++part)
      for (std::size_t s = 0; s < may_grow_.size(); ++s) may_grow_[s] |= may_grow[part][s];
  }

  [[nodiscard]] bool joins(std::uint32_t source, const FilePlane& plane) const {
    const FilePlane& mine = planes_[source];
    if (mine.height > tolerance_ && geometry::dot(mine.normal, plane.normal) <= 0) return false;
    for (const VertexIndex v : file_.outline(source))
      if (std::abs(geometry::dot(plane.normal, geometry::difference(file_.vertices[v], plane.on))) > tolerance_) return false;
    return true;
  }

  // Collects in `members` the faces without a group that are connected to the seed and lie in `plane`.
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

  // The mean plane of the members: their area-weighted normal, through the mean of their corners.
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

  // Adds the surface of a face. The normal is set later if no other face is on it.
  // The plane of a small face is inaccurate far away from it, so the mean plane of the group may contain more faces.
  void gather(std::uint32_t seed) {
    const auto group = static_cast<std::uint32_t>(scene_.surfaces.size());
    scene_.surfaces.emplace_back();
    group_of_[seed] = group;
    if (may_grow_[seed] == 0) return;
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
    scene_.surfaces.back().normal = plane.normal;
  }

  PolyScene& scene_;
  const MendResult& mended_;
  const FileFaces& file_;
  double tolerance_;
  unsigned jobs_;
  std::vector<FilePlane> planes_;  // of the faces of the file
  std::vector<bool> in_scene_;
  std::vector<std::uint32_t> starts_;  // of each face of the file in next_to_
  std::vector<std::uint32_t> next_to_;
  std::vector<std::uint8_t> may_grow_;  // 1 if a neighbour of the face is in its plane
  std::vector<std::uint32_t> group_of_;
  std::vector<std::uint32_t> reached_;  // by each face of the file: in which round
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> members_;
  std::vector<std::uint32_t> more_;
};

}  // namespace

void find_surfaces(PolyScene& scene, const MendResult& mended, const FileFaces& file, double tolerance, unsigned jobs) {
  Surfaces(scene, mended, file, tolerance, jobs).run();
}

}  // namespace sightline::scene
