// `sightline draw ALGORITHM SCENE --fill`: faces filled, by an algorithm that draws lines as well.
#pragma once

#include <optional>
#include <string>

#include "host/algorithms/registry/faces.hpp"
#include "host/app/command_line.hpp"
#include "host/app/commands/draw_output.hpp"
#include "host/app/scene_source.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

struct FillArguments {
  bool fill = false;
  double stripe = 1;  // pixels
};

// --fill and --stripe.
void add_fill_options(const Command& command, FillArguments& arguments);

struct FilledPicture {
  const SceneSource& source;
  const scene::PolyCamera& camera;
  std::optional<double> field;
  const DrawOutput& output;  // settled
  bool json = false;
};

// .svg: outlines with holes; .png: pixels by stripes. Throws Failure.
ExitCode draw_filled(const harness::FaceAlgorithm& algorithm, const FillArguments& arguments,
                     const FilledPicture& picture, DrawingFormat format);

}  // namespace sightline::app
