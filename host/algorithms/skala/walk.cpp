#include "host/algorithms/skala/walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "host/algorithms/skala/facing.hpp"
#include "host/algorithms/skala/gapped_horizon.hpp"
#include "host/algorithms/skala/horizon_edge.hpp"
#include "host/algorithms/skala/passing.hpp"

namespace sightline::algorithms::skala {
namespace {

// A contour begins and ends on edges that may be the horizon themselves, so it is inked up to this depth behind the
// horizon.
constexpr float contour_slack = -1.0F / 32;

struct Corner {
  std::size_t row = 0;
  std::size_t column = 0;
};

// The listener that does nothing. Walks with a listener are compiled separately.
struct NoListener {
  void line(std::span<const Vertex>, const std::vector<Piece>&) {}
  template <class Screen>
  void row_ended(const Screen&) {}
};

class TraceListener {
 public:
  explicit TraceListener(Trace& trace) : trace_(&trace) {}
  void line(std::span<const Vertex> line, const std::vector<Piece>& seen) { trace_->line(line, seen); }
  template <class Screen>
  void row_ended(const Screen& screen) {
    trace_->row_ended(screen.top(), screen.bottom());
  }

 private:
  Trace* trace_;
};

int columns_of(const View& view) {
  return std::clamp(view.columns, fewest_columns, most_columns);
}

// Draws one surface. `Screen` is Horizon or GappedHorizon.
template <class Listener, class Screen>
class Walker {
 public:
  Walker(const Walk& order, picture::VectorDrawing& drawing, Listener listener, Screen& screen)
      : listener_(listener),
        order_(order),
        surface_(*order.surface),
        view_(*order.view),
        sheet_(drawing, columns_of(view_)),
        horizon_(screen),
        lines_(view_.subject == Subject::lines),
        net_(lines_ ? view_.family == Family::both : view_.net),
        all_edges_(net_ || !lines_ || view_.silhouette),
        diagonals_(!lines_ || view_.silhouette),
        rims_(view_.rims && view_.subject != Subject::surface),
        net_only_(!gapped && std::is_same_v<Listener, NoListener> && lines_ && net_ && !view_.silhouette && view_.visibility && surface_.whole() &&
                  surface_.columns() > 1),
        slices_only_(!gapped && lines_ && !all_edges_ && view_.visibility && surface_.whole() && surface_.columns() > 2),
        dots_(lines_ && (!surface_.whole() || surface_.columns() == 1)) {}

  WalkResult go() {
    begin();
    for (std::size_t row = 0; row + 1 < surface_.rows(); ++row) {
      if (net_only_) {
        strip_of_net(row);
      } else {
        slices_only_ ? strip_of_slices(row) : strip(row);
      }
    }
    return end();
  }

  // The steps of the walk. For several surfaces, each step is taken for all of them in turn.
  void begin() {
    const std::size_t rows = surface_.rows();
    const std::size_t columns = surface_.columns();
    if (view_.subject == Subject::surface) walked_.seen.resize((rows - 1) * (columns - 1));
    column_pens_.resize(columns);
    if (rows > 0) first_row();
  }
  void begin_strip(std::size_t row) { column_edge(row, 0); }
  void cell(std::size_t row, std::size_t column) {
    dot(row + 1, column);
    if (column + 1 == surface_.columns()) return;
    const bool defined = gapped && !strips_ && view_.visibility && cell_defined(surface_, row, column);
    if (diagonals_ && cell_defined(surface_, row, column)) inside(row, column);
    if (all_edges_ || column + 2 == surface_.columns() || !whole_strip(row, column)) column_edge(row, column + 1);
    row_edge(row + 1, column);
    if (!defined) return;
    diagonals_ ? cover(row, column, Half::far) : cover(row, column);
  }
  // A cell through which other surfaces pass is drawn twice: draw_alone() finds what is visible of it alone, draw_among()
  // draws it among the other surfaces.
  void draw_alone(std::size_t row, std::size_t column) {
    pass_ = Pass::alone;
    seen_alone_.clear();
    cell(row, column);
    pass_ = Pass::usual;
  }
  void draw_among(std::size_t row, std::size_t column, std::span<const Walk* const> rivals, double towards_eye) {
    pass_ = Pass::among;
    next_alone_ = 0;
    rivals_ = rivals;
    towards_eye_ = towards_eye;
    cell(row, column);
    pass_ = Pass::usual;
  }
  // Adds the whole cell to the occluders.
  void cover_cell(std::size_t row, std::size_t column) {
    if (!cell_defined(surface_, row, column)) return;
    if (!diagonals_) return cover(row, column);
    cover(row, column, Half::near);
    cover(row, column, Half::far);
  }
  void cover_near(std::size_t row, std::size_t column) { cover(row, column, Half::near); }
  void end_row() {
    row_pen_.lift(sheet_);
    wake_ = {};
    listener_.row_ended(horizon_);
  }
  WalkResult end() {
    for (Pen& pen : column_pens_) pen.lift(sheet_);
    stitcher_.finish(sheet_);
    return std::move(walked_);
  }

