// See cross_check.hpp.
#include "host/compare/cross_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "host/algorithms/registry/heights.hpp"
#include "host/base/text.hpp"
#include "host/compare/cross_check_compare.hpp"
#include "host/compare/cross_check_faces.hpp"
#include "host/compare/stripes.hpp"
#include "host/compare/turning.hpp"
#include "host/compare/willis_8080.hpp"
#include "host/scene/cells/from_cell_scene.hpp"

namespace sightline::compare {
namespace {

constexpr std::string_view oracle_name = "oracle";

std::vector<Participant> find_participants() {
  std::vector<Participant> found;
  const auto at = [&found](std::string_view name) -> Participant& {
    const auto known =
        std::find_if(found.begin(), found.end(), [name](const Participant& who) { return who.name == name; });
    return known != found.end() ? *known : found.emplace_back(Participant{name});
  };
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms())
    at(algorithm.name).lines = true;
  for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms())
    at(algorithm.name).faces = true;
  for (const registry::HeightAlgorithm& algorithm : registry::height_algorithms()) at(algorithm.name).faces = true;
  at(stripes_name).faces = true;
  at(oracle_name).faces = true;
  at(willis_on_8080().name).faces = true;
  at(turn_name).screen = true;
  for (const std::string_view name : {jones_pdp7_name, jones_no_eae_name, jones_twin_name}) at(name).jones = true;
  at(skala_8080_name).ink = true;
  return found;
}

constexpr std::string_view colours_faces = "colours faces; those of this scene's solids are compared where they are tilted (C1 to C4)";
constexpr std::string_view wants_cells = "looks along z into cells parallel to the axes";
constexpr std::string_view wants_heights = "draws functions of two variables only";

constexpr std::array all_not_applicable{
    NotApplicable{"skala", "C", NotApplicable::Views::all, wants_heights},
    NotApplicable{"skala", "J", NotApplicable::Views::all, wants_heights},
    NotApplicable{skala_8080_name, "C", NotApplicable::Views::all, wants_heights},
    NotApplicable{skala_8080_name, "J", NotApplicable::Views::all, wants_heights},
    NotApplicable{jones_pdp7_name, "C", NotApplicable::Views::all, wants_cells},
    NotApplicable{jones_pdp7_name, "H", NotApplicable::Views::all, wants_cells},
    NotApplicable{jones_no_eae_name, "C", NotApplicable::Views::all, wants_cells},
    NotApplicable{jones_no_eae_name, "H", NotApplicable::Views::all, wants_cells},
    NotApplicable{jones_twin_name, "C", NotApplicable::Views::all, wants_cells},
    NotApplicable{jones_twin_name, "H", NotApplicable::Views::all, wants_cells},
    NotApplicable{"willis", "J", NotApplicable::Views::all, colours_faces},
    NotApplicable{"willis-8080", "J", NotApplicable::Views::all, colours_faces},
    NotApplicable{stripes_name, "J", NotApplicable::Views::all, colours_faces},
    NotApplicable{"plantinga", "J", NotApplicable::Views::all, "events of a turn are those of parallel projection"},
    NotApplicable{turn_name, "J", NotApplicable::Views::all, "turns in parallel projection"},
    NotApplicable{"willis", "H", NotApplicable::Views::all,
                  "leaves touching facets clustered: no plane with integer coefficients separates them"},
    NotApplicable{stripes_name, "C7", NotApplicable::Views::all,
                  "two faces hide each other in different places, for which the paper has no order"},
    NotApplicable{stripes_name, "C9", NotApplicable::Views::all, "65 faces are turned to the eye, the 8080 holds 64"},
    NotApplicable{stripes_name, "H", NotApplicable::Views::all, "1,922 faces are turned to the eye, the 8080 holds 64"},
    NotApplicable{"plantinga", "C", NotApplicable::Views::perspective,
                  "events of a turn are those of parallel projection"},
    NotApplicable{turn_name, "C", NotApplicable::Views::perspective, "turns in parallel projection"},
    NotApplicable{turn_name, "H", NotApplicable::Views::all, "has some 3,000 edges, and the machine holds 512"},
    NotApplicable{"willis-8080", "H", NotApplicable::Views::all, "has tens of thousands of pieces, and the machine holds 255"},
};

