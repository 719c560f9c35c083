// See compare_output.hpp.
#include "host/app/commands/compare_output.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "host/app/commands/jones_session.hpp"
#include "host/app/commands/skala_options.hpp"
#include "host/app/outputs.hpp"
#include "host/base/json.hpp"
#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/base/text_table.hpp"
#include "host/picture/overlay.hpp"

namespace sightline::app {

namespace {

namespace jones = guests::jones;
using base::Json;
using base::TextTable;
using compare::ComparedPicture;
using compare::ComparedRaster;
using compare::ComparedVectors;
using compare::HeightComparison;
using compare::SceneComparison;
using picture::LineMetrics;
using picture::PixelMetrics;

constexpr std::array<std::string_view, 4> compared_families{"slices along x", "slices along z",
                                                            "both families", "slices"};

std::string pixels_and_share(const LineMetrics& metrics, double length) {
  const double share = 100 * metrics.share(length);
  return std::isfinite(share) ? fmt::format("{:.2f} ({:.3f} %)", length, share)
                              : fmt::format("{:.2f}", length);
}

std::string distance_text(double distance) {
  return std::isfinite(distance) ? fmt::format("{:.2f}", distance) : std::string("none");
}

std::string view_text(const SceneComparison& comparison) {
  const scene::PolyCamera& camera = comparison.camera;
  if (!camera.perspective) return "along " + base::joined(camera.forward, ",") + ", orthographic";
  return fmt::format("from {},{},{}", base::shortest_number(comparison.eye[0]), base::shortest_number(comparison.eye[1]),
                     base::shortest_number(comparison.eye[2]));
}

TextTable lines_table() {
  TextTable table({-15, -22, -22, 9, 9, 9, 9, -30, 6, 0});
  table.row({"", "missing px", "extra px", "miss >1", "extra >1", "H px", "99.9 %",
             "  wrong points, 95 % interval", "pieces"});
  return table;
}

void add_lines(TextTable& table, const std::string& name, const LineMetrics& m,
               const std::string& exactness) {
  const picture::Rate& rate = m.wrong_visibility;
  table.row({"  " + name, pixels_and_share(m, m.missing), pixels_and_share(m, m.extra),
             fmt::format("{:.2f}", m.missing_far), fmt::format("{:.2f}", m.extra_far),
             distance_text(m.hausdorff.greatest), distance_text(m.hausdorff.usual),
             fmt::format("  {:.3f} % ({:.3f} to {:.3f})", 100 * rate.rate, 100 * rate.low, 100 * rate.high),
             std::to_string(m.pieces_different), "  " + exactness});
}

TextTable points_table() {
  TextTable table({-15, 14, 12, 12, 10, 10, 10, 10});
  table.row({"", "different", "at edges", "elsewhere", "missing", "extra", "miss >1", "extra >1"});
  return table;
}

void add_points(TextTable& table, const std::string& name, const PixelMetrics& m) {
  table.row({"  " + name, fmt::format("{} ({:.3f} %)", m.different(), 100 * m.mismatch()),
             std::to_string(m.different_on_boundary), std::to_string(m.different_inside),
             std::to_string(m.missing), std::to_string(m.extra), std::to_string(m.missing_far),
             std::to_string(m.extra_far)});
}

// Dots against truths that do not share the rounding of the programs, or share it knowingly.
std::string dots_text(const HeightComparison& comparison) {
  std::string text;
  TextTable unrounded({-15, 9, 9, 9, 14, 14, 9, 9, 0});
  unrounded.row({"", "dots", ">1", ">2", "px missing >1", "px missing >2", "H px", "99.9 %", "  rounded"});
  double length = 0;
  for (const ComparedRaster& row : comparison.rasters) {
    if (!row.unrounded) continue;
    const picture::DotsAndLines& d = *row.unrounded;
    length = d.length;
    unrounded.row({"  " + row.name, std::to_string(d.dots), std::to_string(d.dots_beyond_1), std::to_string(d.dots_beyond_2),
                   fmt::format("{:.2f}", d.length_beyond_1), fmt::format("{:.2f}", d.length_beyond_2),
                   distance_text(d.hausdorff.greatest), distance_text(d.hausdorff.usual), "  " + row.rounding});
  }
  if (length > 0) text += fmt::format("dots against the unrounded lines between samples, {:.1f} px\n", length) + unrounded.text();
  if (comparison.view.picture == guests::skala::PictureKind::lines)
    text += comparison.chord ? fmt::format("  chord error: the function itself is up to {:.2f} px from these lines\n", comparison.chord->greatest)
                             : std::string("  chord error: none, there is nothing between the samples\n");
  TextTable native({-15, 9, 9, 9, 9, 9, 9, 9, 9});
  native.row({"", "missing", ">1", ">2", "extra", ">1", ">2", "H px", "99.9 %"});
  bool any = false;
  for (const ComparedRaster& row : comparison.rasters) {
    if (!row.from_native) continue;
    any = true;
    const picture::RasterDifference& d = *row.from_native;
    native.row({"  " + row.name, std::to_string(d.missing.all), std::to_string(d.missing.beyond_1), std::to_string(d.missing.beyond_2),
                std::to_string(d.extra.all), std::to_string(d.extra.beyond_1), std::to_string(d.extra.beyond_2),
                distance_text(d.hausdorff.greatest), distance_text(d.hausdorff.usual)});
  }
  return any ? text + "dots against the native drawing by the program's own rule\n" + native.text() : text;
}

std::string faces_text(const SceneComparison& comparison) {
  if (comparison.faces.empty()) return "";
  const PixelMetrics& any = comparison.faces.front().metrics;
  TextTable table = points_table();
  for (const compare::ComparedFaces& compared : comparison.faces) {
    add_points(table, compared.name, compared.metrics);
    if (compared.not_solved > 0)
      table.line(fmt::format("{}: {} pairs of faces it says itself it cannot separate", compared.name,
                             compared.not_solved));
    if (!compared.agrees()) table.line(compared.name + ": NOT THE ORACLE'S");
  }
  return fmt::format("faces, by points: {}, {} of them at edges\n", any.pixels, any.boundary_pixels) +
         table.text();
}

std::string exactness_text(const ComparedPicture& compared) {
  if (!compared.identical) return "";
  return *compared.identical ? "equal to the oracle's" : "NOT THE ORACLE'S";
}

std::string guest_text(const compare::GuestCheck& guest) {
  if (!guest.difference.empty()) return "guest and twin differ: " + guest.difference + "\n";
  return fmt::format("guest and twin: identical, {} display words, status {}; view 1 took {:.3f} s\n",
                     guest.words, jones::name(guest.status), seconds(guest.time));
}

std::string turn_text(const compare::TurnCheck& turn) {
  if (!turn.difference.empty()) return "turn on the PDP-7 differs: " + turn.difference + "\n";
  return fmt::format(
      "turn on the PDP-7: its twin's, {} display words, {:.1f} ms; {} flashes at {:.4f} degrees, H {:.2f} points, 99.9 % {:.2f}, from exact{}; by points, missing {} and extra {}, beyond 1 point {} and {}\n",
      turn.words, seconds(turn.time) * 1e3, turn.flashes, turn.angle * 360.0 / (1 << 18), turn.distance.greatest, turn.distance.usual,
      turn.agrees() ? fmt::format("; its words explain up to {:.2f}", turn.bound)
                    : fmt::format(": MORE THAN THE {:.2f} THAT ITS WORDS EXPLAIN", turn.bound),
      turn.raster.missing.all, turn.raster.extra.all, turn.raster.missing.beyond_1, turn.raster.extra.beyond_1);
}

std::string reasons_text(const std::vector<std::pair<std::string, std::string>>& reasons) {
  std::string text;
  for (const auto& [name, reason] : reasons) text += fmt::format("{} not compared: {}\n", name, reason);
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

picture::OverlayCaption lines_caption(const std::string& title, const LineMetrics& m) {
  return {title, fmt::format("agreed {:.1f} px", m.true_length - m.missing),
          fmt::format("missing {:.2f} px", m.missing), fmt::format("extra {:.2f} px", m.extra)};
}

// Points that are lit in both but differ count as extra: overlay_of.
picture::OverlayCaption points_caption(const std::string& title, const PixelMetrics& m) {
  return {title, fmt::format("agreed {} points", m.lit - m.missing - (m.different() - m.missing - m.extra)),
          fmt::format("missing {}", m.missing), fmt::format("extra {}", m.different() - m.missing)};
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

Json apart_json(const picture::PointsApart& points) {
  return {{"points", points.all}, {"beyond_1", points.beyond_1}, {"beyond_2", points.beyond_2}};
}

Json raster_json(const picture::RasterDifference& d) {
  return {{"lit_in_truth", d.lit_in_truth},
          {"lit", d.lit_in_drawn},
          {"missing", apart_json(d.missing)},
          {"extra", apart_json(d.extra)},
          {"hausdorff", d.hausdorff.greatest},
          {"hausdorff_99_9", d.hausdorff.usual}};
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

std::string compare_table(const SceneComparison& comparison) {
  std::string text = fmt::format("{} {}", comparison.scene, view_text(comparison));
  if (!comparison.pictures.empty())
    text += fmt::format(", {:.1f} px of lines are seen", comparison.pictures.front().metrics.true_length);
  TextTable table = lines_table();
  for (const ComparedPicture& compared : comparison.pictures)
    add_lines(table, compared.name, compared.metrics, exactness_text(compared));
  text += "\n" + table.text() + faces_text(comparison);
  if (comparison.guest) text += guest_text(*comparison.guest);
  if (!comparison.stripes_difference.empty())
    text += "the 8080's stripes and their twin differ: " + comparison.stripes_difference + "\n";
  if (comparison.turn) text += turn_text(*comparison.turn);
  return text + reasons_text(comparison.not_applicable);
}

std::string compare_table(const std::string& name, const HeightComparison& comparison) {
  const guests::skala::View& view = comparison.view;
  std::string text =
      fmt::format("{}, {}, {}, rotated {}, seen from {} degrees", name, picture_name(view.picture),
                  compared_families[static_cast<std::size_t>(view.family)], view.rotation, view.elevation);
  if (!comparison.rasters.empty()) {
    const PixelMetrics& any = comparison.rasters.front().metrics;
    text += fmt::format(", {} of {} points are lit, {} at edges", any.lit, any.pixels, any.boundary_pixels);
  }
  if (view.picture == guests::skala::PictureKind::contours) text += fmt::format(", {} levels", view.levels);
  TextTable table = points_table();
  for (const ComparedRaster& compared : comparison.rasters)
    add_points(table, compared.name, compared.metrics);
  text += "\n" + table.text() + dots_text(comparison);
  for (const ComparedVectors& vectors : comparison.vectors) {
    TextTable lines = lines_table();
    add_lines(lines, vectors.name, vectors.metrics, "");
    text +=
        fmt::format("as lines, of which {:.1f} px are seen\n", vectors.metrics.true_length) + lines.text();
  }
  text += comparison.agrees()
              ? fmt::format("guest and twin: identical in every dot and mask; drawn in {:.3f} s\n",
                            static_cast<double>(comparison.guest_time.count()) /
                                static_cast<double>(core::ClockRate{}.hertz))
              : "guest and twin differ: " + comparison.guest_difference + "\n";
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
                        {"raster", raster_json(turn.raster)},
                        {"hausdorff_99_9", turn.distance.usual}};
  }
  document["not_compared"] = reasons_json(comparison.not_applicable);
  return document;
}

Json compare_json(const std::string& name, const HeightComparison& comparison) {
  Json document{{"function", name},
                {"picture", picture_name(comparison.view.picture)},
                {"rotation", comparison.view.rotation},
                {"elevation", comparison.view.elevation},
                {"agrees", comparison.agrees()},
                {"pictures", Json::array()}};
  for (const ComparedRaster& compared : comparison.rasters) {
    Json row = points_json(compared.name, compared.metrics);
    row["rounding"] = compared.rounding;
    if (compared.unrounded) row["unrounded"] = unrounded_json(*compared.unrounded);
    if (compared.from_native) row["from_native"] = raster_json(*compared.from_native);
    document["pictures"].push_back(std::move(row));
  }
  document["chord_error"] = comparison.chord ? Json(comparison.chord->greatest) : Json(nullptr);
  // An object; of several methods a list of them.
  for (const ComparedVectors& vectors : comparison.vectors) {
    Json object{{"name", vectors.name}};
    object.update(metrics_json(vectors.metrics));
    if (comparison.vectors.size() > 1)
      document["vectors"].push_back(std::move(object));
    else
      document["vectors"] = std::move(object);
  }
  document["guest"] = {{"identical_to_twin", comparison.agrees()},
                       {"difference", comparison.guest_difference},
                       {"t_states", comparison.guest_time.count()}};
  return document;
}

std::vector<std::string> write_overlays(const std::string& directory, const std::string& name,
                                        const SceneComparison& comparison) {
  std::vector<std::string> paths;
  const compare::ScreenFrame& frame = comparison.frame;
  for (const ComparedPicture& compared : comparison.pictures) {
    const LineMetrics& m = compared.metrics;
    const std::string title =
        fmt::format("{}: {} against the oracle, {}", comparison.scene, compared.name, view_text(comparison));
    const picture::OverlayCaption caption = lines_caption(title, m);
    write_overlay(
        overlay_base(directory, name, compared.name),
        picture::overlay_of(compared.difference, {frame.low, frame.low}, {frame.high, frame.high}, caption),
        title, paths);
  }
  for (const compare::ComparedFaces& compared : comparison.faces) {
    const std::string title = fmt::format("{}: faces by {} against the nearest ones, {}", comparison.scene,
                                          compared.name, view_text(comparison));
    write_overlay(overlay_base(directory, name, compared.name + " faces"),
                  picture::overlay_of(compared.truth, compared.grid, points_caption(title, compared.metrics)),
                  title, paths);
  }
  return paths;
}

std::vector<std::string> write_overlays(const std::string& directory, const std::string& name,
                                        const HeightComparison& comparison) {
  std::vector<std::string> paths;
  for (const ComparedRaster& compared : comparison.rasters) {
    const PixelMetrics& m = compared.metrics;
    const std::string title =
        fmt::format("{}, {}: {} against {}", name, picture_name(comparison.view.picture), compared.name,
                    compared.against);
    const picture::OverlayCaption caption = points_caption(title, m);
    write_overlay(overlay_base(directory, name, compared.name),
                  picture::overlay_of(compared.truth.value_or(comparison.truth), compared.grid, caption),
                  title, paths);
  }
  for (const ComparedVectors& vectors : comparison.vectors) {
    const std::string title = fmt::format("{}, {}: {} against what is truly seen of them", name,
                                          picture_name(comparison.view.picture), vectors.name);
    write_overlay(
        overlay_base(directory, name, vectors.name),
        picture::overlay_of(vectors.difference, {0, 0}, {255, 255}, lines_caption(title, vectors.metrics)),
        title, paths);
  }
  return paths;
}

}  // namespace sightline::app
