// See line_union.hpp.
#include "host/picture/line_union.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

#include "host/geometry/predicates.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/scene/model/face_cut.hpp"

namespace sightline::picture {
namespace {

using SightPoint = std::array<double, 3>;
using geometry::Int128;

double length(const scene::PolyPoint& v) {
  return std::sqrt(static_cast<double>(geometry::dot(geometry::vector_of(v), geometry::vector_of(v))));
}

double dot(const SightPoint& a, const scene::PolyPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A plane through the eye, so a line of the image: normal and offset, in lowest terms, the first that is not zero positive.
using LineKey = std::array<Int128, 4>;

LineKey lowest_terms(LineKey key) {
  Int128 divisor = 0;
  for (const Int128 part : key) divisor = geometry::common_divisor(divisor, part);
  if (divisor == 0) return key;
  const auto leading = std::find_if(key.begin(), key.end(), [](Int128 part) { return part != 0; });
  if (*leading < 0) divisor = -divisor;
  for (Int128& part : key) part /= divisor;
  return key;
}

std::uint64_t hash_of(const LineKey& key) {
  std::uint64_t hash = 0;
  for (const Int128 part : key) {
    for (const std::uint64_t half : {static_cast<std::uint64_t>(part), static_cast<std::uint64_t>(part >> 64)}) {
      hash = (hash ^ half) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29U;
    }
  }
  return hash;
}

class LineUnion {
 public:
  LineUnion(std::span<const LineLayer> layers, const scene::PolyScene& scene, const scene::PolyCamera& camera)
      : layers_(layers),
        scene_(scene),
        camera_(camera),
        lengths_{length(camera.right), length(camera.up), length(camera.forward)} {
    // Planes of faces are wanted by number where there are crossings.
    if (scene.crossings.empty()) return;
    for (const scene::PolyBody& body : scene.bodies)
      for (const scene::PolyFace& face : body.faces) faces_.push_back(&face);
  }

  UnitedLines run() {
    std::size_t pieces = 0;
    for (const LineLayer& layer : layers_) pieces += layer.picture.pieces.size();
    items_.reserve(pieces);
    by_line_.reserve(pieces);
    for (std::uint32_t layer = 0; layer < layers_.size(); ++layer) take(layer);
    std::sort(by_line_.begin(), by_line_.end());
    std::vector<std::uint32_t> run;
    for (std::size_t i = 0; i < by_line_.size();) {
      run.clear();
      const std::uint64_t hash = by_line_[i].first;
      for (; i < by_line_.size() && by_line_[i].first == hash; ++i) run.push_back(by_line_[i].second);
      unite_equal_hashes(run);
    }
    return std::move(result_);
  }

 private:
  struct Item {
    const LinePiece* piece = nullptr;
    std::uint32_t layer = 0;
  };
  // Of an item on its line of the image.
  struct End {
    std::uint32_t item = 0;
    bool high = false;  // of the piece's parameters
    SightPoint at{};
    double place = 0;      // along the line
    double tolerance = 0;  // of `place`: beyond it, doubles decide
  };
  struct Span {
    std::uint32_t item = 0;
    std::uint32_t low = 0;  // ranks of its ends
    std::uint32_t high = 0;
  };

  [[nodiscard]] bool is_crossing(const LineEdge& edge) const {
    return !scene_.crossings.empty() && edge.from >= scene_.crossings.front().from;
  }

  [[nodiscard]] LineKey key_of(const LineEdge& edge) const {
    if (is_crossing(edge)) return crossing_key(scene_.crossings[(edge.from - scene_.crossings.front().from) / 2]);
    const std::array<std::int64_t, 4> line = image_line(edge, scene_, camera_);
    return {line[0], line[1], line[2], line[3]};
  }

  // A combination of the line's two planes that is zero at the eye. A line drawn on one face was cut by a plane of sight.
  [[nodiscard]] LineKey crossing_key(const scene::PolyCrossing& crossing) const {
    const bool on_face = crossing.face_a == crossing.face_b;
    const geometry::Plane b = on_face ? scene_.cut_planes[crossing.plane] : plane_of(crossing.face_b);
    if (on_face) return lowest_terms({b.normal[0], b.normal[1], b.normal[2], camera_.perspective ? 0 : b.offset});
    const geometry::Plane a = plane_of(crossing.face_a);
    const geometry::Vector3 forward = geometry::vector_of(camera_.forward);
    const auto at_eye = [&](const geometry::Plane& plane) {
      return camera_.perspective ? Int128{plane.at(camera_.eye)} : geometry::wide_dot(plane.normal, forward);
    };
    // Common factors first: normals have 39 bits, the values 60.
    Int128 of_a = at_eye(b);
    Int128 of_b = at_eye(a);
    if (const Int128 divisor = geometry::common_divisor(of_a, of_b); divisor != 0) {
      of_a /= divisor;
      of_b /= divisor;
    }
    LineKey key{};
    for (std::size_t i = 0; i < 3; ++i) key[i] = a.normal[i] * of_a - b.normal[i] * of_b;
    if (!camera_.perspective) key[3] = a.offset * of_a - b.offset * of_b;
    return lowest_terms(key);
  }

  [[nodiscard]] geometry::Plane plane_of(std::uint32_t face) const {
    return scene::plane_of(scene_.vertices, *faces_[face]);
  }

  void take(std::uint32_t layer) {
    LineEdge known{};
    bool is_point = true;
    std::uint64_t hash = 0;
    for (const LinePiece& piece : layers_[layer].picture.pieces) {
      if (piece.edge != known) {
        known = piece.edge;
        const LineKey key = key_of(known);
        is_point = key[0] == 0 && key[1] == 0 && key[2] == 0;
        hash = hash_of(key);
      }
      if (is_point) continue;
      by_line_.emplace_back(hash, static_cast<std::uint32_t>(items_.size()));
      items_.push_back({&piece, layer});
    }
  }

  void unite_equal_hashes(const std::vector<std::uint32_t>& run) {
    const LineEdge& first = items_[run[0]].piece->edge;
    const bool one_edge = std::all_of(run.begin(), run.end(), [&](std::uint32_t i) { return items_[i].piece->edge == first; });
    if (one_edge) {
      // Its pieces share no stretch.
      for (const std::uint32_t i : run) add_line(end_of(i, false), end_of(i, true), items_[i].layer, std::span(&first, 1));
      return;
    }
    // Different lines with one hash are next to impossible.
    std::vector<std::uint32_t> rest = run;
    while (!rest.empty()) {
      const LineKey key = key_of(items_[rest[0]].piece->edge);
      std::vector<std::uint32_t> same;
      std::vector<std::uint32_t> others;
      for (const std::uint32_t i : rest) (key_of(items_[i].piece->edge) == key ? same : others).push_back(i);
      unite(same, key);
      rest = std::move(others);
    }
  }

  // Of a point of an edge: from + s (to - from).
  [[nodiscard]] SightPoint end_of(std::uint32_t item, bool high) const {
    const LinePiece& piece = *items_[item].piece;
    const double s = (high ? piece.high : piece.low).to_double();
    const SightPoint from = scene::place_of(scene_, piece.edge.from);
    const SightPoint to = scene::place_of(scene_, piece.edge.to);
    SightPoint d{};
    for (std::size_t a = 0; a < 3; ++a) d[a] = (s == 1 ? to[a] : from[a] + s * (to[a] - from[a])) - camera_.eye[a];
    return {dot(d, camera_.right) / lengths_[0], dot(d, camera_.up) / lengths_[1],
            camera_.perspective ? dot(d, camera_.forward) / lengths_[2] : 1};
  }

  void add_line(const SightPoint& from, const SightPoint& to, std::uint32_t layer, std::span<const LineEdge> sources) {
    result_.lines.push_back({from, to, layer, static_cast<std::uint32_t>(result_.sources.size()),
                             static_cast<std::uint32_t>(sources.size())});
    result_.sources.insert(result_.sources.end(), sources.begin(), sources.end());
  }

  // The axis, right or up, along which a line of the image is longer.
  [[nodiscard]] std::size_t axis_of(const LineKey& key) const {
    std::array<double, 3> normal{};
    for (std::size_t i = 0; i < 3; ++i) normal[i] = static_cast<double>(key[i]);
    return std::abs(dot(normal, camera_.up)) * lengths_[0] >= std::abs(dot(normal, camera_.right)) * lengths_[1] ? 0 : 1;
  }

  [[nodiscard]] End placed_end(std::uint32_t item, bool high, std::size_t axis) const {
    // The places are computed to about 10^-10 of a step.
    constexpr double error = 1e-9;
    constexpr double least_depth = 1e-8;
    End end{item, high, end_of(item, high)};
    const double depth = end.at[2];
    if (depth > least_depth) {
      end.place = end.at[axis] / depth;
      end.tolerance = error * (1 + std::abs(end.place)) / std::min(depth, 1.0);
    } else {
      end.tolerance = std::numeric_limits<double>::infinity();
      end.place = std::copysign(end.tolerance, end.at[axis]);
    }
    return end;
  }

  // Negative, zero or positive; of ends of edges between vertices.
  [[nodiscard]] int compare_exactly(const End& a, const End& b, std::size_t axis) const {
    const LinePiece& m = *items_[a.item].piece;
    const LinePiece& n = *items_[b.item].piece;
    const geometry::Rational& s = a.high ? m.high : m.low;
    const geometry::Rational& t = b.high ? n.high : n.low;
    const auto vertex = [](const LinePiece& piece, const geometry::Rational& r) {
      return r == geometry::Rational(0) ? piece.edge.from : piece.edge.to;
    };
    if (s.denominator() == 1 && t.denominator() == 1 && vertex(m, s) == vertex(n, t)) return 0;
    return compare(image_coordinate(m.edge, s, axis, scene_, camera_), image_coordinate(n.edge, t, axis, scene_, camera_));
  }

  // Sorts the ends along the line and numbers their places; equal places have one number.
  std::vector<std::uint32_t> ranked(std::vector<End>& ends, std::size_t axis) const {
    std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.place < b.place; });
    const auto near = [&](std::size_t i) {
      return !(ends[i].place - ends[i - 1].place > std::max(ends[i].tolerance, ends[i - 1].tolerance));
    };
    std::vector<std::uint32_t> ranks(ends.size());
    std::uint32_t rank = 0;
    for (std::size_t begin = 0; begin < ends.size();) {
      std::size_t end = begin + 1;
      while (end < ends.size() && near(end)) ++end;
      const auto first = ends.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto last = ends.begin() + static_cast<std::ptrdiff_t>(end);
      const bool exact = std::none_of(first, last, [this](const End& e) { return is_crossing(items_[e.item].piece->edge); });
      if (exact && end - begin > 1)
        std::stable_sort(first, last, [&](const End& a, const End& b) { return compare_exactly(a, b, axis) < 0; });
      for (std::size_t i = begin; i < end; ++i) {
        bool same = i > begin;
        if (same && exact) same = compare_exactly(ends[i - 1], ends[i], axis) == 0;
        if (same && !exact) {
          const double a = ends[i - 1].place;
          const double b = ends[i].place;
          same = a == b || b - a <= 1e-9 * (1 + std::abs(a));
        }
        if (i > 0 && !same) ++rank;
        ranks[i] = rank;
      }
      begin = end;
    }
    return ranks;
  }

