#include "tests/tools/verify/certificate_scenes.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/exact/edge_scenes.hpp"

namespace sightline::tests {
namespace {

using Words = std::vector<std::string>;

std::vector<Words> words_of(const std::string& text) {
  std::vector<Words> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    Words& words = lines.emplace_back();
    std::istringstream of_line(line);
    for (std::string word; of_line >> word;) words.push_back(word);
  }
  return lines;
}

std::string text_of(const std::vector<Words>& lines) {
  std::string text;
  for (const Words& words : lines) {
    for (std::size_t w = 0; w < words.size(); ++w) text += (w > 0 ? " " : "") + words[w];
    text += '\n';
  }
  return text;
}

bool is_claim(const Words& words) {
  return words[0] == "left" || words[0] == "right" || words[0] == "both";
}

// Adds a little to a number, or to the upper part of a fraction.
void shift(std::string& word, Dice& dice) {
  const std::size_t bar = word.find('/');
  const long long by = dice(0, 1) == 0 ? (dice(0, 1) == 0 ? 1 : -1) : dice(-100, 100);
  word = std::to_string(std::stoll(word) + by) + (bar == std::string::npos ? "" : word.substr(bar));
}

std::size_t any(std::size_t count, Dice& dice) { return static_cast<std::size_t>(dice(0, static_cast<std::int32_t>(count) - 1)); }

// The number of a random line for which `is` holds; the number of lines if there is none.
template <class Is>
std::size_t any_line(const std::vector<Words>& lines, Dice& dice, Is is) {
  std::vector<std::size_t> found;
  for (std::size_t l = 0; l < lines.size(); ++l)
    if (is(lines[l])) found.push_back(l);
  return found.empty() ? lines.size() : found[any(found.size(), dice)];
}

void change_claim(std::vector<Words>& lines, Dice& dice) {
  const std::size_t at = any_line(lines, dice, is_claim);
  if (at == lines.size()) return;
  Words& claim = lines[at];
  switch (dice(0, 6)) {
    case 0: shift(claim[static_cast<std::size_t>(dice(1, 2))], dice); break;
    case 1: claim[1] = "0/1"; break;
    case 2: claim[2] = "1/1"; break;
    case 3: {  // an end of another claim
      const std::size_t other = any_line(lines, dice, is_claim);
      claim[static_cast<std::size_t>(dice(1, 2))] = lines[other][static_cast<std::size_t>(dice(1, 2))];
      break;
    }
    case 4:
      if (claim[3] == "behind") claim[3] = "0";
      else shift(claim[3], dice);
      break;
    case 5: {  // the face of another claim
      std::swap(claim[3], lines[any_line(lines, dice, is_claim)][3]);
      break;
    }
    default: {
      const std::array<std::string, 3> sides{"left", "right", "both"};
      claim[0] = sides[any(3, dice)];
    }
  }
}

// Boxes as a mesh of triangles whose vertices have been rounded: two triangles form a surface.
scene::PolyScene rounded_mesh(std::uint32_t seed) {
  scene::PolyScene scene = scene::generate_boxes(3, seed);
  Dice dice(seed);
  std::uint32_t surface = 0;
  for (scene::PolyBody& body : scene.bodies) {
    std::vector<scene::PolyFace> triangles;
    for (const scene::PolyFace& face : body.faces) {
      const scene::Ring& ring = face.outline;
      triangles.push_back({{ring[0], ring[1], ring[2]}, {}});
      triangles.push_back({{ring[0], ring[2], ring[3]}, {}});
      scene.surface_of.insert(scene.surface_of.end(), 2, surface++);
      const auto normal = geometry::normal_of(scene.vertices[ring[0]], scene.vertices[ring[1]], scene.vertices[ring[2]]);
      std::array<double, 3> direction{};
      for (std::size_t a = 0; a < 3; ++a) direction[a] = normal[a] > 0 ? 1 : normal[a] < 0 ? -1 : 0;
      scene.surfaces.push_back({direction});
    }
    body.faces = triangles;
  }
  for (scene::PolyPoint& vertex : scene.vertices)
    for (std::int32_t& c : vertex) c += dice(-1, 1);
  return scene;
}

}  // namespace

hidden_lines::Scene loaded(scene::PolyScene scene) {
  hidden_lines::Scene result;
  result.name = "scene";
  result.scene = std::move(scene);
  return result;
}

