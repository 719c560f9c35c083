#include "host/picture/pen_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace sightline::picture {
namespace {

struct PenPlace {
  double x = 0;  // mm
  double y = 0;
};

double length_between(const PenPlace& a, const PenPlace& b) {
  const double x = a.x - b.x;
  const double y = a.y - b.y;
  return std::sqrt(x * x + y * y);  // std::hypot, which cannot overflow, takes a sixth of the time of a view of many lines
}

// Whether a distance is certainly above a limit, tested by its square: nearly always equivalent to comparing the distance
// itself, which takes ten times as long to compute.
bool is_beyond(const PenPlace& a, const PenPlace& b, double limit) {
  const double x = a.x - b.x;
  const double y = a.y - b.y;
  constexpr double margin = 1 + 1e-9;  // far above the errors of rounding
  return x * x + y * y > limit * limit * margin;
}

using Corners = std::vector<std::uint32_t>;  // points of the drawing
constexpr std::uint32_t no_end = std::numeric_limits<std::uint32_t>::max();

// A grid over places, in which cells hold about two each.
class Cells {
 public:
  explicit Cells(std::span<const PenPlace> places) : places_(places) {}

  void fill(const std::vector<std::uint32_t>& members) {
    low_ = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    PenPlace high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
    for (const std::uint32_t m : members) {
      low_ = {std::min(low_.x, places_[m].x), std::min(low_.y, places_[m].y)};
      high = {std::max(high.x, places_[m].x), std::max(high.y, places_[m].y)};
    }
    const double width = std::max(high.x - low_.x, 1e-6);
    const double height = std::max(high.y - low_.y, 1e-6);
    size_ = std::max(std::sqrt(width * height * 2 / static_cast<double>(std::max<std::size_t>(members.size(), 1))),
                     std::max(width, height) / 1000);
    columns_ = static_cast<std::int64_t>(width / size_) + 1;
    rows_ = static_cast<std::int64_t>(height / size_) + 1;
    starts_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    for (const std::uint32_t m : members) ++starts_[cell_of(places_[m]) + 1];
    for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    members_.resize(members.size());
    std::vector<std::uint32_t> at(starts_.begin(), starts_.end() - 1);
    for (const std::uint32_t m : members) members_[at[cell_of(places_[m])]++] = m;
  }

  // Calls visit(member) for the members of rings of cells around a place, until done(distance) returns true, which means
  // that nothing farther away is needed.
  template <class Visit, class Done>
  void around(const PenPlace& place, Visit visit, Done done) const {
    const std::int64_t column = column_of(place.x);
    const std::int64_t row = row_of(place.y);
    const std::int64_t most = std::max(columns_, rows_);
    for (std::int64_t ring = 0; ring <= most; ++ring) {
      if (ring > 0 && done(static_cast<double>(ring - 1) * size_)) return;
      const std::int64_t first = std::max<std::int64_t>(row - ring, 0);
      const std::int64_t last = std::min(row + ring, rows_ - 1);
      for (std::int64_t r = first; r <= last; ++r) {
        const bool whole = r == row - ring || r == row + ring;
        for (std::int64_t c = column - ring; c <= column + ring; c += whole || ring == 0 ? 1 : 2 * ring) {
          if (c < 0 || c >= columns_) continue;
          const auto cell = static_cast<std::size_t>(r * columns_ + c);
          for (std::uint32_t m = starts_[cell]; m < starts_[cell + 1]; ++m) visit(members_[m]);
        }
      }
    }
  }

 private:
  [[nodiscard]] std::int64_t column_of(double x) const {
    return std::clamp(static_cast<std::int64_t>((x - low_.x) / size_), std::int64_t{0}, columns_ - 1);
  }
  [[nodiscard]] std::int64_t row_of(double y) const {
    return std::clamp(static_cast<std::int64_t>((y - low_.y) / size_), std::int64_t{0}, rows_ - 1);
  }
  [[nodiscard]] std::size_t cell_of(const PenPlace& place) const {
    return static_cast<std::size_t>(row_of(place.y) * columns_ + column_of(place.x));
  }

