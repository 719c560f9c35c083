// Any bytes as a grid file: read, by its content and as points, and whatever is a grid becomes every kind of picture.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "host/guests/skala/stream.hpp"
#include "host/scene/heights/read_grid.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto points = scene::read_height_grid(text, "fuzz", {{"x", "2", "z"}});
  if (!points) static_cast<void>(points.error().message());
  const auto result = scene::read_height_grid(text, "fuzz");
  if (!result) return 0;
  guests::skala::View view;
  view.rotation = static_cast<double>(size % 48) * 7.5;
  view.zoom = size % 3 == 0 ? 4.0 : 1.0;
  for (const auto picture : {guests::skala::PictureKind::lines, guests::skala::PictureKind::surface,
                             guests::skala::PictureKind::contours}) {
    view.picture = picture;
    static_cast<void>(guests::skala::stream_of(*result, view));
  }
  return 0;
}
