// See poly_planes.hpp.
#include "host/scene/read/poly_planes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "host/base/radix_sort.hpp"
#include "host/base/threads.hpp"
#include "host/geometry/vector.hpp"

namespace sightline::scene {
namespace {

using Vector = geometry::RealVector;

constexpr std::uint32_t no_group = std::numeric_limits<std::uint32_t>::max();

// What is measured of a face of the file.
struct FileFace {
  Vector normal{};    // of length 1, as the scene has the face turned; zero if it has no area
  double area = 0;    // twice
  double height = 0;  // twice the area over the longest side
};

struct FilePlane {
  Vector normal{};  // of length 1
  Vector on{};
};

class Surfaces {
 public:
  Surfaces(PolyScene& scene, const MendResult& mended, const FileFaces& file, double tolerance, unsigned jobs)
      : scene_(scene), mended_(mended), file_(file), tolerance_(tolerance), jobs_(jobs) {}

  void run() {
    measure();
    find_growing();
    group_of_.assign(faces_.size(), no_group);
    if (std::find(may_grow_.begin(), may_grow_.end(), 1) != may_grow_.end()) {
      link();
      reached_.assign(faces_.size(), 0);
      for (const std::uint32_t source : by_area())
        if (group_of_[source] == no_group) gather(source);
    }
    number_surfaces();
  }

 private:
  void measure() {
    faces_.resize(file_.size());
    in_scene_.assign(faces_.size(), false);
    std::vector<bool> turned(faces_.size(), false);
    for (const MendedFace& face : mended_.faces) {
      in_scene_[face.source] = true;
      turned[face.source] = face.turned;
    }
    base::for_parts(jobs_, faces_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s)
        if (in_scene_[s]) faces_[s] = measured(file_.outline(s), turned[s]);
    });
  }

