// The parts of `sightline draw`, and the options that its methods share: where the drawing goes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/registry/heights.hpp"
#include "host/app/camera_options.hpp"
#include "host/app/command_line.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::app {

// `draw METHOD SCENE` for a method that says which face is seen at each point: filled faces, their outlines,
// or a flight as an animated PNG. The method is one of the registry's, which does not end.
void add_draw_faces(const Command& command, const registry::FaceAlgorithm& algorithm);
// `draw METHOD GRID` for a method that draws a surface over a grid of heights as vectors. The method is one of
// the registry's, which does not end.
void add_draw_heights(const Command& command, const registry::HeightMethod& method);

// --- where to

enum class DrawingFormat { svg, png, hpgl };

struct DrawOutput {
  std::optional<Command> command;  // whose options these are
  std::string file;
  picture::Paper paper;          // SVG and HP-GL
  std::string size = "200x200";  // of the paper, millimetres
  std::string pixels = "1024x1024";
  picture::ImageSize image;
};

// --output, --size, --margin, --pen, --pixels.
void add_draw_output_options(const Command& command, DrawOutput& output);

// Reads the sizes and the ending of the file: .svg, .png, .plt, .hpgl, in small or capital letters. Failure
// usage, also of a size that the format does not have.
[[nodiscard]] DrawingFormat read_draw_output(DrawOutput& output);

// Failure usage if `option` was given: it means nothing without what `needed` names.
void refuse_option(const DrawOutput& output, const std::string& option, std::string_view needed);

// Into output.file, opened before the drawing was made. It is there whole or not at all. Failure io. A
// drawing of nothing is warned about.
void write_drawing(const picture::VectorDrawing& drawing, const DrawOutput& output, DrawingFormat format,
                   const std::string& title, Output& file);

}  // namespace sightline::app
