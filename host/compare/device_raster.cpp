// See device_raster.hpp.
#include "host/compare/device_raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <unordered_map>
#include <utility>

#include "emulators/type340/vector_generator.hpp"
#include "host/programs/skala/projection.hpp"
#include "host/picture/line_metrics_parts.hpp"

namespace sightline::compare {
namespace {

using picture::LinePart;
using picture::PixelGrid;
using picture::PixelPoint;
using picture::PixelSegment;
using picture::ReferenceLine;

struct GridPoint {
  int x = 0;
  int y = 0;

  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

int sign_of(int value) {
  return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}

void light(PixelGrid& grid, const GridPoint& at) {
  if (at.x >= 0 && at.x < grid.width && at.y >= 0 && at.y < grid.height) grid.set(at.x, at.y, 1);
}

// Builds a line of the Type 340: vector words from the position of the beam.
class Beam {
 public:
  Beam(PixelGrid& grid, const GridPoint& from, const GridPoint& to)
      : grid_(grid), at_(from), right_(sign_of(to.x - from.x)), up_(sign_of(to.y - from.y)) {
    light(grid_, at_);
  }

  // A vector word with these magnitudes, 0 to 127.
  void word(int dx, int dy) {
    const auto x = static_cast<std::uint8_t>(dx);
    const auto y = static_cast<std::uint8_t>(dy);
    type340::RateMultiplier multiplier;
    for (int pulse = type340::pulses_of_vector(x, y); pulse > 0; --pulse) {
      const auto step = multiplier.count(x, y);
      at_.x += step.x ? right_ : 0;
      at_.y += step.y ? up_ : 0;
      light(grid_, at_);
    }
  }

