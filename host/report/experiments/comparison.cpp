#include "host/report/experiments/comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "host/compare/papers.hpp"
#include "host/compare/scenes.hpp"
#include "host/compare/sweep_views.hpp"
#include "host/scene/generate/open_rooms.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::report {

namespace {

using compare::AnswerRow;
using compare::MethodView;
using compare::Spread;

constexpr std::uint64_t seed = 1971;
constexpr std::uint64_t views = 100;
constexpr std::uint64_t full_views = 1000;
constexpr std::uint64_t level_views =
    20;  // of each 100 views of polyhedra: in parallel projection, as Plantinga's method needs
constexpr std::uint64_t views_by_programs = 20;
constexpr std::uint64_t views_of_faces = 2;

constexpr std::size_t rooms_a_side = 4;
constexpr std::array<double, 10> doors_a_wall{0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4, 6, 8};

struct Generated {
  std::string_view family;
  std::size_t size;
};
constexpr std::array<Generated, 9> polyhedra{{{"boxes", 8},
                                              {"boxes", 16},
                                              {"boxes", 32},
                                              {"bricks", 20},
                                              {"bricks", 60},
                                              {"prisms", 10},
                                              {"prisms", 35},
                                              {"town", 16},
                                              {"rooms", 3}}};

template <class Value>
Value done(base::Result<Value> result, const std::string& scene, base::ErrorKind kind = base::ErrorKind::program_failed) {
  if (!result) throw base::error_of(kind, fmt::format("{}: {}", scene, result.error().message()));
  return std::move(*result);
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[(values.size() - 1) / 2];
}

void note_count(const compare::SceneComparison& comparison, std::string_view method, std::string_view name,
                std::vector<double>& counts) {
  for (const compare::ComparedPicture& picture : comparison.pictures) {
    if (picture.name != method) continue;
    for (const registry::AlgorithmCount& count : picture.counts)
      if (count.name == name) counts.push_back(static_cast<double>(count.value));
  }
}

class Comparing {
 public:
  Comparing(const Context& context, Comparison& made) : context_(context), made_(made) {
    made_.views = context.full ? full_views : views;
    made_.views_by_programs = made_.views * views_by_programs / views;
    made_.views_of_faces = made_.views * views_of_faces / views;
  }

  void add(const scene::CellScene& scene, std::string name, std::string kind) {
    ComparisonScene of{std::move(name), std::move(kind), 0, scene.openings.size(), walls_of(scene)};
    add(scene, scene::poly_scene_of(scene), &scene, std::move(of));
  }
  void add(const scene::PolyScene& scene, std::string name) {
    add(scene, scene, nullptr, {std::move(name), "polyhedra"});
  }

  void finish() {
    made_.rows = by_scene_.rows();
    made_.methods = by_method_.rows();
    for (ComparisonScene& scene : made_.scenes) {
      const auto time = [&](std::string_view method,
                            std::optional<Spread> AnswerRow::*spread) -> std::optional<double> {
        for (const AnswerRow& row : made_.rows)
          if (row.scene == scene.name && row.method == method && row.picture == "lines" && row.*spread)
            return (row.*spread)->median;
        return std::nullopt;
      };
      scene.exact_s = time("exact", &AnswerRow::host_seconds);
      scene.jones_s = time("jones", &AnswerRow::host_seconds);
      scene.montani_re_s = time("montani-re", &AnswerRow::host_seconds);
      scene.pdp7_s = time(compare::jones_pdp7_name, &AnswerRow::emulated_seconds);
    }
  }

