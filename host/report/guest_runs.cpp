#include "host/report/guest_runs.hpp"

#include <fmt/format.h>

#include <utility>

#include "emulators/devices/ef9365_timing.hpp"
#include "host/base/file.hpp"
#include "host/guests/skala/stream.hpp"
#include "host/picture/crisp_raster.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/png.hpp"
#include "host/picture/raster_image.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::harness::report {

namespace {

std::string name_of(const JonesOrder& order) {
  return fmt::format("{}, {} EAE", order.scene, order.eae ? "with" : "without");
}

std::optional<ReportError> check(const JonesOrder& order, const JonesRun& run,
                                 const std::string& difference) {
  const std::string name = name_of(order);
  if (run.guest.timed_out || run.guest.views.size() < 2)
    return ReportError{ErrorKind::guest_failed, name + ": the program did not complete two views"};
  if (run.view().status != guests::jones::Status::complete)
    return ReportError{ErrorKind::guest_failed,
                       fmt::format("{}: the view stopped: {}", name, guests::jones::name(run.view().status))};
  if (!difference.empty())
    return ReportError{
        ErrorKind::differs,
        name + ": internal error: the view on the PDP-7 is not the one its native twin computes: " + difference};
  return std::nullopt;
}

Outcome<base::Bytes> png_of(const picture::Image& image) {
  auto bytes = picture::encode_png(image, {{"Software", "sightline"}});
  if (!bytes) return ReportError{ErrorKind::file, bytes.error().message()};
  return std::move(*bytes);
}

guests::skala::View view_of(const SkalaOrder& order, bool visibility) {
  guests::skala::View view;
  view.picture = order.picture;
  view.rotation = order.rotation;
  view.visibility = visibility;
  return view;
}

std::optional<ReportError> check(const SkalaOrder& order, const guests::skala::CheckedPicture& run) {
  const guests::skala::GuestPicture& guest = run.guest;
  if (!guest.ended || guest.status != guests::skala::Status::complete || !guest.faults.empty()) {
    const std::string_view why = !guest.ended            ? "it did not end"
                                 : !guest.faults.empty() ? guest.faults.front().what
                                                         : text_of(guest.status);
    return ReportError{ErrorKind::guest_failed,
                       fmt::format("{}: the program on the 8080 failed: {}", order.function, why)};
  }
  if (run.difference.empty()) return std::nullopt;
  return ReportError{
      ErrorKind::differs,
      fmt::format("{}: internal error: the 8080's picture is not the one its native twin makes; {}",
                  order.function, run.difference)};
}

// The program on the 8080 makes every dot with a command of its own.
core::TStates dot_time() {
  return core::ClockRate{}.t_states_in(devices::ef9365::clocks(devices::ef9365::start_up_clocks + 1));
}

}  // namespace

Outcome<JonesRun> run_jones(const JonesOrder& order) {
  auto scene = scene::load_cell_scene(order.scene);
  if (!scene) return ReportError{ErrorKind::bad_input, scene.error().message()};
  guests::jones::ProgramOptions program_options;
  program_options.eae = order.eae;
  auto session = guests::jones::Session::of(*scene, program_options);
  if (!session) {
    session.error().file = order.scene;
    return ReportError{ErrorKind::bad_input, session.error().message()};
  }
  guests::jones::GuestOptions options;
  options.stereo = order.stereo;
  if (order.photograph) options.photograph = shutter_time;
  guests::jones::CheckedRun checked = session->run(options);
  JonesRun run{std::move(*scene), session->program(), std::move(checked.guest), checked.twin.counts};
  if (auto error = check(order, run, checked.difference)) return std::move(*error);
  return run;
}

Outcome<std::vector<std::pair<JonesOrder, JonesRun>>> run_all_jones(const Context& context,
                                                                    bool photographs) {
  std::vector<std::pair<JonesOrder, JonesRun>> runs;
  for (const std::string_view name : scene::builtin_scene_names()) {
    context.progress(fmt::format("{} on the PDP-7", name));
    for (const bool eae : {true, false}) {
      JonesOrder order{std::string(name), eae, false, photographs && eae};
      auto run = run_jones(order);
      if (!run) return std::move(run.error());
      runs.emplace_back(std::move(order), std::move(*run));
    }
  }
  return runs;
}

double seconds(core::Duration time) {
  return core::in_seconds(time);
}

Outcome<base::Bytes> crisp_png(const JonesRun& run) {
  return png_of(picture::crisp_raster(run.guest.pass));
}

Outcome<base::Bytes> phosphor_png(const JonesRun& run) {
  const core::Instant close = run.guest.shutter_close;
  picture::PhosphorPhotograph photograph(close - shutter_time, close);
  photograph.expose(run.guest.photograph);
  return png_of(photograph.develop());
}

Outcome<SkalaRun> run_skala(const guests::skala::Session& session, const SkalaOrder& order) {
  const auto function = scene::height_function(order.function);
  if (!function) return ReportError{ErrorKind::bad_input, order.function + ": no such function"};
  const scene::HeightGrid grid = scene::sample(*function, order.size);
  const auto stream = guests::skala::stream_of(grid, view_of(order, true));
  SkalaRun run;
  run.stream_bytes = stream.size();
  guests::skala::CheckedPicture checked = session.run(stream);
  if (auto error = check(order, checked)) return std::move(*error);
  run.twin = checked.twin.counts;
  run.guest = std::move(checked.guest);
  run.points_lit = guests::skala::points_lit(run.guest);
  run.dots_busy = dot_time() * static_cast<std::int64_t>(run.twin.points_plotted);
  if (order.compare_plain) {
    const auto plain = session.run(guests::skala::stream_of(grid, view_of(order, false)));
    if (auto error = check(order, plain)) return std::move(*error);
    run.plain = plain.guest.drawing;
  }
  return run;
}

std::string_view name_of(guests::skala::PictureKind picture) {
  switch (picture) {
    case guests::skala::PictureKind::lines: return "lines";
    case guests::skala::PictureKind::surface: return "surface";
    case guests::skala::PictureKind::contours: return "contours";
  }
  return "";
}

double seconds(core::TStates time) {
  return static_cast<double>(time.count()) / static_cast<double>(core::ClockRate{}.hertz);
}

Outcome<base::Bytes> raster_png(const SkalaRun& run, const SkalaOrder& order) {
  const auto palette = order.picture == guests::skala::PictureKind::surface ? picture::RasterPalette::grey
                                                                            : picture::RasterPalette::colour;
  return png_of(picture::raster_image(run.guest.raster, palette, 1));
}

}  // namespace sightline::harness::report