  [[nodiscard]] FileFace measured(std::span<const VertexIndex> outline, bool turned) const {
    FileFace face;
    const Vector& first = file_.vertices[outline[0]];
    Vector sum{};
    double longest = 0;  // squared
    Vector a{};
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector b = geometry::difference(file_.vertices[outline[i + 1 == outline.size() ? 0 : i + 1]], first);
      const Vector part = geometry::cross(a, b);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += part[k];
      const Vector side = geometry::difference(b, a);
      longest = std::max(longest, geometry::dot(side, side));
      a = b;
    }
    face.area = geometry::length(sum);
    face.height = longest > 0 ? face.area / std::sqrt(longest) : 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (face.area > 0) face.normal[k] = (turned ? -sum[k] : sum[k]) / face.area;
    return face;
  }

  // Of a triangle through its first corner, of others through the mean of all.
  [[nodiscard]] FilePlane plane_of(std::uint32_t source) const {
    const auto outline = file_.outline(source);
    const Vector& first = file_.vertices[outline[0]];
    FilePlane plane{faces_[source].normal, first};
    if (outline.size() == 3) return plane;
    Vector shift{};
    for (const VertexIndex v : outline)
      for (std::size_t k = 0; k < 3; ++k) shift[k] += (file_.vertices[v][k] - first[k]) / static_cast<double>(outline.size());
    for (std::size_t k = 0; k < 3; ++k) plane.on[k] += shift[k];
    return plane;
  }

  // Which faces have a neighbour in their plane: all others are in no group unless another face takes them into its own.
  void find_growing() {
    std::vector<std::vector<std::uint8_t>> may_grow(jobs_, std::vector<std::uint8_t>(faces_.size(), 0));
    base::for_parts(jobs_, mended_.neighbours.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      std::vector<std::uint8_t>& grows = may_grow[part];
      for (std::size_t n = begin; n < end; ++n) {
        const auto [a, b] = mended_.neighbours[n];
        if (a == b) continue;
        if (grows[a] == 0 && is_turned_like(b, faces_[a].normal) && is_in(b, plane_of(a))) grows[a] = 1;
        if (grows[b] == 0 && is_turned_like(a, faces_[b].normal) && is_in(a, plane_of(b))) grows[b] = 1;
      }
    });
    may_grow_ = std::move(may_grow[0]);
    for (std::size_t part = 1; part < may_grow.size(); ++part)
      for (std::size_t s = 0; s < may_grow_.size(); ++s) may_grow_[s] |= may_grow[part][s];
  }

  // Areas are not negative, so their bits have the same order.
  [[nodiscard]] std::uint64_t area_bits(std::uint32_t source) const { return ~std::bit_cast<std::uint64_t>(faces_[source].area); }

  // Whether a face is before another one in the order in which groups begin: the largest first, of equal ones the first in the file.
  [[nodiscard]] bool is_before(std::uint32_t a, std::uint32_t b) const {
    return area_bits(a) != area_bits(b) ? area_bits(a) < area_bits(b) : a < b;
  }

  // The faces that may grow, in this order. The upper 32 bits are sorted by digits; a comparison sort orders the few faces that agree
  // in these.
  [[nodiscard]] std::vector<std::uint32_t> by_area() const {
    struct Entry {
      std::uint32_t key = 0;
      std::uint32_t source = 0;
    };
    std::vector<Entry> entries;
    for (std::uint32_t s = 0; s < faces_.size(); ++s)
      if (may_grow_[s] != 0) entries.push_back({static_cast<std::uint32_t>(area_bits(s) >> 32U), s});
    base::radix_sort(entries, 0, 32, [](const Entry& entry) { return entry.key; }, jobs_);
    std::vector<std::uint32_t> order;
    order.reserve(entries.size());
    for (const Entry& entry : entries) order.push_back(entry.source);
    for (std::size_t first = 0; first < entries.size();) {
      std::size_t last = first + 1;
      while (last < entries.size() && entries[last].key == entries[first].key) ++last;
      const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end = order.begin() + static_cast<std::ptrdiff_t>(last);
      const auto before = [this](std::uint32_t a, std::uint32_t b) { return is_before(a, b); };
      if (last - first > 1 && !std::is_sorted(begin, end, before)) std::sort(begin, end, before);
      first = last;
    }
    return order;
  }

  // Which faces of the file are next to each other.
  void link() {
    starts_.assign(faces_.size() + 1, 0);
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
  }

  [[nodiscard]] bool is_turned_like(std::uint32_t source, const Vector& normal) const {
    return !(faces_[source].height > tolerance_ && geometry::dot(faces_[source].normal, normal) <= 0);
  }

  [[nodiscard]] bool is_in(std::uint32_t source, const FilePlane& plane) const {
    for (const VertexIndex v : file_.outline(source))
      if (std::abs(geometry::dot(plane.normal, geometry::difference(file_.vertices[v], plane.on))) > tolerance_) return false;
    return true;
  }

  // Collects in `members` the faces without a group that are connected to the seed and lie in `plane`. A face that cannot grow and is
  // before the seed is a group of its own.
  void flood(std::uint32_t seed, const FilePlane& plane, std::vector<std::uint32_t>& members) {
    ++round_;
    reached_[seed] = round_;
    members.assign(1, seed);
    for (std::size_t m = 0; m < members.size(); ++m) {
      const std::uint32_t source = members[m];
      for (std::uint32_t n = starts_[source]; n < starts_[source + 1]; ++n) {
        const std::uint32_t other = next_to_[n];
        if (group_of_[other] != no_group || reached_[other] == round_ || (may_grow_[other] == 0 && is_before(other, seed))) continue;
        if (!is_turned_like(other, plane.normal) || !is_in(other, plane)) continue;
        reached_[other] = round_;
        members.push_back(other);
      }
    }
  }

  // The mean plane of the members: their area-weighted normal, through the mean of their corners.
  // Empty if they have no area.
  [[nodiscard]] std::optional<FilePlane> mean_plane(const std::vector<std::uint32_t>& members) const {
    FilePlane mean;
    std::size_t corners = 0;
    const Vector first = plane_of(members[0]).on;
    for (const std::uint32_t source : members) {
      for (std::size_t k = 0; k < 3; ++k) mean.normal[k] += faces_[source].area * faces_[source].normal[k];
      for (const VertexIndex v : file_.outline(source)) {
        for (std::size_t k = 0; k < 3; ++k) mean.on[k] += file_.vertices[v][k] - first[k];
        ++corners;
      }
    }
    const double area = geometry::length(mean.normal);
    if (area <= 0) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) {
      mean.normal[k] /= area;
      mean.on[k] = first[k] + mean.on[k] / static_cast<double>(corners);
    }
    return mean;
  }

  // Finds the group that a face begins. The plane of a small face is inaccurate far away from it, so the mean plane of the group may
  // contain more faces.
  void gather(std::uint32_t seed) {
    if (faces_[seed].area <= 0) return;
    Vector normal = faces_[seed].normal;
    flood(seed, plane_of(seed), members_);
    constexpr int most_rounds = 16;
    for (int i = 0; i < most_rounds && members_.size() > 1; ++i) {
      const std::optional<FilePlane> mean = mean_plane(members_);
      if (!mean || !is_turned_like(seed, mean->normal) || !is_in(seed, *mean)) break;
      flood(seed, *mean, more_);
      if (more_.size() <= members_.size()) break;
      members_.swap(more_);
      normal = mean->normal;
    }
    faces_[seed].normal = normal;
    for (const std::uint32_t source : members_) group_of_[source] = seed;
  }

  // In the order of their first faces in the scene. A face without a group is a surface.
  void number_surfaces() {
    std::vector<std::uint32_t> number(faces_.size(), no_group);  // by the face that begins the group
    std::uint32_t count = 0;
    scene_.surface_of.reserve(mended_.faces.size());
    for (const MendedFace& face : mended_.faces) {
      const std::uint32_t first = group_of_[face.source] == no_group ? face.source : group_of_[face.source];
      if (number[first] == no_group) number[first] = count++;
      scene_.surface_of.push_back(number[first]);
    }
    scene_.surfaces.resize(count);
    for (std::size_t s = 0; s < number.size(); ++s)
      if (number[s] != no_group) scene_.surfaces[number[s]].normal = faces_[s].normal;
  }

  PolyScene& scene_;
  const MendResult& mended_;
  const FileFaces& file_;
  double tolerance_;
  unsigned jobs_;
  std::vector<FileFace> faces_;  // of the file
  std::vector<bool> in_scene_;
  std::vector<std::uint32_t> starts_;  // of each face of the file in next_to_
  std::vector<std::uint32_t> next_to_;
  std::vector<std::uint8_t> may_grow_;  // 1 if a neighbour of the face is in its plane
  std::vector<std::uint32_t> group_of_;  // of each face of the file: the one that begins its group
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
