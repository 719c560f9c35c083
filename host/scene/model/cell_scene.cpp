#include "host/scene/model/cell_scene.hpp"

namespace sightline::scene {

std::string SceneError::message() const {
  std::string text;
  for (const std::string* part : {&source, &place}) {
    if (!part->empty()) text += *part + ": ";
  }
  return text + cause;
}

}  // namespace sightline::scene
