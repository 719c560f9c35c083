// What requests of the page have in common: their members with a usual value for what is not there, the scene they name, and a
// program put into a PDP-7.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/machines/machine.hpp"
#include "host/live/web/workbench.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::live::web {

[[nodiscard]] std::string text_of(const Json& request, std::string_view key);
[[nodiscard]] double number_of(const Json& request, std::string_view key, double otherwise);
[[nodiscard]] bool flag_of(const Json& request, std::string_view key, bool otherwise = false);

// A file of the page of that name, else a built-in or generated scene.
[[nodiscard]] base::Result<scene::LoadedScene> scene_named(const Workbench& workbench, const std::string& name);

// Three whole numbers below 32768; empty if it is something else.
[[nodiscard]] std::optional<scene::PolyPoint> point_of(const Json* json);
// The scene's own camera, turned as the request's "camera" says: "eye", "forward", "right" and "up" arrays, "perspective" a boolean.
[[nodiscard]] base::Result<scene::PolyCamera> camera_of(const scene::PolyScene& scene, const Json& request);

// A program that has been assembled.
struct CoreProgram {
  machines::Program image;  // with its start
  bool eae = true;
  Json options = Json::object();  // of the machine, besides the program, its display and the EAE
  std::map<std::string, std::uint32_t, std::less<>> symbols;
};
// A PDP-7 with a display, the program in core, standing at its start: the answer of "make". The file of the program stays on the
// page under that name.
[[nodiscard]] Json make_pdp7(Workbench& workbench, const std::string& file, const CoreProgram& program, std::uint32_t switches);
// The machine of such an answer; null if it is a refusal.
[[nodiscard]] MachineSession* session_of(Workbench& workbench, const Json& made);

}  // namespace sightline::live::web
