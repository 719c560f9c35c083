#include "host/algorithms/willis/model.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "host/algorithms/willis/cut.hpp"
#include "host/algorithms/willis/distance.hpp"
#include "host/algorithms/willis/near_pairs.hpp"
#include "host/algorithms/willis/surfaces.hpp"
#include "host/algorithms/willis/trace.hpp"
#include "host/base/result.hpp"

namespace sightline::algorithms::willis {

namespace {

// Cuts clusters until there are none. A piece of a surface that is in no cluster is in no cluster either, because its
// boundary is within that of the whole surface. Therefore only the pieces of clusters are tested again.
class Unclustering {
 public:
  Unclustering(Model& model, const ModelOptions& options, Trace* trace) : model_(model), options_(options), trace_(trace) {
    const auto least = static_cast<std::uint64_t>(options.limits.smallest) * lattice_unit;
    squared_smallest_ = least * least;
  }

  void run() {
    find_pairs();
    model_.clusters = pairs_.size();
    if (trace_ != nullptr) trace_->clusters(model_.pieces, pairs_);
    while (model_.tests <= options_.limits.tests && cut_once()) {
      take_pairs_over();
      if (trace_ != nullptr) trace_->clusters(model_.pieces, pairs_);
    }
    for (const auto& [a, b] : pairs_) model_.residual.push_back({a, b, reason_of(a, b)});
  }

 private:
  void find_pairs() {
    std::vector<ReachingBox> boxes;
    boxes.reserve(model_.pieces.size());
    for (const Surface& s : model_.pieces) boxes.push_back(box_of(s));
    for (const auto& [a, b] : near_pairs(boxes))
      if (is_cluster(a, b)) pairs_.emplace_back(a, b);
  }

  [[nodiscard]] bool is_cluster(std::uint32_t a, std::uint32_t b) {
    const Surface& s = model_.pieces[a];
    const Surface& t = model_.pieces[b];
    if (s.cell != t.cell || s.face == t.face) return false;
    const PairRules& rules = options_.rules;
    if (!can_obscure(s, t, rules.rule90) && !can_obscure(t, s, rules.rule90)) return false;
    ++model_.tests;
    return reach_each_other(s, t, rules.shape);
  }

  [[nodiscard]] std::uint32_t larger(std::uint32_t a, std::uint32_t b) const {
    const std::uint64_t da = squared_diameter(model_.pieces[a].points);
    const std::uint64_t db = squared_diameter(model_.pieces[b].points);
    if (da != db) return da > db ? a : b;
    return std::min(a, b);
  }

  // Why the larger surface of a pair cannot be cut; nullopt if it can.
  [[nodiscard]] std::optional<ResidualReason> obstacle(std::uint32_t a, std::uint32_t b) const {
    const Surface& s = model_.pieces[larger(a, b)];
    const Limits& limits = options_.limits;
    if (s.depth >= limits.touching_depth && touching_[larger(a, b)] != 0) return ResidualReason::touching;
    if (s.depth >= limits.depth) return ResidualReason::depth;
    if (squared_diameter(s.points) <= squared_smallest_) return ResidualReason::size;
    return std::nullopt;
  }

  [[nodiscard]] ResidualReason reason_of(std::uint32_t a, std::uint32_t b) const {
    if (const auto reason = obstacle(a, b)) return *reason;
    return halve(model_.pieces[larger(a, b)]) ? ResidualReason::pieces : ResidualReason::lattice;
  }

  // Where two surfaces touch, cutting one would make the other the larger, and so on without end.
  void mark_touching() {
    touching_.assign(model_.pieces.size(), 0);
    for (const auto& [a, b] : pairs_)
      if (meet(model_.pieces[a], model_.pieces[b])) touching_[a] = touching_[b] = 1;
  }

