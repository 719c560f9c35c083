// The law of fitted frames: no line of a picture is lost, added or moved between the algorithm's pieces and the file. Random
// boxes from
// random sides on random paper, in every format, read back by the rules of the format. The expected positions are computed here
// from the
// definitions of a camera (PolyCamera) and of a fitted drawing.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/picture/dxf.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/pdf.hpp"
#include "host/picture/pen_order.hpp"
#include "host/picture/plotter.hpp"
#include "host/picture/step_file.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/read_drawing.hpp"

namespace sightline::picture {
namespace {

using programs::jones::Dice;
using tests::DrawnSegment;

struct View {
  scene::PolyScene scene;
  scene::PolyCamera camera;
};

std::optional<View> random_view(Dice& dice) {
  scene::PolyBuilder builder;
  const std::int32_t reach = dice(0, 1) == 0 ? 60 : 60'000;
  for (int b = dice(1, 2); b > 0; --b) {
    scene::PolyPoint low{};
    scene::PolyPoint high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = dice(-reach, reach - 1);
      high[a] = dice(low[a] + 1, reach);
    }
    builder.add_box("", low, high);
  }
  View view{builder.take(), {}};
  const scene::SceneFrame frame = scene::frame_of(scene::PolyCamera{});
  std::array<double, 3> direction{};
  const std::int32_t most = dice(0, 2) == 0 ? 1 : 20;  // 1: along axes and diagonals
  for (double& c : direction) c = dice(-most, most);
  if (direction == std::array<double, 3>{}) return std::nullopt;
  view.camera = scene::camera_outside(frame, view.scene, direction, dice(0, 1) == 0);
  if (scene::eye_error(view.scene, view.camera)) return std::nullopt;
  return view;
}

// The pieces in millimetres of the field, by the definitions alone. Empty if the picture cannot be fitted.
std::optional<std::vector<DrawnSegment>> expected_lines(const View& view, const LinePicture& picture, double width, double height) {
  const auto unit = [](const scene::PolyPoint& v) {
    const long double length = std::sqrt(static_cast<long double>(v[0]) * v[0] + static_cast<long double>(v[1]) * v[1] +
                                         static_cast<long double>(v[2]) * v[2]);
    return std::array<long double, 3>{v[0] / length, v[1] / length, v[2] / length};
  };
  const std::array axes{unit(view.camera.right), unit(view.camera.up), unit(view.camera.forward)};
  std::vector<DrawnSegment> lines;
  std::array<long double, 4> bounds{1e30L, 1e30L, -1e30L, -1e30L};
  std::vector<std::array<long double, 4>> images;
  for (const LinePiece& piece : picture.pieces) {
    std::array<long double, 4> image{};
    for (std::size_t end = 0; end < 2; ++end) {
      const geometry::Rational& s = end == 0 ? piece.low : piece.high;
      const long double t = static_cast<long double>(s.numerator()) / static_cast<long double>(s.denominator());
      std::array<long double, 3> seen{};
      for (std::size_t a = 0; a < 3; ++a) {
        const long double from = view.scene.vertices[piece.edge.from][a];
        const long double to = view.scene.vertices[piece.edge.to][a];
        for (std::size_t k = 0; k < 3; ++k) seen[k] += axes[k][a] * (from + t * (to - from) - view.camera.eye[a]);
      }
      const long double depth = view.camera.perspective ? seen[2] : 1;
      for (std::size_t a = 0; a < 2; ++a) {
        image[2 * end + a] = seen[a] / depth;
        bounds[a] = std::min(bounds[a], image[2 * end + a]);
        bounds[2 + a] = std::max(bounds[2 + a], image[2 * end + a]);
      }
    }
    images.push_back(image);
  }
  if (images.empty()) return std::nullopt;
  const long double scale = std::min(width / (bounds[2] - bounds[0]), height / (bounds[3] - bounds[1]));
  if (!(scale > 0) || !std::isfinite(scale)) return std::nullopt;
  for (const auto& image : images) {
    DrawnSegment line{};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t a = i % 2;
      const long double size = a == 0 ? width : height;
      line[i] = static_cast<double>(size / 2 + (image[i] - (bounds[a] + bounds[2 + a]) / 2) * scale);
    }
    // A line seen end-on is omitted.
    if (std::hypot(line[2] - line[0], line[3] - line[1]) > 1e-6) lines.push_back(line);
  }
  return lines;
}