template <class Table>
const auto* find_in(const Table& table, std::string_view name) {
  const auto found =
      std::find_if(table.begin(), table.end(), [name](const auto& row) { return row.name == name; });
  return found != table.end() ? &*found : nullptr;
}

// The PDP-7's picture of the views, drawn before all others: participants with lines draw theirs at its angles, too.
struct TurnedView {
  std::optional<ScreenPicture> screen;
  std::string problem;
};
struct TurnedViews {
  std::optional<Turning> turning;
  std::vector<TurnedView> views;
};

// The machine's lines in pixels of a view.
std::vector<picture::PixelSegment> lines_in_view(const Turning& turning, const CommonScene& scene, const CrossCheckView& view,
                                                 const TurnPicture& shown) {
  // The scene was moved to the axis; every vertex by the same amount.
  scene::PolyPoint moved = scene.scene.vertices.front();
  for (std::size_t a = 0; a < 3; ++a) moved[a] -= turning.scene_on_axis().vertices.front()[a];
  const picture::PixelPoint on_axis = view.place(moved);
  double lowest = turning.scene_on_axis().vertices.front()[1];
  double highest = lowest;
  for (const scene::PolyPoint& v : turning.scene_on_axis().vertices) {
    lowest = std::min<double>(lowest, v[1]);
    highest = std::max<double>(highest, v[1]);
  }
  // The machine's screen may show the scene's left side at the right.
  const double turn = shown.angle * 2 * std::numbers::pi / (1 << 18);
  const auto& right = view.camera.right;
  const double sign = right[0] * std::cos(turn) - right[2] * std::sin(turn) < 0 ? -1 : 1;
  const double pixels = view.window().scale / turning.scale();  // per point of the display
  const auto placed = [&](const picture::PixelPoint& p) {
    return picture::PixelPoint{on_axis.x + sign * (p.x - 512) * pixels,
                               on_axis.y + (p.y - 512) * pixels + (lowest + highest) / 2 * turning.scale() * pixels};
  };
  std::vector<picture::PixelSegment> lines;
  for (const picture::PixelSegment& line : shown.lines) lines.push_back({placed(line.a), placed(line.b)});
  return lines;
}

TurnedViews turned_views(const CommonScene& scene) {
  TurnedViews turned;
  turned.views.resize(scene.views.size());
  std::string problem;
  for (std::size_t v = 0; v < scene.views.size(); ++v) {
    const CrossCheckView& view = scene.views[v];
    TurnedView& of = turned.views[v];
    if (listed_reason(turn_name, scene.name, view.camera.perspective)) continue;
    if (!turned.turning && problem.empty()) {
      auto made = Turning::of(scene.scene);
      if (made)
        turned.turning.emplace(std::move(*made));
      else
        problem = made.error().message();
    }
    of.problem = problem;
    const auto angle = turn_angle_of(view.camera);
    if (!angle) of.problem = "the view does not look along the plane of the turn";
    if (!of.problem.empty()) continue;
    auto drawn = turned.turning->draw(*angle, &view.camera);
    if (!drawn)
      of.problem = drawn.error().message();
    else if (!drawn->difference.empty())
      of.problem = "the program differs from its twin: " + drawn->difference;
    else {
      of.screen.emplace(ScreenPicture{std::move(*drawn), {}, 0});
      of.screen->in_view = lines_in_view(*turned.turning, scene, view, of.screen->turn);
      of.screen->bound_in_view = of.screen->turn.view_bound * view.window().scale / turned.turning->scale();
    }
  }
  return turned;
}

