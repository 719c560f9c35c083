// The table of speed and accuracy: one row per method and scene, over one view or many.
//
// `compare` prints it, `sweep` and `demo` write it at the end, and the report begins with it. Its numbers come from
// the measures of a view in scenes.hpp and heights.hpp.
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
  double all = 0;          // visible in the reference: length of lines, or points
  double wrong = 0;        // missing and extra together
  double far = 0;          // part of wrong farther than a point from the reference
  std::optional<double> greatest;          // Hausdorff distance of the pictures, in points
  std::optional<bool> exact;               // of exact methods: whether this picture is exact
  std::string defect;                      // of a program that differs from its twin, or by more than its words explain; else empty
  std::optional<double> emulated_seconds;  // on the emulated machine
  std::optional<double> host_seconds;      // on this computer
  std::optional<std::uint64_t> read;       // how much of the scene was read
  std::optional<std::uint64_t> of_all;     // of how much
  std::string what;                        // "cells", "faces", "pairs"
  std::optional<double> chord{};           // of a sampled function: distance of its curve from the lines between samples, in points
  std::optional<picture::RasterDifference> raster{};  // lit points compared with those of the exact lines, by the device's rule

  // Exact; or, of other methods, no error farther than a point from the reference.
  [[nodiscard]] bool right() const { return defect.empty() && (exact ? *exact : far == 0); }
};

[[nodiscard]] std::vector<MethodView> method_views(const SceneComparison& comparison);
[[nodiscard]] std::vector<MethodView> method_views(const HeightComparison& comparison);

// "skala-8080" for the method of height grids called guest, "skala-twin" for twin, "skala" for native.
[[nodiscard]] std::string height_method_name(std::string_view name);

// Wrong in per cent of what is visible. If nothing is visible: 0, or 100 if something is drawn.
[[nodiscard]] double wrong_percent(const MethodView& view);

// As one JSON object.
[[nodiscard]] base::Json json_of(const picture::RasterDifference& difference);
// As one JSON object, with host times if there are any. method_view_of does not read the raster difference back.
[[nodiscard]] base::Json json_of(const MethodView& view);
// Empty if the object is not a method's view.
[[nodiscard]] std::optional<MethodView> method_view_of(const base::Json& object);

// Quantiles over the views of a row: median, 90th percentile and maximum.
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
  std::size_t right = 0;             // number of right views
  Spread wrong;                      // in `unit`
  Spread wrong_percent;              // of what is visible; if nothing is: 0, or 100 if something is drawn
  Spread far;                        // part of wrong farther than a point
  std::optional<Spread> greatest;    // points
  std::optional<Spread> emulated_seconds;
  std::optional<Spread> host_seconds;
  std::optional<Spread> read;
  std::optional<std::uint64_t> of_all;
  std::string what;
  bool exact = false;                // whether the method is exact
  std::optional<double> chord;       // the greatest
  std::string defect;                // the first
  // The number of the view with the greatest wrong share among the views that are not right, or among all if all are
  // right. Of equal ones, the first.
  std::uint64_t worst_view = 0;
};

class Answer {
 public:
  // Adds a view of a scene by its number.
  void add(const std::string& scene, std::uint64_t number, const std::vector<MethodView>& views);
  // In the order in which scenes, and the methods of each, were added first.
  [[nodiscard]] std::vector<AnswerRow> rows() const;

 private:
  // A row under construction. It keeps only numbers of each view, because sweeps have millions of views.
  struct Gathered {
    AnswerRow row;  // the fields that are no quantiles
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
