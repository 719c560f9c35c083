// See open_vertices.hpp.
#include "host/scene/read/open_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace sightline::scene {
namespace {

using FilePoint = OpenVertices::FilePoint;

std::vector<VertexIndex> ends_of(std::span<const OpenEdge> edges) {
  std::vector<VertexIndex> ends;
  ends.reserve(2 * edges.size());
  for (const OpenEdge& edge : edges) ends.insert(ends.end(), {edge.from, edge.to});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

std::vector<geometry::Box> boxes_at(const std::vector<PolyPoint>& points, const std::vector<VertexIndex>& vertices) {
  std::vector<geometry::Box> boxes;
  boxes.reserve(vertices.size());
  for (const VertexIndex v : vertices) boxes.push_back({points[v], points[v]});
  return boxes;
}

template <class Point>
double square_of_distance(const Point& a, const Point& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (double(a[i]) - double(b[i])) * (double(a[i]) - double(b[i]));
  return sum;
}

// Where the foot of a perpendicular is along an edge, 0 to 1 between its ends, and the square of the distance from its line.
template <class Point>
std::pair<double, double> foot_on(const Point& from, const Point& to, const Point& p) {
  std::array<double, 3> along{};
  std::array<double, 3> way{};
  double length = 0;
  double part = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along[i] = double(to[i]) - double(from[i]);
    way[i] = double(p[i]) - double(from[i]);
    length += along[i] * along[i];
    part += along[i] * way[i];
  }
  if (length == 0) return {0, square_of_distance(from, p)};
  part /= length;
  double off = 0;
  for (std::size_t i = 0; i < 3; ++i) off += (way[i] - part * along[i]) * (way[i] - part * along[i]);
  return {part, off};
}

}  // namespace

OpenVertices::OpenVertices(const std::vector<PolyPoint>& points, std::span<const OpenEdge> edges,
                           std::span<const FilePoint> file, std::span<const VertexIndex> target)
    : points_(points), vertices_(ends_of(edges)), tree_(boxes_at(points, vertices_)) {
  with_bodies_.reserve(2 * edges.size());
  for (const OpenEdge& edge : edges) with_bodies_.insert(with_bodies_.end(), {{edge.from, edge.body}, {edge.to, edge.body}});
  std::sort(with_bodies_.begin(), with_bodies_.end());
  with_bodies_.erase(std::unique(with_bodies_.begin(), with_bodies_.end()), with_bodies_.end());
  std::vector<std::pair<VertexIndex, FilePoint>> pairs;
  for (VertexIndex v = 0; v < target.size(); ++v)
    if (std::binary_search(vertices_.begin(), vertices_.end(), target[v])) pairs.emplace_back(target[v], file[v]);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  first_.reserve(vertices_.size() + 1);
  for (const auto& [vertex, at] : pairs) {
    while (first_.size() < vertices_.size() && vertices_[first_.size()] <= vertex) first_.push_back(file_points_.size());
    file_points_.push_back(at);
  }
  first_.resize(vertices_.size() + 1, file_points_.size());
}

