// The page that `sightline demo` writes beside its pictures: three answers, the table, the plot, the pictures, and the numbers
// behind them folded. HTML and CSS in one file, no scripts; the pictures are files beside it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/app/commands/demo_verdicts.hpp"

namespace sightline::app {

struct PageFigure {
  std::string file;     // beside the page
  std::string caption;  // also what is said of it to those who do not see it
  bool points = false;  // made of few points: enlarged without smoothing
};

struct PageGallery {
  std::string title;
  int columns = 3;  // 3 or 4, on a screen that is wide enough
  std::string text;
  std::vector<PageFigure> figures;
};

struct DemoPage {
  ThreeAnswers answers;
  std::vector<Verdict> verdicts;
  std::vector<PageGallery> galleries;
  std::vector<std::pair<std::string, std::string>> tables;  // title and text, as printed with letters of one width
};

// Texts are escaped here.
[[nodiscard]] std::string demo_page(const DemoPage& page, const DemoAnswer& answer);

// The pictures that were written, for the page. Writes SCENE-difference.png and FUNCTION-difference.png: what the devices lit
// beside what exact lines light by the same rule. Error io.
[[nodiscard]] std::vector<PageGallery> demo_galleries(const std::string& directory, const DemoResults& results);

}  // namespace sightline::app