  std::span<const PenPlace> places_;
  PenPlace low_;
  double size_ = 1;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> members_;
};

// --- joining

// Ends of lines (2 n the first and 2 n + 1 the last point of line n) and which pairs of them are joined.
class Joins {
 public:
  Joins(std::span<const PenPlace> places, const std::vector<Corners>& lines) : places_(places), lines_(lines) {
    for (const Corners& line : lines) {
      ends_.push_back(places[line.front()]);
      ends_.push_back(places[line.back()]);
    }
    partner_.assign(ends_.size(), no_end);
  }

  // Joins the nearest ends first, and of those equally near (in steps of `unit`) the straightest continuation.
  void join(double distance, double unit) {
    if (!(distance > 0) || ends_.empty()) return;
    std::vector<std::uint32_t> open;
    for (std::uint32_t e = 0; e < ends_.size(); ++e)
      if (partner_[e] == no_end && lines_[e / 2].size() > 1) open.push_back(e);
    if (open.empty()) return;
    Cells cells(ends_);
    cells.fill(open);
    struct Pair {
      double steps, turn;
      std::uint32_t a, b;
    };
    std::vector<Pair> pairs;
    for (const std::uint32_t a : open) {
      cells.around(
          ends_[a],
          [&](std::uint32_t b) {
            if (b <= a || is_beyond(ends_[a], ends_[b], distance)) return;
            const double length = length_between(ends_[a], ends_[b]);
            if (length > distance) return;
            if (b == (a ^ 1U) && lines_[a / 2].size() < 3) return;  // it would go back along the line
            pairs.push_back({std::floor(length / unit), turn(a, b), a, b});
          },
          [&](double from) { return from > distance; });
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
      if (p.steps != q.steps) return p.steps < q.steps;
      if (p.turn != q.turn) return p.turn < q.turn;
      return p.a != q.a ? p.a < q.a : p.b < q.b;
    });
    for (const Pair& pair : pairs) {
      if (partner_[pair.a] != no_end || partner_[pair.b] != no_end) continue;
      partner_[pair.a] = pair.b;
      partner_[pair.b] = pair.a;
    }
  }

  // The joined lines.
  [[nodiscard]] std::vector<Corners> result() const {
    std::vector<Corners> joined;
    std::vector<bool> done(lines_.size(), false);
    const auto follow = [&](std::uint32_t from) {
      Corners line;
      for (std::uint32_t end = from; end != no_end && !done[end / 2]; end = partner_[end ^ 1U]) {
        done[end / 2] = true;
        const Corners& next = lines_[end / 2];
        if (end % 2 == 0) {
          line.insert(line.end(), next.begin(), next.end());
        } else {
          line.insert(line.end(), next.rbegin(), next.rend());
        }
      }
      return line;
    };
    for (std::uint32_t e = 0; e < ends_.size(); ++e)
      if (partner_[e] == no_end && !done[e / 2]) joined.push_back(follow(e));
    for (std::uint32_t n = 0; n < lines_.size(); ++n) {
      if (done[n]) continue;
      const std::uint32_t first = 2 * n;
      joined.push_back(follow(first));
      joined.back().push_back(joined.back().front());  // closed
    }
    return joined;
  }

 private:
  // 0 for a straight continuation, up to 2.
  [[nodiscard]] double turn(std::uint32_t a, std::uint32_t b) const {
    const PenPlace out = direction(a);
    const PenPlace in = direction(b);
    return 1 + out.x * in.x + out.y * in.y;
  }
  // Outwards from the line's end, of length 1.
  [[nodiscard]] PenPlace direction(std::uint32_t end) const {
    const Corners& line = lines_[end / 2];
    const PenPlace& tip = ends_[end];
    const PenPlace& before = places_[end % 2 == 0 ? line[1] : line[line.size() - 2]];
    const double length = length_between(tip, before);
    return length > 0 ? PenPlace{(tip.x - before.x) / length, (tip.y - before.y) / length} : PenPlace{};
  }

  std::span<const PenPlace> places_;
  const std::vector<Corners>& lines_;
  std::vector<PenPlace> ends_;
  std::vector<std::uint32_t> partner_;
};

// --- corners on straight lines

double distance_from_line(const PenPlace& p, const PenPlace& a, const PenPlace& b) {
  const double length = length_between(a, b);
  if (length == 0) return length_between(p, a);
  const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length;
  if (along < 0) return length_between(p, a);
  if (along > length) return length_between(p, b);
  return std::abs((p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x)) / length;
}