// Draws the views of one participant that are not listed as not applicable.
class Drawing {
 public:
  Drawing(const CommonScene& scene, const Participant& who, const CrossCheckTables& tables, const TurnedViews& turned)
      : scene_(scene), who_(who), tables_(tables), turned_(turned), pictures_(scene.views.size()) {
    bool any = false;
    for (std::size_t v = 0; v < pictures_.size(); ++v) {
      const bool perspective = scene.views[v].camera.perspective;
      pictures_[v].not_applicable = listed_reason(who.name, scene.name, perspective).value_or("");
      any = any || pictures_[v].not_applicable.empty();
    }
    if (any && who.lines) draw_lines();
    if (any && who.faces && !scene.matter) draw_faces();
    if (any && who.screen) draw_screen();
    if (any && who.jones) draw_jones();
    if (any && who.ink) draw_ink();
  }

  [[nodiscard]] std::vector<CrossCheckPicture> take() { return std::move(pictures_); }

 private:
  template <class Draw>
  void for_each_view(Draw&& draw) {
    for (std::size_t v = 0; v < pictures_.size(); ++v)
      if (pictures_[v].not_applicable.empty()) draw(scene_.views[v], pictures_[v]);
  }
  void fail(const std::string& problem) {
    for_each_view(
        [&problem](const CrossCheckView&, CrossCheckPicture& picture) { picture.problem = problem; });
  }

  void draw_lines() {
    const registry::LineAlgorithm* const algorithm = find_in(tables_.lines, who_.name);
    if (algorithm == nullptr) return fail("no such algorithm in the registry of lines");
    if (scene_.matter) return draw_matter(*algorithm);
    if (auto reason = algorithm->why_not(scene_.scene)) return fail(*reason);
    auto made = algorithm->prepare(scene_.scene);
    if (!made) return fail(made.error().message());
    const auto& prepared = *made;
    for_each_view([&](const CrossCheckView& view, CrossCheckPicture& picture) {
      draw_on_screen(*algorithm, prepared, view, picture);
      picture.same_by_image = algorithm->same_by_image;
      if (auto reason = algorithm->why_not_seen(scene_.scene, view.camera)) {
        picture.problem = std::move(*reason);
        return;
      }
      auto seen = prepared.view(view.camera);
      if (!seen) {
        picture.problem = seen.error().message();
      } else {
        picture.lines = std::move(seen->picture);
      }
    });
  }

  // The real lines of a scene of cells: by a method that takes cells, of its own cells; by others, of its matter; by
  // a method without other lines, the edges of faces.
  void draw_matter(const registry::LineAlgorithm& algorithm) {
    const bool of_faces = algorithm.prepare_cells == nullptr && !algorithm.draws_crossings;
    const scene::PolyScene& scene = of_faces ? scene_.matter->with_box() : scene_.scene;
    if (auto reason = algorithm.why_not(scene)) return fail(*reason);
    auto made = algorithm.prepare_cells != nullptr ? algorithm.prepare_cells(scene::complex_of(*scene_.cells, scene)) : algorithm.prepare(scene);
    if (!made) return fail(made.error().message());
    for_each_view([&](const CrossCheckView& view, CrossCheckPicture& picture) {
      const geometry::Point& eye = view.camera.eye;
      auto seen = of_faces ? made->view(view.camera) : registry::view_of(*made, view.camera, scene_.matter->lines_at(eye));
      if (!seen) {
        picture.problem = seen.error().message();
        return;
      }
      picture.same_by_image = true;  // edges with different names may coincide
      picture.lines = of_faces ? scene_.matter->on_lines(seen->picture, eye) : std::move(seen->picture);
    });
  }

