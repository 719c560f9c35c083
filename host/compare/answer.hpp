// One answer at a glance: how fast and how wrong each method is on each scene, one row a method and scene, over one view or many.
//
// What `compare` prints, `sweep` ends with, the report opens with and `demo` writes is this table; the measures of a view are those of
// scenes.hpp and heights.hpp, brought to the same few numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/json.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/scenes.hpp"
#include "host/picture/raster_difference.hpp"

namespace sightline::compare {

// One view by one method.
struct MethodView {
  std::string method;      // "jones-pdp7"
  std::string picture;     // "lines", "faces", "dots"
  std::string rounding;    // of the coordinates measured: "points", "dots" or "pixels" of the device, "1/8 point", "none"
  std::string unit;        // of the next three: "px", "points", "dots"
  double all = 0;          // truly seen: length of lines, or points
  double wrong = 0;        // missing and extra together
  double far = 0;          // of this, farther than a point from what is right
  std::optional<double> greatest;          // distance of the pictures as sets, in points
  std::optional<bool> exact;               // of exact methods: whether this picture is
  std::string defect;                      // of a program that is not its twin, or farther off than its words explain; else empty
  std::optional<double> emulated_seconds;  // on the machine
  std::optional<double> host_seconds;      // here
  std::optional<std::uint64_t> read;       // of the scene: so many
  std::optional<std::uint64_t> of_all;     // of so many
  std::string what;                        // "cells", "faces", "pairs"
  std::optional<double> chord{};           // of a sampled function: how far its curve is from the lines between samples, in points
  std::optional<picture::RasterDifference> raster{};  // the device's points against exact ones by the device's rule

  // Exact, or nothing of it is farther than a point from what is right.
  [[nodiscard]] bool right() const { return defect.empty() && (exact ? *exact : far == 0); }
};

[[nodiscard]] std::vector<MethodView> method_views(const SceneComparison& comparison);
[[nodiscard]] std::vector<MethodView> method_views(const HeightComparison& comparison);

// "skala-8080" for what methods of height grids call guest, "skala-twin" for twin, "skala" for native.
[[nodiscard]] std::string height_method_name(std::string_view name);

// Of what is truly seen; of a view in which nothing is, 0, or 100 if something is drawn.
[[nodiscard]] double wrong_percent(const MethodView& view);

// As one object.
[[nodiscard]] base::Json json_of(const picture::RasterDifference& difference);
// As one object; without host times unless there are any. The raster difference is left out of what is read back.
[[nodiscard]] base::Json json_of(const MethodView& view);
// Empty if it is no such object.
[[nodiscard]] std::optional<MethodView> method_view_of(const base::Json& object);

// Of the views of a row: half of them have no more; 90 in 100 have no more; the greatest.
struct Spread {
  double median = 0;
  double ninety = 0;
  double greatest = 0;
};

struct AnswerRow {
  std::string scene;
  std::string method;
  std::string picture;
  std::string rounding;
  std::string unit;
  std::size_t views = 0;
  std::size_t right = 0;             // views
  Spread wrong;                      // in the unit
  Spread wrong_percent;              // of what is truly seen; of a view in which nothing is, 0, or 100 if something is drawn
  Spread far;                        // of wrong, farther than a point
  std::optional<Spread> greatest;    // points
  std::optional<Spread> emulated_seconds;
  std::optional<Spread> host_seconds;
  std::optional<Spread> read;
  std::optional<std::uint64_t> of_all;
  std::string what;
  bool exact = false;                // an exact method
  std::optional<double> chord;       // the greatest
  std::string defect;                // the first
  // The number of the view with the greatest wrong share among those that are not right, or else among all; the first of such.
  std::uint64_t worst_view = 0;
};

class Answer {
 public:
  // A view of a scene, by its number.
  void add(const std::string& scene, std::uint64_t number, const std::vector<MethodView>& views);
  // In the order in which scenes, and of each its methods, came first.
  [[nodiscard]] std::vector<AnswerRow> rows() const;

 private:
  // Of a row: of each view only the numbers, because sweeps have millions of views.
  struct Gathered {
    AnswerRow row;  // what needs no numbers of all views
    std::vector<double> wrong;
    std::vector<double> wrong_percent;
    std::vector<double> far;
    std::vector<double> greatest;
    std::vector<double> emulated_seconds;
    std::vector<double> host_seconds;
    std::vector<double> read;
    std::vector<double> chord;
    double worst_percent = -1;
    bool worst_is_right = true;
  };
  std::vector<Gathered> gathered_;
};

}  // namespace sightline::compare
