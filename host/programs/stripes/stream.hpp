// The byte stream for the stripes program (firmware/i8080/stripes/SPECIFICATION.md, section 1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/base/result.hpp"
#include "host/programs/stripes/scene.hpp"
#include "host/programs/stripes/status.hpp"

namespace sightline::programs::stripes {

enum class Output : std::uint8_t { raster, vector };
enum class Computer : std::uint8_t { host, i8080 };

struct StreamOptions {
  Output output = Output::raster;
  Computer stripes = Computer::i8080;   // which one cuts polygons into stripes
  Computer priority = Computer::i8080;  // which one finds the priority list
  Build build = Build::plain;           // coverage and overwrite: raster output; coverage: the 8080 makes the stripes
};

struct Stream {
  std::vector<std::uint8_t> bytes;
  std::size_t polygon_bytes = 0;  // of planes and corners
  std::size_t stripe_bytes = 0;   // of lists
};

// The faces are in priority order if the host has found it. Error: what does not fit, its largest part, and by how much.
[[nodiscard]] base::Result<Stream> encode(const ProjectedScene& scene, const StreamOptions& options);

// Puts a header and check sums around a body, right or wrong.
[[nodiscard]] std::vector<std::uint8_t> framed(std::uint8_t mode, std::size_t faces, const std::vector<std::uint8_t>& body);

}  // namespace sightline::programs::stripes
