#include "host/app/commands/stripes_demo.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "host/app/outputs.hpp"
#include "host/app/scene_argument.hpp"
#include "host/picture/raster_image.hpp"

namespace sightline::app {

namespace stripes = programs::stripes;

std::vector<StripesDemoRow> run_stripes_demo(const std::string& directory) {
  std::vector<StripesDemoRow> rows{{"roberts"}, {"house"}, {"boxes-20"}, {"boxes-20", false, true}, {"roberts", true}};
  make_directory(directory);
  for (StripesDemoRow& row : rows) {
    const scene::PolyScene scene = load_scene(row.scene).scene;
    stripes::StreamOptions options;
    options.output = row.plotter ? stripes::Output::vector : stripes::Output::raster;
    if (row.antialias) options.build = stripes::Build::coverage;
    row.drawn = value_of(stripes::run({.scene = scene, .view = stripes::view_of(scene, scene.camera), .options = options, .check = true}), row.scene);
    if (row.plotter) continue;
    constexpr int scale = 3;
    Output png((std::filesystem::path(directory) / stripes_picture(row)).string());
    write_png(png, picture::raster_image(row.drawn.picture.raster, picture::RasterPalette::grey, scale),
              {{"Title", fmt::format("{}, Montani and Re 1985 on the 8080, EF9365 board", row.scene)}, {"Software", "sightline"}});
    png.commit();
  }
  return rows;
}

std::string stripes_picture(const StripesDemoRow& row) {
  return row.scene + (row.antialias ? "-stripes-antialias.png" : "-stripes.png");
}

std::string stripes_demo_table(const std::vector<StripesDemoRow>& rows) {
  std::string text = fmt::format("{:<11}{:>9}{:>7}{:>13}{:>15}{:>12}{:>10}\n", "scene", "device", "faces", "bytes sent",
                                 "priority list", "drawing", "seconds");
  for (const StripesDemoRow& row : rows) {
    const stripes::MachinePicture& picture = row.drawn.picture;
    text += fmt::format("{:<11}{:>9}{:>7}{:>13}{:>15.2f}{:>12.2f}{:>10.2f}\n", row.scene, row.plotter ? "plotter" : row.antialias ? "greys" : "raster",
                        row.drawn.scene.faces.size(), row.drawn.stream.bytes.size(), core::in_seconds(picture.ranking),
                        core::in_seconds(picture.drawing), core::in_seconds(picture.receiving + picture.working()));
  }
  text += "Seconds at 3 MHz; the last column has the receipt, too. Stripes and priority list are made by the 8080. Greys: edges antialiased.\n";
  return text;
}

void add_stripes_demo(base::Json& document, const std::vector<StripesDemoRow>& rows) {
  document["stripes"] = base::Json::array();
  for (const StripesDemoRow& row : rows) {
    const stripes::MachinePicture& picture = row.drawn.picture;
    document["stripes"].push_back({{"scene", row.scene},
                                   {"device", row.plotter ? "calcomp" : "raster"},
                                   {"antialias", row.antialias},
                                   {"faces", row.drawn.scene.faces.size()},
                                   {"scene_bytes", row.drawn.stream.bytes.size()},
                                   {"receiving_seconds", core::in_seconds(picture.receiving)},
                                   {"priority_seconds", core::in_seconds(picture.ranking)},
                                   {"drawing_seconds", core::in_seconds(picture.drawing)}});
  }
}

}  // namespace sightline::app
