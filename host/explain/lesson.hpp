// A picture made by an algorithm, step by step, as data: what the page's theatre plays and `sightline explain` writes.
//
// A lesson has sheets to draw on (the image, a plan of the ground, a circle of directions), and on each sheet
// layers. A step says in a caption what the algorithm has just done, where its paper says so, and what its counts
// are now; with it come the new contents of the layers that it changes. All other layers stay as they are, so a
// picture of step n is what the steps up to n have left in each layer.
//
// What is drawn comes from the algorithms' own traces: a step shown is a step taken.
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

// How a mark looks; the player gives each a colour in its light and its dark dress.
enum class Look : std::uint8_t {
  faint,    // there to be compared with: the wire frame, the plan
  plain,    // of the matter at hand, nothing special
  now,      // what this step is about
  other,    // what it is compared with
  seen,     // found to be visible
  hidden,   // found to be hidden
  waiting,  // still to come
  mask,     // a part of the image: what is left of it to look through
};
[[nodiscard]] std::string_view name_of(Look look);

using Point = std::array<double, 2>;  // on a sheet, y upwards

struct Mark {
  enum class Kind : std::uint8_t { line, area, dot, text, label };
  Kind kind = Kind::line;
  Look look = Look::plain;
  std::vector<Point> points;  // line: two or more, joined; area: a corner each; dot, text and label: one
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
// The name of an area: words centred on a point of it. A text is next to its point instead.
[[nodiscard]] inline Mark label(Look look, Point at, std::string words) {
  return {Mark::Kind::label, look, {at}, std::move(words)};
}

// A sheet shows the box from `low` to `high`, both axes to the same scale unless `stretched`.
struct Sheet {
  std::string title;  // "The image"
  Point low{};
  Point high{};
  bool stretched = false;
};

struct Layer {
  std::size_t sheet = 0;
  std::string name;         // layers of a sheet are drawn in the order in which they first come
  std::vector<Mark> marks;  // all it holds from this step on
};

struct Count {
  std::string name;
  std::uint64_t value = 0;
};

struct Step {
  std::string caption;         // one to three plain sentences
  std::string section;         // of the paper: "section 4"; empty: none
  std::vector<Count> counts;   // the same names in every step
  std::vector<Layer> changes;
};

struct Lesson {
  std::string algorithm;  // "jones"
  std::string title;      // "Jones 1971: through the openings from cell to cell"
  std::string scene;
  std::vector<Sheet> sheets;
  std::vector<Step> steps;  // at least one
  bool cut = false;         // there were more steps than most_steps
};

// A lesson longer than this ends with a step that says so.
inline constexpr std::size_t most_steps = 4000;

// Schema sightline/explain/1. Numbers have four digits behind the point at most.
[[nodiscard]] std::string json_of(const Lesson& lesson);

}  // namespace sightline::explain
