// Where a drawing goes: the format by the file's name, the size of paper or image. For every algorithm of
// `sightline draw`.
#pragma once

#include <string>

#include "host/app/command.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::app {

enum class DrawingFormat { svg, png, hpgl };

struct DrawOutput {
  std::string file;
  picture::Paper paper;          // SVG and HP-GL
  std::string size = "200x200";  // of the paper, millimetres
  std::string pixels = "1024x1024";
  picture::ImageSize image;
};

// --output, --size, --margin, --pen, --pixels.
void add_draw_output_options(CLI::App& command, DrawOutput& output);

// Reads the sizes and the ending of the file: .svg, .png, .plt, .hpgl. Failure usage.
[[nodiscard]] DrawingFormat settled(DrawOutput& output);

// The file is there whole or not at all. Failure io.
void write_drawing(const picture::VectorDrawing& drawing, const DrawOutput& output, DrawingFormat format,
                   const std::string& title);

}  // namespace sightline::app