 private:
  PixelGrid& grid_;
  GridPoint at_;
  int right_;
  int up_;
};

constexpr int longest_word = 127;

// firmware/pdp7/jones/SPECIFICATION.md, section 5.
void jones_words(Beam& beam, int dx, int dy) {
  const int words = (std::max(dx, dy) + longest_word - 1) / longest_word;
  GridPoint done;
  for (int i = 1; i <= words; ++i) {
    const GridPoint sum{(i * dx + words / 2) / words, (i * dy + words / 2) / words};
    beam.word(sum.x - done.x, sum.y - done.y);
    done = sum;
  }
}

// firmware/pdp7/turn/SPECIFICATION.md, section 6.
void turn_words(Beam& beam, int dx, int dy) {
  const bool along_x = dx >= dy;
  const int whole = std::max(dx, dy);
  const int lesser = std::min(dx, dy);
  GridPoint left{whole, lesser};
  const auto word = [&](int major, int minor) {
    beam.word(along_x ? major : minor, along_x ? minor : major);
    left = {left.x - major, left.y - minor};
  };
  int error = whole / 2 - whole;
  while (left.x > longest_word) {
    int minor = longest_word * lesser / whole;
    error += longest_word * lesser % whole;
    if (error >= 0) {
      error -= whole;
      ++minor;
    }
    word(longest_word, minor);
  }
  word(left.x, left.y);
}

double distance_from_line(const PixelSegment& line, const PixelPoint& point) {
  const PixelPoint foot = picture::point_at(line, picture::place_on(line, point));
  return std::hypot(point.x - foot.x, point.y - foot.y);
}

// Visits every dot of a line of Skala's program with its position on the unrounded line.
template <class Visit>
void for_dots(const PixelSegment& image, const Visit& visit) {
  const auto nearest_point = [](const PixelPoint& p) {
    constexpr int last = programs::skala::raster_side - 1;
    return GridPoint{std::clamp(programs::skala::raster_coordinate(p.x), 0, last),
                     std::clamp(programs::skala::raster_coordinate(p.y), 0, last)};
  };
  GridPoint at = nearest_point(image.a);
  const GridPoint end = nearest_point(image.b);
  const int u = std::abs(end.x - at.x);
  const int v = std::abs(end.y - at.y);
  const bool along_x = u >= v;
  const int length = std::max(u, v);
  const int lesser = std::min(u, v);
  const GridPoint way{sign_of(end.x - at.x), sign_of(end.y - at.y)};
  const double extent = along_x ? image.b.x - image.a.x : image.b.y - image.a.y;
  const auto place = [&] {
    const double from = along_x ? at.x - image.a.x : at.y - image.a.y;
    return length == 0 ? 0.5 : std::clamp(from / extent, 0.0, 1.0);
  };
  visit(at, place());
  int error = end.x >= at.x ? -((length + 1) >> 1) : -((length >> 1) + 1);
  for (int i = 0; i < length; ++i) {
    error += lesser;
    if (error >= 0) {
      (along_x ? at.y : at.x) += along_x ? way.y : way.x;
      error -= length;
    }
    (along_x ? at.x : at.y) += along_x ? way.x : way.y;
    visit(at, place());
  }
}

}  // namespace

PixelGrid points_of(std::span<const core::Stroke> strokes, int side) {
  PixelGrid grid(side, side);
  for (const core::Stroke& stroke : strokes) light(grid, {stroke.x, stroke.y});
  return grid;
}

PixelGrid points_of(const core::Raster& raster) {
  PixelGrid grid(core::Raster::width, core::Raster::height);
  for (std::size_t i = 0; i < grid.values.size(); ++i) grid.values[i] = raster.points()[i] != 0 ? 1 : 0;
  return grid;
}

PixelGrid points_of(std::span<const picture::PenPath> paths, int side) {
  PixelGrid grid(side, side);
  for (const picture::PenPath& path : paths) {
    for (std::size_t i = 0; i < path.corners.size(); ++i) {
      const picture::PenPoint to = path.corners[i];
      GridPoint at{to.x, to.y};
      if (i > 0) at = {path.corners[i - 1].x, path.corners[i - 1].y};
      light(grid, at);
      while (at != GridPoint{to.x, to.y}) {
        at = {at.x + sign_of(to.x - at.x), at.y + sign_of(to.y - at.y)};
        light(grid, at);
      }
    }
  }
  return grid;
}

PixelGrid type340_points(std::span<const PixelSegment> lines, LongLines program) {
  PixelGrid grid(picture::screen_points, picture::screen_points);
  const auto round_half_up = [](double value) {
    return static_cast<int>(std::clamp(std::floor(value + 0.5), 0.0, picture::screen_points - 1.0));
  };
  for (const PixelSegment& line : lines) {
    const GridPoint from{round_half_up(line.a.x), round_half_up(line.a.y)};
    const GridPoint to{round_half_up(line.b.x), round_half_up(line.b.y)};
    const int dx = std::abs(to.x - from.x);
    const int dy = std::abs(to.y - from.y);
    if (program == LongLines::jones && from == to) continue;
    Beam beam(grid, from, to);
    program == LongLines::jones ? jones_words(beam, dx, dy) : turn_words(beam, dx, dy);
  }
  return grid;
}

std::vector<PixelSegment> divide_like(std::span<const PixelSegment> lines, std::span<const PixelSegment> pieces,
                                     double near) {
  std::vector<PixelSegment> divided;
  for (const PixelSegment& line : lines) {
    const double length = picture::length_of(line);
    std::vector<double> places{0, 1};
    for (const PixelSegment& piece : pieces) {
      if (length <= near) break;
      if (distance_from_line(line, piece.a) > near || distance_from_line(line, piece.b) > near) continue;
      for (const PixelPoint& end : {piece.a, piece.b}) {
        const double place = picture::place_on(line, end);
        // A place within `near` of an end counts as that end.
        if (place * length > near && (1 - place) * length > near) places.push_back(place);
      }
    }
    std::sort(places.begin(), places.end());
    PixelPoint from = line.a;
    double last = 0;
    for (std::size_t i = 1; i < places.size(); ++i) {
      // Where a piece ends and the next begins, there is one place.
      if (i + 1 < places.size() && (places[i] - last) * length <= near) continue;
      last = places[i];
      const PixelPoint to = i + 1 < places.size() ? picture::point_at(line, last) : line.b;
      divided.push_back({from, to});
      from = to;
    }
  }
  return divided;
}

ComparedFlashes compare_flashes(std::span<const PixelSegment> exact, std::span<const PixelSegment> pieces,
                                std::span<const core::Stroke> pass) {
  ComparedFlashes compared{type340_points(divide_like(exact, pieces)), points_of(pass), {}};
  compared.difference = picture::raster_difference(compared.truth, compared.shown);
  return compared;
}

std::vector<PixelSegment> visible_segments(std::span<const ReferenceLine> lines) {
  std::vector<PixelSegment> segments;
  for (const ReferenceLine& line : lines)
    for (const LinePart& part : line.visible)
      segments.push_back({picture::point_at(line.image, part.low), picture::point_at(line.image, part.high)});
  return segments;
}

std::vector<ReferenceLine> lines_as_drawn(std::vector<ReferenceLine> lines, std::span<const picture::DrawnPiece> pieces) {
  std::unordered_map<picture::LineId, std::size_t> index;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].visible.clear();
    index.emplace(lines[i].id, i);
  }
  for (const picture::DrawnPiece& piece : pieces) {
    const auto found = index.find(piece.line);
    if (found == index.end()) continue;
    ReferenceLine& line = lines[found->second];
    const double a = picture::place_on(line.image, piece.image.a);
    const double b = picture::place_on(line.image, piece.image.b);
    line.visible.push_back({std::clamp(std::min(a, b), 0.0, 1.0), std::clamp(std::max(a, b), 0.0, 1.0)});
  }
  for (ReferenceLine& line : lines) line.visible = picture::united(std::move(line.visible));
  return lines;
}

