// Turning models with their events and tapes, made once per test program.
#pragma once

#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/programs/turn/tape.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::programs::turn {

struct TurnedModel {
  scene::PolyScene scene;  // on the axis
  algorithms::plantinga::RotationModel model;
  algorithms::plantinga::EventList list;
  Tape tape;
};

// A built-in or generated scene, or a file below the repository's root.
inline scene::PolyScene scene_named(const std::string& name) {
  if (const auto named = scene::named_scene(name)) return scene::load_scene(**named)->scene;
  std::ifstream file(std::string(SIGHTLINE_SOURCE_DIR) + "/" + name);
  std::stringstream text;
  text << file.rdbuf();
  return scene::load_scene({name, text.str()})->scene;
}

inline const TurnedModel& turned_model(const std::string& name, Memory memory = Memory::words_8k, bool tilted = true) {
  static std::map<std::string, std::unique_ptr<TurnedModel>> models;
  auto& slot = models[name + (memory == Memory::words_8k ? " 8" : " 32") + (tilted ? " tilted" : "")];
  if (!slot) {
    scene::PolyScene standing = *stand_on_axis(scene_named(name), tilted);
    algorithms::plantinga::RotationModel model(standing);
    auto list = *algorithms::plantinga::build_event_list(model);
    Tape tape = *encode(model, list, memory);
    slot = std::make_unique<TurnedModel>(
        TurnedModel{std::move(standing), std::move(model), std::move(list), std::move(tape)});
  }
  return *slot;
}

inline const std::string block = "host/examples/turn/block.off";
inline const std::string cube = "host/examples/turn/cube.off";
inline const std::string crossed = "host/examples/turn/crossed.off";
inline const std::string lshape = "host/examples/turn/lshape.json";
inline const std::string star = "host/examples/turn/star.off";
inline const std::string grid = "host/scene/read/builtin/grid.off";

// The factor for long tests: SIGHTLINE_TURNS in the environment, 1 by default.
inline unsigned turns() {
  const char* asked = std::getenv("SIGHTLINE_TURNS");
  return asked == nullptr ? 1U : static_cast<unsigned>(std::atoi(asked));
}

}  // namespace sightline::programs::turn
