#include "host/picture/line_union.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "host/geometry/predicates.hpp"
#include "host/geometry/vector.hpp"
#include "host/picture/camera_view.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/scene/model/face_cut.hpp"

namespace sightline::picture {
namespace {

using geometry::Int128;

// A plane through the eye, which determines a line of the image: normal and offset in lowest terms, the first nonzero
// number positive.
using LineKey = std::array<Int128, 4>;

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
        view_(camera) {
    // The planes of faces are only needed for crossings.
    if (scene.crossings.empty()) return;
    for (const scene::PolyBody& body : scene.bodies)
      for (const scene::PolyFace& face : body.faces) faces_.push_back(&face);
  }

  UnitedLines run() {
    std::size_t pieces = 0;
    for (const LineLayer& layer : layers_) pieces += layer.picture.pieces.size();
    items_.reserve(pieces);
    by_line_.reserve(pieces);
    spans_of_.assign(layers_.size(), 0);
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
  // An end of an item of `group_` on the image line.
  struct End {
    std::uint32_t item = 0;  // index in `group_`
    bool high = false;       // at the high end of the piece's parameters
    SeenPoint at{};
    double place = 0;      // along the line
    double tolerance = 0;  // error bound of `place`; beyond it, doubles decide
    ImageRatio ratio = {};  // the exact place; only for ends with others nearby
  };
  struct Span {
    std::uint32_t item = 0;
    std::uint32_t low = 0;  // ranks of its ends
    std::uint32_t high = 0;
  };
  // The start or end of a span.
  struct Event {
    std::uint32_t rank = 0;
    bool begins = false;
    std::uint32_t layer = 0;
  };
  // A range of ranks, assigned to one layer.
  struct Stretch {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t layer = 0;
  };

  static constexpr double least_depth = 1e-8;  // of an end that is not at infinity

  [[nodiscard]] bool is_crossing(const LineEdge& edge) const {
    return scene::crossing_at(scene_, edge.from) != nullptr;
  }

  [[nodiscard]] LineKey key_of(const LineEdge& edge) const {
    if (const scene::PolyCrossing* const crossing = scene::crossing_at(scene_, edge.from)) return crossing_key(*crossing);
    const std::array<std::int64_t, 4> line = in_lowest_terms(image_plane(edge, scene_, camera_));
    return {line[0], line[1], line[2], line[3]};
  }

  // A combination of the crossing's two planes that is zero at the eye. A line drawn on one face was cut by a plane of
  // sight.
  [[nodiscard]] LineKey crossing_key(const scene::PolyCrossing& crossing) const {
    const bool on_face = crossing.face_a == crossing.face_b;
    const geometry::Plane b = on_face ? scene_.cut_planes[crossing.plane] : plane_of(crossing.face_b);
    if (on_face) return in_lowest_terms(LineKey{b.normal[0], b.normal[1], b.normal[2], camera_.perspective ? 0 : b.offset});
    const geometry::Plane a = plane_of(crossing.face_a);
    const geometry::Vector3 forward = geometry::vector_of(camera_.forward);
    const auto at_eye = [&](const geometry::Plane& plane) {
      return camera_.perspective ? Int128{plane.at(camera_.eye)} : geometry::wide_dot(plane.normal, forward);
    };
    // Common factors are removed first: normals have 39 bits, the values 60.
    Int128 of_a = at_eye(b);
    Int128 of_b = at_eye(a);
    if (const Int128 divisor = geometry::common_divisor(of_a, of_b); divisor != 0) {
      of_a /= divisor;
      of_b /= divisor;
    }
    LineKey key{};
    for (std::size_t i = 0; i < 3; ++i) key[i] = a.normal[i] * of_a - b.normal[i] * of_b;
    if (!camera_.perspective) key[3] = a.offset * of_a - b.offset * of_b;
    return in_lowest_terms(key);
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
      // A single piece overlaps nothing.
      for (const std::uint32_t i : run) {
        result_.lines.push_back({end_of(i, false), end_of(i, true), items_[i].layer,
                                 static_cast<std::uint32_t>(result_.sources.size()), 1});
        result_.sources.push_back(first);
      }
      return;
    }
    // Equal hashes of different lines are extremely rare.
    rest_ = run;
    while (!rest_.empty()) {
      const LineEdge edge = items_[rest_[0]].piece->edge;
      group_.clear();
      std::size_t others = 0;
      for (const std::uint32_t i : rest_) {
        if (items_[i].piece->edge == edge || on_one_line(items_[i].piece->edge, edge)) group_.push_back(i);
        else rest_[others++] = i;
      }
      rest_.resize(others);
      unite(edge);
    }
  }

