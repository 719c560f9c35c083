// The list of errors that the parts of check_scene write to, and how they name things.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/check/cell_scene.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::scene {

inline constexpr const char* axis_names = "xyz";

[[nodiscard]] inline std::string axis_name(std::size_t axis) {
  return {axis_names[axis]};
}

[[nodiscard]] inline std::string text_of(const geometry::Point& p) {
  return "(" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + ")";
}

// "x 0..600"
[[nodiscard]] inline std::string text_of(std::size_t axis, geometry::Span span) {
  return axis_name(axis) + " " + std::to_string(span.low) + ".." + std::to_string(span.high);
}

// The first of one or more errors, which says how many there are.
[[nodiscard]] inline base::Error first_of(const std::vector<base::Error>& errors) {
  base::Error first = errors.front();
  if (errors.size() > 1) first.found += " (the first of " + std::to_string(errors.size()) + " errors)";
  return first;
}

class Problems {
 public:
  // Nothing is added beyond most_scene_errors, and no error twice (a face has two sides).
  void add(std::string place, std::string cause) {
    base::Error error{"", std::move(place), std::move(cause)};
    if (!full() && std::find(errors_.begin(), errors_.end(), error) == errors_.end()) {
      errors_.push_back(std::move(error));
    }
  }
  void add(const char* kind, std::size_t number, std::string cause) {
    add(std::string(kind) + " " + std::to_string(number), std::move(cause));
  }

  [[nodiscard]] bool none() const { return errors_.empty(); }
  [[nodiscard]] bool full() const { return errors_.size() >= most_scene_errors; }
  [[nodiscard]] std::vector<base::Error> take() { return std::move(errors_); }

 private:
  std::vector<base::Error> errors_;
};

}  // namespace sightline::scene
