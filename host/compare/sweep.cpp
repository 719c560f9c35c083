// See sweep.hpp.
#include "host/compare/sweep.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/compare/piece_difference.hpp"
#include "host/compare/stripes.hpp"
#include "host/compare/sweep_views.hpp"

namespace sightline::compare {
namespace {

using base::Json;

// FNV-1a over the scene's data that methods use, to detect a changed file.
class Fingerprint {
 public:
  void add(std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte, value >>= 8) hash_ = (hash_ ^ (value & 0xffU)) * 0x100000001b3U;
  }
  [[nodiscard]] std::string text() const {
    char digits[17];
    static_cast<void>(std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_)));
    return digits;
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

std::string fingerprint_of(const scene::PolyScene& scene) {
  Fingerprint print;
  const auto add_ring = [&print](std::span<const scene::VertexIndex> ring) {
    print.add(ring.size());
    for (const scene::VertexIndex v : ring) print.add(v);
  };
  print.add(scene.vertices.size());
  for (const scene::PolyPoint& p : scene.vertices)
    for (const std::int32_t c : p) print.add(static_cast<std::uint32_t>(c));
  for (const scene::PolyBody& body : scene.bodies) {
    print.add(body.faces.size());
    print.add(body.sheet ? 1 : 0);
    for (const scene::PolyFace& face : body.faces) {
      add_ring(face.outline);
      print.add(face.holes.size());
      for (const auto& hole : face.holes) add_ring(hole);
    }
  }
  return print.text();
}

std::string fingerprint_of(const scene::HeightGrid& grid) {
  Fingerprint print;
  for (const std::vector<double>* const numbers : {&grid.x, &grid.z, &grid.heights}) {
    print.add(numbers->size());
    for (const double number : *numbers) print.add(std::bit_cast<std::uint64_t>(number));
  }
  for (const double number : {grid.range.low, grid.range.high}) print.add(std::bit_cast<std::uint64_t>(number));
  return print.text();
}

std::string text_of(const geometry::Rational& r) {
  return std::to_string(r.numerator()) + "/" + std::to_string(r.denominator());
}

Json json_of(const PieceDifference& difference) {
  Json document{{"missing_pieces", difference.missing}, {"extra_pieces", difference.extra}};
  if (!difference.first) return document;
  document["first"] = {{"edge", Json::array({difference.first->edge.from, difference.first->edge.to})},
                       {"low", text_of(difference.first->low)},
                       {"high", text_of(difference.first->high)},
                       {"is", difference.first_is_missing ? "missing" : "extra"}};
  return document;
}

template <class Counts>
Json counts_of(const Counts& counts) {
  Json document = Json::object();
  for (const auto& count : counts) document[std::string(count.name)] = count.value;
  return document;
}

// The properties of a line picture that the measures do not contain.
void add_lines(const ComparedPicture& row, Json& result) {
  if (row.pieces) {
    result["pieces"] = *row.pieces;
    result["visible_length"] = row.visible_length;
  }
  if (row.piece_difference) result["difference"] = json_of(*row.piece_difference);
  if (!row.counts.empty()) result["counts"] = counts_of(row.counts);
}

// A method that also draws faces has two results, so the second needs another name.
std::string unused_name(const Json& results, const std::string& method) {
  return results.find(method) == nullptr ? method : method + " faces";
}

bool is_asked(const SweepOptions& options, std::string_view method) {
  return std::find(options.methods.begin(), options.methods.end(), method) != options.methods.end();
}

// The names of method_names() that are in one of the two lists.
std::vector<std::string> union_of(const std::vector<std::string>& methods, const std::vector<std::string>& added) {
  std::vector<std::string> both;
  for (const std::string& name : method_names())
    for (const std::vector<std::string>* const list : {&methods, &added})
      if (std::find(list->begin(), list->end(), name) != list->end() && (both.empty() || both.back() != name)) both.push_back(name);
  return both;
}

base::Error does_not_apply(const std::string& source, const std::string& method, const std::string& reason) {
  return {source, "", method + " does not apply: " + reason};
}

}  // namespace

