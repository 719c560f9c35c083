// Where a drawing goes: the format by the file's name, the size of paper or image. For every algorithm of
// `sightline draw`.
#pragma once

#include <string>
#include <string_view>

#include "host/app/command_line.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::app {

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
[[nodiscard]] DrawingFormat settled(DrawOutput& output);

// Failure usage if `option` was given: it means nothing without what `needed` names.
void refuse_option(const DrawOutput& output, const std::string& option, std::string_view needed);

// Into output.file, opened before the drawing was made. It is there whole or not at all. Failure io. A
// drawing of nothing is warned about.
void write_drawing(const picture::VectorDrawing& drawing, const DrawOutput& output, DrawingFormat format,
                   const std::string& title, Output& file);

}  // namespace sightline::app