// Each run is extended while all points that it skips are near to it.
Corners straighten(const Corners& line, std::span<const PenPlace> places, double tolerance) {
  constexpr std::size_t longest_run = 1000;
  Corners result{line[0]};
  std::size_t from = 0;
  while (from + 1 < line.size()) {
    std::size_t to = from + 1;
    const auto reaches = [&](std::size_t end) {
      for (std::size_t i = from + 1; i < end; ++i)
        if (distance_from_line(places[line[i]], places[line[from]], places[line[end]]) > tolerance) return false;
      return true;
    };
    while (to + 1 < line.size() && to - from < longest_run && reaches(to + 1)) ++to;
    result.push_back(line[to]);
    from = to;
  }
  return result;
}

// --- the order

// A tour through lines, each traversed in one of two directions; ends are numbered as in Joins.
class Tour {
 public:
  Tour(std::span<const PenPlace> places, std::vector<Corners>& lines, const PenPlace& start)
      : places_(places), lines_(lines), start_(start), count_(static_cast<std::uint32_t>(lines.size())) {}

  // Returns the tour as the end at which each line is begun.
  std::vector<std::uint32_t> run() {
    if (count_ == 0) return {};
    nearest_first();
    for (std::uint32_t n = 0; n < count_; ++n) {
      ends_.push_back(places_[lines_[n].front()]);
      ends_.push_back(places_[lines_[n].back()]);
    }
    position_.resize(count_);
    for (std::uint32_t i = 0; i < count_; ++i) position_[order_[i] / 2] = i;
    if (count_ > 2) {
      find_neighbours();
      improve();
    }
    begin_closed_lines();
    return order_;
  }

 private:
  [[nodiscard]] bool is_closed(std::uint32_t line) const {
    const Corners& corners = lines_[line];
    const PenPlace& a = places_[corners.front()];
    const PenPlace& b = places_[corners.back()];
    return corners.size() > 3 && a.x == b.x && a.y == b.y;
  }