  [[nodiscard]] bool on_one_line(const LineEdge& a, const LineEdge& b) const {
    if (is_crossing(a) || is_crossing(b)) return key_of(a) == key_of(b);
    const std::array<std::int64_t, 4> m = image_plane(a, scene_, camera_);
    const std::array<std::int64_t, 4> n = image_plane(b, scene_, camera_);
    const std::size_t k = m[0] != 0 ? 0 : m[1] != 0 ? 1 : 2;
    for (std::size_t i = 0; i < 4; ++i)
      if (Int128{m[i]} * n[k] != Int128{n[i]} * m[k]) return false;
    return n[k] != 0;
  }

  // The point from + s (to - from) of an edge.
  [[nodiscard]] SeenPoint end_of(std::uint32_t item, bool high) const {
    const LinePiece& piece = *items_[item].piece;
    const double s = (high ? piece.high : piece.low).to_double();
    const geometry::RealVector from = scene::place_of(scene_, piece.edge.from);
    const geometry::RealVector to = scene::place_of(scene_, piece.edge.to);
    geometry::RealVector point = to;
    if (s != 1)
      for (std::size_t a = 0; a < 3; ++a) point[a] = from[a] + s * (to[a] - from[a]);
    return view_.at(point);
  }

  // The axis, right or up, along which a line of the image is longer.
  [[nodiscard]] std::size_t axis_of(const LineEdge& edge) const {
    std::array<double, 3> normal{};
    if (is_crossing(edge)) {
      const LineKey key = key_of(edge);
      for (std::size_t i = 0; i < 3; ++i) normal[i] = static_cast<double>(key[i]);
    } else {
      const std::array<std::int64_t, 4> plane = image_plane(edge, scene_, camera_);
      for (std::size_t i = 0; i < 3; ++i) normal[i] = static_cast<double>(plane[i]);
    }
    const auto along = [&](std::size_t number) { return std::abs(geometry::dot(normal, view_.direction(number))); };
    return along(1) * view_.length(0) >= along(0) * view_.length(1) ? 0 : 1;
  }

  // Adds the ends of an item of `group_`. In perspective, the image ends at infinity where the edge passes the eye.
  void place_ends(std::uint32_t item, std::size_t axis) {
    // The places are computed to about 10^-10 of a step.
    constexpr double error = 1e-9;
    std::array<End, 2> ends{End{item, false, end_of(group_[item], false)}, End{item, true, end_of(group_[item], true)}};
    if (ends[0].at[2] <= least_depth && ends[1].at[2] <= least_depth) return;
    for (const bool high : {false, true}) {
      SeenPoint& at = ends[high ? 1 : 0].at;
      const SeenPoint& other = ends[high ? 0 : 1].at;
      if (at[2] >= 0) continue;
      const double part = at[2] / (at[2] - other[2]);
      for (std::size_t i = 0; i < 2; ++i) at[i] += part * (other[i] - at[i]);
      at[2] = 0;
    }
    for (End& end : ends) {
      const double depth = end.at[2];
      if (depth > least_depth) {
        end.place = end.at[axis] / depth;
        end.tolerance = error * (1 + std::abs(end.place)) / std::min(depth, 1.0);
      } else {
        end.tolerance = std::numeric_limits<double>::infinity();
        end.place = std::copysign(end.tolerance, end.at[axis]);
      }
      ends_.push_back(end);
    }
  }