// Both ways: each line is in the file, and the file has no other lines.
void expect_same(const std::vector<DrawnSegment>& expected, const std::vector<DrawnSegment>& found, double tolerance) {
  for (const DrawnSegment& line : expected) ASSERT_LE(tests::distance_from(found, line), tolerance) << "a line is missing";
  for (const DrawnSegment& line : found) ASSERT_LE(tests::distance_from(expected, line), tolerance) << "a line is extra";
}

std::vector<DrawnSegment> move_lines(std::vector<DrawnSegment> lines, double scale, double across, double up) {
  for (DrawnSegment& line : lines)
    line = {line[0] * scale + across, line[1] * scale + up, line[2] * scale + across, line[3] * scale + up};
  return lines;
}

// Upright paper lies on its side in the plotter: its top is to the left.
std::vector<DrawnSegment> turn_upright_paper(std::vector<DrawnSegment> lines, double height) {
  for (DrawnSegment& line : lines) line = {height - line[1], line[0], height - line[3], line[2]};
  return lines;
}

// All dark pixels are on the lines, and the lines are on dark pixels.
void expect_pixels(const std::vector<DrawnSegment>& lines, const Image& image) {
  const auto is_dark = [&](int column, int row) { return image.pixels[image.index(column, row)] < 250; };
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      if (!is_dark(column, row)) continue;
      double nearest = 1e9;
      for (const DrawnSegment& line : lines)
        nearest = std::min(nearest, tests::distance_to(line, column + 0.5, image.height - row - 0.5));
      ASSERT_LE(nearest, 2.3) << column << ' ' << row;
    }
  }
  for (const DrawnSegment& line : lines) {
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double x = line[0] + t * (line[2] - line[0]);
      const double y = image.height - (line[1] + t * (line[3] - line[1]));
      bool dark = false;
      for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) {
          const int column = static_cast<int>(std::floor(x)) + i;
          const int row = static_cast<int>(std::floor(y)) + j;
          dark = dark || (0 <= column && column < image.width && 0 <= row && row < image.height && is_dark(column, row));
        }
      ASSERT_TRUE(dark) << x << ' ' << y;
    }
  }
}

