// The parts of `sightline draw`, and the options that its methods share: where the drawing goes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/registry/heights.hpp"
#include "host/app/camera_options.hpp"
#include "host/app/command_line.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/picture/plotter.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::app {

// `draw METHOD SCENE` for a method that says which face is seen at each point: filled faces, their outlines,
// or a flight as an animated PNG. The method is one of the registry's, which does not end.
void add_draw_faces(const Command& command, const registry::FaceAlgorithm& algorithm);
// `draw METHOD GRID` for a method that draws a surface over a grid of heights as vectors. The method is one of
// the registry's, which does not end.
void add_draw_heights(const Command& command, const registry::HeightAlgorithm& algorithm);

// --- where to

struct DrawOutput {
  std::optional<Command> command;  // whose options these are
  std::string file;
  std::string format;            // empty: as the file's name says
  picture::Paper paper;          // SVG and HP-GL, and an image with a size; read_draw_output settles it
  double margin = 10;            // as given: that of the paper is wider where the plotter needs that, and 0 with a scale
  std::string size = "200x200";  // of the paper: a name, or millimetres
  bool landscape = false;
  std::string scale;  // "N:M", of a drawing that is not stretched to the paper; empty: none
  std::array<double, 2> room{};  // for a drawing with a scale, around the middle of the paper, in mm
  std::string pixels = "1024x1024";
  double dpi = 150;
  picture::ImageSize image;
  bool as_found = false;  // not in the order of a pen
  double min_gap = 0;
  std::string device;
  std::vector<int> pens;
  std::optional<double> speed;
  bool relative = false;
  bool report = false;

  [[nodiscard]] bool is_sheet() const;  // an image of a whole sheet of paper
  [[nodiscard]] const picture::Plotter* plotter() const;
};

// --output, --format, of the paper, of the pen, of an image.
void add_draw_output_options(const Command& command, DrawOutput& output);

// Reads the sizes and the ending of the file: .svg, .png, .plt, .hpgl, .pdf, .dxf, .steps, in small or capital letters. Error
// usage, also of an option that the format does not have, or of paper that the plotter does not take.
[[nodiscard]] hidden_lines::Format read_draw_output(DrawOutput& output);

// Error usage if `option` was given: it means nothing without what `needed` names.
void refuse_option(const DrawOutput& output, const std::string& option, std::string_view needed);

// "210 x 297 mm" of paper, "1024 x 1024 pixels" of an image; of settled options.
[[nodiscard]] std::string size_text(const DrawOutput& output, hidden_lines::Format format);

// "N:M", such as 1:50, as N / M. Error usage.
[[nodiscard]] double scale_argument(const std::string& text);
// Error usage, with the paper that is needed: a drawing with a scale does not fit into output.room.
void require_room(const picture::VectorDrawing& drawing, const DrawOutput& output);

// Into output.file, opened before the drawing was made, in the order of a pen. It is there whole or not at all. Error
// io. A drawing of nothing is warned about, and so are layers that share a pen. Result: of what is drawn with a pen, how far that
// travels.
std::optional<base::Json> write_drawing(const picture::VectorDrawing& drawing, const DrawOutput& output, hidden_lines::Format format,
                                        const std::string& title, Output& file);

}  // namespace sightline::app
