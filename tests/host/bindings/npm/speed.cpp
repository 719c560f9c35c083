// The time that speed.mjs measures, natively: SIDE x SIDE boxes (100 by default), scene and drawing with hidden lines, in milliseconds.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sightline/hidden_lines.hpp>

int main(int argc, char** argv) {
  const int side = argc > 1 ? std::atoi(argv[1]) : 100;
  sightline::Mesh mesh;
  for (int b = 0; b < side * side; ++b) {
    const int x = b % side;
    const int y = b / side;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < 8; ++i)
      mesh.vertices.push_back({3.0 * x + 2.0 * (i & 1), (i >> 1 & 1) * (1.0 + (x * 7 + y * 5) % 4), 3.0 * y + 2.0 * (i >> 2)});
    for (const char* triangle : {"026", "064", "157", "173", "045", "051", "237", "276", "013", "032", "467", "475"}) {
      for (int i = 0; i < 3; ++i) mesh.corners.push_back(first + static_cast<std::uint32_t>(triangle[i] - '0'));
      mesh.ring_sizes.push_back(3);
    }
  }
  using Clock = std::chrono::steady_clock;
  const auto milliseconds = [](Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); };
  for (int run = 0; run < 3; ++run) {
    const auto begin = Clock::now();
    const sightline::Scene scene(mesh);
    const auto loaded = Clock::now();
    const auto drawing = scene.draw({.view = "iso"}, {.hidden = true});
    const auto drawn = Clock::now();
    const auto bytes = drawing.file().size();
    const auto written = Clock::now();
    std::printf("scene %.0f, draw %.0f, SVG %.0f ms: %zu lines, %zu bytes\n", milliseconds(loaded - begin), milliseconds(drawn - loaded),
                milliseconds(written - drawn), drawing.lines.size(), bytes);
  }
}