 private:
  template <class Scene>
  void add(const Scene& scene, const scene::PolyScene& faces, const scene::CellScene* cells,
           ComparisonScene of) {
    context_.progress("comparison: " + of.name);
    for (const scene::PolyBody& body : faces.bodies) of.faces += body.faces.size();
    const auto camera = [&](std::uint64_t number) {
      const bool level = cells == nullptr && number % views >= views - level_views;
      return compare::random_camera(
          faces, cells, level ? compare::Directions::level : compare::Directions::usual, seed, number);
    };
    std::vector<double> visits;
    std::vector<double> pairs;
    const auto draw = [&](std::vector<std::string> methods, bool with_faces, std::uint64_t first,
                          std::uint64_t last, auto&& wanted) {
      compare::CompareOptions options;
      options.methods = std::move(methods);
      options.faces = with_faces;
      options.host_times = context_.host_times;
      options.host_seconds = 0;
      options.for_table = true;
      const auto prepared = done(compare::SceneMethods::of(scene, options), of.name);
      for (std::uint64_t number = first; number < last; ++number) {
        const compare::SceneComparison comparison = done(prepared.view(camera(number)), of.name);
        for (const auto& [method, reason] : comparison.not_applicable)
          if (cells != nullptr && method == compare::jones_pdp7_name) of.not_on_pdp7 = reason;
        if (!with_faces) {
          note_count(comparison, "jones", "visits", visits);
          note_count(comparison, "montani-re", "relations", pairs);
        }
        std::vector<MethodView> drawn = method_views(comparison);
        std::erase_if(drawn, [&](const MethodView& view) { return !wanted(view); });
        by_scene_.add(of.name, number, drawn);
        for (MethodView& view : drawn) view.read = view.of_all = std::nullopt;  // of different scenes
        by_method_.add("", made_.scenes.size() * made_.views + number, drawn);
      }
    };
    const auto all = [](const MethodView&) { return true; };
    if (cells != nullptr) draw({"jones-pdp7", "jones-twin"}, false, 0, made_.views_by_programs, all);
    draw({"exact", "jones", "montani-re", "plantinga"}, false, 0, made_.views, all);
    const std::string turn(compare::turn_name);
    if (cells == nullptr) draw({turn}, false, views - level_views, views, all);
    draw({"montani-re", "willis", "willis-8080", "stripes-8080"}, true, 0, made_.views_of_faces,
         [](const MethodView& view) { return view.picture == "faces"; });
    if (!visits.empty()) of.visits = median_of(std::move(visits));
    if (!pairs.empty()) of.pairs = median_of(std::move(pairs));
    made_.scenes.push_back(std::move(of));
  }

