// A lesson shows step by step how an algorithm makes a picture. `sightline explain` writes it; the page's theatre plays it.
//
// A lesson has sheets (the image, a plan of the ground, a circle of directions), and each sheet has layers. A step has a
// caption that says what the algorithm has just done, the section of the paper, the counts, and the new contents of the
// layers that change. All other layers keep their contents.
//
// Steps are made from the traces of the algorithms, so a lesson shows only what the algorithm did.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/json.hpp"

namespace sightline::explain {

// The style of a mark; the player has a colour for each in its light and its dark theme.
enum class Look : std::uint8_t {
  faint,    // background for comparison: the wire frame, the plan
  plain,    // part of the scene without special meaning
  now,      // the subject of this step
  other,    // the part that the subject is compared with
  seen,     // found to be visible
  hidden,   // found to be hidden
  waiting,  // to be processed later
  mask,     // the part of the image that is still open
};
[[nodiscard]] std::string_view name_of(Look look);

using Point = std::array<double, 2>;  // on a sheet, y upwards

struct Mark {
  enum class Kind : std::uint8_t { line, area, dot, text, label };
  Kind kind = Kind::line;
  Look look = Look::plain;
  std::vector<Point> points;  // line: two or more, connected; area: its corners; dot, text and label: one
  std::string text = {};
};
[[nodiscard]] inline Mark line(Look look, std::vector<Point> points) {
  return {Mark::Kind::line, look, std::move(points)};
}
[[nodiscard]] inline Mark area(Look look, std::vector<Point> corners) {
  return {Mark::Kind::area, look, std::move(corners)};
}
[[nodiscard]] inline Mark dot(Look look, Point at) { return {Mark::Kind::dot, look, {at}}; }
[[nodiscard]] inline Mark text(Look look, Point at, std::string words) {
  return {Mark::Kind::text, look, {at}, std::move(words)};
}
// The name of an area, centred on a point of it. (A text is placed beside its point.)
[[nodiscard]] inline Mark label(Look look, Point at, std::string words) {
  return {Mark::Kind::label, look, {at}, std::move(words)};
}

// A sheet shows the box from `low` to `high`, both axes at the same scale unless `stretched`.
struct Sheet {
  std::string title;  // "The image"
  Point low{};
  Point high{};
  bool stretched = false;
};

struct Layer {
  std::size_t sheet = 0;
  std::string name;         // layers of a sheet are drawn in the order in which they first appear
  std::vector<Mark> marks;  // the contents from this step on
};

struct Count {
  std::string name;
  std::uint64_t value = 0;
};

struct Step {
  std::string caption;         // one to three plain sentences
  std::string section;         // section of the paper: "section 4"; empty: none
  std::vector<Count> counts;   // the same names in every step
  std::vector<Layer> changes;
};

struct Lesson {
  std::string algorithm;  // "jones"
  std::string title;      // "Jones 1971: through the openings from cell to cell"
  std::string scene;
  std::vector<Sheet> sheets;
  std::vector<Step> steps;  // at least one
  bool cut = false;         // the lesson ended at most_steps
};

// A longer lesson ends with a step that says so.
inline constexpr std::size_t most_steps = 4000;

// Schema sightline/explain/1. Numbers have at most four decimals.
[[nodiscard]] std::string json_of(const Lesson& lesson);

}  // namespace sightline::explain