 private:
  void first_row() {
    for (std::size_t column = 0; column < surface_.columns(); ++column) {
      dot(0, column);
      row_edge(0, column);
    }
    end_row();
  }

  // Draws the strip between a row and the next farther one, and that row.
  void strip(std::size_t row) {
    begin_strip(row);
    strips_ = gapped && !all_edges_ && view_.visibility;
    for (std::size_t column = 0; column < surface_.columns(); ++column) cell(row, column);
    if (strips_) cover_strip(row);
    end_row();
  }

  // For slices alone: between two of them the surface is ruled, as if nothing were between the ends of a strip.
  void cover_strip(std::size_t row) {
    std::vector<Vertex> outline;
    const std::size_t cells = surface_.columns() - 1;
    for (std::size_t first = 0; first < cells; ++first) {
      std::size_t last = first;
      while (last < cells && cell_defined(surface_, row, last)) ++last;
      if (last == first) continue;
      outline.clear();
      for (std::size_t column = first; column <= last; ++column) outline.push_back(surface_.at(row, column));
      for (std::size_t column = last + 1; column-- > first;) outline.push_back(surface_.at(row + 1, column));
      if constexpr (gapped) horizon_.cover(outline);
      first = last;
    }
  }

  // The same if there are only rims between the slices.
  void strip_of_slices(std::size_t row) {
    const std::size_t last = surface_.columns() - 1;
    column_edge(row, 0);
    if constexpr (!gapped) {
      const auto chain = surface_.row(row + 1).first(last);
      const bool seen = horizon_.draw_chain(chain, wake_);
      listener_.line(chain, horizon_.pieces());
      if (seen) row_pen_.draw(sheet_, layer(along_rows), horizon_.pieces());
    }
    column_edge(row, last);
    row_edge(row + 1, last - 1);
    end_row();
  }

  // strip() without the parts that a net does not have.
  void strip_of_net(std::size_t row) {
    if constexpr (!gapped) {
      const std::span<const Vertex> near = surface_.row(row);
      const std::span<const Vertex> far = surface_.row(row + 1);
      if (row == 0) horizon_.find_columns(near, far_columns_);
      std::swap(near_columns_, far_columns_);
      horizon_.find_columns(far, far_columns_);
      const auto across = [&](std::size_t column) {
        Wake wake;
        const auto sight = horizon_.draw_edge(near[column], far[column], near_columns_[column], far_columns_[column], wake);
        ink(sight, column_pens_[column], layer(along_columns), near[column], far[column]);
      };
      const std::uint32_t row_layer = layer(along_rows);
      Wake wake;
      across(0);
      for (std::size_t column = 0; column + 1 < far.size(); ++column) {
        across(column + 1);
        const auto sight = horizon_.draw_edge(far[column], far[column + 1], far_columns_[column], far_columns_[column + 1], wake);
        ink(sight, row_pen_, row_layer, far[column], far[column + 1]);
      }
    }
    end_row();
  }
  [[gnu::always_inline]] void ink(Horizon::Sight sight, Pen& pen, std::uint32_t of_layer, Vertex from, Vertex to) {
    if (sight == Horizon::Sight::whole) {
      pen.draw(sheet_, of_layer, from, to);
    } else if (sight == Horizon::Sight::parts) {
      pen.draw(sheet_, of_layer, horizon_.pieces());
    }
  }

  // Whether this cell and the next both exist, so that no edge of the surface is between them.
  [[nodiscard]] bool whole_strip(std::size_t row, std::size_t column) const {
    if (surface_.whole()) return true;
    return surface_.defined(row, column) && surface_.defined(row + 1, column) &&
           surface_.defined(row, column + 1) && surface_.defined(row + 1, column + 1) &&
           surface_.defined(row, column + 2) && surface_.defined(row + 1, column + 2);
  }

