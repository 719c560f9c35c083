#include "host/programs/skala/stream_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sightline::programs::skala {

namespace {

constexpr int last_place = 255;
constexpr std::array<double, 2> borders{0.0, last_place};

enum class Side { on_screen, above, below, beside };

bool on_screen(const Vertex& v) {
  return v.column >= 0 && v.column <= last_place && v.row >= 0 && v.row <= last_place;
}

bool is_shading(ChainStep step) {
  return step == ChainStep::shade || step == ChainStep::rim;
}

// A segment, with a parameter t from 0 to 1.
class Segment {
 public:
  Segment(const Vertex& from, const Vertex& to, RasterChain::Levels levels)
      : from_(from), to_(to), levels_(levels) {}

  // The parameters where it crosses the border lines of the raster, with 0 and 1, ascending.
  struct Cuts {
    std::array<double, 6> at{};
    std::size_t count = 0;
  };
  [[nodiscard]] Cuts cuts() const {
    Cuts cuts;
    insert(cuts, 0.0);
    for (const double border : borders) {
      add(cuts, border, from_.x, to_.x);
      add(cuts, border, from_.y, to_.y);
    }
    insert(cuts, 1.0);
    return cuts;
  }

  [[nodiscard]] Side side(double t) const {
    const double x = between(from_.x, to_.x, t);
    if (x < 0 || x > last_place) return Side::beside;
    const double y = between(from_.y, to_.y, t);
    return y < 0 ? Side::below : y > last_place ? Side::above : Side::on_screen;
  }

  [[nodiscard]] ChainNode node(double t, Side side, ChainStep step) const {
    const auto [low, high] = std::minmax(from_.column, to_.column);
    int column = t == 0 ? from_.column : t == 1 ? to_.column : raster_coordinate(between(from_.x, to_.x, t));
    column = std::clamp(std::clamp(column, low, high), 0, last_place);
    int row = t == 0 ? from_.row : t == 1 ? to_.row : raster_coordinate(between(from_.y, to_.y, t));
    if (side != Side::on_screen) row = side == Side::above ? last_place : 0;
    const double level = between(levels_.from, levels_.to, t);
    return {column, std::clamp(row, 0, last_place), static_cast<int>(std::floor(level + 0.5)), step, false};
  }

 private:
  static double between(double a, double b, double t) { return a + t * (b - a); }

  static void add(Cuts& cuts, double border, double a, double b) {
    if ((a < border) == (b < border) && (a > border) == (b > border)) return;
    const double t = (border - a) / (b - a);
    if (t > 0 && t < 1) insert(cuts, t);
  }
  static void insert(Cuts& cuts, double t) {
    std::size_t place = cuts.count++;
    for (; place > 0 && cuts.at[place - 1] > t; --place) cuts.at[place] = cuts.at[place - 1];
    cuts.at[place] = t;
  }

  const Vertex& from_;
  const Vertex& to_;
  RasterChain::Levels levels_;
};

}  // namespace

void RasterChain::part(const ChainNode& from, const ChainNode& to) {
  if (end_ == nullptr) {
    nodes_.push_back(from);
    nodes_.back().fresh = true;
  }
  const ChainNode& here = nodes_.back();
  const bool moves = here.column != to.column || here.row != to.row;
  if (moves || (is_shading(to.step) && here.level != to.level)) nodes_.push_back(to);
}

void RasterChain::segment(const Vertex& from, const Vertex& to, ChainStep step, Levels levels) {
  if (end_ != &from) end_ = nullptr;
  const Segment segment(from, to, levels);
  if (on_screen(from) && on_screen(to)) {
    part(segment.node(0, Side::on_screen, step), segment.node(1, Side::on_screen, step));
    end_ = &to;
    return;
  }
  const auto cuts = segment.cuts();
  for (std::size_t i = 0; i + 1 < cuts.count; ++i) {
    const Side side = segment.side((cuts.at[i] + cuts.at[i + 1]) / 2);
    const bool off = side == Side::above || side == Side::below;
    if (side == Side::beside || (off && step == ChainStep::test)) {
      end_ = nullptr;
      continue;
    }
    const ChainStep inkless = off && step == ChainStep::draw ? ChainStep::mask : step;
    part(segment.node(cuts.at[i], side, inkless), segment.node(cuts.at[i + 1], side, inkless));
    end_ = &to;
  }
}

void RasterChain::point(const Vertex& vertex, ChainStep step, int level) {
  end_ = nullptr;
  if (vertex.column < 0 || vertex.column > last_place) return;
  if (!on_screen(vertex)) {
    if (step == ChainStep::test) return;
    if (step == ChainStep::draw) step = ChainStep::mask;
  }
  nodes_.push_back({vertex.column, std::clamp(vertex.row, 0, last_place), level, step, true});
}

RasterChain RasterChain::reversed() const {
  RasterChain result;
  result.nodes_.assign(nodes_.rbegin(), nodes_.rend());
  // Steps belong to lines, so they move to the other end, and so does the beginning of a piece.
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t old = nodes_.size() - 1 - i;
    ChainNode& node = result.nodes_[i];
    node.fresh = old + 1 == nodes_.size() || nodes_[old + 1].fresh;
    if (!node.fresh) node.step = nodes_[old + 1].step;
  }
  return result;
}

Cell Cells::cell(std::size_t row, std::size_t column) const {
  const GridIndex along_row = order_.index(row, column + 1);
  const GridIndex across_rows = order_.index(row + 1, column);
  const bool last_row = row + 2 == order_.rows;
  const bool last_column = column + 2 == order_.columns;
  const bool swap = !columns_go_left();
  return {order_.index(row, column),         swap ? across_rows : along_row, swap ? along_row : across_rows,
          order_.index(row + 1, column + 1), swap ? last_row : last_column,  swap ? last_column : last_row};
}

void Cells::join(RasterChain& chain, GridIndex from, GridIndex to, ChainStep step) const {
  if (at(from).defined && at(to).defined) chain.segment(at(from), at(to), step);
}

RasterChain Cells::near_margins(ChainStep step) const {
  RasterChain chain;
  if (rows() == 0 || columns() == 0) return chain;
  if (rows() == 1 && columns() == 1) {
    if (at(order_.index(0, 0)).defined) chain.point(at(order_.index(0, 0)), step);
    return chain;
  }
  const bool swap = !columns_go_left();
  const auto margin = [&](bool left, std::size_t i) {
    return left == swap ? order_.index(i, 0) : order_.index(0, i);
  };
  for (std::size_t i = (swap ? rows() : columns()) - 1; i > 0; --i)
    join(chain, margin(true, i), margin(true, i - 1), step);
  for (std::size_t i = 1; i < (swap ? columns() : rows()); ++i)
    join(chain, margin(false, i - 1), margin(false, i), step);
  return chain;
}

RasterChain Cells::far_margins(std::size_t row, std::size_t column, ChainStep step, ChainStep border) const {
  const Cell here = cell(row, column);
  RasterChain chain;
  join(chain, here.left, here.farthest, here.left_margin_is_border ? border : step);
  join(chain, here.farthest, here.right, here.right_margin_is_border ? border : step);
  return chain;
}

}  // namespace sightline::programs::skala
