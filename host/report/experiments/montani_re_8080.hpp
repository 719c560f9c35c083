// Scenes in stripes on the 8080 (firmware/i8080/stripes): Montani and Re's method in 4 KB of program. On the raster
// board and on the plotter; stripes and priority list are made by the machine, or by the host.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

// Times in emulated seconds.
struct StripesScene {
  std::string scene;
  std::size_t faces = 0;  // turned to the eye
  std::size_t polygon_bytes = 0;
  std::size_t stripe_bytes = 0;
  double receipt_s = 0;
  double priority_s = 0;
  double drawing_s = 0;
  double whole_s = 0;
  double by_host_s = 0;  // stripes and list by the host
  double plotter_s = 0;
  double plotter_moves_s = 0;
  Picture raster;                             // filled faces
  Picture drawing;                            // the same stripes as lines
  std::array<std::uint64_t, 6> decided_by{};  // pairs of faces, by the test that decides them
  std::uint64_t relations = 0;
  std::uint64_t deleted = 0;
  std::size_t cuts = 0;
};

struct MontaniRe8080 {
  std::vector<StripesScene> scenes;
  // Bytes of memory.
  std::size_t program_bytes = 0;
  std::size_t program_room = 0;
  std::size_t data_room = 0;
  std::size_t scene_room = 0;
  std::size_t most_faces = 0;
};

[[nodiscard]] MontaniRe8080 montani_re_8080(const Context& context);

class Page;
struct SkalaPictures;
void montani_re_8080_chapter(Page& page, const MontaniRe8080& measured, const SkalaPictures& skala);

}  // namespace sightline::report
