#include "host/algorithms/montani_re/visible_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "host/algorithms/montani_re/edge_parameter.hpp"
#include "host/algorithms/montani_re/isolated_edge_sight.hpp"
#include "host/algorithms/montani_re/pyramids.hpp"
#include "host/algorithms/montani_re/trace.hpp"
#include "host/base/result.hpp"
#include "host/geometry/interval_set.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Rational;

// Collects pieces of edges and finally joins those of the same edge.
class EdgePieces {
 public:
  explicit EdgePieces(const FaceSet& set) : set_(set) {
    found_.reserve(2 * set.faces.size());
    for (const std::uint32_t line : set.isolated) {
      const geometry::IntervalSet seen = seen_of_isolated_edge(set, line);
      for (const geometry::Interval& interval : seen.intervals()) unite(line, interval);
    }
  }

  void add(const Face& face, const TrapezoidPcs& region) {
    add_sides(region);
    for (const std::uint32_t line : face.lines) {
      if (set_.image.lines()[line].horizontal()) add_horizontal(line, region);
    }
  }

  [[nodiscard]] picture::LinePicture picture() const {
    // Small keys are sorted instead of pieces.
    struct Key {
      std::uint64_t edge = 0;
      std::uint32_t found = 0;
    };
    std::vector<Key> keys(found_.size());
    for (std::uint32_t k = 0; k < keys.size(); ++k) {
      const picture::LineEdge& edge = set_.edges[found_[k].line];
      keys[k] = {std::uint64_t{edge.from} << 32 | edge.to, k};
    }
    std::sort(keys.begin(), keys.end(),
              [](const Key& a, const Key& b) { return a.edge != b.edge ? a.edge < b.edge : a.found < b.found; });
    picture::LinePicture picture;
    picture.pieces.reserve(keys.size());
    for (std::size_t k = 0; k < keys.size();) {
      const Found& first = found_[keys[k].found];
      const picture::LineEdge edge = set_.edges[first.line];
      std::size_t end = k + 1;
      while (end < keys.size() && keys[end].edge == keys[k].edge) ++end;
      if (end == k + 1) {
        picture.pieces.push_back({edge, first.interval.low, first.interval.high});
      } else {
        geometry::IntervalSet seen;
        for (; k < end; ++k) seen.unite(found_[keys[k].found].interval.low, found_[keys[k].found].interval.high);
        for (const geometry::Interval& interval : seen.intervals())
          picture.pieces.push_back({edge, interval.low, interval.high});
      }
      k = end;
    }
    return picture;
  }

 private:
  struct Run {
    std::uint32_t line = 0;
    const Ordinate* low = nullptr;
    const Ordinate* high = nullptr;
  };

  // Bands ascend, so a side is continued by the next band or not at all. Only the ends of such runs are ends of visible
  // pieces.
  void add_sides(const TrapezoidPcs& region) {
    runs_.clear();
    for (const Band& band : region.bands) {
      for (const Side& side : region.sides_of(band)) {
        if (!side.own) continue;
        const auto run =
            std::find_if(runs_.rbegin(), runs_.rend(), [&side](const Run& r) { return r.line == side.line; });
        if (run != runs_.rend() && set_.image.compare(*run->high, band.low) == 0) {
          run->high = &band.high;
        } else {
          runs_.push_back({side.line, &band.low, &band.high});
        }
      }
    }
    for (const Run& run : runs_) {
      const Rational low = parameter_at(set_.image, run.line, *run.low);
      const Rational high = parameter_at(set_.image, run.line, *run.high);
      unite(run.line, low < high ? geometry::Interval{low, high} : geometry::Interval{high, low});
    }
  }

  // A horizontal edge is seen where the region has area just above or just below it.
  void add_horizontal(std::uint32_t line, const TrapezoidPcs& region) {
    const Ordinate y = set_.image.ordinate_of(set_.image.end_before_eye(line));
    for (const Band& band : region.bands) {
      if (set_.image.compare(band.low, y) != 0 && set_.image.compare(band.high, y) != 0) continue;
      const auto sides = region.sides_of(band);
      for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
        if (set_.image.order_at(sides[k].line, sides[k + 1].line, y) >= 0) continue;
        const auto part = part_between(set_.image, line, sides[k].line, sides[k + 1].line);
        if (part) unite(line, *part);
      }
    }
  }

  void unite(std::uint32_t line, const geometry::Interval& interval) {
    if (interval.low < interval.high) found_.push_back({line, interval});
  }

  struct Found {
    std::uint32_t line = 0;
    geometry::Interval interval;
  };

  const FaceSet& set_;
  std::vector<Found> found_;
  std::vector<Run> runs_;
};

base::Error passing_through(const Face& f, const Face& g) {
  const auto name = [](const Face& face) {
    return "face " + std::to_string(face.index) + " of body " + std::to_string(face.body);
  };
  return {"", "montani-re", name(f) + " and " + name(g) + " pass through each other, so neither has priority"};
}

// Joins pieces of several windows: pieces of one edge that touch on a border become one. An edge that is not before the
// eye has no image, even on a border.
void join(picture::LinePicture& picture, const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  std::vector<picture::LinePiece> pieces = std::move(picture.pieces);
  picture.pieces.clear();
  std::sort(pieces.begin(), pieces.end(), [](const picture::LinePiece& a, const picture::LinePiece& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.low < b.low;
  });
  for (const picture::LinePiece& piece : pieces) {
    if (!before_eye(scene, camera, piece.edge.from) && !before_eye(scene, camera, piece.edge.to)) continue;
    if (!picture.pieces.empty() && picture.pieces.back().edge == piece.edge &&
        piece.low <= picture.pieces.back().high) {
      picture.pieces.back().high = std::max(picture.pieces.back().high, piece.high);
    } else {
      picture.pieces.push_back(piece);
    }
  }
}

}  // namespace

picture::LinePicture edges_of_regions(const FaceSet& set, const std::vector<TrapezoidPcs>& regions) {
  EdgePieces pieces(set);
  for (std::size_t face = 0; face < regions.size(); ++face) pieces.add(set.faces[face], regions[face]);
  return pieces.picture();
}

base::Result<LineView> visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera, Trace* trace) {
  LineView view;
  const std::vector<FaceSet> sets = faces_before_eye(scene, camera);
  for (const FaceSet& set : sets) {
    if (trace != nullptr) trace->faces(set, sets.size() == 1 && !set.window);
    const VisibleRegions seen = visible_regions(set, Silhouette::neighbours, trace);
    if (seen.interpenetrating) {
      return passing_through(set.faces[seen.interpenetrating->first],
                             set.faces[seen.interpenetrating->second]);
    }
    picture::LinePicture part = edges_of_regions(set, seen.regions);
    if (view.picture.pieces.empty()) {
      view.picture = std::move(part);
    } else {
      view.picture.pieces.insert(view.picture.pieces.end(), part.pieces.begin(), part.pieces.end());
    }
    view.counts += seen.counts;
  }
  // One set without a window needs no joining: no border cuts anything, and all edges are in front of the eye.
  if (sets.size() != 1 || sets[0].window) join(view.picture, scene, camera);
  return view;
}

}  // namespace sightline::algorithms::montani_re
