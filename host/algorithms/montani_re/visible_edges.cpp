#include "host/algorithms/montani_re/visible_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "host/algorithms/montani_re/edge_parameter.hpp"
#include "host/geometry/interval_set.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Rational;

// Collects pieces of edges; those of one edge are joined in the end.
class EdgePieces {
 public:
  explicit EdgePieces(const FaceSet& set) : set_(set), seen_(set.edges.size()) {}

  void add(const Face& face, const TrapezoidPcs& region) {
    add_sides(region);
    for (const std::uint32_t line : face.lines) {
      if (set_.image.lines()[line].horizontal()) add_horizontal(line, region);
    }
  }

  [[nodiscard]] picture::LinePicture picture() const {
    picture::LinePicture picture;
    std::vector<std::uint32_t> order(seen_.size());
    for (std::uint32_t line = 0; line < order.size(); ++line) order[line] = line;
    std::sort(order.begin(), order.end(),
              [this](std::uint32_t a, std::uint32_t b) { return set_.edges[a] < set_.edges[b]; });
    for (const std::uint32_t line : order) {
      for (const geometry::Interval& interval : seen_[line].intervals()) {
        picture.pieces.push_back({set_.edges[line], interval.low, interval.high});
      }
    }
    return picture;
  }

 private:
  struct Run {
    std::uint32_t line = 0;
    const Ordinate* low = nullptr;
    const Ordinate* high = nullptr;
  };

  // Bands ascend, so that a run of one line goes on at once or never; only its ends are ends of what is seen.
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
      add(run.line, parameter_at(set_.image, run.line, *run.low),
          parameter_at(set_.image, run.line, *run.high));
    }
  }

  // Seen where the region has breadth just above or just below.
  void add_horizontal(std::uint32_t line, const TrapezoidPcs& region) {
    const Ordinate y = set_.image.ordinate_of(set_.image.lines()[line].from);
    for (const Band& band : region.bands) {
      if (set_.image.compare(band.low, y) != 0 && set_.image.compare(band.high, y) != 0) continue;
      const auto sides = region.sides_of(band);
      for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
        if (set_.image.order_at(sides[k].line, sides[k + 1].line, y) >= 0) continue;
        add(line, parameter_at_line(set_.image, line, sides[k].line),
            parameter_at_line(set_.image, line, sides[k + 1].line));
      }
    }
  }

  void add(std::uint32_t line, Rational from, Rational to) {
    if (to < from) std::swap(from, to);
    if (from < Rational{0}) from = Rational{0};
    if (Rational{1} < to) to = Rational{1};
    seen_[line].unite(from, to);
  }

  const FaceSet& set_;
  std::vector<geometry::IntervalSet> seen_;  // by line
  std::vector<Run> runs_;
};

scene::SceneError passing_through(const Face& f, const Face& g) {
  const auto name = [](const Face& face) {
    return "face " + std::to_string(face.index) + " of body " + std::to_string(face.body);
  };
  return {"", "montani-re", name(f) + " and " + name(g) + " pass through each other: neither has priority"};
}

}  // namespace

picture::LinePicture edges_of_regions(const FaceSet& set, const std::vector<TrapezoidPcs>& regions) {
  EdgePieces pieces(set);
  for (std::size_t face = 0; face < regions.size(); ++face) pieces.add(set.faces[face], regions[face]);
  return pieces.picture();
}

std::variant<LineView, scene::SceneError> visible_edges(const scene::PolyScene& scene,
                                                        const scene::PolyCamera& camera) {
  auto faces = faces_of(scene, camera);
  if (auto* error = std::get_if<scene::SceneError>(&faces)) return std::move(*error);
  const FaceSet& set = std::get<FaceSet>(faces);
  const VisibleRegions seen = visible_regions(set);
  if (seen.interpenetrating) {
    return passing_through(set.faces[seen.interpenetrating->first], set.faces[seen.interpenetrating->second]);
  }
  return LineView{edges_of_regions(set, seen.regions), seen.counts};
}

}  // namespace sightline::algorithms::montani_re