  bool draw(Corner a, Corner b, Wake& wake) {
    const Vertex from = vertex(a);
    const Vertex to = vertex(b);
    if (!view_.visibility) {
      unhidden_.assign(1, {from, to});
      return true;
    }
    const bool seen = horizon_.draw(from, to, wake);
    listener_.line(std::array{from, to}, horizon_.pieces());
    if (pass_ == Pass::usual) return seen;
    return seen_in_pass(from, to, [&] { return leading_part(leads(a, a, 0), leads(b, b, 0)); });
  }
  [[nodiscard]] const std::vector<Piece>& pieces() const {
    if (pass_ == Pass::among && view_.visibility) return seen_among_;
    return view_.visibility ? horizon_.pieces() : unhidden_;
  }

  // For a line that was just tested. In the pass `alone` nothing is inked.
  template <class LeadingPart>
  bool seen_in_pass(Vertex from, Vertex to, const LeadingPart& leading) {
    if (pass_ == Pass::alone) {
      seen_alone_.push_back(horizon_.pieces());
      return false;
    }
    seen_among_ = visible_pieces(from, to, leading(), seen_alone_[next_alone_++], horizon_.pieces());
    return !seen_among_.empty();
  }

  // The leads at a point between two corners.
  [[nodiscard]] Leads leads(Corner a, Corner b, double t) const {
    Leads all;
    for (const Walk* rival : rivals_) {
      const auto at = [&](Corner corner) { return (order_.heights[id(corner)] - rival->heights[id(corner)]) * towards_eye_; };
      const double lead = t == 0 ? at(a) : at(a) + t * (at(b) - at(a));
      all.push_back(lead == lead ? lead : 0);  // NaN: a missing surface hides nothing
    }
    return all;
  }

  void row_edge(std::size_t row, std::size_t column) {
    if (column + 1 >= surface_.columns() || !surface_.defined(row, column) ||
        !surface_.defined(row, column + 1)) {
      wake_ = {};
      return;
    }
    if (!draw({row, column}, {row, column + 1}, wake_)) return;
    mark(row, column);
    if (row > 0) mark(row - 1, column);
    if (lines_ || net_) {
      row_pen_.draw(sheet_, layer(along_rows), pieces());
    } else if (rims_ && edge_of_surface_along(row, column)) {
      row_pen_.draw(sheet_, layer(rims), pieces());
    }
    if (!view_.silhouette || row == 0) return;
    if (folds(side_of(surface_, row - 1, column, Half::far), side_of(surface_, row, column, Half::near)))
      silhouette({row, column}, {row, column + 1});
  }

  void column_edge(std::size_t row, std::size_t column) {
    if (!surface_.defined(row, column) || !surface_.defined(row + 1, column)) return;
    // A net has all edges and inks them all in the same way.
    const bool rim = !net_ && edge_of_surface_across(row, column);
    if (!all_edges_ && !rim) return;
    Wake wake;
    if (!draw({row, column}, {row + 1, column}, wake)) return;
    mark(row, column);
    if (column > 0) mark(row, column - 1);
    if (net_) {
      column_pens_[column].draw(sheet_, layer(along_columns), pieces());
    } else if (rims_ && rim) {
      column_pens_[column].draw(sheet_, layer(rims), pieces());
    }
    if (!view_.silhouette || column == 0) return;
    if (folds(side_of(surface_, row, column - 1, Half::far), side_of(surface_, row, column, Half::near)))
      silhouette({row, column}, {row + 1, column});
  }

  // Draws the cell's diagonal and the contours on both sides of it.
  void inside(std::size_t row, std::size_t column) {
    const Corner beside{row, column + 1};
    const Corner behind{row + 1, column};
    contours({Corner{row, column}, beside, behind});
    Wake wake;
    if (draw(behind, beside, wake)) {
      mark(row, column);
      if (view_.silhouette &&
          folds(side_of(surface_, row, column, Half::near), side_of(surface_, row, column, Half::far)))
        silhouette(behind, beside);
    }
    cover(row, column, Half::near);
    contours({Corner{row + 1, column + 1}, behind, beside});
  }