  void draw_jones() {
    for_each_view([&](const CrossCheckView& view, CrossCheckPicture& picture) {
      auto builds = who_.name == jones_twin_name ? jones_twins(scene_, view) : jones_on_pdp7(scene_, view, who_.name == jones_pdp7_name);
      if (builds)
        picture.builds = std::move(*builds);
      else
        picture.problem = builds.error().message();
    });
  }

  void draw_ink() {
    for_each_view([&](const CrossCheckView&, CrossCheckPicture& picture) {
      picture.ink = skala_pictures(*scene_.heights, program_view(scene_));
      for (const SkalaInk& ink : *picture.ink)
        if (picture.problem.empty() && !ink.difference.empty())
          picture.problem = fmt::format("{}: {}", name_of(ink), ink.difference);
    });
  }

  // Draws the lines again, at the angle of the machine that turns the scene.
  void draw_on_screen(const registry::LineAlgorithm& algorithm, const registry::PreparedScene& prepared, const CrossCheckView& view,
                      CrossCheckPicture& picture) {
    const TurnedView& turned = turned_.views[static_cast<std::size_t>(&view - scene_.views.data())];
    if (!turned.screen || algorithm.why_not_seen(scene_.scene, turned.screen->turn.camera)) return;
    auto seen = prepared.view(turned.screen->turn.camera);
    if (!seen) return;
    picture.lines_on_screen = turned_.turning->on_screen(seen->picture, turned.screen->turn.angle);
    picture.lines_at_angle = std::move(seen->picture);
  }

  void draw_screen() {
    for_each_view([&](const CrossCheckView& view, CrossCheckPicture& picture) {
      const TurnedView& turned = turned_.views[static_cast<std::size_t>(&view - scene_.views.data())];
      picture.problem = turned.problem;
      picture.screen = turned.screen;
    });
  }

  void draw_faces() {
    if (who_.name == oracle_name) {
      for_each_view([&](const CrossCheckView& view, CrossCheckPicture& picture) {
        picture.faces = nearest_faces(scene_, view);
      });
      return;
    }
    if (who_.name == stripes_name) {
      for_each_view([&](const CrossCheckView& view, CrossCheckPicture& picture) {
        auto drawn = stripes_faces(scene_.scene, view.camera, view.window());
        if (!drawn)
          picture.problem = drawn.error().message();
        else if (!drawn->difference.empty())
          picture.problem = drawn->difference;
        else
          picture.faces = std::move(drawn->faces);
      });
      return;
    }
    if (const auto* const heights = registry::find_height_algorithm(who_.name)) {
      if (!scene_.heights) return fail("draws functions of two variables only");
      for_each_view([&](const CrossCheckView& view, CrossCheckPicture& picture) {
        picture.faces = surface_faces(*heights, scene_, view);
      });
      return;
    }
    const registry::FaceAlgorithm* const algorithm =
        who_.name == willis_on_8080().name ? &willis_on_8080() : find_in(tables_.faces, who_.name);
    if (algorithm == nullptr) return fail("no such algorithm in the registry of faces");
    registry::FaceOptions options;
    options.plan = scene_.plan;
    auto made = algorithm->prepare(scene_.scene, options);
    if (!made) return fail(made.error().message());
    const auto& prepared = *made;
    if (!prepared.not_solved.empty())
      return fail(
          fmt::format("not solved, {} pairs: {}", prepared.not_solved.size(), prepared.not_solved[0]));
    for_each_view([&](const CrossCheckView& view, CrossCheckPicture& picture) {
      auto seen = prepared.view(view.camera, view.window());
      if (!seen) {
        picture.problem = seen.error().message();
      } else {
        picture.faces = std::move(seen->faces);
      }
    });
  }

  const CommonScene& scene_;
  const Participant& who_;
  const CrossCheckTables& tables_;
  const TurnedViews& turned_;
  std::vector<CrossCheckPicture> pictures_;
};

