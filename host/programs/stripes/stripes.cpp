#include "host/programs/stripes/stripes.hpp"

#include <fmt/core.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "host/programs/stripes/check.hpp"
#include "host/programs/stripes/twin/twin.hpp"

namespace sightline::programs::stripes {

namespace {

// Describes what did not fit, from the twin, which has stopped with status full.
base::Error too_full(const TwinPicture& twin, const ProjectedScene& scene, Build build) {
  const SceneFace& face = scene.faces[twin.fault];
  const std::string place = fmt::format("face {} of body {}", face.index, face.body);
  const auto too_many = [&](std::string_view what, std::size_t count, std::size_t most) {
    return base::Error{"", place, fmt::format("{} of {} ends of substripes in a line, {} too many", what, count, count - most),
                       fmt::format("at most {} for the 8080", most)};
  };
  const Counts& counts = twin.counts;
  if (build == Build::coverage && counts.silhouette_most > most_silhouette_changes)
    return base::Error{"", place, fmt::format("{} columns in a line where the coverage changes, {} too many", counts.silhouette_most,
                                              counts.silhouette_most - most_silhouette_changes),
                       fmt::format("at most {} for the 8080", most_silhouette_changes)};
  if (build == Build::coverage && twin.cuts.size() < most_cuts)
    return base::Error{"", place, "too many columns in a line where the coverage changes",
                       fmt::format("at most {} for the 8080", most_face_changes)};
  if (counts.silhouette_most > most_silhouette_toggles)
    return too_many("a silhouette", counts.silhouette_most, most_silhouette_toggles);
  if (twin.seen_most > most_seen_toggles) return too_many("what is seen", twin.seen_most, most_seen_toggles);
  if (twin.cuts.size() == most_cuts)
    return base::Error{"", place, fmt::format("more than {} cuts of cyclic overlaps", most_cuts),
                       fmt::format("at most {} for the 8080", most_cuts)};
  return base::Error{"", place, "too many sides in a line after a cut", fmt::format("at most {} for the 8080", most_face_toggles)};
}

picture::PixelGrid faces_of(const TwinPicture& twin, const ProjectedScene& scene) {
  picture::PixelGrid grid(picture_size, picture_size);
  for (std::size_t i = 0; i < twin.items.size(); ++i)
    if (twin.items[i] != 0) grid.values[i] = scene.faces[twin.items[i] - 1U].number;
  return grid;
}

}  // namespace

base::Result<Outcome> run(const Order& order) { return run(order, resident_program(order.options.build)); }

base::Result<Outcome> run(const Order& order, const Program& program) {
  auto projected = project_scene(order.scene, order.view, order.options.priority == Computer::host);
  if (!projected) return projected.error();
  auto stream = encode(*projected, order.options);
  if (!stream) return stream.error();
  Outcome outcome{std::move(*projected), std::move(*stream), {}, {}};
  MachineOptions options;
  options.device = order.options.output == Output::vector ? Device::calcomp : Device::ef9365;
  outcome.picture = run_machine(program, outcome.stream.bytes, options);
  const MachinePicture& picture = outcome.picture;
  if (!picture.ended) return base::program_failed("the program on the 8080 did not end");
  const bool full = picture.status == Status::full;
  if (order.check || full) {
    const TwinPicture twin = run_twin(outcome.stream.bytes, order.options.build);
    if (const std::string difference = difference_from_twin(picture, twin); !difference.empty())
      return base::difference("internal error: the picture on the 8080 is not the one its native twin computes: " + difference);
    if (full) return too_full(twin, outcome.scene, order.options.build);
    if (order.options.build != Build::coverage) outcome.faces = faces_of(twin, outcome.scene);
  }
  if (!picture.faults.empty())
    return base::program_failed(fmt::format("{}: {}", picture.faults.front().what, picture.faults.front().count));
  if (picture.status != Status::complete) return base::program_failed(fmt::format("the program stopped: {}", text_of(picture.status)));
  return outcome;
}

PenWork pen_work(std::span<const std::uint8_t> commands) {
  constexpr std::uint8_t pen_up = 8;
  PenWork work;
  bool down = false;
  for (const std::uint8_t command : commands) {
    if (command < pen_up) {
      ++(down ? work.steps_down : work.steps_up);
      continue;
    }
    work.lifts += command == pen_up ? 1 : 0;
    down = command > pen_up;
  }
  return work;
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