  // Adds half a cell to the occluders.
  void cover(std::size_t row, std::size_t column, Half half) {
    if constexpr (gapped) {
      if (!view_.visibility) return;
      const Vertex corner = half == Half::near ? surface_.at(row, column) : surface_.at(row + 1, column + 1);
      horizon_.cover(std::array{corner, surface_.at(row, column + 1), surface_.at(row + 1, column)});
    }
  }
  // Adds a cell without a drawn diagonal to the occluders.
  void cover(std::size_t row, std::size_t column) {
    if constexpr (gapped)
      horizon_.cover(std::array{surface_.at(row, column), surface_.at(row, column + 1), surface_.at(row + 1, column + 1), surface_.at(row + 1, column)});
  }

  void contours(const std::array<Corner, 3>& triangle) {
    if (order_.levels.empty()) return;
    std::array<std::size_t, 3> ids{};
    for (std::size_t i = 0; i < 3; ++i) ids[i] = id(triangle[i]);
    const auto band = [&](std::size_t i) { return order_.bands[ids[i]]; };
    const std::size_t low = std::min({band(0), band(1), band(2)});
    const std::size_t high = std::max({band(0), band(1), band(2)});
    for (std::size_t level = low; level < high; ++level) {
      std::array<ContourEnd, 2> ends{};
      std::size_t found = 0;
      for (std::size_t i = 0; i < 3 && found < 2; ++i) {
        const std::size_t next = (i + 1) % 3;
        if ((band(i) > level) == (band(next) > level)) continue;
        ends[found] = crossing(triangle[i], triangle[next], order_.levels[level]);
        ends[found++].joint = joint(ids[i], ids[next]);
      }
      contour(static_cast<std::uint32_t>(level), ends);
    }
  }

  // A point on the side between two corners, of which the first has the lower number.
  struct ContourEnd {
    Vertex at;
    Corner a;
    Corner b;
    double t = 0;
    Joint joint = 0;
  };

  void contour(std::uint32_t level, const std::array<ContourEnd, 2>& ends) {
    const ContourEnd& from = ends[0];
    const ContourEnd& to = ends[1];
    if (!view_.visibility) {
      unhidden_.assign(1, {from.at, to.at});
    } else if (pass_ == Pass::usual) {
      if (!horizon_.test(from.at, to.at, contour_slack)) return;
    } else {
      horizon_.test(from.at, to.at, contour_slack);
      const auto leading = [&] { return leading_part(leads(from.a, from.b, from.t), leads(to.a, to.b, to.t)); };
      if (!seen_in_pass(from.at, to.at, leading)) return;
    }
    stitcher_.add(layer(first_contour) + level, from.at, to.at, pieces(), from.joint, to.joint);
  }

  // Gives the same result for both directions of the edge.
  [[nodiscard]] ContourEnd crossing(Corner a, Corner b, double level) const {
    if (id(b) < id(a)) std::swap(a, b);
    const double low = order_.heights[id(a)];
    const double high = order_.heights[id(b)];
    // Computed from halves, because the difference of two heights may overflow.
    double t = (level / 2 - low / 2) / (high / 2 - low / 2);
    // The heights are so small and close that their halves are equal.
    if (!(t >= 0 && t <= 1)) t = 0.5;
    const Vertex from = vertex(a);
    const Vertex to = vertex(b);
    const Vertex at{static_cast<float>(double{from.x} + t * (double{to.x} - double{from.x})),
                    static_cast<float>(double{from.y} + t * (double{to.y} - double{from.y}))};
    return {at, a, b, t, 0};
  }

  // Names an edge: 1 + 3 times its first vertex + its direction.
  [[nodiscard]] Joint joint(std::size_t a, std::size_t b) const {
    const std::size_t first = std::min(a, b);
    const std::size_t step = std::max(a, b) - first;
    const bool along = step == 1 && (first + 1) % surface_.columns() != 0;
    const std::size_t way = along ? 0 : step == surface_.columns() ? 1 : 2;
    return 1 + 3 * Joint{first} + way;
  }

  void silhouette(Corner from, Corner to) {
    if (!is_outline(surface_, from.row, from.column, to.row, to.column, columns_of(view_))) return;
    stitcher_.add(layer(silhouettes), vertex(from), vertex(to), pieces(), 1 + Joint{id(from)}, 1 + Joint{id(to)});
  }

