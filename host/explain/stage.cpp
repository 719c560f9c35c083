#include "host/explain/stage.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::explain {
namespace {

using geometry::dot;

Space between(const Space& a, const Space& b, double t) {
  return {a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t};
}

constexpr double widest = 1;  // the tangent of 45 degrees

}  // namespace

ImageStage::ImageStage(const scene::PolyScene& scene, const scene::PolyCamera& camera)
    : scene_(scene), camera_(camera), view_(camera) {
  double farthest = 1;
  for (const auto& vertex : scene.vertices) farthest = std::max(farthest, std::abs(view_.at(vertex)[2]));
  nearest_ = camera.perspective ? farthest / 1000 : -1e300;
  bool first = true;
  for (const picture::LineEdge& edge : picture::edges_of(scene)) {
    for (const Point& p : line_in_image(space(scene.vertices[edge.from]), space(scene.vertices[edge.to]))) {
      for (std::size_t a = 0; a < 2; ++a) {
        const double value = camera.perspective ? std::clamp(p[a], -widest, widest) : p[a];
        low_[a] = first ? value : std::min(low_[a], value);
        high_[a] = first ? value : std::max(high_[a], value);
      }
      first = false;
    }
  }
  const double margin = std::max({high_[0] - low_[0], high_[1] - low_[1], 1e-6}) * 0.04;
  for (std::size_t a = 0; a < 2; ++a) {
    low_[a] -= margin;
    high_[a] += margin;
    if (!camera.perspective) continue;
    low_[a] = std::max(low_[a], -widest);
    high_[a] = std::min(high_[a], widest);
  }
}

Point ImageStage::project(const Space& p) const {
  return camera_.perspective ? Point{p[0] / p[2], p[1] / p[2]} : Point{p[0], p[1]};
}

// Clips a line to the part in front of the eye; false if nothing is left.
bool ImageStage::cut(Space& from, Space& to) const {
  if (!camera_.perspective) return true;
  if (from[2] < nearest_ && to[2] < nearest_) return false;
  if (from[2] < nearest_) from = between(from, to, (nearest_ - from[2]) / (to[2] - from[2]));
  if (to[2] < nearest_) to = between(to, from, (nearest_ - to[2]) / (from[2] - to[2]));
  return true;
}

Sheet ImageStage::sheet(std::string title) const { return {std::move(title), low_, high_}; }

std::vector<Point> ImageStage::line_in_image(const Space& from, const Space& to) const {
  Space a = view_.at(from);
  Space b = view_.at(to);
  if (!cut(a, b)) return {};
  return {project(a), project(b)};
}

std::vector<Point> ImageStage::outline_in_image(std::span<const Space> corners) const {
  std::vector<Point> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Space a = view_.at(corners[i]);
    Space b = view_.at(corners[(i + 1) % corners.size()]);
    const bool leaves = camera_.perspective && b[2] < nearest_;
    if (!cut(a, b)) continue;
    points.push_back(project(a));
    if (leaves) points.push_back(project(b));
  }
  return points;
}

void ImageStage::add_line(std::vector<Mark>& marks, Look look, const Space& from, const Space& to) const {
  std::vector<Point> points = line_in_image(from, to);
  if (!points.empty()) marks.push_back(line(look, std::move(points)));
}

void ImageStage::add_area(std::vector<Mark>& marks, Look look, std::span<const Space> corners) const {
  std::vector<Point> points = outline_in_image(corners);
  if (points.size() > 2) marks.push_back(area(look, std::move(points)));
}

void ImageStage::add_edge(std::vector<Mark>& marks, Look look, const picture::LineEdge& edge) const {
  add_line(marks, look, space(scene_.vertices[edge.from]), space(scene_.vertices[edge.to]));
}

void ImageStage::add_piece(std::vector<Mark>& marks, Look look, const picture::LinePiece& piece) const {
  const Space from = space(scene_.vertices[piece.edge.from]);
  const Space to = space(scene_.vertices[piece.edge.to]);
  add_line(marks, look, between(from, to, piece.low.to_double()), between(from, to, piece.high.to_double()));
}