// All comparisons of two participants for one view.
std::vector<ViewVerdict> verdicts(const CommonScene& scene, const CrossCheckView& view, const Participant& a,
                                  const CrossCheckPicture& of_a, const Participant& b,
                                  const CrossCheckPicture& of_b) {
  const auto lines = [](const Participant& who, const CrossCheckPicture& picture) {
    return NamedLines{who.name, &*picture.lines, picture.same_by_image};
  };
  const auto faces = [](const Participant& who, const CrossCheckPicture& picture) {
    return NamedFaces{who.name, &*picture.faces};
  };
  if (a.jones && b.jones) return {compare_pictures(NamedJones{a.name, &*of_a.builds}, NamedJones{b.name, &*of_b.builds})};
  if (a.jones) return {compare_pictures(scene, view, NamedJones{a.name, &*of_a.builds}, lines(b, of_b))};
  if (b.jones) return {compare_pictures(scene, view, NamedJones{b.name, &*of_b.builds}, lines(a, of_a))};
  if (a.ink || b.ink) {
    const NamedInk ink = a.ink ? NamedInk{a.name, &*of_a.ink} : NamedInk{b.name, &*of_b.ink};
    return {(a.ink ? b : a).name == oracle_name ? compare_with_oracle(scene, ink) : compare_with_native(scene, ink)};
  }
  if (a.screen || b.screen) {
    const NamedScreen screen = a.screen ? NamedScreen{a.name, &*of_a.screen} : NamedScreen{b.name, &*of_b.screen};
    const Participant& other = a.screen ? b : a;
    const CrossCheckPicture& of_other = a.screen ? of_b : of_a;
    if (!other.lines) return {compare_pictures(screen, faces(other, of_other))};
    if (!of_other.lines_at_angle) return {{false, "points", fmt::format("{} has no picture at the angle of the machine", other.name)}};
    return {compare_pictures(screen, {{other.name, &*of_other.lines_at_angle, of_other.same_by_image}, &of_other.lines_on_screen})};
  }
  std::vector<ViewVerdict> all;
  if (a.lines && b.lines) all.push_back(compare_pictures(scene, view, lines(a, of_a), lines(b, of_b)));
  if (a.faces && b.faces && !scene.matter) all.push_back(compare_pictures(scene, view, faces(a, of_a), faces(b, of_b)));
  if (!all.empty()) return all;
  all.push_back(a.lines ? compare_pictures(scene, view, lines(a, of_a), faces(b, of_b))
                        : compare_pictures(scene, view, lines(b, of_b), faces(a, of_a)));
  return all;
}

// No participant has faces of scenes of cells.
bool is_complete(const CommonScene& scene, const Participant& who, const CrossCheckPicture& picture) {
  return picture.problem.empty() && (!who.lines || picture.lines) && (!who.faces || scene.matter || picture.faces) &&
         (!who.screen || picture.screen) && (!who.jones || picture.builds) && (!who.ink || picture.ink);
}