  // Makes a closed line begin at this corner.
  void rotate(std::uint32_t line, std::size_t corner) {
    Corners& corners = lines_[line];
    corners.pop_back();
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(corner), corners.end());
    corners.push_back(corners.front());
  }

  // A place where a line can begin.
  struct StartPlace {
    std::uint32_t line;
    std::uint32_t corner;
  };

  void nearest_first() {
    std::vector<StartPlace> starts;
    std::vector<PenPlace> at;
    for (std::uint32_t n = 0; n < count_; ++n) {
      const auto add = [&](std::size_t corner) {
        starts.push_back({n, static_cast<std::uint32_t>(corner)});
        at.push_back(places_[lines_[n][corner]]);
      };
      if (is_closed(n)) {
        for (std::size_t c = 0; c + 1 < lines_[n].size(); ++c) add(c);
      } else {
        add(0);
        if (lines_[n].size() > 1) add(lines_[n].size() - 1);
      }
    }
    std::vector<bool> done(count_, false);
    std::vector<std::uint32_t> left(starts.size());
    std::iota(left.begin(), left.end(), 0U);
    Cells cells(at);
    cells.fill(left);
    std::size_t filled = left.size();
    std::size_t open = left.size();
    PenPlace pen = start_;
    for (std::uint32_t n = 0; n < count_; ++n) {
      // Searching many nearly empty cells is slow.
      if (4 * open < filled) {
        left.erase(std::remove_if(left.begin(), left.end(), [&](std::uint32_t d) { return done[starts[d].line]; }), left.end());
        cells.fill(left);
        filled = open = left.size();
      }
      std::uint32_t best = no_end;
      double nearest = std::numeric_limits<double>::max();
      cells.around(
          pen,
          [&](std::uint32_t d) {
            if (is_beyond(pen, at[d], nearest) || done[starts[d].line]) return;
            const double distance = length_between(pen, at[d]);
            if (distance < nearest || (distance == nearest && d < best)) {
              nearest = distance;
              best = d;
            }
          },
          [&](double from) { return nearest <= from; });
      const StartPlace door = starts[best];
      done[door.line] = true;
      const bool closed = is_closed(door.line);
      open -= closed ? lines_[door.line].size() - 1 : std::min<std::size_t>(lines_[door.line].size(), 2);
      if (closed) rotate(door.line, door.corner);
      order_.push_back(2 * door.line + (closed || door.corner == 0 ? 0U : 1U));
      pen = places_[closed || door.corner != 0 ? lines_[door.line].front() : lines_[door.line].back()];
    }
  }

  static constexpr std::size_t most_neighbours = 8;

  void find_neighbours() {
    std::vector<std::uint32_t> all(ends_.size());
    std::iota(all.begin(), all.end(), 0U);
    Cells cells(ends_);
    cells.fill(all);
    neighbours_.assign(ends_.size() * most_neighbours, no_end);
    std::vector<std::pair<double, std::uint32_t>> near;
    for (const std::uint32_t e : all) {
      near.clear();
      cells.around(
          ends_[e],
          [&](std::uint32_t f) {
            if (f / 2 != e / 2) near.emplace_back(length_between(ends_[e], ends_[f]), f);
          },
          [&](double from) {
            return near.size() >= most_neighbours &&
                   std::count_if(near.begin(), near.end(), [from](const auto& n) { return n.first <= from; }) >=
                       static_cast<std::ptrdiff_t>(most_neighbours);
          });
      const std::size_t kept = std::min(near.size(), most_neighbours);
      std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end());
      for (std::size_t k = 0; k < kept; ++k) neighbours_[e * most_neighbours + k] = near[k].second;
    }
  }

  // By position in the tour: where line i is begun and left. Before the first line is the start; after the last, nothing.
  [[nodiscard]] std::uint32_t entry(std::uint32_t i) const { return order_[i]; }
  [[nodiscard]] const PenPlace& left_at(std::int64_t i) const {
    return i < 0 ? start_ : ends_[order_[static_cast<std::size_t>(i)] ^ 1U];
  }
  [[nodiscard]] double to_next(const PenPlace& from, std::int64_t next) const {
    return next < static_cast<std::int64_t>(count_) ? length_between(from, ends_[order_[static_cast<std::size_t>(next)]]) : 0;
  }

  void note(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i <= last; ++i) position_[order_[i] / 2] = i;
  }

  [[nodiscard]] std::vector<std::uint32_t>::iterator at(std::int64_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); }

  void turn_round(std::uint32_t first, std::uint32_t last) {
    std::reverse(at(first), at(last) + 1);
    for (std::uint32_t i = first; i <= last; ++i) order_[i] ^= 1U;
    note(first, last);
  }

  // Moves lines first to last between `after` and the next line, reversed if `turned`.
  void move(std::uint32_t first, std::uint32_t last, std::int64_t after, bool turned) {
    if (turned) turn_round(first, last);
    if (after > last) {
      std::rotate(at(first), at(last) + 1, at(after) + 1);
      note(first, static_cast<std::uint32_t>(after));
    } else {
      std::rotate(at(after) + 1, at(first), at(last) + 1);
      note(static_cast<std::uint32_t>(after + 1), last);
    }
  }

  void improve() {
    // Reversing and moving take time in proportion to the distance in the tour, so distant pairs are skipped in large
    // drawings.
    reach_ = std::max<std::int64_t>(1000, 30'000'000 / count_);
    std::vector<std::uint32_t> waiting(count_);
    for (std::uint32_t i = 0; i < count_; ++i) waiting[i] = order_[count_ - 1 - i] / 2;
    std::vector<bool> waits(count_, true);
    std::int64_t budget = 60 * std::int64_t{count_};
    while (!waiting.empty() && budget-- > 0) {
      const std::uint32_t line = waiting.back();
      waiting.pop_back();
      waits[line] = false;
      touched_.clear();
      if (!improve_at(2 * line) && !improve_at(2 * line + 1)) continue;
      for (const std::uint32_t other : touched_) {
        if (waits[other]) continue;
        waits[other] = true;
        waiting.push_back(other);
      }
    }
  }

  [[nodiscard]] bool is_near(std::int64_t a, std::int64_t b) const { return std::abs(a - b) <= reach_; }

  void touch(std::int64_t position) {
    for (std::int64_t i = std::max<std::int64_t>(position - 1, 0);
         i <= std::min<std::int64_t>(position + 1, std::int64_t{count_} - 1); ++i)
      touched_.push_back(order_[static_cast<std::size_t>(i)] / 2);
  }

  bool improve_at(std::uint32_t e) {
    constexpr double least_gain = 1e-9;
    const std::int64_t i = position_[e / 2];
    const bool leaves = order_[static_cast<std::size_t>(i)] != e;  // e is the end at which its line is left
    // The travel that is replaced: after e, or before it.
    const double old = leaves ? to_next(ends_[e], i + 1) : length_between(left_at(i - 1), ends_[e]);
    for (std::size_t k = 0; k < most_neighbours; ++k) {
      const std::uint32_t f = neighbours_[e * most_neighbours + k];
      if (f == no_end) break;
      const double link = length_between(ends_[e], ends_[f]);
      if (link >= old) break;
      const std::int64_t j = position_[f / 2];
      if (!is_near(i, j)) continue;
      const bool f_leaves = order_[static_cast<std::size_t>(j)] != f;
      if (leaves && f_leaves && j > i) {
        // Reverse i+1 .. j.
        const double gain = old + to_next(ends_[f], j + 1) - link -
                            to_next(ends_[entry(static_cast<std::uint32_t>(i + 1))], j + 1);
        if (gain > least_gain) return turn(i + 1, j);
      }
      if (!leaves && !f_leaves && j < i) {
        // Reverse j .. i-1.
        const double gain = old + length_between(left_at(j - 1), ends_[f]) - link -
                            length_between(left_at(j - 1), left_at(i - 1));
        if (gain > least_gain) return turn(j, i - 1);
      }
      for (std::int64_t more = 0; more < 3; ++more) {
        // The lines from f on that are moved, with f next to e.
        const std::int64_t first = f_leaves ? j - more : j;
        const std::int64_t last = f_leaves ? j : j + more;
        const std::int64_t after = leaves ? i : i - 1;
        if (first < 0 || last >= count_ || (after >= first - 1 && after <= last)) continue;
        const bool turned = leaves == f_leaves;
        const PenPlace& far = f_leaves ? ends_[entry(static_cast<std::uint32_t>(first))] : left_at(last);
        const double before =
            length_between(left_at(first - 1), ends_[entry(static_cast<std::uint32_t>(first))]) +
            to_next(left_at(last), last + 1);
        const double closed = to_next(left_at(first - 1), last + 1);
        const double other = leaves ? to_next(far, i + 1) : length_between(left_at(i - 1), far);
        if (old + before - closed - link - other <= least_gain) continue;
        touch(first);
        touch(last);
        touch(after);
        move(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), after, turned);
        touch(after);
        return true;
      }
    }
    return false;
  }

  bool turn(std::int64_t first, std::int64_t last) {
    touch(first);
    touch(last);
    turn_round(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last));
    return true;
  }

  // Chooses the corner of each closed line that gives the least travel.
  void begin_closed_lines() {
    for (std::int64_t i = 0; i < count_; ++i) {
      const std::uint32_t line = order_[static_cast<std::size_t>(i)] / 2;
      if (!is_closed(line)) continue;
      const auto cost = [&](std::size_t corner) {
        const PenPlace& at = places_[lines_[line][corner]];
        return length_between(left_at(i - 1), at) + to_next(at, i + 1);
      };
      std::size_t best = 0;
      for (std::size_t c = 1; c + 1 < lines_[line].size(); ++c)
        if (cost(c) < cost(best)) best = c;
      if (best == 0) continue;
      rotate(line, best);
      ends_[2 * line] = ends_[2 * line + 1] = places_[lines_[line].front()];
    }
  }

  std::span<const PenPlace> places_;
  std::vector<Corners>& lines_;
  PenPlace start_;
  std::uint32_t count_;
  std::int64_t reach_ = 0;
  std::vector<PenPlace> ends_;
  std::vector<std::uint32_t> order_;     // the end at which each line is begun
  std::vector<std::uint32_t> position_;  // by line: position in the order
  std::vector<std::uint32_t> neighbours_;
  std::vector<std::uint32_t> touched_;
};

