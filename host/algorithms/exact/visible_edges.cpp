#include "host/algorithms/exact/visible_edges.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "host/algorithms/exact/face_shadow.hpp"
#include "host/algorithms/exact/image_grid.hpp"
#include "host/algorithms/exact/view.hpp"
#include "host/algorithms/exact/witnesses.hpp"
#include "host/base/threads.hpp"

namespace sightline::algorithms::exact {
namespace {

// The listener of a search without a trace: its calls compile to nothing.
struct NoListener {
  template <class Shadow>
  void attach(Shadow&) {}
  template <class Shadow>
  void edge(const picture::LineEdge&, const Shadow&) {}
  template <class Shadow>
  void compared(const picture::LineEdge&, const Occluder&, bool, const Shadow&) {}
  template <class Shadow>
  void searched(const picture::LineEdge&, const Shadow&) {}
  void result(const picture::LineEdge&, bool, std::span<const picture::LinePiece>) {}
};

// Reports to a Trace what is visible of an edge after each comparison.
class TraceListener : public NoListener {
 public:
  explicit TraceListener(Trace& trace) : trace_(trace) {}

  template <class Shadow>
  void edge(const picture::LineEdge& edge, const Shadow&) {
    trace_.edge(edge);
  }
  template <class Shadow>
  void compared(const picture::LineEdge& edge, const Occluder& occluder, bool hidden, const Shadow& shadow) {
    std::vector<picture::LinePiece> left;
    if (!hidden) shadow.append_visible(left);
    trace_.compared(edge, occluder.face, left);
  }
  void result(const picture::LineEdge& edge, bool drawn, std::span<const picture::LinePiece> pieces) {
    trace_.result(edge, drawn, pieces);
  }

 private:
  Trace& trace_;
};

// Collects witnesses from the log of each edge.
class ProofListener : public NoListener {
 public:
  template <class Shadow>
  void attach(Shadow& shadow) {
    shadow.keep_log();
  }
  template <class Shadow>
  void edge(const picture::LineEdge&, const Shadow& shadow) {
    faces_.assign(shadow.log().size(), Witness::behind_eye);
  }
  template <class Shadow>
  void compared(const picture::LineEdge&, const Occluder& occluder, bool, const Shadow& shadow) {
    faces_.resize(shadow.log().size(), occluder.face);
  }
  template <class Shadow>
  void searched(const picture::LineEdge&, const Shadow& shadow) {
    const auto& log = shadow.log();
    const bool split = std::any_of(log.begin(), log.end(), [](const auto& entry) { return entry.left != entry.right; });
    proof_.reason = EdgeProof::Reason::witnesses;
    proof_.left = chain(shadow, true, false);
    proof_.right = split ? chain(shadow, false, true) : proof_.left;
  }

  // Call begin(), then search an edge; the result is valid until the next begin().
  void begin(const picture::LineEdge& edge) {
    proof_ = {.edge = edge, .reason = EdgeProof::Reason::point, .left = {}, .right = {}};
  }
  [[nodiscard]] EdgeProof& proof() { return proof_; }

 private:
  // The fewest entries of the log, for one side, that cover what is hidden.
  template <class Shadow>
  [[nodiscard]] std::vector<Witness> chain(const Shadow& shadow, bool left, bool right) {
    const auto& log = shadow.log();
    order_.clear();
    for (std::uint32_t i = 0; i < log.size(); ++i)
      if (((log[i].left && left) || (log[i].right && right)) && less(log[i].interval.low, log[i].interval.high)) order_.push_back(i);
    const auto low = [&](std::size_t i) -> const auto& { return log[order_[i]].interval.low; };
    std::stable_sort(order_.begin(), order_.end(),
                     [&log](std::uint32_t a, std::uint32_t b) { return less(log[a].interval.low, log[b].interval.low); });
    std::vector<Witness> witnesses;
    for (std::size_t next = 0; next < order_.size();) {
      // An interval that begins where nothing is hidden, then those that reach farthest of all that begin in or at the
      // end of what is covered.
      auto reach = low(next);
      for (bool longer = true; longer;) {
        longer = false;
        std::uint32_t farthest = 0;
        auto end = reach;
        for (; next < order_.size() && !less(reach, low(next)); ++next) {
          if (!less(end, log[order_[next]].interval.high)) continue;
          longer = true;
          farthest = order_[next];
          end = log[farthest].interval.high;
        }
        if (!longer) break;
        const Witness witness{shadow.place(log[farthest].interval.low), shadow.place(end), faces_[farthest]};
        if (witness.low < witness.high) witnesses.push_back(witness);
        reach = end;
      }
    }
    return witnesses;
  }

