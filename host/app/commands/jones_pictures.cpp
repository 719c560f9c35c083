#include "host/app/commands/jones_pictures.hpp"

#include <filesystem>

#include "host/app/outputs.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/raster_image.hpp"
#include "host/picture/stroke_drawing.hpp"

namespace sightline::app {

std::string title_of(const std::string& scene_name, bool eae) {
  return scene_name + ", Jones 1971 on the PDP-7 " + (eae ? "with" : "without") + " EAE";
}

std::vector<std::string> write_jones_pictures(const std::string& directory, const std::string& stem,
                                              const std::string& title, const programs::jones::Outcome& outcome) {
  make_directory(directory);
  const std::string base = (std::filesystem::path(directory) / stem).string();
  std::vector<std::string> paths;
  const auto open = [&](const char* ending) {
    paths.push_back(base + ending);
    return Output(paths.back());
  };
  const auto describe = [&](const char* what) -> picture::TextEntries {
    return {{"Title", title}, {"Description", what}, {"Software", "sightline"}};
  };
  Output points = open(".png");
  write_png(points, picture::crisp_raster(outcome.pass), describe("every point lit in one complete pass"));
  points.commit();
  Output lines = open(".svg");
  lines.write(picture::svg_drawing(outcome.pass, title));
  lines.commit();
  if (outcome.photograph.empty()) return paths;
  picture::PhosphorPhotograph photograph(outcome.shutter_close - photograph_time, outcome.shutter_close);
  photograph.expose(outcome.photograph);
  Output screen = open("-phosphor.png");
  write_png(screen, photograph.develop(), describe("the P7 screen, shutter open for 0.2 s"));
  screen.commit();
  return paths;
}

}  // namespace sightline::app
