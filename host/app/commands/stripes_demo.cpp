#include "host/app/commands/stripes_demo.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

#include "host/app/outputs.hpp"
#include "host/app/scene_argument.hpp"
#include "host/picture/raster_image.hpp"

namespace sightline::app {

namespace stripes = programs::stripes;

std::vector<StripesDemoRow> run_stripes_demo(const std::string& directory) {
  std::vector<StripesDemoRow> rows;
  make_directory(directory);
  for (const auto& [name, plotter] : {std::pair("roberts", false), std::pair("house", false), std::pair("boxes-20", false),
                                      std::pair("roberts", true)}) {
    const scene::PolyScene scene = load_scene(name).scene;
    stripes::StreamOptions options;
    options.output = plotter ? stripes::Output::vector : stripes::Output::raster;
    rows.push_back({name, plotter,
                    value_of(stripes::run({.scene = scene, .view = stripes::view_of(scene, scene.camera), .options = options, .check = true}),
                             name)});
    if (plotter) continue;
    constexpr int scale = 3;
    Output png((std::filesystem::path(directory) / (std::string(name) + "-stripes.png")).string());
    write_png(png, picture::raster_image(rows.back().drawn.picture.raster, picture::RasterPalette::grey, scale),
              {{"Title", fmt::format("{}, Montani and Re 1985 on the 8080, EF9365 board", name)}, {"Software", "sightline"}});
    png.commit();
  }
  return rows;
}

std::string stripes_demo_table(const std::vector<StripesDemoRow>& rows) {
  std::string text = fmt::format("{:<11}{:>9}{:>7}{:>13}{:>15}{:>12}{:>10}\n", "scene", "device", "faces", "bytes sent",
                                 "priority list", "drawing", "seconds");
  for (const StripesDemoRow& row : rows) {
    const stripes::MachinePicture& picture = row.drawn.picture;
    text += fmt::format("{:<11}{:>9}{:>7}{:>13}{:>15.2f}{:>12.2f}{:>10.2f}\n", row.scene, row.plotter ? "plotter" : "raster",
                        row.drawn.scene.faces.size(), row.drawn.stream.bytes.size(), core::in_seconds(picture.ranking),
                        core::in_seconds(picture.drawing), core::in_seconds(picture.receiving + picture.working()));
  }
  text += "Seconds at 3 MHz; the last column has the receipt, too. Stripes and priority list are made by the 8080.\n";
  return text;
}

void add_stripes_demo(base::Json& document, const std::vector<StripesDemoRow>& rows) {
  document["stripes"] = base::Json::array();
  for (const StripesDemoRow& row : rows) {
    const stripes::MachinePicture& picture = row.drawn.picture;
    document["stripes"].push_back({{"scene", row.scene},
                                   {"device", row.plotter ? "calcomp" : "raster"},
                                   {"faces", row.drawn.scene.faces.size()},
                                   {"scene_bytes", row.drawn.stream.bytes.size()},
                                   {"receiving_seconds", core::in_seconds(picture.receiving)},
                                   {"priority_seconds", core::in_seconds(picture.ranking)},
                                   {"drawing_seconds", core::in_seconds(picture.drawing)}});
  }
}

}  // namespace sightline::app
