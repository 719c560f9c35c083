// Shared by the fuzz targets for readers of polyhedra: mends and checks what was read, writes it in all formats, and reads
// it again. Three threads read the same as one.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "host/scene/check/poly_scene.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::fuzz {

inline void use(const scene::PolyScene& scene) {
  if (!scene::check_poly_scene(scene).empty()) return;
  for (const auto format : {scene::PolyFormat::off, scene::PolyFormat::obj, scene::PolyFormat::ply, scene::PolyFormat::json}) {
    const auto text = scene::write_poly(scene, format);
    if (!text) continue;
    const auto again = scene::read_poly(*text, "written", format, {.mend = true});
    if (!again) std::abort();
    scene::PolyScene expected = scene;
    expected.face_in_file = expected.vertex_in_file = {};  // JSON is taken as it is
    if (format == scene::PolyFormat::json && again->scene != expected) std::abort();
  }
}

inline void fuzz_poly(const std::uint8_t* data, std::size_t size, scene::PolyFormat format) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const bool mend : {false, true}) {
    const auto result = scene::read_poly(text, "fuzz", format, {mend});
    if (mend) {
      const auto by_threads = scene::read_poly(text, "fuzz", format, {.mend = true, .jobs = 3});
      if (result.has_value() != by_threads.has_value()) std::abort();
      if (result ? result->scene != by_threads->scene : result.error().message() != by_threads.error().message()) std::abort();
    }
    if (!result) continue;
    if (format != scene::PolyFormat::json && !scene::check_poly_scene(result->scene).empty()) std::abort();
    use(result->scene);
  }
}

}  // namespace sightline::fuzz
