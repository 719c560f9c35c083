// See answer.hpp.
#include "host/compare/answer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "emulators/core/tstates.hpp"
#include "host/compare/stripes.hpp"

namespace sightline::compare {
namespace {

using base::Json;

// The counts of how much of the scene a method reads; the first of these that a method has is used.
struct ReadCount {
  std::string_view count;
  std::string_view what;
  std::string_view of_all = {};  // the name of the count of all of them in the scene
};
constexpr ReadCount read_counts[] = {
    {"cells_read", "cells", "cells"}, {"relations", "pairs"}, {"facing", "pieces", "pieces"}, {"distances", "distances"}, {"faces", "faces"}};

template <class Counts>
void tell_read(const Counts& counts, MethodView& view) {
  const auto value = [&](std::string_view name) -> std::optional<std::uint64_t> {
    for (const auto& count : counts)
      if (count.name == name) return count.value;
    return std::nullopt;
  };
  for (const ReadCount& known : read_counts) {
    const auto read = value(known.count);
    if (!read) continue;
    view.read = read;
    if (!known.of_all.empty()) view.of_all = value(known.of_all);
    view.what = known.what;
    return;
  }
}

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

MethodView method_view(const ComparedPicture& row) {
  MethodView view;
  view.method = row.name;
  view.picture = "lines";
  view.rounding = row.rounding;
  view.unit = "px";
  view.all = row.metrics.true_length;
  view.wrong = row.metrics.symmetric();
  view.far = row.metrics.missing_far + row.metrics.extra_far;
  view.greatest = finite(row.metrics.hausdorff.greatest);
  view.exact = row.identical;
  if (row.emulated) view.emulated_seconds = core::in_seconds(*row.emulated);
  view.host_seconds = row.host_seconds;
  view.raster = row.raster;
  tell_read(row.counts, view);
  return view;
}

MethodView method_view(const ComparedFaces& row) {
  MethodView view;
  view.method = row.name;
  view.picture = "faces";
  view.rounding = "pixels";
  view.unit = "points";
  view.all = static_cast<double>(row.metrics.pixels);
  view.wrong = static_cast<double>(row.metrics.different());
  view.far = static_cast<double>(row.metrics.different_inside);
  view.emulated_seconds = row.emulated_seconds;
  view.host_seconds = row.host_seconds;
  // Pairs of faces that the method reports as not ordered are no defect.
  if (row.metrics.different_inside > 0 && row.not_solved == 0) view.defect = "faces are wrong away from edges";
  tell_read(row.counts, view);
  return view;
}

MethodView method_view(const StripesPen& pen) {
  MethodView view;
  view.method = std::string(stripes_name) + " pen";
  view.picture = "lines";
  view.rounding = "pixels";
  view.unit = "steps";
  view.all = static_cast<double>(pen.raster.lit_in_truth);
  // Two sides in one step leave their corner out, so the rule is up to a step off the lines: only points farther away
  // are wrong.
  view.far = static_cast<double>(pen.raster.missing.beyond_2 + pen.raster.extra.beyond_2);
  view.wrong = view.far;
  view.greatest = finite(pen.raster.hausdorff.greatest);
  view.emulated_seconds = core::in_seconds(pen.time);
  view.defect = pen.difference;
  return view;
}

MethodView method_view(const TurnCheck& turn) {
  MethodView view;
  view.method = turn_name;
  view.picture = "lines";
  view.rounding = "points";
  view.unit = "px";
  view.all = turn.metrics.true_length;
  view.wrong = turn.metrics.symmetric();
  view.far = turn.metrics.missing_far + turn.metrics.extra_far;
  view.greatest = finite(turn.distance.greatest);
  view.emulated_seconds = core::in_seconds(turn.time);
  view.raster = turn.raster;
  if (!turn.difference.empty())
    view.defect = turn.difference;
  else if (!turn.agrees())
    view.defect = "farther from the exact lines than its words explain";
  return view;
}

// Dots lie within a point of unrounded lines, so only dots farther away are wrong.
void set_unrounded(const picture::DotsAndLines& unrounded, MethodView& view) {
  view.unit = "px";
  view.all = unrounded.length;
  view.far = static_cast<double>(unrounded.dots_beyond_1) + unrounded.length_beyond_1;
  view.wrong = view.far;
  view.greatest = finite(unrounded.hausdorff.greatest);
}

MethodView method_view(const ComparedRaster& row) {
  MethodView view;
  view.method = height_method_name(row.name);
  view.rounding = "dots";
  view.raster = row.from_native;
  if (row.unrounded) {
    set_unrounded(*row.unrounded, view);
    return view;
  }
  view.unit = "dots";
  view.all = static_cast<double>(row.metrics.lit);
  view.wrong = static_cast<double>(row.metrics.missing + row.metrics.extra);
  view.far = static_cast<double>(row.metrics.missing_far + row.metrics.extra_far);
  return view;
}

MethodView method_view(const ComparedDevice& row) {
  MethodView view;
  // The EF9365 is the board of the paper's figures.
  view.method = row.device == programs::skala::Device::ef9365 ? "skala-8080" : fmt::format("skala-8080 {}", row.name);
  view.rounding = "dots";
  view.raster = row.raster;
  view.defect = row.difference;
  view.emulated_seconds = core::in_seconds(row.time);
  if (row.unrounded) {
    set_unrounded(*row.unrounded, view);
  } else {
    view.unit = "dots";
    view.all = static_cast<double>(row.raster.lit_in_truth);
    view.wrong = static_cast<double>(row.raster.missing.all + row.raster.extra.all);
    view.far = static_cast<double>(row.raster.missing.beyond_1 + row.raster.extra.beyond_1);
    view.greatest = finite(row.raster.hausdorff.greatest);
  }
  return view;
}

// Empty if there are no values.
std::optional<Spread> spread_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t ninety_percent = (9 * values.size() + 9) / 10;  // rounded up
  return Spread{values[(values.size() - 1) / 2], values[ninety_percent - 1], values.back()};
}

template <class Value>
std::optional<Value> at(const Json& object, std::string_view key, std::optional<Value> (Json::*as)() const) {
  const Json* const member = object.find(key);
  return member != nullptr ? (member->*as)() : std::nullopt;
}

}  // namespace

