// See compare_output.hpp.
#include "host/app/commands/compare_output.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "host/app/commands/jones_session.hpp"
#include "host/app/commands/skala_options.hpp"
#include "host/app/outputs.hpp"
#include "host/picture/overlay.hpp"

namespace sightline::app {

namespace {

namespace jones = guests::jones;
using compare::ComparedPicture;
using compare::ComparedRaster;
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

std::string point_text(const scene::PolyPoint& p) {
  return fmt::format("{},{},{}", p[0], p[1], p[2]);
}

std::string view_text(const SceneComparison& comparison) {
  const scene::PolyCamera& camera = comparison.camera;
  return camera.perspective ? "from " + point_text(camera.eye)
                            : "along " + point_text(camera.forward) + ", orthographic";
}

std::string lines_heading() {
  return fmt::format("  {:<13}{:<22}{:<22}{:>9}{:>9}{:>9}{:>9}  {:<28}{:>6}\n", "", "missing px", "extra px",
                     "miss >1", "extra >1", "H px", "99.9 %", "wrong points, 95 % interval", "pieces");
}

std::string lines_row(std::string_view name, const LineMetrics& m, std::string_view exactness) {
  const picture::Rate& rate = m.wrong_visibility;
  std::string text = fmt::format(
      "  {:<13}{:<22}{:<22}{:>9.2f}{:>9.2f}{:>9}{:>9}  {:<28}{:>6}  {}", name, pixels_and_share(m, m.missing),
      pixels_and_share(m, m.extra), m.missing_far, m.extra_far, distance_text(m.hausdorff.greatest),
      distance_text(m.hausdorff.usual),
      fmt::format("{:.3f} % ({:.3f} to {:.3f})", 100 * rate.rate, 100 * rate.low, 100 * rate.high),
      m.pieces_different, exactness);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + '\n';
}

std::string points_heading() {
  return fmt::format("  {:<13}{:>14}{:>12}{:>12}{:>10}{:>10}{:>10}{:>10}\n", "", "different", "at edges",
                     "elsewhere", "missing", "extra", "miss >1", "extra >1");
}

std::string points_row(std::string_view name, const PixelMetrics& m) {
  return fmt::format("  {:<13}{:>14}{:>12}{:>12}{:>10}{:>10}{:>10}{:>10}\n", name,
                     fmt::format("{} ({:.3f} %)", m.different(), 100 * m.mismatch()), m.different_on_boundary,
                     m.different_inside, m.missing, m.extra, m.missing_far, m.extra_far);
}

std::string faces_text(const SceneComparison& comparison) {
  if (comparison.faces.empty()) return "";
  const PixelMetrics& any = comparison.faces.front().metrics;
  std::string text =
      fmt::format("faces, by points: {}, {} of them at edges\n", any.pixels, any.boundary_pixels) +
      points_heading();
  for (const compare::ComparedFaces& compared : comparison.faces) {
    text += points_row(compared.name, compared.metrics);
    if (compared.not_solved > 0)
      text += fmt::format("{}: {} pairs of faces it says itself it cannot separate\n", compared.name,
                          compared.not_solved);
    if (!compared.agrees()) text += compared.name + ": NOT THE ORACLE'S\n";
  }
  return text;
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

}  // namespace

std::string compare_table(const SceneComparison& comparison) {
  std::string text = fmt::format("{} {}", comparison.scene, view_text(comparison));
  if (!comparison.pictures.empty())
    text += fmt::format(", {:.1f} px of lines are seen", comparison.pictures.front().metrics.true_length);
  text += "\n" + lines_heading();
  for (const ComparedPicture& compared : comparison.pictures)
    text += lines_row(compared.name, compared.metrics, exactness_text(compared));
  text += faces_text(comparison);
  if (comparison.guest) text += guest_text(*comparison.guest);
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
  text += "\n" + points_heading();
  for (const ComparedRaster& compared : comparison.rasters)
    text += points_row(compared.name, compared.metrics);
  if (comparison.vectors) {
    const LineMetrics& m = comparison.vectors->metrics;
    text += fmt::format("as lines, of which {:.1f} px are seen\n", m.true_length) + lines_heading() +
            lines_row(comparison.vectors->name, m, "");
  }
  text += comparison.agrees()
              ? fmt::format("guest and twin: identical in every dot and mask; drawn in {:.3f} s\n",
                            static_cast<double>(comparison.guest_time.count()) /
                                static_cast<double>(core::ClockRate{}.hertz))
              : "guest and twin differ: " + comparison.guest_difference + "\n";
  return text;
}

std::vector<std::string> write_overlays(const std::string& directory, const SceneComparison& comparison) {
  std::vector<std::string> paths;
  const compare::ScreenFrame& frame = comparison.frame;
  for (const ComparedPicture& compared : comparison.pictures) {
    const LineMetrics& m = compared.metrics;
    const std::string title =
        fmt::format("{}: {} against the oracle, {}", comparison.scene, compared.name, view_text(comparison));
    const picture::OverlayCaption caption = lines_caption(title, m);
    write_overlay(
        overlay_base(directory, comparison.scene, compared.name),
        picture::overlay_of(compared.difference, {frame.low, frame.low}, {frame.high, frame.high}, caption),
        title, paths);
  }
  for (const compare::ComparedFaces& compared : comparison.faces) {
    const std::string title = fmt::format("{}: faces by {} against the nearest ones, {}", comparison.scene,
                                          compared.name, view_text(comparison));
    write_overlay(overlay_base(directory, comparison.scene, compared.name + " faces"),
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
  if (comparison.vectors) {
    const LineMetrics& m = comparison.vectors->metrics;
    const std::string title = fmt::format("{}, {}: {} against what is truly seen of them", name,
                                          picture_name(comparison.view.picture), comparison.vectors->name);
    write_overlay(
        overlay_base(directory, name, comparison.vectors->name),
        picture::overlay_of(comparison.vectors->difference, {0, 0}, {255, 255}, lines_caption(title, m)),
        title, paths);
  }
  return paths;
}

}  // namespace sightline::app