CrossCheckCell compare_pair(const CommonScene& scene, const Participant& a,
                            const std::vector<CrossCheckPicture>& of_a, const Participant& b,
                            const std::vector<CrossCheckPicture>& of_b) {
  CrossCheckCell cell{a.name, b.name, CrossCheckState::not_applicable, 0, {}, {}, {}};
  const auto add = [&cell](std::size_t view, const std::string& text) {
    cell.text += fmt::format("{}view {}: {}", cell.text.empty() ? "" : "; ", view + 1, text);
  };
  if (const auto reason = why_incomparable(a.name, b.name)) {
    cell.text = *reason;
    return cell;
  }
  std::vector<std::string_view> ways;
  for (std::size_t v = 0; v < scene.views.size(); ++v) {
    if (!of_a[v].not_applicable.empty() || !of_b[v].not_applicable.empty()) continue;
    if (!is_complete(scene, a, of_a[v]) || !is_complete(scene, b, of_b[v])) {
      const bool first = !is_complete(scene, a, of_a[v]);
      const std::string& problem = (first ? of_a : of_b)[v].problem;
      cell.state = CrossCheckState::not_run;
      cell.text = fmt::format("view {}: {}: {}", v + 1, first ? a.name : b.name, problem);
      return cell;
    }
    for (const ViewVerdict& verdict : verdicts(scene, scene.views[v], a, of_a[v], b, of_b[v])) {
      if (std::find(ways.begin(), ways.end(), verdict.how) == ways.end()) ways.push_back(verdict.how);
      for (const MachineDistance& distance : verdict.distances) cell.distances.push_back({distance, v});
      if (!verdict.agrees) {
        cell.state = CrossCheckState::differs;
        cell.text = fmt::format("view {}: {}", v + 1, verdict.text);
        return cell;
      }
      add(v, verdict.text);
    }
    cell.state = CrossCheckState::agrees;
    ++cell.views;
  }
  if (std::find(ways.begin(), ways.end(), "image") != ways.end()) std::erase(ways, "pieces");
  cell.how = base::joined(ways, ", ");
  if (cell.state != CrossCheckState::not_applicable) return cell;
  const auto& [who, pictures] = of_a[0].not_applicable.empty() ? std::pair{&b, &of_b} : std::pair{&a, &of_a};
  cell.text = fmt::format("{} {}", who->name, pictures->front().not_applicable);
  return cell;
}

}  // namespace

std::span<const Participant> participants() {
  static const std::vector<Participant> found = find_participants();
  return found;
}

std::span<const NotApplicable> not_applicable() {
  return all_not_applicable;
}

std::optional<std::string_view> listed_reason(std::string_view who, std::string_view scene,
                                              bool perspective) {
  for (const NotApplicable& listed : all_not_applicable)
    if (listed.who == who && scene.starts_with(listed.scenes) &&
        (listed.views == NotApplicable::Views::all || perspective))
      return listed.reason;
  return std::nullopt;
}

std::optional<std::string_view> why_incomparable(std::string_view a, std::string_view b) {
  if (a != skala_8080_name && b != skala_8080_name) return std::nullopt;
  const std::string_view other = a == skala_8080_name ? b : a;
  if (other == oracle_name || registry::find_height_algorithm(other) != nullptr) return std::nullopt;
  return "skala-8080 draws slices, the other one the triangles between them, which extend beyond the slices";
}

std::size_t listed_cells(const CommonScene& scene) {
  std::size_t cells = 0;
  for (const Participant& a : participants()) {
    for (const Participant& b : participants()) {
      if (&a >= &b || why_incomparable(a.name, b.name)) continue;
      cells += std::any_of(scene.views.begin(), scene.views.end(), [&](const CrossCheckView& view) {
        return !listed_reason(a.name, scene.name, view.camera.perspective) &&
               !listed_reason(b.name, scene.name, view.camera.perspective);
      });
    }
  }
  return cells;
}

bool SceneCrossCheck::agrees() const {
  return std::all_of(cells.begin(), cells.end(), [](const CrossCheckCell& cell) {
    return cell.state == CrossCheckState::agrees || cell.state == CrossCheckState::not_applicable;
  });
}

SceneCrossCheck cross_check(const CommonScene& scene, const CrossCheckTables& tables,
                            const std::function<void(std::string_view)>& progress) {
  SceneCrossCheck agreement;
  const std::span<const Participant> all = participants();
  progress(fmt::format("{} ({}): {}", scene.name, scene.title, turn_name));
  const TurnedViews turned = turned_views(scene);
  for (const Participant& who : all) {
    progress(fmt::format("{} ({}): {}", scene.name, scene.title, who.name));
    agreement.pictures.push_back(Drawing(scene, who, tables, turned).take());
  }
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = a + 1; b < all.size(); ++b)
      agreement.cells.push_back(
          compare_pair(scene, all[a], agreement.pictures[a], all[b], agreement.pictures[b]));
  return agreement;
}

}  // namespace sightline::compare
