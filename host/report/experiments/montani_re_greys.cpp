#include "host/report/experiments/montani_re_greys.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/algorithms/registry/faces.hpp"
#include "host/base/value_of.hpp"
#include "host/picture/raster_image.hpp"
#include "host/programs/stripes/program.hpp"
#include "host/programs/stripes/stripes.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/report/page.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::montani_re;
namespace stripes = programs::stripes;

constexpr std::array<std::string_view, 6> scene_names{"roberts", "house", "boxes-5", "boxes-8", "boxes-20", "bricks-20"};
constexpr int dots = stripes::picture_size;
constexpr std::size_t dot_count = std::size_t{dots} * dots;
constexpr double white = 7;

// The level of each dot, from the lowest line.
using Levels = std::vector<double>;

Levels levels_of(const core::Raster& raster) {
  Levels levels(dot_count);
  for (int y = 0; y < dots; ++y)
    for (int x = 0; x < dots; ++x)
      levels[static_cast<std::size_t>(y * dots + x)] = raster.points()[static_cast<std::size_t>(y * core::Raster::width + x)];
  return levels;
}

// The integral from -infinity to s of the part of a dot, from 0 on, that is to the west of u.
double integral(double s) {
  return s <= 0 ? 0 : s < 1 ? s * s / 2 : s - 0.5;
}

// Adds to each dot how much of it is to the east of an edge, times `level`; downward edges positive. Around a closed loop that
// turns left this is the part inside.
void add_edge(Levels& levels, const picture::PixelPoint& from, const picture::PixelPoint& to, double level) {
  if (from.y == to.y) return;
  const double sign = to.y < from.y ? 1 : -1;
  const picture::PixelPoint& low = from.y < to.y ? from : to;
  const picture::PixelPoint& high = from.y < to.y ? to : from;
  const double slope = (high.x - low.x) / (high.y - low.y);
  for (int y = std::max(0, static_cast<int>(std::floor(low.y))); y < dots && y < high.y; ++y) {
    const double bottom = std::max<double>(y, low.y);
    const double top = std::min<double>(y + 1, high.y);
    if (top <= bottom) continue;
    const double x0 = low.x + slope * (bottom - low.y);
    const double x1 = low.x + slope * (top - low.y);
    const double west = std::min(x0, x1);
    const double east = std::max(x0, x1);
    for (int x = 0; x < dots; ++x) {
      const double part = east - west > 1e-9 ? (integral(x + 1 - west) - integral(x + 1 - east)) / (east - west)
                                             : std::clamp(x + 1 - west, 0.0, 1.0);
      levels[static_cast<std::size_t>(y * dots + x)] += sign * level * part * (top - bottom);
    }
  }
}

registry::FaceWindow window_of(const stripes::View& view) {
  return {dots, dots, view.scale, view.left, dots - view.bottom};
}

std::map<std::uint32_t, double> levels_by_face(const stripes::ProjectedScene& scene) {
  std::map<std::uint32_t, double> levels;
  for (const stripes::SceneFace& face : scene.faces) levels[face.number] = face.level;
  return levels;
}

// From the exact outlines of the visible regions; also the dots in which more than one level is mixed.
struct ExactLevels {
  Levels levels = Levels(dot_count);
  std::vector<bool> mixed = std::vector<bool>(dot_count);
};

ExactLevels exact_levels(const registry::PreparedFaces& prepared, const stripes::View& view, std::map<std::uint32_t, double> levels) {
  constexpr double noise = 1e-6;
  ExactLevels exact;
  const auto seen = base::value_of(prepared.regions(view.camera, window_of(view)), "regions");
  for (const registry::FaceRegion& region : seen.regions) {
    Levels part(dot_count);
    for (const auto& loop : region.loops)
      for (std::size_t k = 0; k < loop.size(); ++k) add_edge(part, loop[k], loop[(k + 1) % loop.size()], 1);
    for (std::size_t i = 0; i < dot_count; ++i) {
      exact.levels[i] += part[i] * levels[region.face];
      if (part[i] > noise && part[i] < 1 - noise) exact.mixed[i] = true;
    }
  }
  return exact;
}

Levels native_levels(const scene::PolyScene& scene, const stripes::View& view, std::map<std::uint32_t, double> levels, double thickness) {
  registry::FaceOptions options;
  options.stripe = thickness;
  const auto prepared = base::value_of(registry::find_face_algorithm("montani-re")->prepare(scene, options), "montani-re");
  Levels shown(dot_count);
  base::value_of(prepared.coverage(view.camera, window_of(view),
                                   [&](const registry::FacePart& part) {
                                     shown[static_cast<std::size_t>(part.row * dots + part.column)] +=
                                         levels[part.face] * static_cast<double>(part.part) / static_cast<double>(part.whole);
                                   }),
                 "coverage");
  for (double& level : shown) level = std::round(level);
  return shown;
}

