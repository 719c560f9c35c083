// Scenes and views for the tests of stripes, and all ways to draw one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "host/algorithms/registry/faces.hpp"
#include "host/compare/cross_check_scenes.hpp"
#include "host/programs/stripes/check.hpp"
#include "host/programs/stripes/stripes.hpp"
#include "host/programs/stripes/twin/twin.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::programs::stripes {

inline registry::FaceWindow window_of(const View& view) {
  return {picture_size, picture_size, view.scale, view.left, picture_size - view.bottom};
}

// All of the scene from its own camera.
inline View whole_view(const scene::PolyScene& scene) {
  return view_of(scene, scene.camera);
}

// A view of a common scene, of 256 points, in the picture's 255.
inline View common_view(const compare::CrossCheckView& view) {
  const registry::FaceWindow window = view.window();
  const double size = double{picture_size} / window.width;
  return {view.camera, window.scale * size, window.left * size, (window.height - window.top) * size};
}

inline scene::PolyScene scene_named(const std::string& name) {
  const auto file = scene::named_scene(name);
  return scene::load_scene(**file)->scene;
}

// A run and its twin's, with any status.
struct CheckedPicture {
  MachinePicture machine;
  TwinPicture twin;
  std::string difference;  // between the pictures, or, for complete ones, between the counts
};

// Accepts any bytes; they select the device.
inline CheckedPicture run_both(std::span<const std::uint8_t> stream) {
  MachineOptions options;
  if (stream.size() >= header_bytes && (stream[header_bytes - 2] & vector_output) != 0) options.device = Device::calcomp;
  CheckedPicture picture{run_machine(resident_program(), stream, options), run_twin(stream), {}};
  picture.difference = difference_from_twin(picture.machine, picture.twin);
  if (picture.difference.empty() && picture.twin.status == Status::complete && !(picture.machine.counts == picture.twin.counts))
    picture.difference = "other counts";
  return picture;
}

inline constexpr std::array both{Computer::host, Computer::i8080};
inline constexpr std::array outputs{Output::raster, Output::vector};

}  // namespace sightline::programs::stripes
