#include "host/explain/cell_diagrams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/explain/cell_shapes.hpp"
#include "host/picture/lettering.hpp"

namespace sightline::explain {
namespace {

// Millimetres.
constexpr double field_width = 60;
constexpr double field_height = 50;
constexpr double gap = 6;
constexpr double title_height = 3;
constexpr double number_height = 2.2;
constexpr double ring_radius = 2.8;
constexpr double graph_scale = 2;  // the graph has the width and height of this many fields, if there are as many columns

enum Pen : std::uint32_t { frames, back_edges, front_edges, scene_lines, portals, numbers };

picture::VectorDrawing empty_drawing() {
  picture::VectorDrawing drawing;
  drawing.layers = {{"fields", {200, 200, 200}, 0}, {"edges of the cells at the back", {150, 150, 150}, 1.2}, {"edges of the cells", {110, 110, 110}, 0},
                    {"lines of the scene", {0, 0, 0}, 0}, {"portals", {0, 90, 200}, 0}, {"numbers", {180, 40, 0}, 0}};
  return drawing;
}

// A part of the sheet. Places of an oblique view are fitted to it, below the title.
struct Field {
  double left = 0;
  double bottom = 0;
  double width = 0;
  double height = 0;
};

class Placement {
 public:
  Placement(const Field& field, const std::vector<Point>& places, double margin) {
    if (places.empty()) return;
    Point low = places.front();
    Point high = low;
    for (const Point& p : places)
      for (std::size_t a = 0; a < 2; ++a) {
        low[a] = std::min(low[a], p[a]);
        high[a] = std::max(high[a], p[a]);
      }
    const Point room{field.width - 2 * margin, field.height - 2 * margin - 2 * title_height};
    scale_ = 1e300;
    for (std::size_t a = 0; a < 2; ++a)
      if (high[a] > low[a]) scale_ = std::min(scale_, room[a] / (high[a] - low[a]));
    if (scale_ > 1e299) scale_ = 1;
    const Point middle{field.left + field.width / 2, field.bottom + margin + room[1] / 2};
    for (std::size_t a = 0; a < 2; ++a) origin_[a] = middle[a] - scale_ * (low[a] + high[a]) / 2;
  }

  [[nodiscard]] Point at(const Point& p) const { return {origin_[0] + scale_ * p[0], origin_[1] + scale_ * p[1]}; }

 private:
  double scale_ = 1;
  Point origin_{};
};

class Diagrams {
 public:
  Diagrams(const scene::CellComplex& complex, const scene::PolyCamera& camera) : complex_(complex), view_(camera) {
    for (scene::CellNumber cell = 0; cell < complex.cells.size(); ++cell) edges_.push_back(edges_of(complex, cell));
  }

  picture::VectorDrawing drawing() {
    const auto count = static_cast<double>(complex_.cells.size());
    // About as wide as high, with the graph above the diagrams.
    const auto columns = static_cast<std::size_t>(std::clamp(std::ceil(std::sqrt(count)), 2.0, 8.0));
    const std::size_t rows = (complex_.cells.size() + columns - 1) / columns;
    const Field graph{0, static_cast<double>(rows) * (field_height + gap), static_cast<double>(columns) * (field_width + gap) - gap,
                      graph_scale * field_height};
    drawing_.width = graph.width;
    drawing_.height = graph.bottom + graph.height;
    draw_graph(graph);
    for (scene::CellNumber cell = 0; cell < complex_.cells.size(); ++cell) {
      const std::size_t row = cell / columns;
      draw_cell({static_cast<double>(cell % columns) * (field_width + gap), static_cast<double>(rows - 1 - row) * (field_height + gap), field_width, field_height},
                cell);
    }
    return std::move(drawing_);
  }

 private:
  void draw_line(Pen layer, const Point& from, const Point& to) { picture::append_line(drawing_, layer, from[0], from[1], to[0], to[1]); }

  void frame(const Field& field, const std::string& title) {
    const Point low{field.left, field.bottom};
    const Point high{field.left + field.width, field.bottom + field.height};
    draw_line(frames, low, {high[0], low[1]});
    draw_line(frames, {high[0], low[1]}, high);
    draw_line(frames, high, {low[0], high[1]});
    draw_line(frames, {low[0], high[1]}, low);
    picture::append_text(drawing_, numbers, low[0] + 2, high[1] - 2 - title_height, title_height, title);
  }

  void write_centred(const Point& place, const std::string& text) {
    picture::append_text(drawing_, numbers, place[0] - picture::text_width(number_height, text) / 2, place[1] - number_height / 2, number_height, text);
  }