TEST(FittedFrame, EveryLineOfThePictureIsInTheFileAndNoOther) {
  Dice dice(38);
  const int cases = tests::effort(10'000, 400);
  int drawn = 0;
  for (int n = 0; n < cases; ++n) {
    const auto view = random_view(dice);
    if (!view) continue;
    const LinePicture picture = algorithms::exact::visible_edges(view->scene, view->camera);
    Paper paper;
    paper.width = dice(30, 900) + dice(0, 999) / 1000.0;
    paper.height = dice(30, 900) + dice(0, 999) / 1000.0;
    paper.margin = dice(0, 14) + dice(0, 1) / 3.0;
    const int format = n % 7;
    const ImageSize pixels{dice(30, 120), dice(30, 120), 1.2};
    if (format == 6) {  // an image, whose field is four pixels per unit
      paper.width = pixels.width / 4.0;
      paper.height = pixels.height / 4.0;
      paper.margin = 0;
    }
    const Plotter* plotter = nullptr;
    if (format == 4) {  // HP-GL of a plotter with limits
      plotter = find_plotter(dice(0, 1) == 0 ? "hp7475a" : "hp7550a");
      const PlotterPaperLimits& sheet = plotter->papers[static_cast<std::size_t>(dice(0, 3))];
      paper.width = sheet.width;
      paper.height = sheet.height;
      if (dice(0, 1) == 0) std::swap(paper.width, paper.height);
    } else if (format == 5) {
      plotter = find_plotter("calcomp");
      paper.height = std::min(paper.height, 279.4);
    }
    if (plotter != nullptr) paper.margin = std::max(paper.margin, *least_margin(*plotter, paper));
    DrawingField field;
    field.width = paper.width - 2 * paper.margin;
    field.height = paper.height - 2 * paper.margin;
    const auto in_field = expected_lines(*view, picture, field.width, field.height);
    if (!in_field) continue;
    // On the paper.
    const std::vector<DrawnSegment> expected = move_lines(*in_field, 1, paper.margin, paper.margin);
    SCOPED_TRACE("case " + std::to_string(n) + ", format " + std::to_string(format));
    VectorDrawing drawing = line_drawing(picture, view->scene, view->camera, field);
    // Half of them in pen order, which joins ends within 0.005 mm and omits corners within 0.001 mm.
    double slack = 0.0001;  // points of a drawing are in single precision
    if (dice(0, 1) == 0) {
      drawing = in_pen_order(drawing, paper);
      slack += 0.006;
    }
    switch (format) {
      case 0: expect_same(expected, tests::segments_of(tests::lines_of_svg(svg_of(drawing, paper, ""), paper.height)), slack + 0.0008); break;
      case 1: expect_same(expected, tests::segments_of(tests::lines_of_pdf(pdf_of(drawing, paper, ""))), slack + 0.0008); break;
      case 2: expect_same(expected, tests::segments_of(tests::lines_of_dxf(dxf_of(drawing, paper))), slack + 0.0008); break;
      case 3: {
        const auto found = tests::segments_of(tests::lines_of_hpgl(hpgl_of(drawing, paper)));
        expect_same(expected, move_lines(found, 0.025, 0, 0), slack + 0.0178);
        break;
      }
      case 4: {
        const bool upright = paper.height > paper.width;
        const std::vector<DrawnSegment> sheet = upright ? turn_upright_paper(expected, paper.height) : expected;
        // The middle of the paper is the middle of the plotter's range.
        double x = 0;
        double y = 0;
        for (const PlotterPaperLimits& limits : plotter->papers)
          if (limits.width == std::max(paper.width, paper.height)) {
            x = (limits.x * 0.025 - limits.width) / 2;
            y = (limits.y * 0.025 - limits.height) / 2;
          }
        const auto found = tests::segments_of(tests::lines_of_hpgl(hpgl_of(drawing, paper, {.plotter = plotter})));
        expect_same(move_lines(sheet, 1, x, y), move_lines(found, 0.025, 0, 0), slack + 0.0178);
        break;
      }
      case 5: {
        const auto found = tests::segments_of(tests::lines_of_steps(step_file_of(drawing, paper)));
        const double up = (279.4 - paper.height) / 2;
        expect_same(move_lines(expected, 1, 0, up), move_lines(found, 0.254, 0, 0), slack + 0.36);
        break;
      }
      default: {
        // Half a pen width and half a pixel are kept free around it.
        const double margin = 1.2 / 2 + 0.5;
        std::vector<DrawnSegment> lines = *in_field;
        for (DrawnSegment& line : lines)
          for (std::size_t i = 0; i < 4; ++i) {
            const double size = i % 2 == 0 ? pixels.width : pixels.height;
            line[i] = margin + line[i] / (i % 2 == 0 ? field.width : field.height) * (size - 2 * margin);
          }
        expect_pixels(lines, image_of(drawing, pixels));
        break;
      }
    }
    if (HasFatalFailure()) return;
    ++drawn;
  }
  EXPECT_GT(drawn, cases * 8 / 10);
}

}  // namespace
}  // namespace sightline::picture
