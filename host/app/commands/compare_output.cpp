#include "host/app/commands/compare_output.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "host/app/commands/skala_options.hpp"
#include "host/app/outputs.hpp"
#include "host/base/json.hpp"
#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/picture/overlay.hpp"
#include "host/picture/raster_difference.hpp"

namespace sightline::app {

namespace {

namespace jones = programs::jones;
using base::Json;
using compare::ComparedPicture;
using compare::ComparedRaster;
using compare::ComparedVectors;
using compare::HeightComparison;
using compare::SceneComparison;
using picture::LineMetrics;
using picture::PixelMetrics;

constexpr std::array<std::string_view, 4> compared_families{"slices along x", "slices along z",
                                                            "both families", "slices"};

std::string view_text(const SceneComparison& comparison) {
  const scene::PolyCamera& camera = comparison.camera;
  if (!camera.perspective) return "along " + base::joined(camera.forward, ",") + ", orthographic";
  return fmt::format("from {},{},{}", base::shortest_number(comparison.eye[0]), base::shortest_number(comparison.eye[1]),
                     base::shortest_number(comparison.eye[2]));
}

// The points that a device lit, compared with those that exact lines light by its rule of rounding.
std::string raster_text(std::string_view method, const picture::RasterDifference& raster) {
  const auto apart = [](const picture::DifferingPoints& points) {
    if (points.all == 0) return std::string("none");
    if (points.beyond_1 == 0) return fmt::format("{} (none more than a point away)", points.all);
    return fmt::format("{} ({} more than a point away, {} more than two)", points.all, points.beyond_1, points.beyond_2);
  };
  return fmt::format("{} lit {} points; exact lines light {} by the same rule: missing {}, extra {}, farthest {:.2f}\n", method,
                     raster.lit_in_drawn, raster.lit_in_truth, apart(raster.missing), apart(raster.extra), raster.hausdorff.greatest);
}

std::string guest_text(const compare::GuestCheck& guest) {
  if (!guest.difference.empty()) return fmt::format("{} and its twin, the same program in C++, differ: {}\n", compare::jones_pdp7_name, guest.difference);
  return fmt::format("{} and its twin, the same program in C++, give the same {} display words, status {}\n", compare::jones_pdp7_name, guest.words, jones::name(guest.status));
}

std::string turn_text(const compare::TurnCheck& turn) {
  if (!turn.difference.empty()) return "turn-pdp7 differs: " + turn.difference + "\n";
  return fmt::format("turn-pdp7 draws the solid at a size of its own: percentages are of {:.1f} px of visible lines\n"
                     "turn-pdp7 and its twin, the same program in C++, give the same {} display words, {} flashes at {:.4f} degrees{}\n",
                     turn.metrics.true_length, turn.words, turn.flashes, turn.angle * 360.0 / (1 << 18),
                     turn.agrees() ? fmt::format("; its words explain a distance of up to {:.2f}", turn.bound)
                                   : fmt::format(": FARTHER OFF THAN THE {:.2f} THAT ITS WORDS EXPLAIN", turn.bound));
}

std::string rasters_text(const std::vector<compare::MethodView>& views) {
  std::string text;
  for (const compare::MethodView& view : views)
    if (view.raster) text += raster_text(view.method, *view.raster);
  return text;
}

void write_overlay(const std::string& base, const picture::Overlay& overlay, const std::string& title,
                   std::vector<std::string>& paths) {
  Output image(base + ".png");
  Output drawing(base + ".svg");
  write_png(image, picture::overlay_image(overlay), {{"Title", title}, {"Software", "sightline"}});
  drawing.write(picture::overlay_svg(overlay, title));
  image.commit();
  drawing.commit();
  paths.push_back(base + ".png");
  paths.push_back(base + ".svg");
}

// Whether the pictures differ by more than the rounding of floating-point lengths.
bool differs(const LineMetrics& m) {
  return m.symmetric() > 1e-6;
}

picture::OverlayCaption lines_caption(const std::string& title, const LineMetrics& m) {
  return {title + "; not coloured: stretches up to 1 px", fmt::format("agreed {:.1f} px", m.true_length - m.missing),
          fmt::format("missing {:.2f} px", m.missing), fmt::format("extra {:.2f} px", m.extra)};
}

// Points that are lit in both but differ count as extra, as in overlay_of.
picture::OverlayCaption points_caption(const std::string& title, const PixelMetrics& m) {
  return {title, fmt::format("agreed {} points", m.lit - m.missing - (m.different() - m.missing - m.extra)),
          fmt::format("missing {}", m.missing), fmt::format("extra {}", m.different() - m.missing)};
}

// Replaces the numbers of visible items by 1.
picture::PixelGrid lit_only(picture::PixelGrid grid) {
  for (std::uint32_t& value : grid.values) value = value != 0 ? 1 : 0;
  return grid;
}

std::string overlay_base(const std::string& directory, const std::string& scene, const std::string& name) {
  make_directory(directory);
  return (std::filesystem::path(directory) / (file_stem(scene) + "-compare-" + file_stem(name))).string();
}

// --- JSON

Json reasons_json(const std::vector<std::pair<std::string, std::string>>& reasons) {
  Json list = Json::array();
  for (const auto& [name, reason] : reasons) list.push_back({{"name", name}, {"reason", reason}});
  return list;
}

Json metrics_json(const LineMetrics& m) {
  return {{"true_length", m.true_length},
          {"drawn_length", m.drawn_length},
          {"missing", m.missing},
          {"extra", m.extra},
          {"missing_share", m.share(m.missing)},
          {"extra_share", m.share(m.extra)},
          {"missing_far", m.missing_far},
          {"extra_far", m.extra_far},
          {"hausdorff", m.hausdorff.greatest},
          {"hausdorff_99_9", m.hausdorff.usual},
          {"wrong_visibility",
           {{"points", m.wrong_visibility.points},
            {"wrong", m.wrong_visibility.wrong},
            {"rate", m.wrong_visibility.rate},
            {"low", m.wrong_visibility.low},
            {"high", m.wrong_visibility.high}}},
          {"pieces_different", m.pieces_different}};
}

Json line_json(const ComparedPicture& compared) {
  Json row{{"name", compared.name}, {"rounding", compared.rounding}};
  if (compared.identical) row["equal_to_oracle"] = *compared.identical;
  row.update(metrics_json(compared.metrics));
  if (compared.raster) row["raster"] = compare::json_of(*compared.raster);
  return row;
}

Json points_json(const std::string& name, const PixelMetrics& m) {
  return {{"name", name},
          {"pixels", m.pixels},
          {"boundary_pixels", m.boundary_pixels},
          {"different_on_boundary", m.different_on_boundary},
          {"different_inside", m.different_inside},
          {"mismatch", m.mismatch()},
          {"boundary_mismatch", m.boundary_mismatch()},
          {"interior_mismatch", m.interior_mismatch()},
          {"lit", m.lit},
          {"missing", m.missing},
          {"extra", m.extra},
          {"missing_far", m.missing_far},
          {"extra_far", m.extra_far}};
}

Json unrounded_json(const picture::DotsAndLines& d) {
  return {{"dots", d.dots},
          {"dots_beyond_1", d.dots_beyond_1},
          {"dots_beyond_2", d.dots_beyond_2},
          {"length", d.length},
          {"missing_beyond_1", d.length_beyond_1},
          {"missing_beyond_2", d.length_beyond_2},
          {"hausdorff", d.hausdorff.greatest},
          {"hausdorff_99_9", d.hausdorff.usual}};
}

}  // namespace

std::string compare_heading(const SceneComparison& comparison) {
  std::string text = fmt::format("{} {}", comparison.scene, view_text(comparison));
  if (!comparison.pictures.empty()) {
    const double length = comparison.pictures.front().metrics.true_length;
    text += length > 0 ? fmt::format(": {:.1f} pixels (px) of lines are visible", length) : std::string(": no line is on the screen");
  }
  return text + "\n";
}

std::string compare_heading(const std::string& name, const HeightComparison& comparison) {
  const algorithms::skala::View& view = comparison.view;
  std::string text =
      fmt::format("{}, {}, {}, rotated {}, seen from {} degrees", name, picture_name(view.subject),
                  compared_families[static_cast<std::size_t>(view.family)], view.rotation, view.elevation);
  if (view.subject == algorithms::skala::Subject::contours) text += fmt::format(", {} levels", view.levels);
  if (!comparison.vectors.empty())
    text += fmt::format(": {:.1f} pixels (px) of lines are visible", comparison.vectors.front().metrics.true_length);
  return text + "\n";
}

std::string compare_notes(const SceneComparison& comparison) {
  std::string text = rasters_text(method_views(comparison));
  if (comparison.guest) text += guest_text(*comparison.guest);
  if (comparison.turn) text += turn_text(*comparison.turn);
  for (const compare::ComparedFaces& faces : comparison.faces)
    if (faces.not_solved > 0)
      text += fmt::format("{} says itself that it cannot order {} pairs of faces\n", faces.name, faces.not_solved);
  return text;
}

std::string compare_notes(const HeightComparison& comparison, const std::vector<compare::MethodView>& rows) {
  std::string text = rasters_text(rows);
  if (comparison.agrees()) text += "skala-8080 and its twin, the same program in C++, give the same dots, masks and status\n";
  if (comparison.chord)
    text += fmt::format("the function itself is up to {:.2f} points from the straight lines between its samples\n", comparison.chord->greatest);
  return text;
}

Json compare_json(const SceneComparison& comparison) {
  Json document{{"scene", comparison.scene},
                {"perspective", comparison.camera.perspective},
                {"eye", comparison.eye},
                {"eye_steps", comparison.camera.eye},
                {"forward", comparison.camera.forward},
                {"pixels_a_unit", comparison.frame.scale},
                {"agrees", comparison.agrees()},
                {"pictures", Json::array()}};
  for (const ComparedPicture& compared : comparison.pictures)
    document["pictures"].push_back(line_json(compared));
  document["faces"] = Json::array();
  for (const compare::ComparedFaces& compared : comparison.faces) {
    Json row = points_json(compared.name, compared.metrics);
    row["not_separated"] = compared.not_solved;
    document["faces"].push_back(std::move(row));
  }
  if (comparison.guest) {
    document["guest"] = {{"identical_to_twin", comparison.guest->difference.empty()},
                         {"difference", comparison.guest->difference},
                         {"status", jones::name(comparison.guest->status)},
                         {"display_words", comparison.guest->words},
                         {"emulated_ns", comparison.guest->time.count()}};
  }
  if (comparison.turn) {
    const compare::TurnCheck& turn = *comparison.turn;
    document["turn"] = {{"identical_to_twin", turn.difference.empty()},
                        {"difference", turn.difference},
                        {"angle", turn.angle},
                        {"display_words", turn.words},
                        {"emulated_ns", turn.time.count()},
                        {"flashes", turn.flashes},
                        {"hausdorff", turn.distance.greatest},
                        {"hausdorff_bound", turn.bound},
                        {"raster", compare::json_of(turn.raster)},
                        {"hausdorff_99_9", turn.distance.usual}};
  }
  document["not_compared"] = reasons_json(comparison.not_applicable);
  return document;
}

Json compare_json(const std::string& name, const HeightComparison& comparison) {
  Json document{{"function", name},
                {"picture", picture_name(comparison.view.subject)},
                {"rotation", comparison.view.rotation},
                {"elevation", comparison.view.elevation},
                {"agrees", comparison.agrees()},
                {"pictures", Json::array()}};
  for (const ComparedRaster& compared : comparison.rasters) {
    Json row = points_json(compare::height_method_name(compared.name), compared.metrics);
    row["rounding"] = compared.rounding;
    if (compared.unrounded) row["unrounded"] = unrounded_json(*compared.unrounded);
    if (compared.from_native) row["from_native"] = compare::json_of(*compared.from_native);
    document["pictures"].push_back(std::move(row));
  }
  document["chord_error"] = comparison.chord ? Json(comparison.chord->greatest) : Json(nullptr);
  // An object, or an array of objects if there are several methods.
  for (const ComparedVectors& vectors : comparison.vectors) {
    Json object{{"name", compare::height_method_name(vectors.name)}};
    object.update(metrics_json(vectors.metrics));
    if (comparison.vectors.size() > 1)
      document["vectors"].push_back(std::move(object));
    else
      document["vectors"] = std::move(object);
  }
  document["devices"] = Json::array();
  for (const compare::ComparedDevice& device : comparison.devices) {
    Json row{{"name", device.name},
             {"identical_to_twin", device.difference.empty()},
             {"difference", device.difference},
             {"t_states", device.time.count()},
             {"raster", compare::json_of(device.raster)}};
    if (device.unrounded) row["unrounded"] = unrounded_json(*device.unrounded);
    document["devices"].push_back(std::move(row));
  }
  document["guest"] = {{"identical_to_twin", comparison.guest_difference.empty()},
                       {"difference", comparison.guest_difference},
                       {"t_states", comparison.guest_time.count()}};
  return document;
}

std::vector<std::string> write_overlays(const std::string& directory, const std::string& name,
                                        const SceneComparison& comparison, bool all) {
  std::vector<std::string> paths;
  const compare::ScreenFrame& frame = comparison.frame;
  for (const ComparedPicture& compared : comparison.pictures) {
    const LineMetrics& m = compared.metrics;
    if (!all && !differs(m)) continue;
    const std::string title =
        fmt::format("{}: {} against the oracle, {}", comparison.scene, compared.name, view_text(comparison));
    const picture::OverlayCaption caption = lines_caption(title, m);
    write_overlay(
        overlay_base(directory, name, compared.name),
        picture::overlay_of(compared.difference, {frame.low, frame.low}, {frame.high, frame.high}, caption),
        title, paths);
    if (!compared.raster) continue;
    const std::string points = overlay_base(directory, name, compared.name + " points") + ".png";
    Output image(points);
    write_png(image, picture::difference_image(compared.lit_in_truth, compared.lit), {{"Title", title}, {"Software", "sightline"}});
    image.commit();
    paths.push_back(points);
  }
  for (const compare::ComparedFaces& compared : comparison.faces) {
    if (!all && compared.metrics.different() == 0) continue;
    const std::string title = fmt::format("{}: faces by {} against the nearest ones, {}", comparison.scene,
                                          compared.name, view_text(comparison));
    write_overlay(overlay_base(directory, name, compared.name + " faces"),
                  picture::overlay_of(compared.truth, compared.grid, points_caption(title, compared.metrics)),
                  title, paths);
  }
  return paths;
}

std::vector<std::string> write_overlays(const std::string& directory, const std::string& name,
                                        const HeightComparison& comparison, bool all) {
  std::vector<std::string> paths;
  for (const ComparedRaster& compared : comparison.rasters) {
    // The dots of the programs are shown below, compared with unrounded lines.
    if (!comparison.devices.empty() && (compared.name == "guest" || compared.name == "twin")) continue;
    const PixelMetrics& m = compared.metrics;
    if (!all && m.different() == 0) continue;
    const std::string title =
        fmt::format("{}, {}: {} against {}", name, picture_name(comparison.view.subject), compared.name,
                    compared.against);
    const picture::OverlayCaption caption = points_caption(title, m);
    write_overlay(overlay_base(directory, name, compare::height_method_name(compared.name)),
                  picture::overlay_of(compared.truth.value_or(comparison.truth), compared.grid, caption),
                  title, paths);
  }
  for (const compare::ComparedDevice& device : comparison.devices) {
    // All boards show the same dots, and so do all plotters: one picture of each kind.
    const compare::ComparedDevice& first = *std::find_if(
        comparison.devices.begin(), comparison.devices.end(),
        [&](const compare::ComparedDevice& other) { return other.dots == device.dots && other.truth == device.truth; });
    if (&first != &device) continue;
    const picture::RasterDifference& d = device.raster;
    if (!all && d.same()) continue;
    const std::string title = fmt::format("{}, {}: dots of the guest, {}, against exact lines by its rule", name,
                                          picture_name(comparison.view.subject), device.name);
    const picture::OverlayCaption caption{title, fmt::format("agreed {} points", d.lit_in_truth - d.missing.all),
                                          fmt::format("missing {}", d.missing.all), fmt::format("extra {}", d.extra.all)};
    write_overlay(overlay_base(directory, name, std::string(device.name) + " dots"),
                  picture::overlay_of(lit_only(device.truth), device.dots, caption), title, paths);
  }
  for (const ComparedVectors& vectors : comparison.vectors) {
    if (!all && !differs(vectors.metrics)) continue;
    const std::string title = fmt::format("{}, {}: {} against what is truly seen of them", name,
                                          picture_name(comparison.view.subject), vectors.name);
    write_overlay(
        overlay_base(directory, name, compare::height_method_name(vectors.name)),
        picture::overlay_of(vectors.difference, {0, 0}, {255, 255}, lines_caption(title, vectors.metrics)),
        title, paths);
  }
  return paths;
}

}  // namespace sightline::app
