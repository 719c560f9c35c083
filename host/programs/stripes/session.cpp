#include "host/programs/stripes/session.hpp"

#include <fmt/core.h>

#include <array>
#include <utility>

namespace sightline::programs::stripes {

CheckedPicture Session::run(std::span<const std::uint8_t> stream) const {
  GuestOptions options;
  if (stream.size() >= header_bytes && (stream[header_bytes - 2] & vector_output) != 0) options.device = Device::calcomp;
  CheckedPicture picture{run_guest(program_, stream, options), run_twin(stream), {}};
  picture.difference = difference_from_twin(picture.guest, picture.twin);
  return picture;
}

base::Result<DrawnScene> Session::draw(const scene::PolyScene& scene, const View& view, const StreamOptions& options) const {
  auto projected = project_scene(scene, view, options.priority == Computer::host);
  if (!projected) return projected.error();
  auto stream = encode(*projected, options);
  if (!stream) return stream.error();
  DrawnScene drawn{std::move(*projected), std::move(*stream), {}};
  drawn.picture = run(drawn.stream.bytes);
  const TwinPicture& twin = drawn.picture.twin;
  if (!drawn.picture.difference.empty() || twin.status != Status::full) return drawn;
  const SceneFace& face = drawn.scene.faces[twin.fault];
  const std::string place = fmt::format("face {} of body {}", face.index, face.body);
  const TwinCounts& counts = twin.counts;
  const auto too_many = [&](std::string_view what, std::size_t count, std::size_t most) {
    return base::Error{"", place, fmt::format("{} of {} ends of substripes in a line, {} too many", what, count, count - most),
                       fmt::format("at most {} for the 8080", most)};
  };
  if (counts.silhouette_most > most_silhouette_toggles)
    return too_many("a silhouette", counts.silhouette_most, most_silhouette_toggles);
  if (counts.seen_most > most_seen_toggles) return too_many("what is seen", counts.seen_most, most_seen_toggles);
  if (twin.cuts.size() == most_cuts)
    return base::Error{"", place, fmt::format("more than {} cuts of cyclic overlaps", most_cuts),
                       fmt::format("at most {} for the 8080", most_cuts)};
  return base::Error{"", place, "too many sides in a line after a cut", fmt::format("at most {} for the 8080", most_face_toggles)};
}

picture::PixelGrid DrawnScene::faces() const {
  picture::PixelGrid grid(picture_size, picture_size);
  for (std::size_t i = 0; i < picture.twin.items.size(); ++i)
    if (picture.twin.items[i] != 0) grid.values[i] = scene.faces[picture.twin.items[i] - 1U].number;
  return grid;
}

std::vector<picture::PenPath> pen_paths(std::span<const std::uint8_t> commands) {
  constexpr std::array<std::array<int, 2>, 8> moves{
      {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};
  constexpr std::uint8_t up = 8;
  std::vector<picture::PenPath> paths;
  std::int32_t x = 0;
  std::int32_t y = 0;
  bool down = false;
  for (const std::uint8_t command : commands) {
    if (command >= up) {
      down = command > up;
      if (down) paths.push_back({{{x, y}}});
      continue;
    }
    x += moves[command][0];
    y += moves[command][1];
    if (down) picture::extend(paths.back(), {x, y});
  }
  return paths;
}

}  // namespace sightline::programs::stripes