  EdgeProof proof_;
  std::vector<std::uint32_t> faces_;  // by entry of the log
  std::vector<std::uint32_t> order_;  // of the log's entries
};

// Compares edges, one after the other, with the occluders near them.
template <class Listener>
class Search {
 public:
  Search(const View& view, const ImageGrid& grid, const picture::ChosenEdges* chosen, Listener& listener)
      : view_(view), grid_(grid), shadow_(view), line_shadow_(view), chosen_(chosen), listener_(listener) {
    listener_.attach(shadow_);
    listener_.attach(line_shadow_);
  }

  void append_visible(std::uint32_t number, std::vector<picture::LinePiece>& pieces) {
    if (number < view_.first_line) append_visible(number, shadow_, pieces);
    else append_visible(number, line_shadow_, pieces);
  }

  // Tells the listener what hides an edge, drawn or not.
  void find_witnesses(std::uint32_t number) {
    if (number < view_.first_line) find_witnesses(number, shadow_);
    else find_witnesses(number, line_shadow_);
  }

 private:
  template <class Shadow>
  void find_witnesses(std::uint32_t number, Shadow& shadow) {
    if (!shadow.begin(number)) return;
    const picture::LineEdge& edge = view_.edges[number];
    listener_.edge(edge, shadow);
    static_cast<void>(is_hidden(number, shadow));
    listener_.searched(edge, shadow);
  }

  template <class Shadow>
  void append_visible(std::uint32_t number, Shadow& shadow, std::vector<picture::LinePiece>& pieces) {
    const picture::LineEdge& edge = view_.edges[number];
    const std::size_t before = pieces.size();
    const bool searched = view_.drawn[number] != 0 && shadow.begin(number);
    if (searched) {
      listener_.edge(edge, shadow);
      if (!is_hidden(number, shadow)) shadow.append_visible(pieces);
      listener_.searched(edge, shadow);
    }
    listener_.result(edge, searched, std::span(pieces).subspan(before));
  }

  template <class Shadow>
  bool is_hidden(std::uint32_t number, Shadow& shadow) {
    const picture::LineEdge& edge = view_.edges[number];
    std::span<const std::uint32_t> beside;  // surfaces whose faces do not hide the edge
    if (chosen_ != nullptr) beside = chosen_->surfaces_at(number);
    const std::uint32_t depth = std::max(view_.points[edge.from].depth, view_.points[edge.to].depth);
    const ImageBounds bounds = view_.bounds_of(number);
    if (may_hide_all(last_, bounds, depth) && hides_rest(edge, last_, beside, shadow)) return true;
    const std::uint32_t limit = grid_.count_up_to(depth);
    ImageGrid::Query query(grid_, bounds);
    const ImageGrid::Cells cells = query.cells();
    near_count_ = 0;
    for (std::uint32_t row = cells.low[1]; row <= cells.high[1]; ++row) {
      for (std::uint32_t column = cells.low[0]; column <= cells.high[0]; ++column) {
        query.enter(column, row);
        const ImageGrid::Entries entries = grid_.entries_at(column, row);
        for (std::size_t begin = 0; begin < entries.size(); begin += batch) {
          const std::size_t end = std::min(begin + batch, entries.size());
          find_near(query, entries, begin, end, limit);
          if (near_count_ >= enough && is_hidden_by_near(edge, beside, shadow)) return true;
          if (entries.ranks[end - 1] >= limit) break;
        }
      }
    }
    return is_hidden_by_near(edge, beside, shadow);
  }