struct ErrorOf {
  double mean = 0;
  double greatest = 0;
};

ErrorOf error_of(const Levels& shown, const ExactLevels& exact) {
  ErrorOf error;
  double count = 0;
  for (std::size_t i = 0; i < dot_count; ++i) {
    if (!exact.mixed[i]) continue;
    const double difference = std::abs(shown[i] - exact.levels[i]) / white;
    error.mean += difference;
    error.greatest = std::max(error.greatest, difference);
    ++count;
  }
  error.mean /= std::max(count, 1.0);
  return error;
}

stripes::Outcome draw(const scene::PolyScene& scene, const std::string& name, stripes::Build build) {
  return base::value_of(
      stripes::run({.scene = scene, .view = stripes::view_of(scene, scene.camera), .options = {.build = build}, .check = true}), name);
}

GreyScene grey_scene(const scene::PolyScene& scene, const std::string& name, const stripes::Outcome& plain) {
  const stripes::View view = stripes::view_of(scene, scene.camera);
  const stripes::Outcome greys = draw(scene, name, stripes::Build::coverage);
  const auto levels = levels_by_face(plain.scene);
  const auto prepared = base::value_of(registry::find_face_algorithm("montani-re")->prepare(scene, {}), name);
  const ExactLevels exact = exact_levels(prepared, view, levels);
  Levels rounded = exact.levels;
  for (double& level : rounded) level = std::round(level);
  const ErrorOf without = error_of(levels_of(plain.picture.raster), exact);
  const ErrorOf with = error_of(levels_of(greys.picture.raster), exact);
  GreyScene row;
  row.scene = name;
  row.faces = plain.scene.faces.size();
  row.mixed_dots = static_cast<std::size_t>(std::count(exact.mixed.begin(), exact.mixed.end(), true));
  row.plain_error = without.mean;
  row.plain_greatest = without.greatest;
  row.greys_error = with.mean;
  row.greys_greatest = with.greatest;
  row.native_error = error_of(native_levels(scene, view, levels, 1), exact).mean;
  row.thin_error = error_of(native_levels(scene, view, levels, 0.25), exact).mean;
  row.least_error = error_of(rounded, exact).mean;
  row.plain_t = plain.picture.drawing.count();
  row.greys_t = greys.picture.drawing.count();
  row.greys = png_picture(picture::raster_image(greys.picture.raster, picture::RasterPalette::grey, 1), true);
  return row;
}

OverwritingScene overwriting_scene(const scene::PolyScene& scene, const std::string& name, const stripes::Outcome& plain) {
  const stripes::Outcome over = draw(scene, name, stripes::Build::overwrite);
  if (!(over.picture.raster == plain.picture.raster)) throw base::difference(name + ": overwriting gives another picture than differences");
  OverwritingScene row;
  row.scene = name;
  row.faces = plain.scene.faces.size();
  row.dots = plain.picture.counts.dots;
  row.overwriting_dots = over.picture.dots_written;
  row.difference_commands = plain.picture.board_commands;
  row.overwriting_commands = over.picture.board_commands;
  row.difference_s = core::in_seconds(plain.picture.drawing);
  row.overwriting_s = core::in_seconds(over.picture.drawing);
  return row;
}

// The priority list of section 3, with faces that have no relation left in the back or the front list, and how many these are.
// Nothing if there are cycles.
struct OrderedFaces {
  std::vector<std::uint32_t> order;
  std::size_t isolated = 0;
};

std::optional<OrderedFaces> order_of(std::uint32_t faces, std::span<const native::Relation> relations, bool isolated_to_front) {
  OrderedFaces result;
  std::vector<bool> left(faces, true);
  std::vector<std::uint32_t> front;
  std::vector<std::uint32_t> back;
  for (std::size_t remaining = faces; remaining > 0;) {
    std::vector<bool> hides(faces);
    std::vector<bool> hidden(faces);
    for (const native::Relation& relation : relations) {
      if (!left[relation.near] || !left[relation.far]) continue;
      hides[relation.near] = true;
      hidden[relation.far] = true;
    }
    std::vector<std::uint32_t> to_front;
    std::vector<std::uint32_t> to_back;
    for (std::uint32_t f = 0; f < faces; ++f) {
      if (!left[f]) continue;
      const bool isolated = !hides[f] && !hidden[f];
      if (isolated) ++result.isolated;
      if (isolated ? isolated_to_front : hides[f] && !hidden[f])
        to_front.push_back(f);
      else if (!hides[f])
        to_back.push_back(f);
    }
    if (to_front.empty() && to_back.empty()) return std::nullopt;
    for (const auto* leaving : {&to_front, &to_back})
      for (const std::uint32_t f : *leaving) left[f] = false;
    remaining -= to_front.size() + to_back.size();
    front.insert(front.end(), to_front.begin(), to_front.end());
    back.insert(back.begin(), to_back.begin(), to_back.end());
  }
  result.order = std::move(front);
  result.order.insert(result.order.end(), back.begin(), back.end());
  return result;
}