  void unite(const std::vector<std::uint32_t>& items, const LineKey& key) {
    const std::size_t axis = axis_of(key);
    std::vector<End> ends;
    for (const std::uint32_t i : items)
      for (const bool high : {false, true}) ends.push_back(placed_end(i, high, axis));
    const std::vector<std::uint32_t> ranks = ranked(ends, axis);
    std::vector<SightPoint> places;  // of each rank
    std::vector<Span> spans(items.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> number_of;  // of an item, among `items`
    for (std::uint32_t i = 0; i < items.size(); ++i) number_of.emplace_back(items[i], i);
    std::sort(number_of.begin(), number_of.end());
    for (std::size_t e = 0; e < ends.size(); ++e) {
      if (ranks[e] == places.size()) places.push_back(ends[e].at);
      const auto found = std::lower_bound(number_of.begin(), number_of.end(), std::pair(ends[e].item, std::uint32_t{0}));
      Span& span = spans[found->second];
      const bool seen = span.item == ends[e].item + 1;
      span.item = ends[e].item + 1;  // until all are known, 0 is none
      (seen ? span.high : span.low) = ranks[e];
    }
    for (Span& span : spans) --span.item;
    spans.erase(std::remove_if(spans.begin(), spans.end(), [](const Span& span) { return span.low == span.high; }), spans.end());
    sweep(spans, places);
  }

  // A stretch from rank to rank that one layer keeps.
  struct Stretch {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t layer = 0;
  };

  void sweep(const std::vector<Span>& spans, const std::vector<SightPoint>& places) {
    struct Event {
      std::uint32_t rank;
      bool begins;
      std::uint32_t layer;
    };
    std::vector<Event> events;
    for (const Span& span : spans) {
      events.push_back({span.low, true, items_[span.item].layer});
      events.push_back({span.high, false, items_[span.item].layer});
    }
    std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.rank < b.rank; });
    std::vector<Stretch> stretches;
    std::multiset<std::uint32_t> active;
    bool open = false;
    for (std::size_t i = 0; i < events.size();) {
      const std::uint32_t rank = events[i].rank;
      std::size_t next = i;
      for (; next < events.size() && events[next].rank == rank; ++next)
        if (events[next].begins) active.insert(events[next].layer);
      for (; i < next; ++i)
        if (!events[i].begins) active.erase(active.find(events[i].layer));
      if (open && (active.empty() || *active.begin() != stretches.back().layer)) {
        stretches.back().high = rank;
        open = false;
      }
      if (!open && !active.empty()) {
        stretches.push_back({rank, rank, *active.begin()});
        open = true;
      }
    }
    // The edges at each stretch.
    std::vector<std::pair<std::size_t, LineEdge>> sources;
    for (const Span& span : spans) {
      auto stretch = std::upper_bound(stretches.begin(), stretches.end(), span.low,
                                      [](std::uint32_t low, const Stretch& s) { return low < s.high; });
      for (; stretch != stretches.end() && stretch->low < span.high; ++stretch) {
        if (layers_[stretch->layer].hidden == layers_[items_[span.item].layer].hidden)
          sources.emplace_back(static_cast<std::size_t>(stretch - stretches.begin()), items_[span.item].piece->edge);
      }
    }
    std::sort(sources.begin(), sources.end());
    sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
    std::vector<LineEdge> edges;
    auto source = sources.begin();
    for (std::size_t n = 0; n < stretches.size(); ++n) {
      edges.clear();
      for (; source != sources.end() && source->first == n; ++source) edges.push_back(source->second);
      add_line(places[stretches[n].low], places[stretches[n].high], stretches[n].layer, std::span<const LineEdge>(edges));
    }
  }

  std::span<const LineLayer> layers_;
  const scene::PolyScene& scene_;
  const scene::PolyCamera& camera_;
  std::array<double, 3> lengths_;
  std::vector<const scene::PolyFace*> faces_;
  std::vector<Item> items_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> by_line_;  // hash of the line, item
  UnitedLines result_;
};

}  // namespace

UnitedLines united_lines(std::span<const LineLayer> layers, const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  return LineUnion(layers, scene, camera).run();
}

LinePicture hidden_pieces(const LinePicture& edges, const LinePicture& visible) {
  LinePicture hidden;
  auto seen = visible.pieces.begin();
  for (const LinePiece& whole : edges.pieces) {
    geometry::Rational low = 0;
    const auto add = [&](const geometry::Rational& high) {
      if (low < high) hidden.pieces.push_back({whole.edge, low, high});
    };
    while (seen != visible.pieces.end() && seen->edge < whole.edge) ++seen;
    for (; seen != visible.pieces.end() && seen->edge == whole.edge; ++seen) {
      add(seen->low);
      low = seen->high;
    }
    add(1);
  }
  return hidden;
}

}  // namespace sightline::picture
