#include "host/app/commands/jones_session.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "host/app/outputs.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/raster_image.hpp"
#include "host/picture/stroke_drawing.hpp"

namespace sightline::app {

programs::jones::Session session_of(const scene::CellScene& scene, const std::string& source,
                                  const programs::jones::ProgramOptions& options) {
  auto session = programs::jones::Session::of(scene, options);
  if (!session) {
    session.error().file = source;
    throw base::bad_input(session.error().message());
  }
  return std::move(*session);
}

void require_twin(const programs::jones::CheckedRun& run, const std::string& source) {
  if (run.difference.empty()) return;
  throw base::difference(fmt::format("{}: internal error: the view on the PDP-7 is not the one its native twin "
                            "computes: {}",
                            source, run.difference));
}

std::string title_of(const std::string& scene_name, bool eae) {
  return scene_name + ", Jones 1971 on the PDP-7 " + (eae ? "with" : "without") + " EAE";
}

double seconds(core::Duration time) {
  return core::in_seconds(time);
}

double refreshes_per_second(const programs::jones::GuestRun& run) {
  return run.refresh_period.count() > 0 ? 1.0 / seconds(run.refresh_period) : 0.0;
}

std::vector<std::string> write_jones_pictures(const std::string& directory, const std::string& stem,
                                              const std::string& title, const programs::jones::GuestRun& run) {
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
  write_png(points, picture::crisp_raster(run.pass), describe("every point lit in one complete pass"));
  points.commit();
  Output lines = open(".svg");
  lines.write(picture::svg_drawing(run.pass, title));
  lines.commit();
  if (run.photograph.empty()) return paths;
  picture::PhosphorPhotograph photograph(run.shutter_close - photograph_time, run.shutter_close);
  photograph.expose(run.photograph);
  Output screen = open("-phosphor.png");
  write_png(screen, photograph.develop(), describe("the P7 screen, shutter open for 0.2 s"));
  screen.commit();
  return paths;
}

std::string file_stem(const std::string& scene_name) {
  std::string stem = scene_name;
  std::replace_if(
      stem.begin(), stem.end(),
      [](char c) {
        return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                 c == '_');
      },
      '_');
  return stem;
}

}  // namespace sightline::app
