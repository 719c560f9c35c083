// The page that `sightline demo` writes beside its pictures: three answers, the table, the plot, the pictures, and, folded, all
// numbers. It is one file of HTML and CSS without scripts; the pictures are separate files.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/app/commands/demo_verdicts.hpp"

namespace sightline::app {

struct PageFigure {
  std::string file;     // in the folder of the page
  std::string caption;  // also the alternative text
  bool points = false;  // a picture of few points, enlarged without smoothing
};

struct PageGallery {
  std::string title;
  int columns = 3;  // 3 or 4, if the screen is wide enough
  std::string text;
  std::vector<PageFigure> figures;
};

struct DemoPage {
  ThreeAnswers answers;
  std::vector<Verdict> verdicts;
  std::vector<PageGallery> galleries;
  std::vector<std::pair<std::string, std::string>> tables;  // title, and text in a fixed-width font
};

// Escapes all texts.
[[nodiscard]] std::string demo_page(const DemoPage& page, const DemoAnswer& answer);

// The galleries of the page. Writes SCENE-difference.png and FUNCTION-difference.png, which compare the points that the devices lit
// with those that exact lines light by the same rule. Error io.
[[nodiscard]] std::vector<PageGallery> demo_galleries(const std::string& directory, const DemoResults& results);

}  // namespace sightline::app