// T-states of drawing in the given order, without the plotter's movements.
double drawing_in_order(const stripes::ProjectedScene& scene, stripes::Output output, const std::string& name) {
  const auto stream = base::value_of(stripes::encode(scene, {.output = output, .priority = stripes::Computer::host}), name);
  stripes::MachineOptions options;
  if (output == stripes::Output::vector) options.device = stripes::Device::calcomp;
  const stripes::MachinePicture picture = stripes::run_machine(stripes::resident_program(), stream.bytes, options);
  if (picture.status != stripes::Status::complete) throw base::program_failed(name + ": the program stopped");
  return core::in_seconds(picture.drawing) - core::in_seconds(picture.device);
}

std::optional<IsolatedScene> isolated_scene(const scene::PolyScene& scene, const std::string& name) {
  const auto set = base::value_of(native::faces_of(scene, scene.camera), name);
  const native::ListedFaces listed = native::listed_faces(set);
  const stripes::View view = stripes::view_of(scene, scene.camera);
  const stripes::ProjectedScene projected = base::value_of(stripes::project_scene(scene, view, false), name);
  const auto in_order = [&](const OrderedFaces& ordered) {
    stripes::ProjectedScene result;
    for (const std::uint32_t f : ordered.order) {
      const auto face = std::find_if(projected.faces.begin(), projected.faces.end(), [&](const stripes::SceneFace& one) {
        return one.body == set.faces[f].body && one.index == set.faces[f].index;
      });
      if (face != projected.faces.end()) result.faces.push_back(*face);
    }
    return result;
  };
  const auto faces = static_cast<std::uint32_t>(set.faces.size());
  const auto back = order_of(faces, listed.relations, false);
  const auto front = order_of(faces, listed.relations, true);
  if (!back || !front) return std::nullopt;
  IsolatedScene row;
  row.scene = name;
  row.faces = projected.faces.size();
  row.isolated = back->isolated;
  using stripes::Output;
  row.back_s = drawing_in_order(in_order(*back), Output::raster, name);
  row.front_s = drawing_in_order(in_order(*front), Output::raster, name);
  row.back_plotter_s = drawing_in_order(in_order(*back), Output::vector, name);
  row.front_plotter_s = drawing_in_order(in_order(*front), Output::vector, name);
  return row;
}

}  // namespace

MontaniReGreys montani_re_greys(const Context& context) {
  MontaniReGreys measured;
  for (const std::string_view scene_name : scene_names) {
    const std::string name(scene_name);
    context.progress(fmt::format("{} on the 8080 with greys, by overwriting, in other orders", name));
    const auto loaded = scene::load_scene(**scene::named_scene(name));
    if (!loaded) throw base::bad_input(loaded.error().message());
    const stripes::Outcome plain = draw(loaded->scene, name, stripes::Build::plain);
    measured.greys.push_back(grey_scene(loaded->scene, name, plain));
    measured.overwriting.push_back(overwriting_scene(loaded->scene, name, plain));
    if (name == "house") continue;  // its eye is among the faces, so that faces are clipped
    if (const auto row = isolated_scene(loaded->scene, name)) measured.isolated.push_back(*row);
  }
  measured.program_bytes = stripes::resident_program(stripes::Build::coverage).memory.size();
  return measured;
}