  // Draws a point in which no line ends.
  void dot(std::size_t row, std::size_t column) {
    if (!dots_ || !surface_.defined(row, column)) return;
    if (column > 0 && surface_.defined(row, column - 1)) return;
    if (column + 1 < surface_.columns() && surface_.defined(row, column + 1)) return;
    if (net_ && ((row > 0 && surface_.defined(row - 1, column)) ||
                 (row + 1 < surface_.rows() && surface_.defined(row + 1, column))))
      return;
    const Vertex here = surface_.at(row, column);
    if (!view_.visibility) {
      unhidden_.assign(1, {here, here});
    } else if (!horizon_.test(here, here, Horizon::usual_slack)) {
      return;
    }
    row_pen_.draw(sheet_, layer(along_rows), pieces());
  }

  void mark(std::size_t row, std::size_t column) {
    if (walked_.seen.empty() || row + 1 >= surface_.rows() || column + 1 >= surface_.columns()) return;
    walked_.seen[row * (surface_.columns() - 1) + column] = true;
  }

  [[nodiscard]] bool edge_of_surface_across(std::size_t row, std::size_t column) const {
    return (column > 0 && cell_defined(surface_, row, column - 1)) != cell_defined(surface_, row, column);
  }
  [[nodiscard]] bool edge_of_surface_along(std::size_t row, std::size_t column) const {
    return (row > 0 && cell_defined(surface_, row - 1, column)) != cell_defined(surface_, row, column);
  }

  [[nodiscard]] std::uint32_t layer(Layer which) const { return order_.first_layer + which; }
  [[nodiscard]] std::size_t id(Corner corner) const {
    return corner.row * surface_.columns() + corner.column;
  }
  [[nodiscard]] Vertex vertex(Corner corner) const { return surface_.at(corner.row, corner.column); }

  static constexpr bool gapped = std::is_same_v<Screen, GappedHorizon>;

  [[no_unique_address]] Listener listener_;
  const Walk& order_;
  const Surface& surface_;
  const View& view_;
  Sheet sheet_;
  Screen& horizon_;
  bool lines_;
  bool net_;
  bool all_edges_;
  bool diagonals_;
  bool rims_;
  bool net_only_;     // draws only edges, and inks each
  bool slices_only_;  // and only rims interrupt a slice
  bool dots_;
  bool strips_ = false;  // strips hide as a whole, not cell by cell
  Wake wake_;
  Pen row_pen_;
  std::vector<Pen> column_pens_;
  std::vector<std::int32_t> near_columns_;  // Horizon::find_columns of the two rows of a strip
  std::vector<std::int32_t> far_columns_;
  Stitcher stitcher_;
  std::vector<Piece> unhidden_;
  WalkResult walked_;
  // Used if several surfaces pass through each other.
  enum class Pass { usual, alone, among };
  Pass pass_ = Pass::usual;
  std::vector<std::vector<Piece>> seen_alone_;  // of the lines of a cell, in the order of the tests
  std::size_t next_alone_ = 0;
  std::vector<Piece> seen_among_;
  std::span<const Walk* const> rivals_;
  double towards_eye_ = 1;
};

template <class Listener>
WalkResult walk_for(const Walk& order, picture::VectorDrawing& drawing, Listener listener) {
  if (order.surface->whole()) {
    Horizon screen(columns_of(*order.view));
    return Walker<Listener, Horizon>(order, drawing, listener, screen).go();
  }
  GappedHorizon screen(columns_of(*order.view));
  return Walker<Listener, GappedHorizon>(order, drawing, listener, screen).go();
}

// Draws several surfaces at once.
class MultiSurfaceWalk {
 public:
  MultiSurfaceWalk(std::span<const Walk> orders, picture::VectorDrawing& drawing, std::uint32_t meetings)
      : orders_(orders),
        surface_(*orders[0].surface),
        sheet_(drawing, columns_of(*orders[0].view)),
        screen_(columns_of(*orders[0].view)),
        meetings_(meetings),
        visibility_(orders[0].view->visibility),
        towards_eye_(surface_.to_eye()[2] >= 0 ? 1 : -1) {
    walkers_.reserve(orders.size());
    for (const Walk& order : orders) walkers_.emplace_back(order, drawing, NoListener(), screen_);
    for (std::size_t i = 0; i < orders.size(); ++i) {
      rivals_.emplace_back();
      for (std::size_t j = 0; j < orders.size(); ++j)
        if (j != i) rivals_.back().push_back(&orders[j]);
    }
  }