  const Context& context_;
  Comparison& made_;
  compare::Answer by_scene_;
  compare::Answer by_method_;
};

constexpr double microseconds = 1e6;  // per second

std::optional<double> median(const std::optional<Spread>& spread, double unit = 1) {
  return spread ? std::optional(spread->median * unit) : std::nullopt;
}
std::optional<double> most(const std::optional<Spread>& spread, double unit = 1) {
  return spread ? std::optional(spread->greatest * unit) : std::nullopt;
}
auto in_microseconds(std::optional<double> ComparisonScene::*time) {
  return [time](const ComparisonScene& scene) {
    return scene.*time ? std::optional(*(scene.*time) * microseconds) : std::nullopt;
  };
}

std::vector<RowColumn<AnswerRow>> answer_columns() {
  using Row = AnswerRow;
  return {
      {"method", "Method", &Row::method},
      {"picture", "Picture", &Row::picture},
      {"views", "Views", &Row::views},
      {"right", "Right", "none beyond a point", &Row::right},
      {"emulated_s", "Emulated", "s, median", [](const Row& row) { return median(row.emulated_seconds); }},
      {"emulated_most_s", "Emulated", "s, most", [](const Row& row) { return most(row.emulated_seconds); }},
      {"host_us", "Here", "us, median", [](const Row& row) { return median(row.host_seconds, microseconds); },
       Real::as_needed, host_time},
      {"host_most_us", "Here", "us, most",
       [](const Row& row) { return most(row.host_seconds, microseconds); }, Real::as_needed, host_time},
      {"wrong_percent", "Wrong", "%, median", [](const Row& row) { return row.wrong_percent.median; }, 3},
      {"wrong_most_percent", "Wrong", "%, most", [](const Row& row) { return row.wrong_percent.greatest; },
       3},
      {"greatest", "Farthest", "points", [](const Row& row) { return most(row.greatest); }, 2}};
}

std::string doors(double count) {
  return fmt::format("{} portal{} per wall", text_of(count), count == 1 ? "" : "s");
}

std::vector<Pair> pairs_of(const Chosen<ComparisonScene>& rooms, std::optional<double> ComparisonScene::*one,
                           std::optional<double> ComparisonScene::*other) {
  std::vector<Pair> pairs;
  for (const ComparisonScene& room : rooms)
    if (room.*one && room.*other) pairs.push_back({*room.openness(), *(room.*one), *(room.*other)});
  return pairs;
}

// The openness up to which Jones's method is faster than `other` on this computer.
std::string advantage(const std::vector<Pair>& pairs, std::string_view other) {
  const auto [last, first] = crossing_of(pairs);
  const auto ratio = [](const Pair& pair) {
    const double times = std::max(pair.other / pair.one, pair.one / pair.other);
    return text_of(times, times < 10 ? 1 : 0);
  };
  if (!last)
    return fmt::format(
        "Jones's method is never faster than {} on this computer: at {} it takes {} times as long.", other,
        doors(pairs.front().at), ratio(pairs.front()));
  const std::string faster = fmt::format("at {} {} times", doors(pairs.front().at), ratio(pairs.front()));
  if (!first)
    return fmt::format("Jones's method is faster than {} on this computer throughout: {}, at {} {} times.",
                       other, faster, doors(pairs.back().at), ratio(pairs.back()));
  return fmt::format(
      "Up to {} Jones's method is faster than {} on this computer ({}); from {} on it is slower: at {} it takes {} times as "
      "long.",
      doors(*last), other, faster, doors(*first), doors(pairs.back().at), ratio(pairs.back()));
}

void openness(Page& page, const Comparison& comparison) {
  using Scene = ComparisonScene;
  const auto rooms = comparison.rooms();
  const auto visits = values(rooms, &Scene::visits);
  const Scene& closed = rooms.front();
  const Scene& open = rooms.back();
  const auto against_exact = pairs_of(rooms, &Scene::jones_s, &Scene::exact_s);
  Panel panel{"comparison-openness",
              fmt::format("From {} to {} portals per wall, a view of {} rooms enters {} to {} cells",
                          text_of(*closed.openness()), text_of(*open.openness()), rooms_a_side * rooms_a_side,
                          text_of(visits.front(), 0), text_of(visits.back(), 0))};
  panel.facts = {page.paper_says_dated("jones.best"), page.paper_says_dated("jones.comparison"),
                 page.paper_says_dated("jones.exhaustive")};
  if (page.host_times()) {
    panel.text.emplace_back(advantage(against_exact, "the exact method"));
    panel.text.emplace_back(
        advantage(pairs_of(rooms, &Scene::jones_s, &Scene::montani_re_s), "Montani and Re's"));
  }
  panel.text.push_back(
      page.claim(std::is_sorted(visits.begin(), visits.end()) && visits.front() < visits.back(),
                 "Results are best where opaque planes predominate, as the paper says.") +
      fmt::format(
          " All {} buildings have the same {} rooms and {} walls; only doors are added. A cell is entered once for every chain "
          "of portals through which it is visible: the number of cells entered grows {} times, that of faces {} times.",
          rooms.size(), rooms_a_side * rooms_a_side, text_of(closed.walls),
          text_of(visits.back() / visits.front(), 0),
          text_of(static_cast<double>(open.faces) / static_cast<double>(closed.faces), 1)));
  const auto pdp7 = where(rooms, [](const Scene& scene) { return scene.pdp7_s.has_value(); });
  const auto left_out = where(rooms, [](const Scene& scene) { return !scene.not_on_pdp7.empty(); });
  if (!pdp7.empty())
    panel.text.push_back(
        fmt::format("On the PDP-7 the median view takes {} s at {} and {} s at {}.",
                    text_of(*pdp7.front().get().pdp7_s, 2), doors(*pdp7.front().get().openness()),
                    text_of(*pdp7.back().get().pdp7_s, 2), doors(*pdp7.back().get().openness())) +
        (left_out.empty()
             ? std::string()
             : fmt::format(" It does not take {}: {}.", doors(*left_out.front().get().openness()),
                           left_out.front().get().not_on_pdp7)));
  const auto solids = where(comparison.scenes, equals(&Scene::kind, "polyhedra"));
  std::string of_solids = fmt::format(
      "Here a program computes the cells of unconnected objects. It cuts the free space around them into many cells: a view of "
      "polyhedra of {} to {} faces enters {} to {} cells.",
      text_of(least(solids, &Scene::faces)), text_of(greatest(solids, &Scene::faces)),
      text_of(least(solids, &Scene::visits), 0), text_of(greatest(solids, &Scene::visits), 0));
  if (page.host_times()) {
    const auto slower = range_of(solids, [](const Scene& scene) { return *scene.jones_s / *scene.exact_s; });
    of_solids += fmt::format(
        " In {} of {} of these scenes Jones's method is slower than the exact one; it takes {} to {} times "
        "as long.",
        count(solids, [](const Scene& scene) { return scene.jones_s > scene.exact_s; }), solids.size(),
        text_of(slower.least, 1), text_of(slower.greatest, 1));
  }
  panel.text.emplace_back(std::move(of_solids));
  const auto at = [](const Scene& room) { return room.openness(); };
  Plot work{"comparison-work",
            "Work against openness",
            "Medians of random views of the buildings. The same on every computer.",
            "Cells entered and pairs of faces against portals per wall: cells entered rise more steeply",
            {"portals per wall"},
            {"count in a view"}};
  add_curves(work, rooms, "jones: cells entered", at, &Scene::visits);
  add_curves(work, rooms, "exact: faces", at,
             [](const Scene& room) { return static_cast<double>(room.faces); });
  add_curves(work, rooms, "montani-re: pairs of faces", at, &Scene::pairs);
  Plot machine{"comparison-pdp7",
               "Time of a view on the PDP-7 against openness",
               "Medians of random views of the buildings that fit into the machine, with the EAE.",
               "Emulated time against portals per wall: it rises steadily",
               {"portals per wall"},
               {"emulated time", "s"}};
  add_curves(machine, rooms, "jones-pdp7", at, &Scene::pdp7_s);
  if (page.host_times()) {
    Plot times{"comparison-times",
               "Time of a view on this computer against openness",
               "Medians of random views of the buildings, one run per view.",
               "Time against portals per wall: Jones's method rises steeply",
               {"portals per wall"},
               {"time", "us"}};
    add_curves(times, rooms, "jones", at, in_microseconds(&Scene::jones_s));
    add_curves(times, rooms, "exact", at, in_microseconds(&Scene::exact_s));
    add_curves(times, rooms, "montani-re", at, in_microseconds(&Scene::montani_re_s));
    page.add_plot(panel, std::move(times));
    page.add(std::move(panel));
    page.plot(std::move(work));
  } else {
    page.add_plot(panel, std::move(work));
    page.add(std::move(panel));
  }
  page.plot(std::move(machine));
}

}  // namespace

