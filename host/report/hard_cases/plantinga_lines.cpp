// Events of a few edges and vertices, exact and in doubles.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/base/result.hpp"
#include "host/report/hard_cases/plantinga.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::plantinga;
using native::Segment;
using native::Vector3;

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  line = line.substr(0, line.find('#'));
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

// Whole numbers within the limit of events.
std::optional<std::int64_t> number_of(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative) word.remove_prefix(1);
  if (word.empty() || word.size() > 7) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : word) {
    if (c < '0' || c > '9') return std::nullopt;
    value = 10 * value + (c - '0');
  }
  if (value >= native::event_coordinate_limit) return std::nullopt;
  return negative ? -value : value;
}

bool append(EventLines& lines, const std::vector<std::string_view>& words) {
  std::vector<std::int64_t> numbers;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto number = number_of(words[i]);
    if (!number) return false;
    numbers.push_back(*number);
  }
  if (words[0] == "vertex" && numbers.size() == 3) {
    lines.vertices.push_back({numbers[0], numbers[1], numbers[2]});
    return true;
  }
  if (words[0] != "edge" || numbers.size() != 6) return false;
  lines.edges.push_back({{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}});
  return true;
}

// Every pair whose event is asked for.
std::vector<std::pair<Vector3, Segment>> pairs_of(const EventLines& lines) {
  std::vector<std::pair<Vector3, Segment>> pairs;
  for (const Vector3& vertex : lines.vertices)
    for (const Segment& edge : lines.edges) pairs.emplace_back(vertex, edge);
  if (!lines.vertices.empty() || lines.edges.size() != 2) return pairs;
  for (std::size_t i = 0; i < 2; ++i)
    for (const Vector3& end : {lines.edges[i].from, lines.edges[i].to})
      pairs.emplace_back(end, lines.edges[1 - i]);
  return pairs;
}

bool three(const EventLines& lines) {
  return lines.vertices.empty() && lines.edges.size() == 3;
}

// As in potential_events.hpp, X and Z of N, D and M.
struct NearCrossing {
  std::array<double, 2> n, d, m;
};
std::array<double, 3> reals(const Vector3& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
std::array<double, 2> cross_xz(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[0] * b[1] - a[1] * b[0]};
}
std::array<double, 3> difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
NearCrossing near_crossing(const Segment& edge, const Segment& other) {
  const auto from = difference(reals(other.from), reals(edge.from));
  const auto along = difference(reals(edge.to), reals(edge.from));
  const auto other_along = difference(reals(other.to), reals(other.from));
  return {cross_xz(from, other_along), cross_xz(along, other_along), cross_xz(from, along)};
}

// A direction and its opposite are one line: its angle from 0 to pi.
double angle_of_line(double x, double z) {
  const bool turned = x < 0 || (x == 0 && z < 0);
  return turned ? std::atan2(-x, -z) : std::atan2(x, z);
}

// The angles of the form's roots.
std::vector<double> roots_in_doubles(const NearCrossing& second, const NearCrossing& third) {
  const double xx = second.n[0] * third.d[0] - third.n[0] * second.d[0];
  const double xz = second.n[0] * third.d[1] + second.n[1] * third.d[0] - third.n[0] * second.d[1] -
                    third.n[1] * second.d[0];
  const double zz = second.n[1] * third.d[1] - third.n[1] * second.d[1];
  const double discriminant = xz * xz - 4 * xx * zz;
  if (!(discriminant > 0)) return {};
  const double q = -(xz + std::copysign(std::sqrt(discriminant), xz)) / 2;
  return {angle_of_line(q, xx), angle_of_line(zz, q)};
}

bool inside(double value, double of) {
  const double at = value / of;
  return at > 0 && at < 1;
}

bool meets_inside(const NearCrossing& crossing, double angle) {
  const auto at = [angle](const std::array<double, 2>& form) {
    return form[0] * std::sin(angle) + form[1] * std::cos(angle);
  };
  return inside(at(crossing.n), at(crossing.d)) && inside(at(crossing.m), at(crossing.d));
}

}  // namespace

base::Result<EventLines> read_event_lines(std::string_view text) {
  EventLines lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const auto words = words_of(text.substr(0, end));
    if (!words.empty() && !append(lines, words))
      return base::fail(fmt::format(
          "line {}: found \"{}\", expected vertex x y z or edge x y z x y z in whole numbers below 2^23",
          number, text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<native::Direction> events_of(const EventLines& lines, bool whole_lines) {
  std::vector<native::Direction> events;
  if (three(lines)) {
    const std::array<Segment, 3> edges{lines.edges[0], lines.edges[1], lines.edges[2]};
    events = whole_lines ? native::roots_of(native::meeting_form(native::crossing_of(edges[0], edges[1]),
                                                                 native::crossing_of(edges[0], edges[2])))
                         : native::three_edge_events(edges);
  }
  for (const auto& [vertex, edge] : pairs_of(lines)) {
    const auto both = native::vertex_edge_events(vertex, edge);
    events.insert(events.end(), both.begin(), both.end());
  }
  native::sort_and_group(events);
  return events;
}

std::size_t event_count_in_doubles(const EventLines& lines, bool whole_lines) {
  std::vector<double> angles;
  if (three(lines)) {
    const NearCrossing second = near_crossing(lines.edges[0], lines.edges[1]);
    const NearCrossing third = near_crossing(lines.edges[0], lines.edges[2]);
    for (const double angle : roots_in_doubles(second, third)) {
      if (whole_lines || (meets_inside(second, angle) && meets_inside(third, angle))) angles.push_back(angle);
    }
  }
  for (const auto& [vertex, edge] : pairs_of(lines)) {
    const auto low = static_cast<double>(edge.from[1]);
    const auto along = difference(reals(edge.to), reals(edge.from));
    const double at = (static_cast<double>(vertex[1]) - low) / along[1];
    const auto m = cross_xz(difference(reals(vertex), reals(edge.from)), along);
    if (at >= 0 && at <= 1 && (m[0] != 0 || m[1] != 0)) angles.push_back(angle_of_line(m[1], -m[0]));
  }
  std::sort(angles.begin(), angles.end());
  return 2 * static_cast<std::size_t>(std::unique(angles.begin(), angles.end()) - angles.begin());
}

}  // namespace sightline::harness::report
