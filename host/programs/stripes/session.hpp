// A checked run of the program of stripes: a view of a scene in, the picture on the emulated 8080 and its twin's out, and where
// they differ.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/programs/stripes/guest.hpp"
#include "host/programs/stripes/program.hpp"
#include "host/programs/stripes/scene.hpp"
#include "host/programs/stripes/stream.hpp"
#include "host/programs/stripes/twin/twin.hpp"
#include "host/picture/pen_path.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::programs::stripes {

struct CheckedPicture {
  GuestPicture guest;
  TwinPicture twin;
  std::string difference;  // as of difference_from_twin; empty: the same in everything
};

struct DrawnScene {
  ProjectedScene scene;
  Stream stream;
  CheckedPicture picture;

  // The face at every dot, numbered over all bodies from 1, 0 for none; rows from the bottom.
  [[nodiscard]] picture::PixelGrid faces() const;
};

// The program, assembled once, and as many pictures as are wanted.
class Session {
 public:
  Session() : program_(assemble_program()) {}

  [[nodiscard]] const Program& program() const { return program_; }
  // Any bytes are taken; the device is the one that they ask for.
  [[nodiscard]] CheckedPicture run(std::span<const std::uint8_t> stream) const;
  // Errors: those of project_scene and encode; a scene that does not fit while it is drawn: where, and by how much.
  [[nodiscard]] base::Result<DrawnScene> draw(const scene::PolyScene& scene, const View& view,
                                              const StreamOptions& options) const;

 private:
  Program program_;
};

// One path from each lowering of the pen to its lifting; straight runs keep only their ends.
[[nodiscard]] std::vector<picture::PenPath> pen_paths(std::span<const std::uint8_t> commands);

}  // namespace sightline::programs::stripes