// The points of a drawing on paper.
std::vector<PenPlace> places_on(const VectorDrawing& drawing, const Paper& paper) {
  const double across = (paper.width - 2 * paper.margin) / drawing.width;
  const double up = (paper.height - 2 * paper.margin) / drawing.height;
  std::vector<PenPlace> places;
  places.reserve(drawing.points.size());
  for (const DrawingPoint& p : drawing.points) places.push_back({paper.margin + p.x * across, paper.margin + p.y * up});
  return places;
}

// Calls visit(previous place or null, place) for the corners of all lines, pen by pen. Null: the pen is lowered here.
template <class Visit, class Change>
void for_corners(const VectorDrawing& drawing, const Paper& paper, Visit visit, Change change) {
  const std::vector<PenPlace> places = places_on(drawing, paper);
  for (std::uint32_t layer = 0; layer < drawing.layers.size(); ++layer) {
    bool first = true;
    for (const DrawingLine& line : drawing.lines) {
      if (line.layer != layer || line.count == 0) continue;
      if (std::exchange(first, false)) change();
      for (std::uint32_t i = 0; i < line.count; ++i)
        visit(i == 0 ? nullptr : &places[line.first + i - 1], places[line.first + i]);
    }
  }
}

}  // namespace

VectorDrawing in_pen_order(const VectorDrawing& drawing, const Paper& paper, const PenOptions& options) {
  const std::vector<PenPlace> places = places_on(drawing, paper);
  VectorDrawing result;
  result.width = drawing.width;
  result.height = drawing.height;
  result.layers = drawing.layers;
  result.points.reserve(drawing.points.size());
  PenPlace pen{};
  for (std::uint32_t layer = 0; layer < drawing.layers.size(); ++layer) {
    std::vector<Corners> lines;
    for (const DrawingLine& line : drawing.lines) {
      if (line.layer != layer || line.count == 0) continue;
      Corners& corners = lines.emplace_back();
      for (std::uint32_t i = 0; i < line.count; ++i) corners.push_back(line.first + i);
    }
    Joins joins(places, lines);
    joins.join(options.join, options.join);
    if (drawing.layers[layer].dash == 0) joins.join(options.min_gap, std::max(options.min_gap / 8, options.join));
    lines = joins.result();
    for (Corners& line : lines) line = straighten(line, places, options.straight);
    for (const std::uint32_t begun : Tour(places, lines, pen).run()) {
      Corners& line = lines[begun / 2];
      if (begun % 2 == 1) std::reverse(line.begin(), line.end());
      result.lines.push_back({layer, static_cast<std::uint32_t>(result.points.size()), static_cast<std::uint32_t>(line.size())});
      for (const std::uint32_t point : line) result.points.push_back(drawing.points[point]);
      pen = places[line.back()];
    }
  }
  for (const DrawingFacet& facet : drawing.facets) {
    result.facets.push_back({static_cast<std::uint32_t>(result.points.size()), facet.count, facet.colour});
    for (std::uint32_t i = 0; i < facet.count; ++i) result.points.push_back(drawing.points[facet.first + i]);
  }
  for (const DrawingArea& area : drawing.areas) {
    result.areas.push_back({static_cast<std::uint32_t>(result.points.size()), area.count, area.colour});
    for (std::uint32_t i = 0; i < area.count; ++i) result.points.push_back(drawing.points[area.first + i]);
  }
  return result;
}