SweepShard sweep_shard(std::uint64_t views, std::uint64_t number, std::uint64_t count) {
  // views and count are below 2^32: no product overflows.
  return {views * (number - 1) / count, views * number / count};
}

base::Result<Sweep> Sweep::of(const std::string& source, const scene::PolyScene& scene, const scene::CellScene* cells,
                              const SweepOptions& options) {
  Sweep sweep;
  sweep.source_ = source;
  sweep.fingerprint_ = fingerprint_of(scene);
  sweep.scene_ = &scene;
  sweep.cells_ = cells;
  sweep.options_ = options;
  std::vector<std::string> added;
  if (options.all_lines)
    for (const registry::LineAlgorithm& algorithm : registry::line_algorithms()) added.emplace_back(algorithm.name);
  if (options.faces)
    for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms()) added.emplace_back(algorithm.name);
  sweep.options_.methods = union_of(options.methods, added);
  const bool as_cells = cells != nullptr && options.directions == Directions::usual;
  for (const std::string& method : options.methods)
    if (const auto reason = why_not_applicable(method, as_cells ? SceneKind::cells : SceneKind::polyhedra)) return does_not_apply(source, method, *reason);
  CompareOptions compared;
  compared.eae = options.eae;
  compared.methods = sweep.options_.methods;
  compared.faces = sweep.compares_faces();
  compared.host_times = options.time;
  compared.host_seconds = 0;
  compared.truth_by_exact = !options.oracle;
  compared.for_table = true;
  auto methods = as_cells ? SceneMethods::of(*cells, compared) : SceneMethods::of(scene, compared);
  if (!methods) return base::Error{source, methods.error().place, methods.error().found};
  for (const auto& [method, reason] : methods->not_applicable()) {
    if (std::find(options.methods.begin(), options.methods.end(), method) != options.methods.end())
      return does_not_apply(source, method, reason);
    std::erase(sweep.options_.methods, method);
  }
  sweep.truth_ = as_cells ? "oracle of cells" : options.oracle ? "oracle of edges" : "exact";
  sweep.methods_ = std::make_shared<const SceneMethods>(std::move(*methods));
  return sweep;
}

base::Result<Sweep> Sweep::of(const std::string& source, scene::HeightGrid grid, const algorithms::skala::View& view,
                              const SweepOptions& options) {
  Sweep sweep;
  sweep.source_ = source;
  sweep.fingerprint_ = fingerprint_of(grid);
  sweep.truth_ = "unrounded lines between the samples";
  sweep.options_ = options;
  for (const std::string& method : options.methods)
    if (const auto reason = why_not_applicable(method, SceneKind::function)) return does_not_apply(source, method, *reason);
  if (options.oracle) return does_not_apply(source, "oracle", "it is the reference for scenes of polyhedra");
  if (options.all_lines) sweep.options_.methods = union_of(options.methods, {"skala-8080", "skala-twin", "skala"});
  sweep.view_ = view;
  sweep.grid_ = std::make_shared<const scene::HeightGrid>(std::move(grid));
  return sweep;
}

bool Sweep::compares_faces() const {
  const auto draws_faces_only = [](const std::string& method) { return method.starts_with("willis") || method == stripes_name; };
  return options_.faces || std::any_of(options_.methods.begin(), options_.methods.end(), draws_faces_only);
}

scene::PolyCamera Sweep::camera(std::uint64_t number) const {
  return random_camera(*scene_, cells_, options_.directions, options_.seed, number);
}

algorithms::skala::View Sweep::height_view(std::uint64_t number) const {
  return random_height_view(*grid_, view_, options_.seed, number);
}

