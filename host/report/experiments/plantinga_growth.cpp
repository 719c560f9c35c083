#include "host/report/experiments/plantinga_growth.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/event_file.hpp"
#include "host/algorithms/plantinga/event_list.hpp"
#include "host/report/experiments/face_tree.hpp"
#include "host/report/experiments/montani_re_growth.hpp"
#include "host/report/experiments/plantinga_models.hpp"
#include "host/report/page.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::plantinga;

// k x k faces, tilted by the matrix of three times a rotation. Rings of integer cosines keep every face plane.
scene::PolyScene torus(std::int32_t k) {
  constexpr double turn = 2 * std::numbers::pi;
  const auto rounded = [](double number) { return static_cast<std::int32_t>(std::lround(number)); };
  scene::PolyScene scene;
  for (std::int32_t j = 0; j < k; ++j) {
    const std::int32_t radius = rounded(600 + 200 * std::cos(turn * j / k));
    const std::int32_t z = 64 * rounded(200 * std::sin(turn * j / k));
    for (std::int32_t i = 0; i < k; ++i) {
      const std::int32_t x = radius * rounded(64 * std::cos(turn * i / k));
      const std::int32_t y = radius * rounded(64 * std::sin(turn * i / k));
      scene.vertices.push_back({2 * x - y + 2 * z, 2 * x + 2 * y - z, -x + 2 * y + 2 * z});
    }
  }
  scene::PolyBody body;
  for (std::int32_t j = 0; j < k; ++j) {
    for (std::int32_t i = 0; i < k; ++i) {
      const auto corner = [k](std::int32_t row, std::int32_t column) {
        return static_cast<scene::VertexIndex>(row % k * k + column % k);
      };
      body.faces.push_back({{corner(j, i), corner(j, i + 1), corner(j + 1, i + 1), corner(j + 1, i)}, {}});
    }
  }
  scene.bodies.push_back(std::move(body));
  return scene;
}

// Three fences of k bars: upright, and slanted both ways.
scene::PolyScene fences(std::int32_t k) {
  constexpr std::int32_t half = 2000;
  constexpr std::array<std::array<std::int32_t, 2>, 3> directions{{{0, 1}, {1, 1}, {-1, 1}}};
  scene::PolyScene scene;
  scene::PolyBody body;
  body.sheet = true;
  for (std::int32_t fence = 0; fence < 3; ++fence) {
    const auto [dx, dy] = directions[static_cast<std::size_t>(fence)];
    const std::int32_t width = std::max(half / (3 * k), 1);
    for (std::int32_t i = 0; i < k; ++i) {
      const std::int32_t x = (2 * i - k + 1) * half / k + 7 * fence + i % 3;  // no two bars meet others alike
      const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
      scene.vertices.push_back({x - width - dx * half, -half * dy, 400 * fence});
      scene.vertices.push_back({x + width - dx * half, -half * dy + 1, 400 * fence});
      scene.vertices.push_back({x + width + dx * half, half * dy, 400 * fence});
      scene.vertices.push_back({x - width + dx * half, half * dy - 1, 400 * fence});
      body.faces.push_back({{first, first + 1, first + 2, first + 3}, {}});
    }
  }
  scene.bodies.push_back(std::move(body));
  return scene;
}

// Visible lines of a frame, averaged over 360 degrees.
double mean_lines(const native::EventList& list) {
  native::EdgeStructureGraph graph(list);
  double sum = 0;
  for (int degrees = -180; degrees < 180; ++degrees) {
    static_cast<void>(graph.turn_to((degrees + 0.5) * std::numbers::pi / 180));
    sum += static_cast<double>(graph.piece_count());
  }
  return sum / 360;
}

TurnGrowth row_of(std::string family, std::string name, const native::RotationModel& model, const native::EventList& list) {
  return {.family = std::move(family),
          .scene = std::move(name),
          .faces = model.faces().size(),
          .edges = model.edges().size(),
          .groups = list.events.size(),
          .changes = list.changes.size(),
          .events_kb = static_cast<double>(native::encode_events(list).size()) / 1024,
          .lines = mean_lines(list)};
}