  [[nodiscard]] const LinePiece& piece_of(const End& end) const { return *items_[group_[end.item]].piece; }

  // Negative, zero or positive: a is less than, equal to, greater than b.
  static int compare_exactly(const ImageRatio& a, const ImageRatio& b) {
    // Ends at vertices are short fractions.
    const auto is_short = [](const ImageRatio& r) {
      constexpr std::int64_t limit = std::int64_t{1} << 62;
      return r.denominator > 0 && r.denominator < limit && r.numerator < limit && r.numerator > -limit;
    };
    if (is_short(a) && is_short(b)) return geometry::sign(a.numerator * b.denominator - b.numerator * a.denominator);
    return compare(a, b);
  }

  // Sorts the ends along the line and numbers their places in `ranks_`; equal places have the same number.
  void rank_ends(std::size_t axis) {
    std::vector<End>& ends = ends_;
    const auto earlier = [](const End& a, const End& b) { return a.item != b.item ? a.item < b.item : a.high < b.high; };
    std::sort(ends.begin(), ends.end(),
              [&](const End& a, const End& b) { return a.place != b.place ? a.place < b.place : earlier(a, b); });
    const auto near = [&](std::size_t i) {
      return !(ends[i].place - ends[i - 1].place > std::max(ends[i].tolerance, ends[i - 1].tolerance));
    };
    ranks_.assign(ends.size(), 0);
    std::uint32_t rank = 0;
    for (std::size_t begin = 0; begin < ends.size();) {
      std::size_t end = begin + 1;
      while (end < ends.size() && near(end)) ++end;
      const auto first = ends.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto last = ends.begin() + static_cast<std::ptrdiff_t>(end);
      const bool exact = std::none_of(first, last, [this](const End& e) { return is_crossing(piece_of(e).edge); });
      if (exact && end - begin > 1) {
        for (auto e = first; e != last; ++e) {
          const LinePiece& piece = piece_of(*e);
          e->ratio = e->at[2] > 0 ? image_coordinate(piece.edge, e->high ? piece.high : piece.low, axis, scene_, camera_)
                                  : ImageRatio{e->at[axis] < 0 ? -1 : 1, 0};
        }
        std::sort(first, last, [&](const End& a, const End& b) {
          const int order = compare_exactly(a.ratio, b.ratio);
          return order != 0 ? order < 0 : earlier(a, b);
        });
      }
      for (std::size_t i = begin; i < end; ++i) {
        bool same = i > begin;
        if (same && exact) same = compare_exactly(ends[i - 1].ratio, ends[i].ratio) == 0;
        if (same && !exact) {
          const double a = ends[i - 1].place;
          const double b = ends[i].place;
          same = a == b || b - a <= 1e-9 * (1 + std::abs(a));
        }
        if (i > 0 && !same) ++rank;
        ranks_[i] = rank;
      }
      begin = end;
    }
  }

  // Unites `group_`, whose items are all on the image line of this edge.
  void unite(const LineEdge& edge) {
    const std::size_t axis = axis_of(edge);
    ends_.clear();
    for (std::uint32_t i = 0; i < group_.size(); ++i) place_ends(i, axis);
    rank_ends(axis);
    places_.clear();
    constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
    spans_.assign(group_.size(), {0, unknown, 0});
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      if (ranks_[e] == places_.size()) places_.push_back(ends_[e].at);
      Span& span = spans_[ends_[e].item];
      span.item = group_[ends_[e].item];
      (span.low == unknown ? span.low : span.high) = ranks_[e];
    }
    spans_.erase(std::remove_if(spans_.begin(), spans_.end(),
                                [](const Span& span) { return span.low == unknown || span.low == span.high; }),
                 spans_.end());
    sweep();
    divide_endless();
    add_stretches();
  }

