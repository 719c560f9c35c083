// Scenes in stripes on the 8080 (firmware/i8080/stripes): Montani and Re's method in 4 KB of program. On the raster board and on the
// plotter, with stripes and priority list made by the machine, and by the host.
//
//   scenes     a scene each: what it takes, its filled faces and its drawing
//   tests      the same scenes: pairs of faces by the test that decides them, and cycles
//   machine    what the program and its data have of the memory
#include <fmt/core.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "host/algorithms/registry/faces.hpp"
#include "host/guests/stripes/session.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/raster_image.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/guest_runs.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::report {

namespace {

namespace stripes = guests::stripes;

constexpr std::array<std::string_view, 6> stripe_scenes{"roberts", "house", "street4", "boxes-8", "boxes-20", "bricks-20"};

stripes::View view_of(const scene::PolyScene& scene) {
  const registry::FaceWindow window =
      registry::face_window(scene, scene.camera, stripes::picture_size, stripes::picture_size, std::nullopt);
  return {scene.camera, window.scale, window.left, window.height - window.top};
}

stripes::DrawnScene drawn(const stripes::Session& session, const scene::PolyScene& scene, const std::string& name,
                          const stripes::StreamOptions& options) {
  auto made = session.draw(scene, view_of(scene), options);
  if (!made) throw Failure(ErrorKind::bad_input, fmt::format("{}: {}", name, made.error().message()));
  if (!made->picture.difference.empty()) throw Failure(ErrorKind::differs, fmt::format("{}: {}", name, made->picture.difference));
  if (made->picture.guest.status != stripes::Status::complete)
    throw Failure(ErrorKind::guest_failed, fmt::format("{}: {}", name, text_of(made->picture.guest.status)));
  return std::move(*made);
}

double whole_time(const stripes::GuestPicture& guest) { return seconds(guest.receiving + guest.working()); }

}  // namespace

Records montani_re_8080(const Context& context) {
  Records records;
  const stripes::Session session;
  for (const std::string_view scene_name : stripe_scenes) {
    const std::string name(scene_name);
    context.progress(fmt::format("{} in stripes on the 8080", name));
    const auto loaded = scene::load_scene(**scene::named_scene(name));
    if (!loaded) throw Failure(ErrorKind::bad_input, loaded.error().message());
    using stripes::Computer;
    using stripes::Output;
    const auto raster = drawn(session, loaded->scene, name, {Output::raster, Computer::i8080, Computer::i8080});
    const auto by_host = drawn(session, loaded->scene, name, {Output::raster, Computer::host, Computer::host});
    const auto plotter = drawn(session, loaded->scene, name, {Output::vector, Computer::i8080, Computer::i8080});
    const stripes::GuestPicture& guest = raster.picture.guest;
    const stripes::TwinCounts& counts = raster.picture.twin.counts;
    const auto pen = stripes::pen_paths(plotter.picture.guest.commands);
    records["scenes"].add({{"scene", name},
                           {"faces", raster.scene.faces.size()},
                           {"polygon_bytes", raster.stream.bytes.size()},
                           {"stripe_bytes", by_host.stream.bytes.size()},
                           {"receipt_s", seconds(guest.receiving)},
                           {"priority_s", seconds(guest.ranking)},
                           {"drawing_s", seconds(guest.drawing)},
                           {"whole_s", whole_time(guest)},
                           {"by_host_s", whole_time(by_host.picture.guest)},
                           {"plotter_s", whole_time(plotter.picture.guest)},
                           {"plotter_moves_s", seconds(plotter.picture.guest.device)},
                           {"raster", png_picture(picture::raster_image(guest.raster, picture::RasterPalette::grey, 1), true)},
                           {"drawing", png_picture(picture::pen_image(pen, picture::calcomp_paper, 1), true)}});
    NamedValues tests{{"scene", name}};
    constexpr std::array<std::string_view, 6> keys{"test_1", "test_2", "test_3", "test_4", "test_5", "test_6"};
    for (std::size_t k = 0; k < keys.size(); ++k) tests.emplace_back(keys[k], counts.decided_by[k + 1]);
    tests.emplace_back("relations", counts.relations);
    tests.emplace_back("deleted", counts.deleted);
    tests.emplace_back("cuts", raster.picture.twin.cuts.size());
    records["tests"].add(std::move(tests));
  }
  records["machine"].add({{"program_bytes", session.program().memory.size()},
                          {"program_room", stripes::program_room},
                          {"data_room", stripes::data_room},
                          {"scene_room", stripes::most_body_bytes},
                          {"most_faces", stripes::most_faces}});
  return records;
}

}  // namespace sightline::report
