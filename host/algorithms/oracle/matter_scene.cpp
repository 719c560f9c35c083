#include "host/algorithms/oracle/matter_scene.hpp"

#include <algorithm>
#include <utility>

#include "host/geometry/interval_set.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::algorithms::oracle {
namespace {

using geometry::Rational;
using picture::LineEdge;
using picture::LinePicture;
using picture::LinePiece;

AxisLine line_through(const geometry::Point& p, const geometry::Point& q) {
  const std::size_t axis = p[0] != q[0] ? 0 : p[1] != q[1] ? 1 : 2;
  const auto [u, v] = geometry::other_axes(axis);
  return {axis, {p[u], p[v]}};
}

// The six sides of a box, visible from inside.
scene::PolyBody sheet_of(const geometry::Box& box, std::map<scene::PolyPoint, scene::VertexIndex>& numbers, scene::PolyScene& scene) {
  scene::PolyBody sheet;
  sheet.name = "outer box";
  sheet.sheet = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [u, v] = geometry::other_axes(axis);
    for (const std::int32_t at : {box.low[axis], box.high[axis]}) {
      scene::PolyFace face;
      for (const auto& [cu, cv] : {std::pair{box.low[u], box.low[v]}, std::pair{box.high[u], box.low[v]},
                                   std::pair{box.high[u], box.high[v]}, std::pair{box.low[u], box.high[v]}}) {
        scene::PolyPoint corner{};
        corner[axis] = at;
        corner[u] = cu;
        corner[v] = cv;
        const auto [known, fresh] = numbers.try_emplace(corner, static_cast<scene::VertexIndex>(scene.vertices.size()));
        if (fresh) scene.vertices.push_back(corner);
        face.outline.push_back(known->second);
      }
      sheet.faces.push_back(std::move(face));
    }
  }
  return sheet;
}

}  // namespace

class MatterScene::Parts {
 public:
  // Adds the part of the line from `low` to `high`, fractions of the way from its `from` to its `to`.
  void add(std::size_t line, const Rational& low, const Rational& high) { parts_[line].unite(low, high); }

  [[nodiscard]] LinePicture picture(const MatterScene& scene) const {
    LinePicture result;
    for (const auto& [line, parts] : parts_) {
      const LineEdge edge = scene.wire(line);
      const bool backwards = scene.scene_.vertices[edge.from] != scene.lines_[line].from;
      const auto turned = [&](const Rational& s) { return backwards ? Rational(s.denominator() - s.numerator(), s.denominator()) : s; };
      for (const auto& [low, high] : parts.intervals())
        result.pieces.push_back({edge, turned(backwards ? high : low), turned(backwards ? low : high)});
    }
    std::sort(result.pieces.begin(), result.pieces.end(), [](const LinePiece& a, const LinePiece& b) {
      return a.edge != b.edge ? a.edge < b.edge : a.low < b.low;
    });
    return result;
  }

 private:
  std::map<std::size_t, geometry::IntervalSet> parts_;
};

base::Result<MatterScene> MatterScene::of(const scene::CellScene& cells) {
  auto matter = Matter::of(cells);
  if (!matter)
    return base::Error{"", "", "has more than 67,108,864 units between its coordinates, which the oracle of cells cannot hold"};
  MatterScene result(std::move(*matter));
  result.scene_ = scene::poly_scene_of(cells);
  std::map<scene::PolyPoint, scene::VertexIndex> numbers;
  for (std::size_t v = 0; v < result.scene_.vertices.size(); ++v)
    numbers.emplace(result.scene_.vertices[v], static_cast<scene::VertexIndex>(v));
  result.with_box_ = result.scene_;
  auto numbers_with_box = numbers;
  result.with_box_.bodies.push_back(sheet_of(cells.outer, numbers_with_box, result.with_box_));
  const auto vertex = [&](const geometry::Point& p) {
    const auto [known, fresh] = numbers.try_emplace(p, static_cast<scene::VertexIndex>(result.scene_.vertices.size()));
    if (fresh) result.scene_.vertices.push_back(p);
    return known->second;
  };
  for (std::size_t l = 0; l < result.lines_.size(); ++l) {
    const RealLine& line = result.lines_[l];
    result.scene_.wires.push_back({vertex(line.from), vertex(line.to)});
    result.on_[line_through(line.from, line.to)].push_back(l);
  }
  return result;
}

LineEdge MatterScene::wire(std::size_t line) const {
  const auto [a, b] = scene_.wires[line];
  return {std::min(a, b), std::max(a, b)};
}

picture::ChosenEdges MatterScene::lines_at(const geometry::Point& eye) const {
  picture::ChosenEdges chosen;
  for (std::size_t l = 0; l < lines_.size(); ++l)
    if (is_line_for(lines_[l], eye)) chosen.edges.push_back(wire(l));
  std::sort(chosen.edges.begin(), chosen.edges.end());
  chosen.kinds.assign(chosen.edges.size(), picture::EdgeKind::wire);
  chosen.turned_away.assign(chosen.edges.size(), 0);
  chosen.first_surface.assign(chosen.edges.size() + 1, 0);
  return chosen;
}

LinePicture MatterScene::visible(const geometry::Point& eye, const Window& window) const {
  Parts parts;
  // Like real_lines(), lines of one axis are in grid order, so each is found among the lines on the same line of space.
  for (const VisibleLine& seen : visible_lines(matter_, lines_, eye, window)) {
    const std::vector<std::size_t>& candidates = on_.at(line_through(seen.p, seen.q));
    const auto line = std::find_if(candidates.begin(), candidates.end(), [&](std::size_t l) { return lines_[l].from == seen.p; });
    for (const auto& [low, high] : seen.intervals.intervals()) parts.add(*line, low, high);
  }
  return parts.picture(*this);
}

LinePicture MatterScene::on_lines(const LinePicture& drawn, const geometry::Point& eye) const {
  Parts parts;
  for (const LinePiece& piece : drawn.pieces) {
    const geometry::Point& p = with_box_.vertices[piece.edge.from];
    const geometry::Point& q = with_box_.vertices[piece.edge.to];
    const auto known = on_.find(line_through(p, q));
    if (known == on_.end()) continue;
    const std::size_t axis = known->first.axis;
    const std::int64_t length = std::int64_t{q[axis]} - p[axis];
    for (const std::size_t l : known->second) {
      const RealLine& line = lines_[l];
      if (!is_line_for(line, eye)) continue;
      const std::int64_t start = std::int64_t{p[axis]} - line.from[axis];
      const std::int64_t of_line = std::int64_t{line.to[axis]} - line.from[axis];
      // The fractions are those of the oracle's crossings, at most 36 bits in lowest terms; lengths have 16 bits.
      const auto place = [&](const Rational& s) {
        return Rational(start * s.denominator() + length * s.numerator(), s.denominator() * of_line);
      };
      const Rational low = std::max(Rational(0), place(length > 0 ? piece.low : piece.high));
      const Rational high = std::min(Rational(1), place(length > 0 ? piece.high : piece.low));
      if (low < high) parts.add(l, low, high);
    }
  }
  return parts.picture(*this);
}

std::optional<LineEdge> MatterScene::wire_on(const AxisLine& line) const {
  const auto known = on_.find(line);
  if (known == on_.end()) return std::nullopt;
  return wire(known->second.front());
}

}  // namespace sightline::algorithms::oracle