double wrong_percent(const MethodView& view) {
  if (view.all > 0) return 100 * view.wrong / view.all;
  return view.wrong > 0 ? 100 : 0;
}

std::vector<MethodView> method_views(const SceneComparison& comparison) {
  std::vector<MethodView> views;
  for (const ComparedPicture& row : comparison.pictures) {
    views.push_back(method_view(row));
    if (row.emulated && comparison.guest) views.back().defect = comparison.guest->difference;
  }
  for (const ComparedFaces& row : comparison.faces) {
    views.push_back(method_view(row));
    if (row.name == stripes_name && !comparison.stripes_difference.empty()) views.back().defect = comparison.stripes_difference;
  }
  if (comparison.stripes_pen) views.push_back(method_view(*comparison.stripes_pen));
  if (comparison.turn) views.push_back(method_view(*comparison.turn));
  return views;
}

std::string height_method_name(std::string_view name) {
  if (name.starts_with("guest")) return "skala-8080" + std::string(name.substr(5));
  if (name.starts_with("twin")) return "skala-twin" + std::string(name.substr(4));
  return name.starts_with("native") ? "skala" + std::string(name.substr(6)) : std::string(name);
}

std::vector<MethodView> method_views(const HeightComparison& comparison) {
  std::vector<MethodView> views;
  const auto of_guest = std::find_if(comparison.devices.begin(), comparison.devices.end(),
                                     [](const ComparedDevice& row) { return row.device == programs::skala::Device::ef9365; });
  for (const ComparedRaster& row : comparison.rasters) {
    // Of a native drawing of lines, the lines are measured, not dots made from them.
    if (row.name.starts_with("native") && !comparison.vectors.empty()) continue;
    const bool program = row.name == "guest" || row.name == "twin";
    // The program's dots are measured against an independent reference, as on its other devices.
    MethodView& view = views.emplace_back(program && of_guest != comparison.devices.end() ? method_view(*of_guest) : method_view(row));
    view.method = height_method_name(row.name);
    if (row.name == "guest") {
      view.defect = comparison.guest_difference;
      view.emulated_seconds = core::in_seconds(comparison.guest_time);
    } else {
      view.emulated_seconds.reset();
      view.raster.reset();  // it is the guest's
    }
  }
  for (const ComparedVectors& row : comparison.vectors) {
    ComparedPicture lines;
    lines.name = "skala";
    lines.rounding = not_rounded;
    lines.metrics = row.metrics;
    lines.host_seconds = comparison.native_seconds;
    views.push_back(method_view(lines));
  }
  for (const ComparedDevice& row : comparison.devices)
    if (row.device != programs::skala::Device::ef9365) views.push_back(method_view(row));
  constexpr std::array<std::string_view, 3> pictures{"dots", "surface", "contours"};
  for (MethodView& view : views) {
    if (comparison.chord) view.chord = comparison.chord->greatest;
    if (view.picture.empty()) view.picture = pictures[static_cast<std::size_t>(comparison.view.subject)];
  }
  return views;
}

base::Json json_of(const picture::RasterDifference& difference) {
  const auto apart = [](const picture::DifferingPoints& points) {
    return Json{{"points", points.all}, {"beyond_1", points.beyond_1}, {"beyond_2", points.beyond_2}};
  };
  return {{"lit_in_truth", difference.lit_in_truth},
          {"lit", difference.lit_in_drawn},
          {"missing", apart(difference.missing)},
          {"extra", apart(difference.extra)},
          {"hausdorff", difference.hausdorff.greatest},
          {"hausdorff_99_9", difference.hausdorff.usual}};
}