  // Adds to near_ those of at most `batch` entries that are of ranks below `limit` and may hide part of the edge. The
  // result is unpredictable, so no branch depends on it.
  void find_near(const ImageGrid::Query& query, const ImageGrid::Entries& entries, std::size_t begin, std::size_t end,
                 std::uint32_t limit) {
    std::size_t count = near_count_;
    for (std::size_t i = begin; i < end; ++i) {
      near_[count] = entries.ranks[i];
      count += static_cast<std::size_t>(query.passes(entries.bounds[i])) & static_cast<std::size_t>(entries.ranks[i] < limit);
    }
    near_count_ = count;
  }

  template <class Shadow>
  bool is_hidden_by_near(const picture::LineEdge& edge, std::span<const std::uint32_t> beside, Shadow& shadow) {
    const std::size_t count = near_count_;
    near_count_ = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (hides_rest(edge, grid_.occluder(near_[i]), beside, shadow)) return true;
    return false;
  }

  [[nodiscard]] bool may_hide_all(std::uint32_t number, const ImageBounds& bounds, std::uint32_t depth) const {
    if (number == no_occluder) return false;
    const ImageBounds& cover = view_.occluder_bounds[number];
    return view_.occluder_depths[number] <= depth && cover.low[0] <= bounds.low[0] && cover.low[1] <= bounds.low[1] &&
           bounds.high[0] <= cover.high[0] && bounds.high[1] <= cover.high[1];
  }

  // Adds what an occluder hides. Returns true once the whole edge is hidden.
  template <class Shadow>
  bool hides_rest(const picture::LineEdge& edge, std::uint32_t number, std::span<const std::uint32_t> beside, Shadow& shadow) {
    const Occluder& occluder = view_.occluders[number];
    if (!beside.empty() && is_of(occluder, beside)) return false;
    const bool hidden = shadow.add(occluder);
    listener_.compared(edge, occluder, hidden, shadow);
    if (hidden) last_ = number;
    return hidden;
  }

  [[nodiscard]] bool is_of(const Occluder& occluder, std::span<const std::uint32_t> surfaces) const {
    const std::uint32_t own = view_.mesh->surface_of(occluder.face);
    return std::find(surfaces.begin(), surfaces.end(), own) != surfaces.end();
  }

  const View& view_;
  const ImageGrid& grid_;
  EdgeShadow<EdgeSight> shadow_;
  EdgeShadow<LineSight> line_shadow_;  // for crossings
  static constexpr std::size_t batch = 16;
  static constexpr std::size_t enough = 4;
  std::array<std::uint32_t, batch + enough> near_{};  // ranks of occluders
  std::size_t near_count_ = 0;
  static constexpr std::uint32_t no_occluder = ~0U;
  std::uint32_t last_ = no_occluder;  // the last occluder that hid the rest of an edge: it may hide the next edge, too
  const picture::ChosenEdges* chosen_;
  Listener& listener_;
};

// The drawn edges, ordered by the cell in which their bounds begin, row by row.
std::vector<std::uint32_t> in_image_order(const View& view, const ImageGrid& grid) {
  const auto cell_of = [&](std::uint32_t edge) {
    const ImageGrid::Cells cells = grid.cells_of(view.bounds_of(edge));
    return std::size_t{cells.low[1]} * grid.side() + cells.low[0];
  };
  std::vector<std::uint32_t> starts(std::size_t{grid.side()} * grid.side() + 1);
  const auto count = static_cast<std::uint32_t>(view.drawn.size());
  for (std::uint32_t edge = 0; edge < count; ++edge)
    if (view.drawn[edge] != 0) ++starts[cell_of(edge) + 1];
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  std::vector<std::uint32_t> order(starts.back());
  for (std::uint32_t edge = 0; edge < count; ++edge)
    if (view.drawn[edge] != 0) order[starts[cell_of(edge)]++] = edge;
  return order;
}

// The visible pieces that one thread finds, in blocks, so that growing copies nothing. The pieces of an edge are in one
// block.
struct SeenPart {
  std::vector<std::vector<picture::LinePiece>> blocks;
  std::vector<std::uint32_t> counts;  // pieces of each edge