  std::vector<WalkResult> go() {
    for (auto& walker : walkers_) walker.begin();
    for (std::size_t row = 0; row + 1 < surface_.rows(); ++row) {
      for (auto& walker : walkers_) walker.begin_strip(row);
      for (std::size_t column = 0; column < surface_.columns(); ++column) cell(row, column);
      for (auto& walker : walkers_) walker.end_row();
    }
    std::vector<WalkResult> result;
    for (auto& walker : walkers_) result.push_back(walker.end());
    stitcher_.finish(sheet_);
    return result;
  }

 private:
  void cell(std::size_t row, std::size_t column) {
    const bool whole = column + 1 < surface_.columns();
    const Coverage::Saved saved = whole && visibility_ && any_meet(row, column) ? columns_under(row, column) : Coverage::Saved();
    if (whole) meet(row, column, saved);
    if (!saved.columns.empty() && any_pass(row, column)) return passing_cell(row, column, saved);
    turns_.clear();
    for (std::size_t i = 0; i < orders_.size(); ++i) {
      const double middle = whole ? sum_of(i, row, column) * towards_eye_ : 0;
      // A missing cell hides nothing.
      turns_.push_back({middle == middle ? -middle : 0, i});
    }
    std::sort(turns_.begin(), turns_.end());
    for (const auto& [middle, i] : turns_) walkers_[i].cell(row, column);
  }

  void passing_cell(std::size_t row, std::size_t column, const Coverage::Saved& saved) {
    for (std::size_t i = 0; i < orders_.size(); ++i) {
      screen_.restore(saved);
      walkers_[i].draw_alone(row, column);
      screen_.restore(saved);
      for (std::size_t j = 0; j < orders_.size(); ++j)
        if (j != i) walkers_[j].cover_cell(row, column);
      walkers_[i].draw_among(row, column, rivals_[i], towards_eye_);
    }
  }

  [[nodiscard]] double height(std::size_t i, std::size_t row, std::size_t column) const {
    return orders_[i].heights[row * surface_.columns() + column];
  }
  [[nodiscard]] double sum_of(std::size_t i, std::size_t row, std::size_t column) const {
    return height(i, row, column) + height(i, row, column + 1) + height(i, row + 1, column) + height(i, row + 1, column + 1);
  }
  [[nodiscard]] bool both_defined(std::size_t i, std::size_t j, std::size_t row, std::size_t column) const {
    return cell_defined(*orders_[i].surface, row, column) && cell_defined(*orders_[j].surface, row, column);
  }
  struct Sides {
    bool above = false;
    bool level = false;
    bool below = false;
  };
  // For the corners of the cells in a range around a cell.
  [[nodiscard]] Sides sides(std::size_t i, std::size_t j, std::size_t row, std::size_t column, std::size_t around) const {
    Sides sides;
    for (std::size_t r = row - std::min(row, around); r <= std::min(row + 1 + around, surface_.rows() - 1); ++r)
      for (std::size_t c = column - std::min(column, around); c <= std::min(column + 1 + around, surface_.columns() - 1); ++c) {
        const double difference = height(i, r, c) - height(j, r, c);
        sides.above = sides.above || difference > 0;
        sides.level = sides.level || difference == 0;
        sides.below = sides.below || difference < 0;
      }
    return sides;
  }
  template <class Test>
  [[nodiscard]] bool any_pair(std::size_t row, std::size_t column, const Test& test) const {
    for (std::size_t i = 0; i < orders_.size(); ++i)
      for (std::size_t j = i + 1; j < orders_.size(); ++j)
        if (both_defined(i, j, row, column) && test(sides(i, j, row, column, 0))) return true;
    return false;
  }
  [[nodiscard]] bool any_pass(std::size_t row, std::size_t column) const {
    return any_pair(row, column, [](const Sides& sides) { return sides.above && sides.below; });
  }
  [[nodiscard]] bool any_meet(std::size_t row, std::size_t column) const {
    return any_pair(row, column, [](const Sides& sides) { return sides.above && (sides.below || sides.level); });
  }
  [[nodiscard]] Coverage::Saved columns_under(std::size_t row, std::size_t column) const {
    const auto x = {surface_.at(row, column).x, surface_.at(row, column + 1).x, surface_.at(row + 1, column).x, surface_.at(row + 1, column + 1).x};
    return screen_.saved(std::min(x), std::max(x));
  }

