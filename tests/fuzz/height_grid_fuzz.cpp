// Any bytes as a grid file, read by its content and with every option. Every grid is drawn as every kind of picture and figure.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>
#include <variant>

#include "host/algorithms/skala/figure.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/read_grid.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto points = scene::read_height_grid(text, "fuzz", {{"x", "2", "z"}});
  if (!points) static_cast<void>(points.error().message());
  for (const auto layout : {scene::GridLayout::matrix, scene::GridLayout::table, scene::GridLayout::points}) {
    const auto forced = scene::read_height_grid(text, "fuzz", {{}, layout});
    if (!forced) static_cast<void>(forced.error().message());
  }
  for (const auto& options : {scene::GridFileOptions{.nodata = 1, .thin = 2}, scene::GridFileOptions{.triangulate = scene::GridSize{9, 7}}}) {
    const auto read = scene::read_height_surface(text, "fuzz", options);
    if (!read) static_cast<void>(read.error().message());
  }
  if (const auto surface = scene::read_height_surface(text, "fuzz"); surface && std::holds_alternative<scene::SurfaceNet>(*surface)) {
    const auto& net = std::get<scene::SurfaceNet>(*surface);
    if (net.vertices.size() != net.points * net.curves || net.points < 2 || net.curves < 2) std::abort();
    if (net.vertices.size() <= 400) static_cast<void>(scene::import_poly(scene::mesh_of(net, {1, 1, 0.6}, "fuzz"), {.mend = true}));
  }
  const auto result = scene::read_height_grid(text, "fuzz");
  if (!result) return 0;
  algorithms::skala::View view;
  view.rotation = static_cast<double>(size % 48) * 7.5;
  view.zoom = size % 3 == 0 ? 4.0 : 1.0;
  for (const auto picture : {algorithms::skala::Subject::lines, algorithms::skala::Subject::surface,
                             algorithms::skala::Subject::contours}) {
    view.subject = picture;
    static_cast<void>(programs::skala::stream_of(*result, view));
  }
  constexpr std::size_t many = 400;
  if (result->heights.size() > many) return 0;
  algorithms::skala::View figure_view;
  figure_view.rotation = view.rotation;
  figure_view.elevation = static_cast<double>(size % 37) * 5 - 90;
  figure_view.columns = 64;
  figure_view.net = size % 2 == 0;
  for (const auto subject : {algorithms::skala::Subject::lines, algorithms::skala::Subject::surface, algorithms::skala::Subject::contours}) {
    figure_view.subject = subject;
    algorithms::skala::FigureOptions options;
    options.axes = options.floor = options.contour_labels = options.legend = true;
    const scene::HeightGrid grids[2] = {*result, *result};
    const auto figure = algorithms::skala::figure(std::span(grids, 1 + size % 2), figure_view, options);
    static_cast<void>(picture::svg_of(figure.drawing, {}, "fuzz"));
  }
  return 0;
}