  std::vector<picture::LinePiece>& block() {
    constexpr std::size_t pieces_a_block = 4096;
    constexpr std::size_t usual_most = 64;  // of an edge
    if (blocks.empty() || blocks.back().size() >= pieces_a_block) blocks.emplace_back().reserve(pieces_a_block + usual_most);
    return blocks.back();
  }
};

// Collects the pieces, found in any order of edges, into a picture ordered by edge.
picture::LinePicture by_edge(std::span<const SeenPart> parts, std::span<const std::uint32_t> order,
                             std::size_t edges) {
  std::vector<std::uint32_t> starts(edges + 1);
  std::size_t next = 0;
  for (const SeenPart& part : parts)
    for (const std::uint32_t count : part.counts) starts[order[next++] + 1] = count;
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  picture::LinePicture picture;
  picture.pieces.resize(starts.back());
  next = 0;
  for (const SeenPart& part : parts) {
    std::size_t block = 0;
    std::size_t used = 0;
    for (const std::uint32_t count : part.counts) {
      const std::uint32_t edge = order[next++];
      if (count == 0) continue;
      if (used == part.blocks[block].size()) {
        ++block;
        used = 0;
      }
      std::copy_n(part.blocks[block].data() + used, count, picture.pieces.data() + starts[edge]);
      used += count;
    }
  }
  return picture;
}

// From this many edges on, edges are compared in image order: then the occluders near an edge are mostly those near the
// edge before it, and are still in the cache.
constexpr std::size_t fewest_edges_ordered = 50'000;
constexpr std::size_t fewest_faces_per_job = 8;  // limits the number of threads
constexpr std::size_t edges_a_look = 1024;       // between two looks at the watch

std::size_t edge_count(const EdgeMesh& mesh, const picture::ChosenEdges* chosen) {
  return chosen != nullptr ? chosen->edges.size() : mesh.edges.size();
}

double part_of(std::size_t done, std::size_t all) { return static_cast<double>(done) / static_cast<double>(all); }

template <class Listener>
picture::LinePicture search_edges(const EdgeMesh& mesh, const scene::PolyCamera& camera, Listener listener,
                                  const picture::ChosenEdges* chosen = nullptr, const base::Watch& watch = {}) {
  const View view = make_view(mesh, camera, chosen);
  const ImageGrid grid(view.occluder_bounds, view.occluder_depths);
  Search<Listener> search(view, grid, chosen, listener);
  picture::LinePicture picture;
  for (std::uint32_t edge = 0; edge < view.edges.size(); ++edge) {
    if (edge % edges_a_look == 0 && !watch.go_on(part_of(edge, view.edges.size()))) return {};
    search.append_visible(edge, picture.pieces);
  }
  return picture;
}

constexpr std::size_t ahead = 8;  // edges: data far apart in memory are prefetched

void fetch(const View& view, std::uint32_t edge) {
  for (const std::uint32_t v : {view.edges[edge].from, view.edges[edge].to}) {
    __builtin_prefetch(&view.mesh->vertices[v]);
    __builtin_prefetch(&view.points[v]);
  }
}

picture::LinePicture search_ordered(const EdgeMesh& mesh, const scene::PolyCamera& camera,
                                    const picture::ChosenEdges* chosen, unsigned jobs, const base::Watch& watch) {
  jobs = static_cast<unsigned>(std::min<std::size_t>(jobs, 1 + mesh.faces.size() / fewest_faces_per_job));
  std::vector<std::uint32_t> order;
  std::vector<SeenPart> parts(jobs);
  {
    const View view = make_view(mesh, camera, chosen, jobs);
    const ImageGrid grid(view.occluder_bounds, view.occluder_depths, jobs);
    order = in_image_order(view, grid);
    base::for_parts(jobs, order.size(), [&](std::size_t number, std::size_t begin, std::size_t end) {
      SeenPart& part = parts[number];
      part.counts.reserve(end - begin);
      NoListener no_occluder;
      Search<NoListener> search(view, grid, chosen, no_occluder);
      for (std::size_t i = begin; i < end; ++i) {
        if ((i - begin) % edges_a_look == 0 && (number == 0 ? !watch.go_on(part_of(i, end)) : watch.ended())) return;
        if (i + ahead < end) fetch(view, order[i + ahead]);
        if (i + 2 * ahead < end) __builtin_prefetch(&view.edges[order[i + 2 * ahead]]);
        std::vector<picture::LinePiece>& pieces = part.block();
        const std::size_t before = pieces.size();
        search.append_visible(order[i], pieces);
        part.counts.push_back(static_cast<std::uint32_t>(pieces.size() - before));
      }
    });
  }
  if (watch.ended()) return {};
  return by_edge(parts, order, edge_count(mesh, chosen));
}

}  // namespace

picture::LinePicture visible_edges(const EdgeMesh& mesh, const scene::PolyCamera& camera,
                                   const picture::ChosenEdges* chosen, unsigned jobs, const base::Watch& watch) {
  if (jobs == 1 && edge_count(mesh, chosen) < fewest_edges_ordered) return search_edges(mesh, camera, NoListener(), chosen, watch);
  return search_ordered(mesh, camera, chosen, jobs, watch);
}

picture::LinePicture visible_edges(const EdgeMesh& mesh, const scene::PolyCamera& camera, const picture::ChosenEdges* chosen,
                                   std::vector<EdgeProof>& proofs, const base::Watch& watch) {
  const View view = make_view(mesh, camera, chosen);
  const ImageGrid grid(view.occluder_bounds, view.occluder_depths);
  ProofListener listener;
  Search<ProofListener> search(view, grid, chosen, listener);
  proofs.clear();
  proofs.resize(view.edges.size());
  const std::vector<std::uint32_t> order = in_image_order(view, grid);
  std::vector<SeenPart> parts(1);
  parts[0].counts.reserve(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % edges_a_look == 0 && !watch.go_on(part_of(i, order.size()))) return {};
    const std::uint32_t edge = order[i];
    std::vector<picture::LinePiece>& pieces = parts[0].block();
    const std::size_t before = pieces.size();
    listener.begin(view.edges[edge]);
    search.append_visible(edge, pieces);
    parts[0].counts.push_back(static_cast<std::uint32_t>(pieces.size() - before));
    proofs[edge] = std::move(listener.proof());
  }
  // Edges that are not drawn have no proof yet.
  for (std::uint32_t edge = 0; edge < proofs.size(); ++edge) {
    if (edge % edges_a_look == 0 && !watch.go_on(1)) return {};
    EdgeProof& proof = proofs[edge];
    proof.edge = view.edges[edge];
    if (view.drawn[edge] != 0) continue;
    if (view.before_eye(view.points[proof.edge.from]) || view.before_eye(view.points[proof.edge.to])) {
      listener.begin(proof.edge);
      search.find_witnesses(edge);
      proof = std::move(listener.proof());
      proof.reason = EdgeProof::Reason::turned_away;
    } else if (edge < view.first_line ? EdgeSight(view).begin(edge) : LineSight(view).begin(edge)) {
      proof.left = proof.right = {{0, 1, Witness::behind_eye}};
    } else {
      proof.reason = EdgeProof::Reason::point;
    }
  }
  return by_edge(parts, order, view.edges.size());
}

picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera, Trace& trace) {
  const EdgeMesh mesh = make_edge_mesh(scene);
  return search_edges(mesh, camera, TraceListener(trace));
}

picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  return visible_edges(make_edge_mesh(scene), camera);
}

}  // namespace sightline::algorithms::exact
