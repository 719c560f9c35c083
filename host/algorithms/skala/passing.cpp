#include "host/algorithms/skala/passing.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::algorithms::skala {
namespace {

// The parameter of a vertex on the line from one vertex to another.
double part_of(Vertex from, Vertex to, Vertex at) {
  const double dx = double{to.x} - from.x;
  const double dy = double{to.y} - from.y;
  if (at == from || (dx == 0 && dy == 0)) return 0;
  if (at == to) return 1;
  return std::clamp(std::abs(dx) > std::abs(dy) ? (double{at.x} - from.x) / dx : (double{at.y} - from.y) / dy, 0.0, 1.0);
}

}  // namespace

LinePart leading_part(std::span<const double> from, std::span<const double> to) {
  LinePart part{0, 1};
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] >= 0 && to[i] >= 0) continue;
    if (from[i] <= 0 && to[i] <= 0) return {1, 0};
    const double meets = from[i] / (from[i] - to[i]);
    if (from[i] > 0) part.to = std::min(part.to, meets);
    else part.from = std::max(part.from, meets);
  }
  return part;
}

std::vector<Piece> visible_pieces(Vertex from, Vertex to, const LinePart& leads, const std::vector<Piece>& before,
                              const std::vector<Piece>& after) {
  std::vector<LinePart> parts;
  const auto take = [&](const std::vector<Piece>& pieces, double low, double high) {
    for (const Piece& piece : pieces) {
      const double begin = std::max(low, part_of(from, to, piece.from));
      const double end = std::min(high, part_of(from, to, piece.to));
      if (begin < end) parts.push_back({begin, end});
    }
  };
  if (leads.from < leads.to) {
    take(after, 0, leads.from);
    take(before, leads.from, leads.to);
    take(after, leads.to, 1);
  } else {
    take(after, 0, 1);
  }
  const auto at = [&](double t) {
    if (t == 0) return from;
    if (t == 1) return to;
    return Vertex{static_cast<float>(from.x + t * (double{to.x} - from.x)), static_cast<float>(from.y + t * (double{to.y} - from.y))};
  };
  std::vector<Piece> seen;
  constexpr double touch = 1e-6;
  for (std::size_t i = 0; i < parts.size();) {
    double end = parts[i].to;
    std::size_t next = i + 1;
    for (; next < parts.size() && parts[next].from <= end + touch; ++next) end = parts[next].to;
    seen.push_back({at(parts[i].from), at(end)});
    i = next;
  }
  return seen;
}

std::optional<std::array<Meeting, 2>> meeting_line(const std::array<double, 3>& differences) {
  std::array<Meeting, 2> ends;
  std::size_t found = 0;
  for (std::size_t i = 0; i < 3 && found < 2; ++i) {
    const std::size_t next = (i + 1) % 3;
    if ((differences[i] > 0) == (differences[next] > 0)) continue;
    ends[found++] = {i, next, differences[i] / (differences[i] - differences[next])};
  }
  if (found < 2) return std::nullopt;
  return ends;
}

}  // namespace sightline::algorithms::skala