PixelGrid skala_points(std::span<const ReferenceLine> lines, SkalaDevice device) {
  // Of positions on a line and its visible parts.
  constexpr double rounding = 1e-9;
  PixelGrid grid(programs::skala::raster_side, programs::skala::raster_side);
  const std::size_t least_run = device == SkalaDevice::plotter ? 2 : 1;
  std::vector<GridPoint> run;
  const auto end_run = [&] {
    if (run.size() >= least_run)
      for (const GridPoint& at : run) light(grid, at);
    run.clear();
  };
  for (const ReferenceLine& line : lines) {
    bool first = true;
    for_dots(line.image, [&](const GridPoint& at, double place) {
      const bool seen = std::any_of(line.visible.begin(), line.visible.end(), [&](const LinePart& part) {
        return part.low - rounding <= place && place <= part.high + rounding;
      });
      // A line that begins where the previous one ended continues it.
      const bool joined = first && !run.empty() && run.back() == at;
      if (first && !joined) end_run();
      first = false;
      if (!seen)
        end_run();
      else if (!joined)
        run.push_back(at);
    });
  }
  end_run();
  return grid;
}

PixelGrid stripes_pen_points(const PixelGrid& faces) {
  PixelGrid grid(faces.width + 1, faces.height + 1);
  // Clamped, so that a face that extends beyond the picture has no side at its border.
  const auto face = [&](int x, int y) { return faces.at(std::clamp(x, 0, faces.width - 1), std::clamp(y, 0, faces.height - 1)); };
  for (int y = 0; y < faces.height; ++y) {
    for (int x = 0; x < faces.width; ++x) {
      const std::uint32_t here = face(x, y);
      if (here != face(x - 1, y)) {
        light(grid, {x, y});
        light(grid, {x, y + 1});
      }
      if (here != face(x, y - 1)) {
        light(grid, {x, y});
        light(grid, {x + 1, y});
      }
    }
  }
  return grid;
}

}  // namespace sightline::compare
