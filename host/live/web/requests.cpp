#include "host/live/web/requests.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "host/scene/model/eye_place.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::live::web {

std::string text_of(const Json& request, std::string_view key) {
  const Json* const member = request.find(key);
  const std::string* const text = member != nullptr ? member->text() : nullptr;
  return text != nullptr ? *text : std::string();
}
double number_of(const Json& request, std::string_view key, double otherwise) {
  const Json* const member = request.find(key);
  return member != nullptr ? member->number().value_or(otherwise) : otherwise;
}
bool flag_of(const Json& request, std::string_view key, bool otherwise) {
  const Json* const member = request.find(key);
  return member != nullptr ? member->boolean().value_or(otherwise) : otherwise;
}

base::Result<scene::LoadedScene> scene_named(const Workbench& workbench, const std::string& name) {
  if (const Bytes* const bytes = workbench.file(name))
    return scene::load_scene({.name = name, .text = std::string(bytes->begin(), bytes->end())}, {.mend = true});
  auto found = scene::named_scene(name);
  if (!found) return base::bad_input(fmt::format("{}: no scene of that name, and no such file on the page", name));
  if (!*found) return std::move(found->error());
  return scene::load_scene(std::move(**found));
}

std::optional<scene::PolyPoint> point_of(const Json* json) {
  if (json == nullptr || json->size() != 3) return std::nullopt;
  scene::PolyPoint point{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = (*json)[i].integer();
    if (!value || std::abs(*value) >= (1 << 15)) return std::nullopt;
    point[i] = static_cast<std::int32_t>(*value);
  }
  return point;
}

base::Result<scene::PolyCamera> camera_of(const scene::PolyScene& scene, const Json& request) {
  scene::PolyCamera camera = scene.camera;
  if (const Json* const given = request.find("camera")) {
    camera.perspective = flag_of(*given, "perspective", camera.perspective);
    for (const auto& [key, part] : {std::pair{"eye", &camera.eye}, {"forward", &camera.forward}, {"right", &camera.right}, {"up", &camera.up}}) {
      const Json* const value = given->find(key);
      if (value == nullptr) continue;
      const auto point = point_of(value);
      if (!point) return base::bad_input(fmt::format("camera: {}: expected three whole numbers below 32768", key));
      *part = *point;
    }
    const auto dot = [](const scene::PolyPoint& a, const scene::PolyPoint& b) {
      return std::int64_t{a[0]} * b[0] + std::int64_t{a[1]} * b[1] + std::int64_t{a[2]} * b[2];
    };
    if (dot(camera.forward, camera.right) != 0 || dot(camera.forward, camera.up) != 0 || dot(camera.right, camera.up) != 0 ||
        dot(camera.forward, camera.forward) == 0 || dot(camera.right, camera.right) == 0 || dot(camera.up, camera.up) == 0)
      return base::bad_input("camera: forward, right and up must be at right angles and not 0");
  }
  if (camera.perspective) {
    if (const auto error = scene::eye_error(scene, camera)) return base::Error(*error);
  }
  return camera;
}

Json make_pdp7(Workbench& workbench, const std::string& file, const CoreProgram& program, std::uint32_t switches) {
  const auto& formats = machines::pdp7().formats;
  const auto octal = std::find_if(formats.begin(), formats.end(), [](const auto& each) { return each.name == "octal"; });
  auto written = octal->write(program.image, file);
  if (!written) return error_answer(written.error().message());
  workbench.put_file(file, std::move(*written));
  Json options{{"--load", file}, {"--display", true}, {program.eae ? "--eae" : "--no-eae", true}};
  options.update(program.options);
  Json made = workbench.answer(Json{{"do", "make"}, {"machine", "pdp7"}, {"options", std::move(options)}});
  MachineSession* const session = session_of(workbench, made);
  if (session == nullptr) return made;
  if (const auto number = session->debugger().register_named("SR")) session->debugger().set(*number, switches);
  std::string table;
  for (const auto& [name, value] : program.symbols) table += fmt::format("{} {:o}\n", name, value);
  Symbols symbols(8);
  static_cast<void>(symbols.add_table(table));
  session->debugger().set_symbols(std::move(symbols));
  session->debugger().start(*program.image.start);
  return made;
}

MachineSession* session_of(Workbench& workbench, const Json& made) {
  const Json* const id = made.find("id");
  return id != nullptr ? workbench.session(static_cast<int>(*id->integer())) : nullptr;
}

}  // namespace sightline::live::web