std::size_t OpenVertices::number_of(VertexIndex vertex) const {
  return static_cast<std::size_t>(std::lower_bound(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin());
}

std::span<const FilePoint> OpenVertices::in_file(VertexIndex vertex) const {
  const std::size_t i = number_of(vertex);
  return std::span(file_points_).subspan(first_[i], first_[i + 1] - first_[i]);
}

std::vector<std::pair<VertexIndex, VertexIndex>> OpenVertices::near_pairs(double distance) const {
  std::vector<std::tuple<double, PolyPoint, PolyPoint, std::pair<VertexIndex, VertexIndex>>> found;
  for (const VertexIndex v : vertices_) {
    const PolyPoint& p = points_[v];
    const geometry::Box around{{p[0] - 1, p[1] - 1, p[2] - 1}, {p[0] + 1, p[1] + 1, p[2] + 1}};
    tree_.for_each_touching(around, [&](std::uint32_t number) {
      const VertexIndex w = vertices_[number];
      if (!(p < points_[w])) return;
      double nearest = std::numeric_limits<double>::infinity();
      for (const FilePoint& a : in_file(v))
        for (const FilePoint& b : in_file(w)) nearest = std::min(nearest, square_of_distance(a, b));
      if (nearest < distance * distance) found.emplace_back(nearest, p, points_[w], std::pair(v, w));
    });
  }
  std::sort(found.begin(), found.end());
  std::vector<std::pair<VertexIndex, VertexIndex>> pairs;
  pairs.reserve(found.size());
  for (const auto& each : found) pairs.push_back(std::get<3>(each));
  return pairs;
}

std::vector<VertexIndex> OpenVertices::on_edge(const OpenEdge& edge, const FilePoint& from, const FilePoint& to,
                                               double tolerance, double step, std::size_t& work) const {
  // Rounding moves a point by less than a step in each coordinate, and joining by one more.
  const double margin = tolerance / step + 4;
  std::vector<std::tuple<double, PolyPoint, VertexIndex>> found;
  const auto visit = [&](std::uint32_t number) {
    const VertexIndex v = vertices_[number];
    if (v == edge.from || v == edge.to) return;
    work += in_file(v).size();
    double place = 0;
    double off = std::numeric_limits<double>::infinity();
    for (const FilePoint& p : in_file(v)) {
      const auto [at, square] = foot_on(from, to, p);
      if (!(at > 0 && at < 1) || !(square < off)) continue;
      place = at;
      off = square;
    }
    if (!(off <= tolerance * tolerance)) return;
    if (!std::binary_search(with_bodies_.begin(), with_bodies_.end(), std::pair(v, edge.body))) return;
    found.emplace_back(place, points_[v], v);
  };
  const auto meets = [&](const geometry::Box& box) {
    ++work;
    return geometry::segment_meets(points_[edge.from], points_[edge.to], box, margin);
  };
  tree_.for_each_that(meets, visit);
  std::sort(found.begin(), found.end());
  std::vector<VertexIndex> vertices;
  vertices.reserve(found.size());
  for (const auto& each : found) vertices.push_back(std::get<2>(each));
  return vertices;
}

std::vector<double> weld_distances(const PolyScene& scene, std::size_t least_joints) {
  constexpr double part_of_body = 0.01;
  constexpr double part_of_edge = 0.5;
  const EdgeTable table(scene);
  std::vector<std::uint32_t> body_of;
  std::vector<double> most_of;  // of each body
  for (const PolyBody& body : scene.bodies) {
    PolyBounds bounds{scene.vertices[body.faces[0].outline[0]], scene.vertices[body.faces[0].outline[0]]};
    for (const PolyFace& face : body.faces) {
      body_of.push_back(static_cast<std::uint32_t>(most_of.size()));
      for (const VertexIndex v : face.outline) {
        for (std::size_t a = 0; a < 3; ++a) {
          bounds.low[a] = std::min(bounds.low[a], scene.vertices[v][a]);
          bounds.high[a] = std::max(bounds.high[a], scene.vertices[v][a]);
        }
      }
    }
    most_of.push_back(2 * part_of_body * static_cast<double>(bounds.half_size()));
  }
  const std::vector<OpenEdge> edges = open_edges_of(table, [&](std::uint32_t face) { return body_of[face]; });
  const std::vector<VertexIndex> vertices = ends_of(edges);
  std::vector<double> reach(vertices.size(), std::numeric_limits<double>::infinity());
  for (const OpenEdge& edge : edges) {
    const double length = std::sqrt(square_of_distance(scene.vertices[edge.from], scene.vertices[edge.to]));
    const double most = std::min(part_of_edge * length, most_of[edge.body]);
    for (const VertexIndex v : {edge.from, edge.to}) {
      double& of_end = reach[static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin())];
      of_end = std::min(of_end, most);
    }
  }
  const geometry::BoxTree tree(boxes_at(scene.vertices, vertices));
  std::vector<double> distances;
  std::vector<std::uint32_t> group(vertices.size());  // of those that are near each other: one of them
  std::iota(group.begin(), group.end(), 0U);
  const auto group_of = [&group](std::uint32_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const PolyPoint& p = scene.vertices[vertices[i]];
    double nearest = 0;
    std::uint32_t neighbour = i;
    const auto visit = [&](std::uint32_t other) {
      const double square = square_of_distance(p, scene.vertices[vertices[other]]);
      if (other == i || square >= nearest || square >= reach[other] * reach[other]) return;
      nearest = square;
      neighbour = other;
    };
    // Most have a neighbour much nearer than the farthest that counts.
    double most = 0;
    for (double radius = 1; neighbour == i && most < reach[i]; radius *= 4) {
      most = std::min(radius, reach[i]);
      nearest = most * most;
      const auto meets = [&](const geometry::Box& box) { return geometry::segment_meets(p, p, box, std::sqrt(nearest)); };
      tree.for_each_that(meets, visit);
    }
    if (neighbour == i) continue;
    distances.push_back(std::sqrt(nearest));
  }
  if (distances.empty()) return distances;
  std::sort(distances.begin(), distances.end());
  // Of more than two vertices at one place the nearest one of each does not tell which belong together.
  const double together = 2 * distances[distances.size() / 2];
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const PolyPoint& p = scene.vertices[vertices[i]];
    const auto meets = [&](const geometry::Box& box) { return geometry::segment_meets(p, p, box, std::min(together, reach[i])); };
    tree.for_each_that(meets, [&](std::uint32_t other) { group[group_of(i)] = group_of(other); });
  }
  // Edges that would be the same if all of these were joined.
  std::vector<std::array<std::uint32_t, 2>> joined;
  for (const OpenEdge& edge : edges) {
    const auto group_at = [&](VertexIndex v) {
      return group_of(static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin()));
    };
    const std::uint32_t a = group_at(edge.from);
    const std::uint32_t b = group_at(edge.to);
    if (a != b) joined.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(joined.begin(), joined.end());
  std::size_t joints = 0;
  for (std::size_t i = 1; i < joined.size(); ++i) joints += joined[i] == joined[i - 1] ? 1U : 0U;
  if (joints < least_joints) return {};
  distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
  return distances;
}

}  // namespace sightline::scene