std::size_t walls_of(const scene::CellScene& scene) {
  std::size_t walls = 0;
  for (std::size_t a = 0; a < scene.cells.size(); ++a) {
    for (std::size_t b = a + 1; b < scene.cells.size(); ++b) {
      const geometry::Box& one = scene.cells[a].box;
      const geometry::Box& other = scene.cells[b].box;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [u, v] = geometry::other_axes(axis);
        const bool touch = one.high[axis] == other.low[axis] || other.high[axis] == one.low[axis];
        if (touch && one.span(u).overlaps(other.span(u)) && one.span(v).overlaps(other.span(v))) ++walls;
      }
    }
  }
  return walls;
}

Crossing crossing_of(const std::vector<Pair>& pairs) {
  Crossing crossing;
  for (const Pair& pair : pairs) {
    if (pair.one >= pair.other) {
      crossing.first = pair.at;
      break;
    }
    crossing.last = pair.at;
  }
  return crossing;
}

Comparison compare_all(const Context& context) {
  Comparison made;
  Comparing comparing(context, made);
  for (const std::string_view name : scene::builtin_scene_names())
    comparing.add(done(scene::load_cell_scene(std::string(name)), std::string(name), base::ErrorKind::bad_input),
                  std::string(name), "built-in");
  for (const double of_wall : doors_a_wall) {
    const auto all =
        static_cast<std::size_t>(of_wall * static_cast<double>(scene::walls_between_rooms(rooms_a_side)));
    comparing.add(scene::generate_open_rooms(rooms_a_side, all, seed), fmt::format("rooms, {} doors", all),
                  "rooms");
  }
  for (const Generated& of : polyhedra) {
    const std::string name = fmt::format("{}-{}", of.family, of.size);
    comparing.add(done(scene::generate_scene(of.family, of.size), name, base::ErrorKind::bad_input), name);
  }
  comparing.finish();
  return made;
}

