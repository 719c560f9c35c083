// The part of `sightline demo` that draws scenes in stripes on the 8080: on the raster board, and one of them on the plotter.
#pragma once

#include <string>
#include <vector>

#include "host/base/json.hpp"
#include "host/programs/stripes/stripes.hpp"

namespace sightline::app {

struct StripesDemoRow {
  std::string scene;
  bool plotter = false;
  bool antialias = false;
  programs::stripes::Outcome drawn{};
};

// Writes SCENE-stripes.png and, with antialiasing, SCENE-stripes-antialias.png into `directory`. Error as programs::stripes::run, or io.
[[nodiscard]] std::vector<StripesDemoRow> run_stripes_demo(const std::string& directory);
// The name of a row's picture.
[[nodiscard]] std::string stripes_picture(const StripesDemoRow& row);
[[nodiscard]] std::string stripes_demo_table(const std::vector<StripesDemoRow>& rows);
// Adds "stripes".
void add_stripes_demo(base::Json& document, const std::vector<StripesDemoRow>& rows);

}  // namespace sightline::app
