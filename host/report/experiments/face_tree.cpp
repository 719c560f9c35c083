#include "host/report/experiments/face_tree.hpp"

#include <limits>
#include <utility>

#include "host/scene/cells/bsp/faces.hpp"
#include "host/scene/cells/bsp/polygon.hpp"
#include "host/scene/cells/builder.hpp"

namespace sightline::report {

FaceTree::FaceTree(const scene::PolyScene& scene) {
  scene::CellComplexBuilder builder(scene, scene::outer_box_of(scene));
  scene::BspTree tree = *scene::build_bsp_tree(scene::face_pieces(scene, builder), builder, std::numeric_limits<std::size_t>::max());
  planes_ = builder.take().planes;
  polygons_ = std::move(tree.faces);
  // The tree does not say in which node a face was kept: the first one on its way that has its plane.
  std::vector<std::vector<std::uint32_t>> in_plane(tree.nodes.size());
  for (std::uint32_t number = 0; number < polygons_.size(); ++number) {
    const scene::PlanePolygon& polygon = polygons_[number].polygon;
    std::uint32_t node = 0;
    while (tree.nodes[node].plane != polygon.plane)
      node = tree.nodes[node].children[scene::sides_of(planes_, polygon, tree.nodes[node].plane).behind ? 0 : 1];
    in_plane[node].push_back(number);
  }
  std::vector<std::uint32_t> place(tree.nodes.size(), leaf);
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
    if (!tree.nodes[i].is_leaf()) place[i] = count++;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].is_leaf()) continue;
    Node& node = nodes_.emplace_back();
    const geometry::Plane& plane = planes_[tree.nodes[i].plane];
    for (std::size_t axis = 0; axis < 3; ++axis) node.plane[axis] = static_cast<double>(plane.normal[axis]);
    node.plane[3] = -static_cast<double>(plane.offset);
    for (std::size_t child = 0; child < 2; ++child) node.children[child] = place[tree.nodes[i].children[child]];
    const auto add = [&](bool turned) {
      const auto first = static_cast<std::uint32_t>(seen_.size());
      for (const std::uint32_t number : in_plane[i])
        if (polygons_[number].sheet || polygons_[number].turned == turned) seen_.push_back(number);
      return first;
    };
    node.first = add(false);
    node.first_behind = add(true);
    node.end = static_cast<std::uint32_t>(seen_.size());
  }
}

void FaceTree::paint(const Eye& eye, std::vector<std::uint32_t>& order) const {
  order.clear();
  const auto scan = [&](const auto& itself, std::uint32_t number) -> void {
    if (number == leaf) return;
    const Node& node = nodes_[number];
    const double side = node.plane[0] * eye[0] + node.plane[1] * eye[1] + node.plane[2] * eye[2] + node.plane[3] * eye[3];
    itself(itself, node.children[side > 0 ? 0 : 1]);
    const std::uint32_t from = side > 0 ? node.first : node.first_behind;
    const std::uint32_t to = side > 0 ? node.first_behind : node.end;
    if (side != 0) order.insert(order.end(), seen_.begin() + from, seen_.begin() + to);
    itself(itself, node.children[side > 0 ? 1 : 0]);
  };
  scan(scan, nodes_.empty() ? leaf : 0);
}

}  // namespace sightline::report
