// The parts of `sightline draw`, and the output options that its methods share.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/registry/heights.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/app/camera_options.hpp"
#include "host/app/command_line.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/plotter.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/surface_net.hpp"

namespace sightline::app {

// Adds `draw METHOD SCENE` for a method that finds the visible face at each point: filled faces, their outlines, or a flight as
// an animated PNG. `algorithm` is an entry of the registry, which exists as long as the program.
void add_draw_faces(const Command& command, const registry::FaceAlgorithm& algorithm);
// Adds `draw METHOD GRID` for a method that draws a surface over a grid of heights as vectors. `algorithm` is an entry of the
// registry.
void add_draw_heights(const Command& command, const registry::HeightAlgorithm& algorithm);

// --- Nets of curves

struct NetView {
  algorithms::skala::BoxSides sides;  // of the box around the net
  double rotation = 0;                // degrees, as of a surface over a grid
  double elevation = 0;
  picture::DrawingField field;
};

// The curves, the border and the silhouette of the net. `name` is its name in errors. Error bad_input: nothing can be drawn of it.
[[nodiscard]] picture::VectorDrawing draw_net(const scene::SurfaceNet& net, const NetView& view, const std::string& name);

// --- Output options

struct DrawOutput {
  std::optional<Command> command;  // the command that has these options
  std::string file;
  std::string format;            // empty: by the extension of the file
  picture::Paper paper;          // for drawings, and images with a size; set by read_draw_output
  double margin = 10;            // as given; that of `paper` is wider if the plotter needs it, and 0 with a scale
  std::string size = "200x200";  // of the paper: a name, or in mm
  bool landscape = false;
  std::string scale;  // "N:M"; empty: the drawing is fitted to the paper
  std::array<double, 2> room{};  // mm around the middle of the paper that a drawing with a scale may fill
  std::string pixels = "1024x1024";
  double dpi = 150;
  picture::ImageSize image;
  bool as_found = false;  // keep the order in which lines were found
  double min_gap = 0;
  std::string device;
  std::vector<int> pens;
  std::optional<double> speed;
  bool relative = false;
  bool report = false;

  [[nodiscard]] bool is_sheet() const;  // whether it is an image of a whole sheet of paper
  [[nodiscard]] const picture::Plotter* plotter() const;
};

// Adds --output, --format and the options for paper, pen and image.
void add_draw_output_options(const Command& command, DrawOutput& output);

// Parses the sizes and the extension of the file (.svg, .png, .plt, .hpgl, .pdf, .dxf, .steps, in any case). Error usage, also
// for an option that the format does not have and for paper that the plotter does not take.
[[nodiscard]] hidden_lines::Format read_draw_output(DrawOutput& output);

// Error usage if `option` was given, because it has no effect without `needed`.
void reject_option(const DrawOutput& output, const std::string& option, std::string_view needed);

// "210 x 297 mm" for paper, "1024 x 1024 pixels" for an image. Called after read_draw_output.
[[nodiscard]] std::string size_text(const DrawOutput& output, hidden_lines::Format format);

// The value N / M of "N:M", such as 1:50. Error usage.
[[nodiscard]] double scale_argument(const std::string& text);
// Error usage if a drawing with a scale does not fit into output.room; the error names the paper that is needed.
void require_room(const picture::VectorDrawing& drawing, const DrawOutput& output);

// Writes a drawing, with its lines ordered for a pen, to output.file, which was opened before. The file is written completely or
// not at all; error io. Warns of an empty drawing and of layers that share a pen. Returns the plot report of formats that a pen
// draws.
std::optional<base::Json> write_drawing(const picture::VectorDrawing& drawing, const DrawOutput& output, hidden_lines::Format format,
                                        const std::string& title, Output& file);

}  // namespace sightline::app