Drawn draw_with_proof(const hidden_lines::Scene& scene, const hidden_lines::Camera& camera, const hidden_lines::EdgeOptions& edges) {
  hidden_lines::ViewOptions options;
  options.edges = edges;
  options.proof = true;
  const auto views = hidden_lines::Views::of(scene, options, {&camera, 1});
  if (!views) throw std::runtime_error(views.error().message());
  const auto drawing = views->at(camera);
  if (!drawing) throw std::runtime_error(drawing.error().message());
  return {views->certificate(camera, *drawing), drawing->proof->edges.size(), drawing->visible.pieces.size()};
}

std::vector<std::string> certificates_to_change() {
  std::vector<std::string> certificates;
  const auto add = [&](const scene::PolyScene& scene, const scene::PolyCamera& camera, const hidden_lines::EdgeOptions& edges = {}) {
    certificates.push_back(draw_with_proof(loaded(scene), camera, edges).certificate);
  };
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    for (const scene::PolyScene& scene : {scene::generate_boxes(4, seed), scene::generate_bricks(4, seed), scene::generate_triangles(5, seed)}) {
      algorithms::RandomCameras cameras(scene, seed);
      add(scene, scene.camera);
      add(scene, cameras.outside(true));
      add(scene, cameras.outside(false));
    }
  }
  // In line with axes: edges behind common edges, and edges seen end-on.
  scene::PolyScene cubes = scene::generate_touch(1);
  for (scene::PolyPoint& vertex : cubes.vertices)
    for (std::int32_t& c : vertex) c /= 250;
  const scene::PolyBounds bounds = scene::bounds_of(cubes);
  add(cubes, {false, bounds.low, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  add(cubes, {false, bounds.low, {1, 0, 1}, {1, 0, -1}, {0, 1, 0}});
  add(cubes, {true, {bounds.middle()[0], bounds.middle()[1], bounds.low[2] - 3}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  // Two boxes through each other, of which only features are drawn.
  scene::PolyScene crossed = scene::generate_boxes(2, 1);
  for (std::size_t v = 8; v < 16; ++v)
    for (std::size_t a = 0; a < 3; ++a) crossed.vertices[v][a] = crossed.vertices[v - 8][a] + static_cast<std::int32_t>(a + 1) * 31;
  algorithms::RandomCameras cameras(crossed, 1);
  add(crossed, cameras.outside(true));
  add(crossed, cameras.outside(false), {"feature", 10});
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const scene::PolyScene mesh = rounded_mesh(seed);
    algorithms::RandomCameras around(mesh, seed);
    add(mesh, around.outside(true));
    add(mesh, around.outside(false));
    add(mesh, around.outside(true), {"all", {}});
  }
  return certificates;
}

std::string changed(const std::string& certificate, Dice& dice) {
  std::vector<Words> lines = words_of(certificate);
  const auto any_of_kind = [&](std::string_view kind) { return any_line(lines, dice, [kind](const Words& words) { return words[0] == kind; }); };
  switch (dice(0, 11)) {
    case 0: case 1: case 2: case 3: case 4: change_claim(lines, dice); break;
    case 5: {  // a line is missing
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(any(lines.size(), dice)));
      break;
    }
    case 6: {  // a line is twice
      const std::size_t at = any(lines.size(), dice);
      const Words copy = lines[at];
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), copy);
      break;
    }
    case 7: case 8: shift(lines[any_of_kind("vertex")][static_cast<std::size_t>(dice(1, 3))], dice); break;
    case 9: shift(lines[any_of_kind("eye")][static_cast<std::size_t>(dice(1, 3))], dice); break;
    case 10: {  // another reason, or another edge for the same reasons
      const std::size_t at = any_line(lines, dice, [](const Words& words) {
        return is_claim(words) || words[0] == "turned" || words[0] == "point" || words[0] == "edge" || words[0] == "intersection";
      });
      Words& line = lines[at];
      if (line[0] == "intersection" && dice(0, 1) == 0) line[static_cast<std::size_t>(dice(3, 10))].back() = static_cast<char>('0' + dice(0, 9));
      else if (line[0] == "edge" || line[0] == "intersection") shift(line[static_cast<std::size_t>(dice(1, 2))], dice);
      else line = {dice(0, 1) == 0 ? "turned" : "point"};
      break;
    }
    default: {  // the scene
      const std::size_t at =
          any_line(lines, dice, [](const Words& words) { return words[0] == "face" || words[0] == "solid" || words[0] == "sheet"; });
      if (lines[at].size() == 1) lines[at][0] = lines[at][0] == "solid" ? "sheet" : "solid";
      else if (dice(0, 2) == 0) std::reverse(lines[at].begin() + 2, lines[at].end());
      else shift(lines[at][1 + any(lines[at].size() - 1, dice)], dice);
    }
  }
  return text_of(lines);
}

}  // namespace sightline::tests