void montani_re_greys_chapter(Page& page, const MontaniReGreys& measured) {
  const auto& greys = measured.greys;
  const auto times = [](const GreyScene& row) { return static_cast<double>(row.greys_t) / static_cast<double>(row.plain_t); };
  const double better = least(greys, [](const GreyScene& row) { return row.plain_error / row.greys_error; });
  page.table(
      "montani-re-8080-greys", "Antialiasing by the sides of stripes, on the 8080 in the eight levels of the board", greys,
      {{"scene", "Scene", &GreyScene::scene},
       {"faces", "Faces", "turned to the eye", &GreyScene::faces},
       {"mixed_dots", "Dots with more than one level", &GreyScene::mixed_dots},
       {"plain_error", "Mean error without", "of white", &GreyScene::plain_error, 3},
       {"greys_error", "Mean error with", "of white", &GreyScene::greys_error, 3},
       {"native_error", "Native, stripes of a dot", "of white", &GreyScene::native_error, 3},
       {"thin_error", "Native, stripes of a quarter", "of white", &GreyScene::thin_error, 3},
       {"least_error", "Exact parts in eight levels", "of white", &GreyScene::least_error, 3},
       {"plain_greatest", "Greatest error without", "of white", &GreyScene::plain_greatest, 3},
       {"greys_greatest", "Greatest error with", "of white", &GreyScene::greys_greatest, 3},
       {"plain_t", "Drawing without", "T-states", &GreyScene::plain_t},
       {"greys_t", "Drawing with", "T-states", &GreyScene::greys_t},
       {"times", "Drawing", "times", times, 2}},
      {.notes = {
           fmt::format("The paper leaves antialiasing by \"the sides of type 1 and 3\" to a future paper. This program (`sightline stripes "
                       "--antialias`, {} bytes) mixes the levels of the faces in a dot by the parts that the sides leave to each, in quarters. "
                       "The error is the difference from the mixture by the exact regions, over the dots in which it has more than "
                       "one level.",
                       text_of(measured.program_bytes)),
           page.claim(better > 1, fmt::format("The error is at least {} times smaller with antialiasing.", text_of(better, 1)),
                      text_of(better)) +
               " " + page.claim(least(greys, times) > 1, "Drawing takes longer with antialiasing in every scene.", text_of(least(greys, times), 2))}});
  page.gallery("montani-re-8080-grey-pictures", "Antialiased on the raster board", greys, [](const GreyScene& scene) {
    return figure(scene.greys, "montani-re-8080-greys-" + scene.scene, fmt::format("{}, {} faces.", scene.scene, scene.faces),
                  "Seven levels and the background.", fmt::format("Faces of {} in greys with smooth edges", scene.scene));
  });
  const auto& over = measured.overwriting;
  const double slowest = greatest(over, [](const OverwritingScene& row) { return row.overwriting_s / row.difference_s; });
  page.table("montani-re-8080-overwriting", "Overwriting against differences on the raster board", over,
             {{"scene", "Scene", &OverwritingScene::scene},
              {"faces", "Faces", &OverwritingScene::faces},
              {"dots", "Dots shown", &OverwritingScene::dots},
              {"overwriting_dots", "Dots written by overwriting", &OverwritingScene::overwriting_dots},
              {"difference_commands", "Commands by differences", &OverwritingScene::difference_commands},
              {"overwriting_commands", "Commands by overwriting", &OverwritingScene::overwriting_commands},
              {"difference_s", "Drawing by differences", "emulated s", &OverwritingScene::difference_s, 3},
              {"overwriting_s", "Drawing by overwriting", "emulated s", &OverwritingScene::overwriting_s, 3}},
             {.notes = {"\"It is sufficient to use the overwriting technique\" for faces of uniform colour; differences are for devices "
                        "that do not permit it or \"to reduce the number of I/O device operations\". The pictures are equal dot for dot. "
                        "On the plotter nothing can be overwritten. " +
                        page.claim(slowest < 1, "Overwriting takes less time than differences in every scene.", text_of(slowest, 2))}});
  page.table("montani-re-8080-isolated", "Faces without relations in the back list or in the front list", measured.isolated,
             {{"scene", "Scene", &IsolatedScene::scene},
              {"faces", "Faces", &IsolatedScene::faces},
              {"isolated", "Without relations", "when they enter the list", &IsolatedScene::isolated},
              {"back_s", "Board, back list", "emulated s", &IsolatedScene::back_s, 4},
              {"front_s", "Board, front list", "emulated s", &IsolatedScene::front_s, 4},
              {"back_plotter_s", "Plotter, back list", "computing, emulated s", &IsolatedScene::back_plotter_s, 4},
              {"front_plotter_s", "Plotter, front list", "computing, emulated s", &IsolatedScene::front_plotter_s, 4}},
             {.notes = {"They \"can be inserted into the FRONT or BACK list, indifferently. The successive computations are reduced if they "
                        "are inserted into the BACK list\". " +
                            page.claim(greatest(measured.isolated, [](const IsolatedScene& row) { return std::abs(row.front_s / row.back_s - 1); }) < 0.05,
                                       "Here the two lists differ by less than 5 % on the board.") +
                            " Scenes whose relations have cycles are left out."}});
}

}  // namespace sightline::report