void comparison_chapter(Page& page, const Comparison& comparison) {
  using Scene = ComparisonScene;
  page.paragraph(
      fmt::format("{} scenes, {} random views of each (seed {}): the built-in scenes, ten buildings of {} rooms with more and "
                  "more doors, seen from inside along z as in the program of 1971; and scenes of polyhedra, one view in five "
                  "in parallel projection, as Plantinga's method needs. Programs on the PDP-7 draw {} of these views, face "
                  "methods {}.",
                  comparison.scenes.size(), comparison.views, seed, rooms_a_side * rooms_a_side,
                  comparison.views_by_programs, comparison.views_of_faces));
  openness(page, comparison);
  std::vector<RowColumn<AnswerRow>> columns = answer_columns();
  columns.push_back(
      {"paper", "The paper says", [](const AnswerRow& row) { return compare::paper_figure(row.method, row.picture); }});
  const auto exact = where(comparison.methods, [](const AnswerRow& row) { return row.exact; });
  page.table("comparison-methods", "All methods over all scenes", comparison.methods, columns,
             {{"Each method over the views of the scenes that it can take. Wrong and right as in the first "
               "table of the report. " +
               page.claim(std::all_of(exact.begin(), exact.end(),
                                      [](const AnswerRow& row) { return row.right == row.views; }),
                          "The exact methods are exact in every view.")}});
  page.table("comparison-scenes", "The scenes, and the median view of each", comparison.scenes,
             {{"scene", "Scene", &Scene::name},
              {"kind", "Kind", &Scene::kind},
              {"faces", "Faces", &Scene::faces},
              {"portals", "Portals", &Scene::portals},
              {"walls", "Walls", &Scene::walls},
              {"openness", "Openness", "portals per wall", &Scene::openness, 2},
              {"visits", "Cells entered", "jones", &Scene::visits, 0},
              {"pairs", "Pairs of faces", "montani-re", &Scene::pairs, 0},
              {"pdp7_s", "jones-pdp7", "s", &Scene::pdp7_s, 3},
              {"jones_us", "jones", "us", in_microseconds(&Scene::jones_s), 1, host_time},
              {"exact_us", "exact", "us", in_microseconds(&Scene::exact_s), 1, host_time},
              {"montani_re_us", "montani-re", "us", in_microseconds(&Scene::montani_re_s), 1, host_time}},
             {{"A wall is a pair of cells that share a piece of a plane, with or without portals in it. The cells of polyhedra "
               "are computed before the measurement, which these times do not include."}});
  columns = answer_columns();
  columns.insert(columns.begin(), {"scene", "Scene", &AnswerRow::scene});
  page.table("comparison", "All methods, scene by scene", comparison.rows, columns, {{}, true});
}

}  // namespace sightline::report
