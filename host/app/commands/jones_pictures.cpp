#include "host/app/commands/jones_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <span>

#include "host/app/outputs.hpp"
#include "host/picture/apng.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/raster_image.hpp"
#include "host/picture/stroke_drawing.hpp"

namespace sightline::app {

namespace {

constexpr std::int64_t frame_rate = 25;
constexpr std::int64_t least_frames = 50;  // two seconds: a view of less is shown in slow motion
constexpr std::int64_t most_frames = 750;

// The points lit while the first view is computed, at equal times; the last frame stays for a second.
base::Bytes movie_of(const programs::jones::Outcome& outcome, const std::string& title) {
  const core::Duration length = outcome.film_end.time_since_epoch();
  const std::int64_t frames = std::clamp(length * frame_rate / core::seconds(1), least_frames, most_frames);
  const double speed = core::in_seconds(length) * frame_rate / static_cast<double>(frames);
  picture::ApngWriter movie({1, static_cast<std::uint16_t>(frame_rate)}, 0,
                            {{"Title", title},
                             {"Description", fmt::format("every point lit while lines are added at once, at {:.2f} of the machine's speed", speed)},
                             {"Software", "sightline"}});
  std::size_t lit = 0;
  for (std::int64_t frame = 1; frame <= frames; ++frame) {
    const core::Instant time = outcome.film_end - length * (frames - frame) / frames;
    while (lit < outcome.film.size() && outcome.film[lit].time <= time) ++lit;
    const picture::FrameTime shown{1, static_cast<std::uint16_t>(frame == frames ? 1 : frame_rate)};
    static_cast<void>(value_of(movie.add(picture::crisp_raster(std::span(outcome.film).first(lit)), shown)));
  }
  return value_of(movie.finish());
}

}  // namespace

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
  if (outcome.film.empty()) return paths;
  Output movie = open(".apng");
  movie.write(movie_of(outcome, title));
  movie.commit();
  return paths;
}

}  // namespace sightline::app
