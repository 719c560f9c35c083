// Prints a sum of everything that the library for C++ returns for each of many random views. The tests of the other languages'
// libraries compute the same sums.
//
//   view_sums SEED BOXES VIEWS
//
// Numbers are drawn by s = 1664525 s + 1013904223 (mod 2^32), starting with SEED; a number below n is (s >> 8) mod n. A box has
// three numbers below 1000 for its low corner, then three below 300 for its size, which is one more. Its corners are in the order
// of x + 2 y + 4 z; its faces are 0264 1573 0451 2376 0132 4675. A view has three numbers below 1001 for a
// direction d, less 500 each; if none is 300 or more in magnitude, the first becomes 400. Views of even number look in the direction d; those
// of odd number from the eye 500 - 5 d (in every axis) at the middle. All are drawn with hidden lines.
//
// A line of output is the number of lines and the CRC-32 (that of zlib) of these arrays, one after the other, little-endian:
//   lines: from and to (4 doubles each); kind (byte); hidden (byte); edge_count (uint32); line_edges (uint32)
//   parts: edge (uint32); numerator and denominator of low and of high (4 int64 each); hidden (byte); hidden_by (uint32)
//   edges: kind (byte); ends (6 doubles each); vertices (2 uint32 each); face_count (uint32); body (uint32); faces (uint32)
#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sightline/hidden_lines.hpp>
#include <vector>

namespace {

class Numbers {
 public:
  explicit Numbers(std::uint32_t seed) : state_(seed) {}
  std::uint32_t below(std::uint32_t n) {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8) % n;
  }

 private:
  std::uint32_t state_;
};

sightline::Mesh boxes(Numbers& numbers, int count) {
  sightline::Mesh mesh;
  for (int b = 0; b < count; ++b) {
    std::array<double, 3> low{};
    std::array<double, 3> size{};
    for (double& c : low) c = numbers.below(1000);
    for (double& c : size) c = 1 + numbers.below(300);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < 8; ++i)
      mesh.vertices.push_back({low[0] + (i & 1) * size[0], low[1] + (i >> 1 & 1) * size[1], low[2] + (i >> 2) * size[2]});
    for (const char* face : {"0264", "1573", "0451", "2376", "0132", "4675"}) {
      for (int i = 0; i < 4; ++i) mesh.corners.push_back(first + static_cast<std::uint32_t>(face[i] - '0'));
      mesh.ring_sizes.push_back(4);
    }
  }
  return mesh;
}

sightline::Camera camera(Numbers& numbers, int view) {
  sightline::Point d{};
  bool large = false;
  for (double& c : d) {
    c = static_cast<double>(numbers.below(1001)) - 500;
    large = large || c >= 300 || c <= -300;
  }
  if (!large) d[0] = 400;
  if (view % 2 == 0) return {.direction = d};
  return {.eye = sightline::Point{500 - 5 * d[0], 500 - 5 * d[1], 500 - 5 * d[2]}};
}

class Sum {
 public:
  template <class Row, class Get>
  void add(const std::vector<Row>& rows, Get get) {
    for (const Row& row : rows) {
      const auto value = get(row);
      value_ = crc32(value_, reinterpret_cast<const unsigned char*>(&value), sizeof value);
    }
  }
  [[nodiscard]] unsigned long value() const { return value_; }

 private:
  unsigned long value_ = crc32(0, nullptr, 0);
};

std::uint8_t byte(bool value) { return value ? 1 : 0; }

unsigned long sum_of(const sightline::Drawing& drawing) {
  using sightline::Edge;
  using sightline::Line;
  using sightline::Part;
  Sum sum;
  sum.add(drawing.lines, [](const Line& l) { return std::array{l.from[0], l.from[1], l.to[0], l.to[1]}; });
  sum.add(drawing.lines, [](const Line& l) { return static_cast<std::uint8_t>(l.kind); });
  sum.add(drawing.lines, [](const Line& l) { return byte(l.hidden); });
  sum.add(drawing.lines, [](const Line& l) { return l.edge_count; });
  sum.add(drawing.line_edges, [](std::uint32_t e) { return e; });
  sum.add(drawing.parts, [](const Part& p) { return p.edge; });
  sum.add(drawing.parts, [](const Part& p) { return std::array{p.low.numerator, p.low.denominator, p.high.numerator, p.high.denominator}; });
  sum.add(drawing.parts, [](const Part& p) { return byte(p.hidden); });
  sum.add(drawing.parts, [](const Part& p) { return p.hidden_by; });
  sum.add(drawing.edges, [](const Edge& e) { return static_cast<std::uint8_t>(e.kind); });
  sum.add(drawing.edges, [](const Edge& e) { return e.ends; });
  sum.add(drawing.edges, [](const Edge& e) { return e.vertices; });
  sum.add(drawing.edges, [](const Edge& e) { return e.face_count; });
  sum.add(drawing.edges, [](const Edge& e) { return e.body; });
  sum.add(drawing.faces, [](std::uint32_t f) { return f; });
  return sum.value();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: view_sums SEED BOXES VIEWS\n");
    return 2;
  }
  Numbers numbers(static_cast<std::uint32_t>(std::atol(argv[1])));
  const sightline::Scene scene(boxes(numbers, std::atoi(argv[2])));
  const sightline::Prepared prepared = scene.prepare({.hidden = true});
  for (int view = 0; view < std::atoi(argv[3]); ++view) {
    const sightline::Drawing drawing = prepared.draw(camera(numbers, view));
    std::printf("%zu %08lx\n", drawing.lines.size(), sum_of(drawing));
  }
}