  // Cuts every surface that must be cut. Returns false if there is nothing to cut, or no space.
  bool cut_once() {
    mark_touching();
    std::vector<std::uint32_t> marked;
    for (const auto& [a, b] : pairs_)
      if (!obstacle(a, b)) marked.push_back(larger(a, b));
    std::sort(marked.begin(), marked.end());
    marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
    halves_.resize(model_.pieces.size());
    for (std::uint32_t i = 0; i < halves_.size(); ++i) halves_[i] = {i, i};
    bool any = false;
    for (const std::uint32_t piece : marked) {
      if (model_.pieces.size() >= options_.limits.pieces) break;
      auto halves = halve(model_.pieces[piece]);
      if (!halves) continue;
      any = true;
      if (trace_ != nullptr) trace_->cut(piece, *halves, static_cast<std::uint32_t>(model_.pieces.size()));
      halves_[piece][1] = static_cast<std::uint32_t>(model_.pieces.size());
      model_.pieces[piece] = std::move((*halves)[0]);
      model_.pieces.push_back(std::move((*halves)[1]));
    }
    return any;
  }

  [[nodiscard]] std::span<const std::uint32_t> halves_of(std::uint32_t piece) const {
    return {halves_[piece].data(), halves_[piece][1] != piece ? std::size_t{2} : std::size_t{1}};
  }

  void take_pairs_over() {
    std::vector<NumberPair> next;
    for (const auto& [a, b] : pairs_) {
      for (const std::uint32_t p : halves_of(a))
        for (const std::uint32_t q : halves_of(b))
          if (is_cluster(p, q)) next.emplace_back(std::min(p, q), std::max(p, q));
    }
    pairs_ = std::move(next);
  }

  Model& model_;
  const ModelOptions& options_;
  Trace* trace_;
  std::uint64_t squared_smallest_ = 0;
  std::vector<NumberPair> pairs_;
  std::vector<std::uint8_t> touching_;                // by piece: 1 if it touches its partner in a cluster
  std::vector<std::array<std::uint32_t, 2>> halves_;  // by piece: its halves if it was just cut, otherwise the piece twice
};

std::string face_name(const scene::PolyScene& scene, const FacePlace& place) {
  const scene::PolyBody& body = scene.bodies[place.body];
  std::string name = "body " + std::to_string(place.body);
  if (!body.name.empty()) name += " (" + body.name + ")";
  return name + " face " + std::to_string(place.face);
}

}  // namespace

std::string_view name_of(ResidualReason reason) {
  switch (reason) {
    case ResidualReason::depth: return "the limit of depth";
    case ResidualReason::size: return "the smallest size";
    case ResidualReason::pieces: return "the limit of pieces";
    case ResidualReason::lattice: return "the lattice";
    case ResidualReason::touching: return "they touch";
  }
  return "";
}

Model make_model(std::vector<Surface> surfaces, const ModelOptions& options, Trace* trace) {
  Model model;
  model.plan = options.plan;
  model.vertical = options.vertical;
  model.surfaces = surfaces.size();
  model.pieces = std::move(surfaces);
  if (options.order_cells) model.cells = make_order_cells(model.pieces, options.limits.pieces);
  if (trace != nullptr) trace->surfaces(model.pieces, model.cells);
  Unclustering(model, options, trace).run();
  return model;
}

base::Result<Model> make_model(const scene::PolyScene& scene, const ModelOptions& options, Trace* trace) {
  auto surfaces = options.plan ? walls_of(scene, options.vertical) : surfaces_of(scene);
  if (!surfaces) return std::move(surfaces.error());
  Model model = make_model(std::move(*surfaces), options, trace);
  if (model.tests > options.limits.tests)
    return base::Error{.found = "found " + std::to_string(model.tests) + " pairs of " + std::to_string(model.pieces.size()) + " pieces to be separated by cuts",
                       .expected = "at most " + std::to_string(options.limits.tests) + " pairs"};
  return model;
}

std::vector<std::string> residual_lines(const Model& model, const scene::PolyScene& scene) {
  const std::vector<FacePlace> places = face_places(scene);
  std::vector<std::tuple<std::uint32_t, std::uint32_t, ResidualReason>> faces;
  for (const Residual& pair : model.residual) {
    const std::uint32_t a = model.pieces[pair.first].face;
    const std::uint32_t b = model.pieces[pair.second].face;
    faces.emplace_back(std::min(a, b), std::max(a, b), pair.reason);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::vector<std::string> lines;
  for (const auto& [a, b, reason] : faces) {
    lines.push_back(face_name(scene, places[a]) + " and " + face_name(scene, places[b]) +
                    " could not be separated: " + std::string(name_of(reason)));
  }
  return lines;
}

}  // namespace sightline::algorithms::willis