std::vector<Space> ImageStage::corners_of(const scene::PolyFace& face) const {
  std::vector<Space> corners;
  for (const scene::VertexIndex v : face.outline) corners.push_back(space(scene_.vertices[v]));
  return corners;
}

void ImageStage::add_face(std::vector<Mark>& marks, Look look, const scene::PolyFace& face) const {
  add_area(marks, look, corners_of(face));
}

void ImageStage::add_names(std::vector<Mark>& marks, Look look, const picture::LineEdge& edge) const {
  for (const scene::VertexIndex end : {edge.from, edge.to}) {
    const Space p = view_.at(space(scene_.vertices[end]));
    if (camera_.perspective && p[2] < nearest_) continue;
    const Point at = project(p);
    if (at[0] >= low_[0] && at[0] <= high_[0] && at[1] >= low_[1] && at[1] <= high_[1]) marks.push_back(text(look, at, std::to_string(end)));
  }
}

void ImageStage::add_label(std::vector<Mark>& marks, Look look, const std::vector<Point>& outline, std::string words, double height) const {
  std::vector<Point> shown = cut_outline(outline, 1, 0, low_[0]);
  shown = cut_outline(shown, -1, 0, -high_[0]);
  shown = cut_outline(shown, 0, 1, low_[1]);
  shown = cut_outline(shown, 0, -1, -high_[1]);
  if (!shown.empty()) marks.push_back(label(look, label_point(shown, height), std::move(words)));
}

std::vector<Mark> ImageStage::wire_frame(Look look) const {
  std::vector<Mark> marks;
  for (const picture::LineEdge& edge : picture::edges_of(scene_)) add_edge(marks, look, edge);
  return marks;
}

std::vector<Point> ImageStage::region(std::span<const std::array<double, 4>> planes) const {
  std::vector<Point> outline{low_, {high_[0], low_[1]}, high_, {low_[0], high_[1]}};
  const Space eye = space(camera_.eye);
  for (const auto& plane : planes) {
    const Space normal{plane[0], plane[1], plane[2]};
    const double a = dot(normal, view_.axis(0));
    const double b = dot(normal, view_.axis(1));
    const double rest = camera_.perspective ? dot(normal, view_.axis(2)) : dot(normal, eye) - plane[3];
    outline = cut_outline(outline, a, b, -rest);
  }
  return outline;
}

std::vector<Point> cut_outline(const std::vector<Point>& outline, double a, double b, double c) {
  std::vector<Point> left;
  const auto value = [&](const Point& p) { return a * p[0] + b * p[1] - c; };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& p = outline[i];
    const Point& q = outline[(i + 1) % outline.size()];
    const double at_p = value(p);
    const double at_q = value(q);
    if (at_p >= 0) left.push_back(p);
    if ((at_p < 0) != (at_q < 0)) {
      const double t = at_p / (at_p - at_q);
      left.push_back({p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t});
    }
  }
  return left;
}

Point label_point(const std::vector<Point>& outline, double height) {
  const auto [lowest, highest] =
      std::minmax_element(outline.begin(), outline.end(), [](const Point& p, const Point& q) { return p[1] < q[1]; });
  const double y = (*lowest)[1] + ((*highest)[1] - (*lowest)[1]) * height;
  std::vector<double> crossings;
  Point mean{};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& p = outline[i];
    const Point& q = outline[(i + 1) % outline.size()];
    if ((p[1] < y) != (q[1] < y)) crossings.push_back(p[0] + (q[0] - p[0]) * (y - p[1]) / (q[1] - p[1]));
    for (std::size_t a = 0; a < 2; ++a) mean[a] += p[a] / static_cast<double>(outline.size());
  }
  if (crossings.empty()) return mean;
  std::sort(crossings.begin(), crossings.end());
  std::size_t longest = 0;
  for (std::size_t i = 2; i + 1 < crossings.size(); i += 2)
    if (crossings[i + 1] - crossings[i] > crossings[longest + 1] - crossings[longest]) longest = i;
  return {(crossings[longest] + crossings[longest + 1]) / 2, y};
}