  // Draws the lines in which surfaces meet: on the near half of the cell before the cell is drawn, on the far half behind
  // the near halves.
  void meet(std::size_t row, std::size_t column, const Coverage::Saved& saved) {
    if (visibility_ && saved.columns.empty()) return;
    const std::size_t near = row * surface_.columns() + column;
    const std::size_t behind = near + surface_.columns();
    for (const Half half : {Half::near, Half::far}) {
      const std::array<std::size_t, 3> corners = half == Half::near ? std::array{near, near + 1, behind} : std::array{behind + 1, behind, near + 1};
      if (half == Half::far && visibility_)
        for (auto& walker : walkers_) walker.cover_near(row, column);
      std::size_t pair = 0;
      for (std::size_t i = 0; i < orders_.size(); ++i)
        for (std::size_t j = i + 1; j < orders_.size(); ++j, ++pair) {
          // If one surface only touches the other from one side, they do not pass through each other.
          if (!both_defined(i, j, row, column) || !sides(i, j, row, column, 1).below) continue;
          add_meeting(i, j, corners, pair);
        }
    }
    if (visibility_) screen_.restore(saved);
  }

  void add_meeting(std::size_t i, std::size_t j, const std::array<std::size_t, 3>& corners, std::size_t pair) {
    std::array<double, 3> differences{};
    for (std::size_t k = 0; k < 3; ++k) differences[k] = orders_[i].heights[corners[k]] - orders_[j].heights[corners[k]];
    const auto line = meeting_line(differences);
    if (!line) return;
    std::array<Vertex, 2> ends{};
    std::array<Joint, 2> joints{};
    for (std::size_t k = 0; k < 2; ++k) {
      const Meeting& at = (*line)[k];
      const std::size_t a = std::min(corners[at.a], corners[at.b]);
      const std::size_t b = std::max(corners[at.a], corners[at.b]);
      const double t = a == corners[at.a] ? at.at : 1 - at.at;
      const Vertex from = orders_[i].surface->at(a / surface_.columns(), a % surface_.columns());
      const Vertex to = orders_[i].surface->at(b / surface_.columns(), b % surface_.columns());
      ends[k] = {static_cast<float>(from.x + t * (double{to.x} - from.x)), static_cast<float>(from.y + t * (double{to.y} - from.y))};
      // A joint for each pair of surfaces and each corner or side.
      const std::size_t step = b - a;
      const std::size_t way = t == 0 || t == 1 ? 3 : step == surface_.columns() ? 1 : step == 1 ? 0 : 2;
      joints[k] = 1 + 4 * (pair * surface_.rows() * surface_.columns() + Joint{t == 1 ? b : a}) + way;
    }
    if (ends[0] == ends[1]) return;
    if (!visibility_) {
      pieces_.assign(1, {ends[0], ends[1]});
    } else if (screen_.test(ends[0], ends[1], contour_slack)) {
      pieces_ = screen_.pieces();
      // Surfaces that meet there may cover up to half a column of the line's ends.
      const auto near = [](Vertex a, Vertex b) { return std::abs(a.x - b.x) <= 0.5F && std::abs(a.y - b.y) <= 0.1F; };
      if (near(pieces_.front().from, ends[0])) pieces_.front().from = ends[0];
      if (near(pieces_.back().to, ends[1])) pieces_.back().to = ends[1];
    } else {
      return;
    }
    stitcher_.add(meetings_, ends[0], ends[1], pieces_, joints[0], joints[1]);
  }

  std::span<const Walk> orders_;
  const Surface& surface_;  // the first; all have the same coordinates
  Sheet sheet_;
  GappedHorizon screen_;
  std::uint32_t meetings_;
  bool visibility_;
  double towards_eye_;  // 1 if greater heights are nearer to the eye, else -1
  std::vector<Walker<NoListener, GappedHorizon>> walkers_;
  std::vector<std::vector<const Walk*>> rivals_;  // by surface: all others
  std::vector<std::pair<double, std::size_t>> turns_;
  Stitcher stitcher_;
  std::vector<Piece> pieces_;
};

}  // namespace

WalkResult walk(const Walk& order, picture::VectorDrawing& drawing) {
  return walk_for(order, drawing, NoListener());
}
WalkResult walk(const Walk& order, picture::VectorDrawing& drawing, Trace& trace) {
  return walk_for(order, drawing, TraceListener(trace));
}

std::vector<WalkResult> walk(std::span<const Walk> orders, picture::VectorDrawing& drawing, std::uint32_t meetings) {
  if (orders.empty()) return {};
  return MultiSurfaceWalk(orders, drawing, meetings).go();
}

}  // namespace sightline::algorithms::skala