base::Json json_of(const MethodView& view) {
  Json object{{"method", view.method}, {"picture", view.picture}, {"rounding", view.rounding}, {"unit", view.unit},
              {"all", view.all},       {"wrong", view.wrong},     {"far", view.far}};
  if (view.greatest) object["greatest"] = *view.greatest;
  if (view.exact) object["exact"] = *view.exact;
  if (!view.defect.empty()) object["defect"] = view.defect;
  if (view.emulated_seconds) object["emulated_s"] = *view.emulated_seconds;
  if (view.host_seconds) object["host_s"] = *view.host_seconds;
  if (view.read) object["read"] = *view.read;
  if (view.of_all) object["of_all"] = *view.of_all;
  if (view.read) object["what"] = view.what;
  if (view.chord) object["chord"] = *view.chord;
  if (view.raster) object["raster"] = json_of(*view.raster);
  return object;
}

std::optional<MethodView> method_view_of(const base::Json& object) {
  MethodView view;
  for (const auto& [key, member] : {std::pair{"method", &MethodView::method}, std::pair{"picture", &MethodView::picture},
                                    std::pair{"rounding", &MethodView::rounding}, std::pair{"unit", &MethodView::unit}}) {
    const Json* const text = object.find(key);
    if (text == nullptr || text->text() == nullptr) return std::nullopt;
    view.*member = *text->text();
  }
  for (const auto& [key, member] :
       {std::pair{"all", &MethodView::all}, std::pair{"wrong", &MethodView::wrong}, std::pair{"far", &MethodView::far}}) {
    const auto number = at(object, key, &Json::number);
    if (!number) return std::nullopt;
    view.*member = *number;
  }
  view.greatest = at(object, "greatest", &Json::number);
  view.chord = at(object, "chord", &Json::number);
  view.exact = at(object, "exact", &Json::boolean);
  view.emulated_seconds = at(object, "emulated_s", &Json::number);
  view.host_seconds = at(object, "host_s", &Json::number);
  for (const auto& [key, member] : {std::pair{"read", &MethodView::read}, std::pair{"of_all", &MethodView::of_all}})
    if (const auto count = at(object, key, &Json::integer); count && *count >= 0) view.*member = static_cast<std::uint64_t>(*count);
  for (const auto& [key, member] : {std::pair{"defect", &MethodView::defect}, std::pair{"what", &MethodView::what}})
    if (const Json* const text = object.find(key); text != nullptr && text->text() != nullptr) view.*member = *text->text();
  return view;
}

void Answer::add(const std::string& scene, std::uint64_t number, const std::vector<MethodView>& views) {
  for (const MethodView& view : views) {
    auto known = std::find_if(gathered_.begin(), gathered_.end(), [&](const Gathered& gathered) {
      return gathered.row.scene == scene && gathered.row.method == view.method && gathered.row.picture == view.picture;
    });
    if (known == gathered_.end()) {
      AnswerRow row;
      row.scene = scene;
      row.method = view.method;
      row.picture = view.picture;
      row.rounding = view.rounding;
      row.unit = view.unit;
      row.of_all = view.of_all;
      row.what = view.what;
      row.exact = view.exact.has_value();
      gathered_.emplace_back().row = std::move(row);
      known = gathered_.end() - 1;
    }
    Gathered& all = *known;
    if (all.row.of_all != view.of_all) all.row.of_all.reset();  // views with different totals have no common total
    const double percent = wrong_percent(view);
    all.wrong.push_back(view.wrong);
    all.wrong_percent.push_back(percent);
    all.far.push_back(view.far);
    if (view.greatest) all.greatest.push_back(*view.greatest);
    if (view.emulated_seconds) all.emulated_seconds.push_back(*view.emulated_seconds);
    if (view.host_seconds) all.host_seconds.push_back(*view.host_seconds);
    if (view.read) all.read.push_back(static_cast<double>(*view.read));
    if (view.chord) all.chord.push_back(*view.chord);
    ++all.row.views;
    if (view.right()) ++all.row.right;
    if (all.row.defect.empty()) all.row.defect = view.defect;
    if (view.right() == all.worst_is_right ? percent > all.worst_percent : all.worst_is_right) {
      all.worst_percent = percent;
      all.worst_is_right = view.right();
      all.row.worst_view = number;
    }
  }
}

std::vector<AnswerRow> Answer::rows() const {
  std::vector<AnswerRow> rows;
  for (const Gathered& all : gathered_) {
    AnswerRow row = all.row;
    row.wrong = *spread_of(all.wrong);
    row.far = *spread_of(all.far);
    row.wrong_percent = *spread_of(all.wrong_percent);
    row.greatest = spread_of(all.greatest);
    row.emulated_seconds = spread_of(all.emulated_seconds);
    row.host_seconds = spread_of(all.host_seconds);
    row.read = spread_of(all.read);
    if (const auto chord = spread_of(all.chord)) row.chord = chord->greatest;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace sightline::compare
