#include "host/report/experiments/guest_runs.hpp"

#include <fmt/core.h>

#include <utility>

#include "host/base/value_of.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/raster_image.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::report {

namespace {

namespace jones = programs::jones;

std::string name_of(const JonesOrder& order) {
  return fmt::format("{}, {} EAE", order.scene, order.eae ? "with" : "without");
}

}  // namespace

JonesRun run_jones(const JonesOrder& order) {
  auto scene = scene::load_cell_scene(order.scene);
  if (!scene) throw base::bad_input(scene.error().message());
  auto program = base::value_of(jones::Prepared::of(*scene, {.eae = order.eae}), order.scene);
  jones::Order of_program;
  of_program.stereo = order.stereo;
  if (order.photograph) of_program.photograph = shutter_time;
  of_program.check = true;
  auto outcome = base::value_of(program.run(of_program), name_of(order));
  if (outcome.view().status != jones::Status::complete)
    throw base::program_failed(fmt::format("{}: the view stopped: {}", name_of(order), jones::name(outcome.view().status)));
  auto twin = base::value_of(program.twin(of_program), name_of(order));
  return {std::move(*scene), std::move(program), std::move(outcome), twin.counts};
}

double seconds(core::Duration time) {
  return core::in_seconds(time);
}

Picture crisp_png(const JonesRun& run) {
  return png_picture(picture::crisp_raster(run.outcome.pass));
}

Picture phosphor_png(const JonesRun& run) { return phosphor_png(run.outcome); }

Picture phosphor_png(const jones::Outcome& outcome) {
  const core::Instant close = outcome.shutter_close;
  picture::PhosphorPhotograph photograph(close - shutter_time, close);
  photograph.expose(outcome.photograph);
  // A quarter of the points: the beam is wider than a point.
  const picture::Image film = photograph.develop();
  picture::Image image(film.width / 2, film.height / 2, film.channels);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const std::size_t channel = i % static_cast<std::size_t>(image.channels);
    const int column = static_cast<int>(i / static_cast<std::size_t>(image.channels)) % image.width;
    const int row = static_cast<int>(i / static_cast<std::size_t>(image.channels)) / image.width;
    unsigned sum = 0;
    for (const int down : {0, 1})
      for (const int right : {0, 1}) sum += film.pixels[film.index(2 * column + right, 2 * row + down) + channel];
    image.pixels[i] = static_cast<std::uint8_t>(sum / 4);
  }
  return png_picture(image);
}

}  // namespace sightline::report