  void draw_graph(const Field& field) {
    std::map<std::pair<scene::CellNumber, scene::CellNumber>, std::size_t> arcs;
    std::size_t to_outside = 0;
    for (const scene::ComplexOpening& opening : complex_.openings) {
      const auto [low, high] = std::minmax(opening.cells[0], opening.cells[1]);
      if (high == scene::outside) {
        ++to_outside;
      } else {
        ++arcs[{low, high}];
      }
    }
    std::string title = fmt::format("{} cells, {} portals between them", complex_.cells.size(), complex_.openings.size() - to_outside);
    if (to_outside > 0) title += fmt::format(", {} lead out", to_outside);
    frame(field, title);
    std::vector<Point> places;
    for (const auto& edges : edges_) places.push_back(view_.at(middle_of(edges)));
    const Placement placement(field, places, 2 * ring_radius);
    for (Point& place : places) place = placement.at(place);
    for (const auto& [cells, count] : arcs) {
      const Point& a = places[cells.first];
      const Point& b = places[cells.second];
      const double length = std::sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]));
      if (length <= 2 * ring_radius) continue;
      const Point along{(b[0] - a[0]) / length, (b[1] - a[1]) / length};
      draw_line(portals, {a[0] + ring_radius * along[0], a[1] + ring_radius * along[1]}, {b[0] - ring_radius * along[0], b[1] - ring_radius * along[1]});
      if (count > 1) write_centred({(a[0] + b[0]) / 2 - 2 * along[1], (a[1] + b[1]) / 2 + 2 * along[0]}, std::to_string(count));
    }
    for (scene::CellNumber cell = 0; cell < places.size(); ++cell) {
      draw_ring(places[cell]);
      write_centred(places[cell], std::to_string(cell));
    }
  }

  void draw_ring(const Point& place) {
    // Each corner is the one before, turned by 15 degrees: the same bits everywhere.
    constexpr int corners = 24;
    constexpr double cosine = 0.96592582628906829;
    constexpr double sine = 0.25881904510252076;
    Point arm{ring_radius, 0};
    for (int i = 0; i < corners; ++i) {
      const Point next{cosine * arm[0] - sine * arm[1], sine * arm[0] + cosine * arm[1]};
      draw_line(front_edges, {place[0] + arm[0], place[1] + arm[1]}, {place[0] + next[0], place[1] + next[1]});
      arm = next;
    }
  }

  void draw_cell(const Field& field, scene::CellNumber cell) {
    const scene::ComplexCell& row = complex_.cells[cell];
    const auto openings = complex_.openings_of(row);
    const auto out = std::count_if(openings.begin(), openings.end(), [&](std::uint32_t n) { return beyond(n, cell) == scene::outside; });
    frame(field, out == 0 ? fmt::format("cell {}", cell) : fmt::format("cell {}, {} out", cell, out));
    std::vector<Point> places;
    for (const CellEdge& edge : edges_[cell]) {
      places.push_back(view_.at(edge.from));
      places.push_back(view_.at(edge.to));
    }
    const Placement placement(field, places, 3);
    const auto at = [&](const Space& p) { return placement.at(view_.at(p)); };
    for (const CellEdge& edge : edges_[cell]) {
      const bool front = view_.faces_viewer(edge.sides[0]) || view_.faces_viewer(edge.sides[1]);
      draw_line(front ? front_edges : back_edges, at(edge.from), at(edge.to));
    }
    for (const scene::ComplexLine line : complex_.lines_of(row)) {
      const scene::ComplexEdge& edge = complex_.edges[line.edge];
      const Space a = space(complex_.vertices[edge.from]);
      const Space b = space(complex_.vertices[edge.to]);
      const auto part = [&](const geometry::Rational& t) {
        const double s = t.to_double();
        return at({a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2])});
      };
      draw_line(scene_lines, part(line.low), part(line.high));
    }
    for (const std::uint32_t number : openings)
      if (beyond(number, cell) != scene::outside) draw_portal(placement, number, cell);
  }

  // The cell on the other side of a portal.
  [[nodiscard]] scene::CellNumber beyond(std::uint32_t opening, scene::CellNumber cell) const {
    const auto& cells = complex_.openings[opening].cells;
    return cells[0] == cell ? cells[1] : cells[0];
  }

  void draw_portal(const Placement& placement, std::uint32_t number, scene::CellNumber cell) {
    std::vector<Point> outline;
    for (const Space& corner : corners_of(complex_, number)) outline.push_back(placement.at(view_.at(corner)));
    if (outline.size() < 3) return;
    for (std::size_t i = 0; i < outline.size(); ++i) draw_line(portals, outline[i], outline[(i + 1) % outline.size()]);
    write_centred(label_point(outline), std::to_string(beyond(number, cell)));
  }

  const scene::CellComplex& complex_;
  ObliqueView view_;
  std::vector<std::vector<CellEdge>> edges_;  // by cell
  picture::VectorDrawing drawing_ = empty_drawing();
};

}  // namespace

base::Result<picture::VectorDrawing> cell_diagrams(const scene::CellComplex& complex, const scene::PolyCamera& camera) {
  if (complex.cells.size() > most_cell_diagrams)
    return base::usage_error(fmt::format("found {} cells, expected at most {} for diagrams; take a smaller scene, or write the cells as JSON",
                                         complex.cells.size(), most_cell_diagrams));
  return Diagrams(complex, camera).drawing();
}

}  // namespace sightline::explain