PlanStage::PlanStage(const scene::PolyScene& scene, const scene::PolyCamera& camera) : scene_(scene), camera_(camera) {
  const auto largest = [](const scene::PolyPoint& v, std::size_t besides) {
    std::size_t found = besides == 0 ? 1 : 0;
    for (std::size_t a = 0; a < 3; ++a)
      if (a != besides && std::abs(v[a]) > std::abs(v[found])) found = a;
    return found;
  };
  vertical_ = largest(camera.up, 3);
  along_ = largest(camera.forward, vertical_);
  across_ = 3 - vertical_ - along_;
  along_sign_ = camera.forward[along_] < 0 ? -1 : 1;
  across_sign_ = camera.right[across_] < 0 ? -1 : 1;
  bool first = true;
  const auto take = [&](const scene::PolyPoint& vertex) {
    const Point p = at(space(vertex));
    for (std::size_t a = 0; a < 2; ++a) {
      low_[a] = first ? p[a] : std::min(low_[a], p[a]);
      high_[a] = first ? p[a] : std::max(high_[a], p[a]);
    }
    first = false;
  };
  for (const auto& vertex : scene.vertices) take(vertex);
  if (camera.perspective) take(camera.eye);
  const double margin = std::max({high_[0] - low_[0], high_[1] - low_[1], 1e-6}) * 0.06;
  for (std::size_t a = 0; a < 2; ++a) {
    low_[a] -= margin;
    high_[a] += margin;
  }
}

std::vector<Mark> PlanStage::arrow() const {
  Point along = at(space(camera_.forward));
  const double length = std::hypot(along[0], along[1]);
  if (length == 0) return {};  // the camera looks along the axis of the plan
  for (double& part : along) part /= length;
  const double reach = std::max(high_[0] - low_[0], high_[1] - low_[1]) * 0.1;
  Point from = at(space(camera_.eye));
  if (!camera_.perspective) {
    // The distance from the sheet's centre back to where the line through it enters the sheet.
    double back = 1e300;
    for (std::size_t a = 0; a < 2; ++a)
      if (along[a] != 0) back = std::min(back, (high_[a] - low_[a]) / 2 / std::abs(along[a]));
    for (std::size_t a = 0; a < 2; ++a) from[a] = (low_[a] + high_[a]) / 2 - along[a] * back;
  }
  const auto point = [&](double forward, double left) {
    return Point{from[0] + reach * (forward * along[0] - left * along[1]), from[1] + reach * (forward * along[1] + left * along[0])};
  };
  return {line(Look::now, {from, point(1, 0)}), line(Look::now, {point(0.7, 0.15), point(1, 0), point(0.7, -0.15)})};
}

Sheet PlanStage::sheet(std::string title) const { return {std::move(title), low_, high_}; }

std::vector<Mark> PlanStage::wire_frame(Look look) const {
  std::vector<Mark> marks;
  for (const picture::LineEdge& edge : picture::edges_of(scene_)) {
    const Point from = at(space(scene_.vertices[edge.from]));
    const Point to = at(space(scene_.vertices[edge.to]));
    if (from != to) marks.push_back(line(look, {from, to}));
  }
  return marks;
}

std::vector<Point> PlanStage::region(std::span<const std::array<double, 4>> planes) const {
  std::vector<Point> outline{low_, {high_[0], low_[1]}, high_, {low_[0], high_[1]}};
  for (const auto& plane : planes) {
    if (plane[vertical_] != 0) continue;
    outline = cut_outline(outline, -plane[across_] * across_sign_, -plane[along_] * along_sign_, -plane[3]);
  }
  return outline;
}

void Steps::count(std::string_view name, std::uint64_t value) {
  const auto found = std::find_if(counts_.begin(), counts_.end(), [&](const Count& count) { return count.name == name; });
  if (found != counts_.end()) {
    found->value = value;
  } else {
    counts_.push_back({std::string(name), value});
  }
}

bool Steps::add(std::string caption, std::string section, std::vector<Layer> changes) {
  if (full_) return false;
  if (lesson_.steps.size() + 1 == most_steps) {
    full_ = lesson_.cut = true;
    lesson_.steps.push_back({"There are more steps than a lesson has room for: take a smaller scene to see the end.", {}, counts_, {}});
    return false;
  }
  lesson_.steps.push_back({std::move(caption), std::move(section), counts_, std::move(changes)});
  return true;
}

}  // namespace sightline::explain