std::string Sweep::head(std::uint64_t number) const {
  Json methods = Json::array();
  for (const std::string& method : options_.methods) methods.push_back(method);
  Json document{{"schema", "sightline/sweep/2"}, {"scene", source_}, {"fingerprint", fingerprint_},
                {"seed", options_.seed},         {"view", number},   {"methods", methods},
                {"truth", truth_}};
  if (compares_faces()) document["faces"] = true;
  if (is_asked(options_, jones_pdp7_name) || is_asked(options_, jones_twin_name)) document["eae"] = options_.eae;
  if (options_.directions != Directions::usual) document["directions"] = options_.directions == Directions::all ? "all" : "level";
  if (grid_) {
    const algorithms::skala::View view = height_view(number);
    document["angles"] = {{"rotate", view.rotation}, {"elevate", view.elevation}};
  } else {
    const scene::PolyCamera seen = camera(number);
    document["camera"] = {{"perspective", seen.perspective},
                          {"eye", seen.eye},
                          {"forward", seen.forward},
                          {"right", seen.right},
                          {"up", seen.up}};
  }
  std::string text = document.dump();
  text.pop_back();
  return text + ",\"results\":";
}

Json Sweep::scene_results(std::uint64_t number) const {
  Json results = Json::object();
  const auto comparison = methods_->view(camera(number));
  if (!comparison) {
    results["error"] = comparison.error().message();
    return results;
  }
  for (const MethodView& view : method_views(*comparison)) {
    Json& result = results[unused_name(results, view.method)];
    result = compare::json_of(view);
    if (view.picture != "lines") continue;
    const auto row = std::find_if(comparison->pictures.begin(), comparison->pictures.end(),
                                  [&](const ComparedPicture& picture) { return picture.name == view.method; });
    if (row != comparison->pictures.end()) add_lines(*row, result);
  }
  for (const auto& [method, reason] : comparison->not_applicable)
    if (is_asked(options_, method)) results[unused_name(results, method)] = {{"not_applicable", reason}};
  // If the display file differs from the twin's, there are no lines to measure; that is a defect.
  if (comparison->guest && !comparison->guest->difference.empty())
    for (const std::string_view method : {jones_pdp7_name, jones_twin_name})
      if (is_asked(options_, method)) results[std::string(method)]["defect"] = comparison->guest->difference;
  return results;
}

Json Sweep::height_results(std::uint64_t number) const {
  Json results = Json::object();
  HeightComparison comparison = compare_heights(*grid_, height_view(number), [](std::string_view) {}, {}, options_.time);
  comparison.devices = compare_devices(*grid_, height_view(number), [](std::string_view) {}, true);
  for (const MethodView& view : method_views(comparison))
    if (is_asked(options_, view.method)) results[view.method] = compare::json_of(view);
  return results;
}

std::string Sweep::line(std::uint64_t number) const {
  return head(number) + (grid_ ? height_results(number) : scene_results(number)).dump() + "}\n";
}

bool Sweep::is_line(std::uint64_t number, std::string_view text) const {
  return text.starts_with(head(number)) && text.ends_with("}}\n");
}

bool SweepTable::add(std::string_view line) {
  const auto document = base::parse_json(line, "line");
  if (!document) return false;
  const Json* const scene = document->find("scene");
  const Json* const number = document->find("view");
  const Json* const results = document->find("results");
  if (scene == nullptr || scene->text() == nullptr || number == nullptr || !number->integer() || results == nullptr) return false;
  bool differs = false;
  std::vector<MethodView> views;
  for (const base::JsonMember& member : results->members()) {
    if (const std::string* const error = member.value.text()) {
      leave_out("", *error);
      differs = true;
    } else if (const Json* const reason = member.value.find("not_applicable"); reason != nullptr && reason->text() != nullptr) {
      leave_out(member.key, *reason->text());
      differs = differs || member.value.find("defect") != nullptr;
    } else if (auto view = method_view_of(member.value)) {
      differs = differs || !view->defect.empty() || view->exact == false;
      views.push_back(std::move(*view));
    }
  }
  answer_.add(*scene->text(), static_cast<std::uint64_t>(*number->integer()), views);
  if (differs) ++differing_;
  return true;
}

void SweepTable::leave_out(const std::string& method, const std::string& reason) {
  for (LeftOut& known : left_out_)
    if (known.method == method) {
      ++known.views;
      return;
    }
  left_out_.push_back({method, 1, reason});
}

}  // namespace sightline::compare
