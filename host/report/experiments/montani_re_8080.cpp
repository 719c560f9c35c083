#include "host/report/experiments/montani_re_8080.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "host/base/value_of.hpp"
#include "host/programs/stripes/program.hpp"
#include "host/programs/stripes/stripes.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/raster_image.hpp"
#include "host/report/experiments/guest_runs.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/report/experiments/skala_pictures.hpp"
#include "host/report/page.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::report {

namespace {

namespace stripes = programs::stripes;

constexpr std::array<std::string_view, 6> stripe_scenes{"roberts", "house", "street4", "boxes-8", "boxes-20", "bricks-20"};

stripes::Outcome draw_stripes(const scene::PolyScene& scene, const std::string& name, const stripes::StreamOptions& options) {
  return base::value_of(stripes::run({.scene = scene, .view = stripes::view_of(scene, scene.camera), .options = options, .check = true}), name);
}

double whole_time(const stripes::MachinePicture& picture) {
  return core::in_seconds(picture.receiving + picture.working());
}

}  // namespace

MontaniRe8080 montani_re_8080(const Context& context) {
  MontaniRe8080 measured;
  for (const std::string_view scene_name : stripe_scenes) {
    const std::string name(scene_name);
    context.progress(fmt::format("{} in stripes on the 8080", name));
    const auto loaded = scene::load_scene(**scene::named_scene(name));
    if (!loaded) throw base::bad_input(loaded.error().message());
    using stripes::Computer;
    using stripes::Output;
    const auto raster = draw_stripes(loaded->scene, name, {Output::raster, Computer::i8080, Computer::i8080});
    const auto by_host = draw_stripes(loaded->scene, name, {Output::raster, Computer::host, Computer::host});
    const auto plotter = draw_stripes(loaded->scene, name, {Output::vector, Computer::i8080, Computer::i8080});
    const stripes::MachinePicture& machine = raster.picture;
    const stripes::Counts& counts = machine.counts;
    const auto pen = stripes::pen_paths(plotter.picture.commands);
    StripesScene& row = measured.scenes.emplace_back();
    row.scene = name;
    row.faces = raster.scene.faces.size();
    row.polygon_bytes = raster.stream.bytes.size();
    row.stripe_bytes = by_host.stream.bytes.size();
    row.receipt_s = core::in_seconds(machine.receiving);
    row.priority_s = core::in_seconds(machine.ranking);
    row.drawing_s = core::in_seconds(machine.drawing);
    row.whole_s = whole_time(machine);
    row.by_host_s = whole_time(by_host.picture);
    row.plotter_s = whole_time(plotter.picture);
    row.plotter_moves_s = core::in_seconds(plotter.picture.device);
    row.raster = png_picture(picture::raster_image(machine.raster, picture::RasterPalette::grey, 1), true);
    row.drawing = png_picture(picture::pen_image(pen, picture::calcomp_paper, 1), true);
    std::copy(counts.decided_by.begin() + 1, counts.decided_by.end(), row.decided_by.begin());
    row.relations = counts.relations;
    row.deleted = counts.deleted;
    row.cuts = counts.cuts;
  }
  measured.program_bytes = stripes::resident_program().memory.size();
  measured.program_room = stripes::program_room;
  measured.data_room = stripes::data_room;
  measured.scene_room = stripes::most_body_bytes;
  measured.most_faces = stripes::most_faces;
  return measured;
}

void montani_re_8080_chapter(Page& page, const MontaniRe8080& measured, const SkalaPictures& skala) {
  const std::vector<StripesScene>& scenes = measured.scenes;
  page.table(
      "montani-re-8080-scenes", "Scenes in stripes on an 8080 at 3 MHz", scenes,
      {{"scene", "Scene", &StripesScene::scene},
       {"faces", "Faces", "turned to the eye", &StripesScene::faces},
       {"polygon_bytes", "Sent as polygons", "bytes", &StripesScene::polygon_bytes},
       {"stripe_bytes", "Sent as stripes", "bytes", &StripesScene::stripe_bytes},
       {"receipt_s", "Receipt", "emulated s", &StripesScene::receipt_s, 2},
       {"priority_s", "Priority list", "emulated s", &StripesScene::priority_s, 2},
       {"drawing_s", "Drawing", "emulated s", &StripesScene::drawing_s, 2},
       {"whole_s", "In all", "emulated s", &StripesScene::whole_s, 2},
       {"by_host_s", "In all, stripes and list by the host", "emulated s", &StripesScene::by_host_s, 2},
       {"plotter_s", "On the plotter", "emulated s", &StripesScene::plotter_s, 1},
       {"plotter_moves_s", "The plotter's movements", "emulated s", &StripesScene::plotter_moves_s, 1}},
      {.notes = {
           fmt::format("The program (`firmware/i8080/stripes`) has {} of {} bytes and {} bytes of data, {} of them for the "
                       "scene, at most {} faces. Every picture is compared with that of a native program written from the same "
                       "specification. The paper names no computer and no time.",
                       text_of(measured.program_bytes), text_of(measured.program_room), text_of(measured.data_room),
                       text_of(measured.scene_room), text_of(measured.most_faces)),
           fmt::format(
               "{} Skala's program on the same machine takes {} to {} s for a drawing of one surface.",
               greatest(scenes, &StripesScene::whole_s) <= 60 ? "No scene takes a minute on the raster board." : "",
               text_of(least(where(skala.pictures, equals(&SkalaPicture::picture, "lines")), &SkalaPicture::drawing_s), 2),
               text_of(greatest(where(skala.pictures, equals(&SkalaPicture::picture, "surface")), &SkalaPicture::drawing_s), 2))}});
  const auto decided_by = [](std::size_t test) {
    return [test](const StripesScene& scene) { return scene.decided_by[test - 1]; };
  };
  page.table("montani-re-8080-tests", "Pairs of faces by the test that decides them, on the 8080", scenes,
             {{"scene", "Scene", &StripesScene::scene},
              {"test_1", "Test 1", "pairs", decided_by(1)},
              {"test_2", "Test 2", "pairs", decided_by(2)},
              {"test_3", "Test 3", "pairs", decided_by(3)},
              {"test_4", "Test 4", "pairs", decided_by(4)},
              {"test_5", "Test 5", "pairs", decided_by(5)},
              {"test_6", "Test 6", "pairs", decided_by(6)},
              {"relations", "Relations", &StripesScene::relations},
              {"deleted", "Deleted", "on cycles, without overlap", &StripesScene::deleted},
              {"cuts", "Cuts", "faces cut by another", &StripesScene::cuts}});
  page.gallery("montani-re-8080-rasters", "Filled faces on the raster board", scenes, [](const StripesScene& scene) {
    return figure(scene.raster, "montani-re-8080-" + scene.scene, fmt::format("{}, {} faces.", scene.scene, scene.faces),
                  "In seven levels, by the lamp.", fmt::format("Faces of {} in greys, hidden parts removed", scene.scene));
  });
  page.gallery("montani-re-8080-drawings", "The same stripes as lines on the plotter", scenes, [](const StripesScene& scene) {
    return figure(scene.drawing, fmt::format("montani-re-8080-{}-lines", scene.scene), scene.scene + ".",
                  text_of(scene.plotter_moves_s, 1) + " s of the plotter's movements.",
                  fmt::format("{} in lines, hidden parts removed", scene.scene));
  });
}

}  // namespace sightline::report
