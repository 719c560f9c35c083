// Draws a tetrahedron behind a square with a hole, and counts what is seen.
#include <cstdio>
#include <fstream>
#include <sightline/hidden_lines.hpp>

int main() {
  sightline::Mesh mesh;
  mesh.vertices = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, 2}, {-4, -4, 5}, {4, -4, 5}, {4, 4, 5}, {-4, 4, 5},
                   {0, -1, 5}, {0, 1, 5}, {1, 1, 5}, {1, -1, 5}};
  for (const auto& face : {std::array{0U, 2U, 1U}, {0U, 1U, 3U}, {1U, 2U, 3U}, {2U, 0U, 3U}}) mesh.add_face(face);
  mesh.add_face(std::array{4U, 5U, 6U, 7U}, std::array{std::vector{8U, 9U, 10U, 11U}});
  const sightline::Drawing drawing = sightline::Scene(mesh).draw({.direction = sightline::Point{0, 0, -1}}, {.hidden = true});
  int visible = 0;
  for (const sightline::Part& part : drawing.parts) visible += part.hidden ? 0 : 1;
  std::ofstream("hidden_lines.svg") << drawing.file({.format = "svg"});
  std::printf("%zu edges, %d visible parts, %zu hidden\n", drawing.edges.size(), visible, drawing.parts.size() - static_cast<std::size_t>(visible));
}
