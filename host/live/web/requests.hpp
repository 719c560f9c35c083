// The functions that answer requests of the page, and what they share: members with default values, the scene that a request names,
// and a program loaded into a PDP-7.
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

// Each answers the requests named above it; null for any other.

// lists, firmware, scene, draw, explain, jones, sight, skala and cost: scenes, the algorithms that draw them, their lessons, and the
// programs of Jones and Skala on their machines.
[[nodiscard]] Json pictures_answer(Workbench& workbench, std::string_view what, const Json& request);
// stripes: draws a scene in stripes on the page's 8080 (firmware/i8080/stripes).
[[nodiscard]] Json stripes_answer(Workbench& workbench, std::string_view what, const Json& request);
// turn and turn_sight: turns a solid on the page's PDP-7 (firmware/pdp7/turn).
[[nodiscard]] Json turning_answer(Workbench& workbench, std::string_view what, const Json& request);
// kind: finds the kind of a file on the page by its content, or else by its extension.
[[nodiscard]] Json kinds_answer(Workbench& workbench, std::string_view what, const Json& request);

[[nodiscard]] std::string text_of(const Json& request, std::string_view key);
[[nodiscard]] double number_of(const Json& request, std::string_view key, double otherwise);
[[nodiscard]] bool flag_of(const Json& request, std::string_view key, bool otherwise = false);

// Loads the file of the page with this name, or else a built-in or generated scene.
[[nodiscard]] base::Result<scene::LoadedScene> scene_named(const Workbench& workbench, const std::string& name);

// Three whole numbers below 32768 in magnitude; empty if it is anything else.
[[nodiscard]] std::optional<scene::PolyPoint> point_of(const Json* json);
// The scene's own camera, changed by the request's "camera": arrays "eye", "forward", "right" and "up", and a boolean "perspective".
[[nodiscard]] base::Result<scene::PolyCamera> camera_of(const scene::PolyScene& scene, const Json& request);

// An assembled program.
struct CoreProgram {
  machines::Program image;  // with a start address
  bool eae = true;
  Json options = Json::object();  // of the machine, except the program, the display and the EAE
  std::map<std::string, std::uint32_t, std::less<>> symbols;
};
// Makes a PDP-7 with a display and the program in core, at its start address; returns the answer of "make". The program becomes a
// file of the page with the name `file`.
[[nodiscard]] Json make_pdp7(Workbench& workbench, const std::string& file, const CoreProgram& program, std::uint32_t switches);
// The machine of such an answer; null if it is an error.
[[nodiscard]] MachineSession* session_of(Workbench& workbench, const Json& made);

}  // namespace sightline::live::web
