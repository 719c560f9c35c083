#include "host/report/experiments/guest_runs.hpp"

#include <fmt/core.h>

#include <utility>

#include "emulators/devices/ef9365_timing.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/raster_image.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::report {

namespace {

namespace jones = programs::jones;
namespace skala = programs::skala;

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

skala::View view_of(const SkalaOrder& order, bool visibility) {
  skala::View view;
  view.picture = order.picture;
  view.rotation = order.rotation;
  view.visibility = visibility;
  view.device = order.device;
  return view;
}

void check(const SkalaOrder& order, const skala::CheckedPicture& run) {
  const skala::GuestPicture& guest = run.guest;
  if (!guest.ended || guest.status != skala::Status::complete || !guest.faults.empty()) {
    const std::string_view why = !guest.ended            ? "it did not end"
                                 : !guest.faults.empty() ? guest.faults.front().what
                                                         : text_of(guest.status);
    throw base::program_failed(fmt::format("{}: the program on the 8080 failed: {}", order.function, why));
  }
  if (!run.difference.empty())
    throw base::difference(fmt::format("{}: internal error: the 8080's picture is not the one its native twin makes; {}",
                    order.function, run.difference));
}

// The program on the 8080 makes every dot with a command of its own.
core::TStates dot_time() {
  return core::ClockRate{}.t_states_in(devices::ef9365::clocks(devices::ef9365::start_up_clocks + 1));
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

SkalaRun run_skala(const skala::Session& session, const SkalaOrder& order) {
  const auto function = scene::height_function(order.function);
  if (!function) throw base::bad_input(order.function + ": no such function");
  const scene::HeightGrid grid = scene::sample(*function, order.size);
  const auto stream = skala::stream_of(grid, view_of(order, true));
  SkalaRun run;
  run.stream_bytes = stream.size();
  skala::GuestOptions machine;
  machine.device = order.device;
  skala::CheckedPicture checked = session.run(stream, machine);
  check(order, checked);
  run.twin = checked.twin.counts;
  run.guest = std::move(checked.guest);
  run.points_lit = skala::points_lit(run.guest);
  run.dots_busy = dot_time() * static_cast<std::int64_t>(run.twin.points_plotted);
  if (order.compare_plain) {
    const auto plain = session.run(skala::stream_of(grid, view_of(order, false)), machine);
    check(order, plain);
    run.plain = plain.guest.drawing;
  }
  return run;
}

std::string_view name_of(skala::PictureKind picture) {
  switch (picture) {
    case skala::PictureKind::lines: return "lines";
    case skala::PictureKind::surface: return "surface";
    case skala::PictureKind::contours: return "contours";
  }
  return "";
}

Picture raster_png(const SkalaRun& run, const SkalaOrder& order) {
  const bool surface = order.picture == skala::PictureKind::surface;
  const auto palette = surface ? picture::RasterPalette::grey : picture::RasterPalette::colour;
  return png_picture(picture::raster_image(run.guest.raster, palette, 1), true);
}

}  // namespace sightline::report