PenTravel pen_travel(const VectorDrawing& drawing, const Paper& paper) {
  PenTravel travel;
  PenPlace pen{};
  for_corners(
      drawing, paper,
      [&](const PenPlace* before, const PenPlace& place) {
        (before == nullptr ? travel.up : travel.down) += length_between(before == nullptr ? pen : *before, place);
        if (before == nullptr) ++travel.lines;
        pen = place;
      },
      [&] { ++travel.pens; });
  travel.lifts = travel.lines;
  return travel;
}

double plot_seconds(const VectorDrawing& drawing, const Paper& paper, const PlotterSpeeds& speeds) {
  const auto seconds = [&](double length, double speed) {
    // From rest to rest: the top speed is reached if the distance is long enough.
    const double ramp = speed * speed / speeds.acceleration;
    return length >= ramp ? length / speed + speed / speeds.acceleration : 2 * std::sqrt(length / speeds.acceleration);
  };
  double total = 0;
  PenPlace pen{};
  for_corners(
      drawing, paper,
      [&](const PenPlace* before, const PenPlace& place) {
        total += before == nullptr ? seconds(length_between(pen, place), speeds.up) + 2 * speeds.lift
                                   : seconds(length_between(*before, place), speeds.down);
        pen = place;
      },
      [&] { total += speeds.pen_change; });
  return total;
}

}  // namespace sightline::picture
