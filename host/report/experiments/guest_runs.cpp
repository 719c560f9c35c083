#include "host/report/experiments/guest_runs.hpp"

#include <fmt/core.h>

#include <utility>

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

void check(const JonesOrder& order, const JonesRun& run, const std::string& difference) {
  const std::string name = name_of(order);
  if (run.guest.timed_out || run.guest.views.size() < 2)
    throw base::program_failed(name + ": the program did not complete two views");
  if (run.view().status != jones::Status::complete)
    throw base::program_failed(fmt::format("{}: the view stopped: {}", name, jones::name(run.view().status)));
  if (!difference.empty())
    throw base::difference(name + ": internal error: the view on the PDP-7 is not the one its native twin computes: " +
                      difference);
}

}  // namespace

JonesRun run_jones(const JonesOrder& order) {
  auto scene = scene::load_cell_scene(order.scene);
  if (!scene) throw base::bad_input(scene.error().message());
  jones::ProgramOptions program_options;
  program_options.eae = order.eae;
  auto session = jones::Session::of(*scene, program_options);
  if (!session) {
    session.error().file = order.scene;
    throw base::bad_input(session.error().message());
  }
  jones::GuestOptions options;
  options.stereo = order.stereo;
  if (order.photograph) options.photograph = shutter_time;
  jones::CheckedRun checked = session->run(options);
  JonesRun run{std::move(*scene), session->program(), std::move(checked.guest), checked.twin.counts};
  check(order, run, checked.difference);
  return run;
}

double seconds(core::Duration time) {
  return core::in_seconds(time);
}

Picture crisp_png(const JonesRun& run) {
  return png_picture(picture::crisp_raster(run.guest.pass));
}

Picture phosphor_png(const JonesRun& run) {
  const core::Instant close = run.guest.shutter_close;
  picture::PhosphorPhotograph photograph(close - shutter_time, close);
  photograph.expose(run.guest.photograph);
  // A quarter of the points: the beam is wider than one of them.
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