TreeDrawing tree_drawing(const TurnGrowth& model, const scene::PolyScene& scene) {
  const FaceTree tree(scene);
  TreeDrawing row{.model = model.scene, .faces = model.faces, .polygons = tree.polygons().size(), .lines = model.lines};
  std::vector<std::uint32_t> order;
  for (int degrees = -180; degrees < 180; ++degrees) {
    const double angle = (degrees + 0.5) * std::numbers::pi / 180;
    tree.paint({std::sin(angle), 0, std::cos(angle), 0}, order);
    row.turned += static_cast<double>(order.size()) / 360;
    for (const std::uint32_t number : order) row.sides += static_cast<double>(tree.polygons()[number].polygon.sides.size()) / 360;
  }
  return row;
}

TurnGrowth turn_of(const Context& context, std::string family, std::string name, const scene::PolyScene& scene) {
  context.progress(fmt::format("events of {}", name));
  const native::RotationModel model(scene);
  const auto begun = std::chrono::steady_clock::now();
  const auto list = native::build_event_list(model);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
  if (!list) throw base::difference(fmt::format("{}: {}", name, list.error().message()));
  TurnGrowth row = row_of(std::move(family), std::move(name), model, *list);
  if (context.host_times) row.prepare_s = taken.count();
  return row;
}

// Without the smallest scene of five, or two of six or seven: small scenes have few events of the kind that grows fastest.
TurnExponents exponents_of(const std::vector<TurnGrowth>& scenes) {
  const std::vector<TurnGrowth> larger(scenes.begin() + static_cast<std::ptrdiff_t>(scenes.size() / 2 - 1), scenes.end());
  const auto exponent = [&larger](const auto& value) {
    std::vector<std::pair<double, double>> points;
    for (const TurnGrowth& row : larger) points.emplace_back(static_cast<double>(row.faces), value(row));
    return growth_exponent(points, 3);
  };
  TurnExponents result{.family = larger.front().family, .from_faces = larger.front().faces, .to_faces = larger.back().faces};
  result.changes = exponent([](const TurnGrowth& row) { return static_cast<double>(row.changes); });
  result.groups = exponent([](const TurnGrowth& row) { return static_cast<double>(row.groups); });
  if (larger.front().prepare_s) result.prepare = exponent([](const TurnGrowth& row) { return *row.prepare_s; });
  return result;
}

const TurnExponents& of_family(const PlantingaGrowth& growth, std::string_view family) {
  return *std::find_if(growth.exponents.begin(), growth.exponents.end(), [family](const TurnExponents& row) { return row.family == family; });
}

// The number of faces with a million changes, by the fit through the largest scene of the family.
double faces_of_a_million(const PlantingaGrowth& growth, std::string_view family) {
  const TurnExponents& fit = of_family(growth, family);
  const TurnGrowth& last = where(growth.scenes, equals(&TurnGrowth::family, std::string(family))).back().get();
  return static_cast<double>(last.faces) * std::pow(1e6 / static_cast<double>(last.changes), 1 / *fit.changes);
}

}  // namespace

PlantingaGrowth plantinga_growth(const Context& context) {
  PlantingaGrowth growth;
  const auto family = [&](const std::string& name, const std::vector<std::size_t>& sizes, const auto& make) {
    std::vector<TurnGrowth> scenes;
    for (const std::size_t size : sizes) scenes.push_back(turn_of(context, name, fmt::format("{}-{}", name, size), make(size)));
    growth.exponents.push_back(exponents_of(scenes));
    growth.scenes.insert(growth.scenes.end(), scenes.begin(), scenes.end());
  };
  family("torus", {3, 6, 10, 17, 31, 55}, [](std::size_t k) { return torus(static_cast<std::int32_t>(k)); });
  family("boxes", {2, 5, 16, 50, 160, 500}, [](std::size_t size) { return scene::generate_boxes(size); });
  std::vector<std::size_t> sizes{10, 30, 100, 300, 1000};
  if (context.full) sizes.push_back(3000);
  family("triangles", sizes, [](std::size_t size) { return scene::generate_triangles(size); });
  sizes = {4, 8, 12, 16, 24, 32};
  if (context.full) sizes.push_back(64);
  family("fences", sizes, [](std::size_t k) { return fences(static_cast<std::int32_t>(k)); });
  for (const std::string_view name : plantinga_models_of(context)) {
    const StudiedModel studied = study_model(context, name);
    TurnGrowth row = row_of("model", studied.name, studied.model, studied.list);
    if (studied.times) row.prepare_s = studied.times->all_cores_s;
    context.progress(fmt::format("BSP tree of {}", name));
    growth.trees.push_back(tree_drawing(row, plantinga_scene(name)));
    growth.scenes.push_back(std::move(row));
  }
  return growth;
}