  // The first active layer keeps the stretch.
  void sweep() {
    events_.clear();
    for (const Span& span : spans_) {
      events_.push_back({span.low, true, items_[span.item].layer});
      events_.push_back({span.high, false, items_[span.item].layer});
    }
    std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) { return a.rank < b.rank; });
    stretches_.clear();
    active_.clear();
    bool open = false;
    for (std::size_t i = 0; i < events_.size();) {
      const std::uint32_t rank = events_[i].rank;
      std::size_t next = i;
      for (; next < events_.size() && events_[next].rank == rank; ++next)
        if (events_[next].begins && ++spans_of_[events_[next].layer] == 1)
          active_.insert(std::upper_bound(active_.begin(), active_.end(), events_[next].layer), events_[next].layer);
      for (; i < next; ++i)
        if (!events_[i].begins && --spans_of_[events_[i].layer] == 0)
          active_.erase(std::lower_bound(active_.begin(), active_.end(), events_[i].layer));
      if (open && (active_.empty() || active_.front() != stretches_.back().layer)) {
        stretches_.back().high = rank;
        open = false;
      }
      if (!open && !active_.empty()) {
        stretches_.push_back({rank, rank, active_.front()});
        open = true;
      }
    }
  }

  // A stretch between two ends at infinity does not determine a line, so it gets an end between them.
  void divide_endless() {
    if (stretches_.size() != 1 || std::max(places_.front()[2], places_.back()[2]) > least_depth) return;
    const Stretch whole = stretches_.front();
    if (whole.low != 0 || whole.high + 1 != places_.size()) return;
    stretches_ = {{0, 1, whole.layer}, {1, whole.high, whole.layer}};
  }

  // Adds the stretches with the edges that lie on each.
  void add_stretches() {
    sources_.clear();
    for (const Span& span : spans_) {
      auto stretch = std::upper_bound(stretches_.begin(), stretches_.end(), span.low,
                                      [](std::uint32_t low, const Stretch& s) { return low < s.high; });
      for (; stretch != stretches_.end() && stretch->low < span.high; ++stretch) {
        if (layers_[stretch->layer].hidden == layers_[items_[span.item].layer].hidden)
          sources_.emplace_back(static_cast<std::uint32_t>(stretch - stretches_.begin()), items_[span.item].piece->edge);
      }
    }
    std::sort(sources_.begin(), sources_.end());
    sources_.erase(std::unique(sources_.begin(), sources_.end()), sources_.end());
    auto source = sources_.begin();
    for (std::uint32_t n = 0; n < stretches_.size(); ++n) {
      const Stretch& stretch = stretches_[n];
      const auto first = static_cast<std::uint32_t>(result_.sources.size());
      for (; source != sources_.end() && source->first == n; ++source) result_.sources.push_back(source->second);
      result_.lines.push_back({places_[stretch.low], places_[stretch.high], stretch.layer, first,
                               static_cast<std::uint32_t>(result_.sources.size()) - first});
    }
  }

  std::span<const LineLayer> layers_;
  const scene::PolyScene& scene_;
  const scene::PolyCamera& camera_;
  CameraView view_;
  std::vector<const scene::PolyFace*> faces_;
  std::vector<Item> items_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> by_line_;  // hash of the line, item
  UnitedLines result_;
  // For the current line.
  std::vector<std::uint32_t> rest_;
  std::vector<std::uint32_t> group_;
  std::vector<End> ends_;
  std::vector<std::uint32_t> ranks_;  // by end
  std::vector<SeenPoint> places_;    // by rank
  std::vector<Span> spans_;
  std::vector<Event> events_;
  std::vector<std::uint32_t> active_;  // ascending, without duplicates
  std::vector<std::size_t> spans_of_;  // by layer: number of active spans
  std::vector<Stretch> stretches_;
  std::vector<std::pair<std::uint32_t, LineEdge>> sources_;  // of stretches
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
