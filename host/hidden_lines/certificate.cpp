#include "host/hidden_lines/certificate.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "host/geometry/integer.hpp"

namespace sightline::hidden_lines {
namespace {

using algorithms::exact::EdgeProof;
using algorithms::exact::Witness;
using geometry::Int128;

class Text {
 public:
  Text& operator<<(std::string_view text) {
    text_ += text;
    return *this;
  }
  Text& operator<<(std::int64_t number) {
    std::array<char, 20> digits{};
    text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
    return *this;
  }
  Text& operator<<(const geometry::Rational& r) { return *this << r.numerator() << "/" << r.denominator(); }
  Text& operator<<(const scene::PolyPoint& p) { return *this << " " << p[0] << " " << p[1] << " " << p[2] << "\n"; }
  // std::to_chars does not take 128 bits.
  Text& wide(Int128 number) {
    std::string digits;
    const bool negative = number < 0;
    for (; number != 0; number /= 10) digits += static_cast<char>('0' + static_cast<int>(number % 10) * (negative ? -1 : 1));
    if (negative) digits += '-';
    std::reverse(digits.begin(), digits.end());
    return *this << (digits.empty() ? "0" : digits);
  }
  void reserve(std::size_t size) { text_.reserve(size); }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void append_scene(const scene::PolyScene& scene, Text& text) {
  // The ends of intersections are not on the grid; their lines contain them.
  const std::size_t vertices = scene.crossings.empty() ? scene.vertices.size() : scene.crossings.front().from;
  for (std::size_t v = 0; v < vertices; ++v) text << "vertex" << scene.vertices[v];
  std::uint32_t number = 0;
  const auto append_ring = [&text](const scene::Ring& ring) {
    for (const scene::VertexIndex v : ring) text << " " << v;
  };
  for (const scene::PolyBody& body : scene.bodies) {
    text << (body.sheet ? "sheet\n" : "solid\n");
    for (const scene::PolyFace& face : body.faces) {
      text << "face " << (scene.surface_of.empty() ? number : scene.surface_of[number]);
      ++number;
      append_ring(face.outline);
      for (const scene::Ring& hole : face.holes) {
        text << " /";
        append_ring(hole);
      }
      text << "\n";
    }
  }
}

// The faces in which an intersection lies, and its ends over their denominators: at most 80 over 61 bits.
void append_intersection(const scene::PolyScene& scene, const scene::PolyCrossing& crossing, Text& text) {
  text << "intersection " << crossing.face_a << " " << crossing.face_b;
  for (const scene::CutPoint& end : crossing.ends) {
    const int turn = end.a > end.b ? 1 : -1;
    for (std::size_t a = 0; a < 3; ++a) {
      text << " ";
      text.wide(turn * (Int128{scene.vertices[end.q][a]} * end.a - Int128{scene.vertices[end.p][a]} * end.b));
    }
    text << " " << turn * (end.a - end.b);
  }
}

void append_witnesses(std::string_view side, std::span<const Witness> witnesses, Text& text) {
  for (const Witness& witness : witnesses) {
    text << side << " " << witness.low << " " << witness.high << " ";
    if (witness.face == Witness::behind_eye) text << "behind\n";
    else text << witness.face << "\n";
  }
}

void append_reasons(const EdgeProof& proof, Text& text) {
  if (proof.reason == EdgeProof::Reason::turned_away) {
    text << "turned\n";
    return;
  }
  if (proof.reason == EdgeProof::Reason::point) text << "point\n";
  if (proof.left == proof.right) return append_witnesses("both", proof.left, text);
  append_witnesses("left", proof.left, text);
  append_witnesses("right", proof.right, text);
}

}  // namespace

std::string certificate_of(const scene::PolyScene& scene, const Camera& camera, const Proof& proof) {
  Text text;
  text.reserve(32 * (scene.vertices.size() + scene::face_count(scene) + proof.edges.size()));
  text << "sightline-certificate 1\nview " << (camera.perspective ? "perspective" : "parallel") << "\neye" << camera.eye << "forward"
       << camera.forward << "rightward" << camera.right << "upward" << camera.up;
  append_scene(scene, text);
  std::vector<scene::PolyWire> wires;
  for (const auto& [a, b] : scene.wires) wires.push_back({std::min(a, b), std::max(a, b)});
  std::sort(wires.begin(), wires.end());
  for (std::size_t e = 0; e < proof.edges.size(); ++e) {
    const EdgeProof& edge = proof.edges[e];
    const auto [from, to] = edge.edge;
    if (const scene::PolyCrossing* const crossing = scene::crossing_at(scene, from)) {
      append_intersection(scene, *crossing, text);
    } else {
      text << (std::binary_search(wires.begin(), wires.end(), scene::PolyWire{from, to}) ? "wire " : "edge ") << from << " " << to;
    }
    if (proof.chosen) {
      const auto surfaces = proof.chosen->surfaces_at(e);
      if (!surfaces.empty()) text << " on";
      for (const std::uint32_t surface : surfaces) text << " " << surface;
    }
    text << "\n";
    append_reasons(edge, text);
  }
  text << "end\n";
  return text.take();
}

}  // namespace sightline::hidden_lines
