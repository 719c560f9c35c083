// The request that draws a scene in stripes on the page's 8080.
#include <fmt/core.h>

#include <utility>

#include "host/programs/stripes/program.hpp"
#include "host/programs/stripes/scene.hpp"
#include "host/programs/stripes/status.hpp"
#include "host/programs/stripes/stream.hpp"
#include "host/live/web/requests.hpp"

namespace sightline::live::web {
namespace {

namespace stripes = programs::stripes;

// Makes an 8080 with the program, to which a host computer sends the faces. The 8080 cuts them into stripes and finds their order.
Json make_stripes(Workbench& workbench, const Json& request) {
  auto loaded = scene_named(workbench, text_of(request, "scene"));
  if (!loaded) return error_answer(loaded.error().message());
  const auto camera = camera_of(loaded->scene, request);
  if (!camera) return error_answer(camera.error().message());
  const bool plotter = text_of(request, "device") == "calcomp";
  stripes::StreamOptions options;
  options.output = plotter ? stripes::Output::vector : stripes::Output::raster;
  if (!plotter && flag_of(request, "antialias")) options.build = stripes::Build::coverage;
  if (flag_of(request, "priority_by_host")) options.priority = stripes::Computer::host;
  const auto scene = stripes::project_scene(loaded->scene, stripes::view_of(loaded->scene, *camera), options.priority == stripes::Computer::host);
  if (!scene) return error_answer(scene.error().message());
  const auto stream = stripes::encode(*scene, options);
  if (!stream) return error_answer(stream.error().message());
  const stripes::Program& program = stripes::resident_program(options.build);
  workbench.put_file(".stripes.stream", stream->bytes);
  workbench.put_file(".stripes.bin", program.memory);
  Json made = workbench.answer(Json{{"do", "make"},
                                    {"machine", "i8080"},
                                    {"options",
                                     {{"--load", Json::array({".stripes.bin"})},
                                      {"--parallel", ".stripes.stream"},
                                      {"--start", fmt::format("{:04X}", program.labels.start)},
                                      {plotter ? "--plotter" : "--board", plotter ? "calcomp" : "ef9365"}}}});
  made["stream"] = stream->bytes.size();
  made["start"] = program.labels.start;
  made["status"] = program.labels.status;
  made["faces"] = scene->faces.size();
  Json texts = Json::array();
  for (int status = 0; status <= static_cast<int>(stripes::Status::device_error); ++status)
    texts.push_back(text_of(static_cast<stripes::Status>(status)));
  made["texts"] = std::move(texts);
  return made;
}

}  // namespace

Json stripes_answer(Workbench& workbench, std::string_view what, const Json& request) {
  if (what == "stripes") return make_stripes(workbench, request);
  return {};
}

}  // namespace sightline::live::web