void plantinga_growth_chapter(Page& page, const PlantingaGrowth& growth) {
  const auto models = where(growth.scenes, equals(&TurnGrowth::family, std::string("model")));
  const double million = faces_of_a_million(growth, "fences");
  page.claims(
      "plantinga-growth-paper", "Plantinga, Seales and Dyer 1990: growth and storage",
      {{.claim = "plantinga.storage_order",
        .here = least_and_greatest(growth.exponents, &TurnExponents::changes),
        .places = 2,
        .condition = "exponents of the four families below",
        .comparison = greatest(growth.exponents, &TurnExponents::changes) <= 3 && least(growth.exponents, &TurnExponents::changes) >= 1
                          ? "within the paper's orders"
                          : "outside the paper's orders"},
       {.claim = "plantinga.million",
        .here = one_figure(std::round(million)),
        .condition = "three fences of bars: faces with a million changes of edges, by the fit",
        .comparison = million < 600 ? "these scenes have as many events with fewer faces than the paper's" : "more faces than the paper's"},
       {.claim = "plantinga.frames",
        .here = least_and_greatest(models, &TurnGrowth::storage_ratio),
        .places = 1,
        .condition = fmt::format("{} of the {} models of Table 1: 360 frames of visible lines as four 16-bit numbers, over the event file",
                                  models.size(), scene::builtin_model_names().size()),
        .comparison = least(models, &TurnGrowth::storage_ratio) > 1 ? "so it is for each of these models" : "not for each of these models"},
       {.claim = "plantinga.tree",
        .here = least_and_greatest(growth.trees, &TreeDrawing::polygons),
        .condition = fmt::format("polygons in the tree of {} models of Table 1, of {} to {} faces", growth.trees.size(),
                                  text_of(least(growth.trees, &TreeDrawing::faces)), text_of(greatest(growth.trees, &TreeDrawing::faces))),
        .comparison = fmt::format("more than the faces in {} of these models",
                                  count(growth.trees, [](const TreeDrawing& tree) { return tree.polygons > tree.faces; }))}});
  page.table("plantinga-growth-scenes", "Plantinga, Seales and Dyer: events and storage of scenes of increasing size", growth.scenes,
             {{"family", "Family", &TurnGrowth::family},
              {"scene", "Scene", &TurnGrowth::scene},
              {"faces", "Faces", &TurnGrowth::faces},
              {"edges", "Edges", &TurnGrowth::edges},
              {"groups", "Directions with events", &TurnGrowth::groups},
              {"changes", "Changes of edges", &TurnGrowth::changes},
              {"events_kb", "Event file", "KB", &TurnGrowth::events_kb, 1},
              {"lines", "Visible lines", "mean of a frame", &TurnGrowth::lines, 1},
              {"frames_kb", "360 frames", "KB", &TurnGrowth::frames_kb, 1},
              {"storage_ratio", "Frames over events", "times", &TurnGrowth::storage_ratio, 2},
              {"equal_frames", "Frames as large as the events", &TurnGrowth::equal_frames, 0},
              {"prepare_s", "Preprocessing", "s", &TurnGrowth::prepare_s, 2, host_time}},
             {.notes = {"Full turns about the y axis. A frame is stored as four 16-bit coordinates for each visible line; the event file "
                        "begins with the structure of the first frame. Preprocessing is on all cores."}});
  const auto most = where(growth.scenes, [](const TurnGrowth& row) { return row.storage_ratio() < 1; });
  const bool families = std::all_of(most.begin(), most.end(), [](const TurnGrowth& row) { return row.family == "triangles" || row.family == "fences"; });
  page.paragraph(page.claim(!most.empty() && families,
                            "Where events grow fastest, the paper's comparison turns round: of the largest clouds of triangles and fences, "
                            "360 frames take less than the events.",
                            text_of(most.size()) + " scenes have frames smaller than their events"));
  page.table("plantinga-tree", "Plantinga, Seales and Dyer: what a BSP tree draws", growth.trees,
             {{"model", "Model", &TreeDrawing::model},
              {"faces", "Faces", &TreeDrawing::faces},
              {"polygons", "Polygons of the tree", &TreeDrawing::polygons},
              {"turned", "Polygons turned to the eye", "mean of a frame", &TreeDrawing::turned, 1},
              {"sides", "Their sides", "mean of a frame", &TreeDrawing::sides, 1},
              {"lines", "Visible lines", "mean of a frame", &TreeDrawing::lines, 1},
              {"ratio", "Sides over visible lines", "times", &TreeDrawing::ratio, 2}},
             {.notes = {"The paper compares its method with that of Fuchs, Kedem and Naylor (1980): all polygons of a BSP tree, the farthest "
                        "first, so that nearer ones cover what they hide. It needs no events, and any view can be the next. " +
                        page.claim(greatest(growth.trees, &TreeDrawing::ratio) > 1,
                                   fmt::format("It draws more lines than are visible in {} of {} models, up to {} times as many. In the others "
                                               "little is hidden, and most visible lines are parts of edges.",
                                               count(growth.trees, [](const TreeDrawing& tree) { return tree.ratio() > 1; }), growth.trees.size(),
                                               text_of(greatest(growth.trees, &TreeDrawing::ratio), 1)),
                                   text_of(greatest(growth.trees, &TreeDrawing::ratio)))}});
  const TurnExponents& torus_fit = of_family(growth, "torus");
  const TurnExponents& fence_fit = of_family(growth, "fences");
  page.table("plantinga-growth-exponents", "Plantinga, Seales and Dyer: exponents of growth with the number of faces", growth.exponents,
             {{"family", "Family", &TurnExponents::family},
              {"from_faces", "From", "faces", &TurnExponents::from_faces},
              {"to_faces", "To", "faces", &TurnExponents::to_faces},
              {"changes", "Changes of edges", &TurnExponents::changes, 2},
              {"groups", "Directions with events", &TurnExponents::groups, 2},
              {"prepare", "Preprocessing, time", &TurnExponents::prepare, 2, host_time}},
             {.notes = {"The paper: storage between n and n^3, often n^2; preprocessing between n^2 and n^4. " +
                        page.claim(torus_fit.changes < 1.2, "The torus is at the low end, because its silhouette hides little.",
                                   "the exponent of the torus is " + text_of(torus_fit.changes, 2)) +
                        " " +
                        page.claim(fence_fit.changes > 2.2,
                                   "The fences approach the high end: of three bars in three directions, most meet in some view.",
                                   "the exponent of the fences is " + text_of(fence_fit.changes, 2)) +
                        " Least squares of logarithms over the scenes of each family from the number of faces under From to that under To."}});
  Plot plot{"plantinga-growth-plot",
            "Changes of edges in a full turn",
            "Changes of edges (the paper's events) against faces. Lines: families; points: models of Table 1.",
            "Four lines on logarithmic axes, one per family, and single points of the models",
            {"faces"},
            {"changes of edges"}};
  for (const TurnExponents& fit : growth.exponents) {
    add_curves(plot, where(growth.scenes, equals(&TurnGrowth::family, fit.family)), fit.family, &TurnGrowth::faces, &TurnGrowth::changes);
  }
  add_curves(plot, models, "models of Table 1", &TurnGrowth::faces, &TurnGrowth::changes,
             {.label = [](const TurnGrowth& row) { return row.scene; }, .line = false});
  page.plot(std::move(plot));
}

}  // namespace sightline::report
