// What `sightline draw` shows of a scene by a method that finds visible lines: edges, lines in which bodies pass through
// each other, hatching; one layer or many.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "host/algorithms/registry/lines.hpp"
#include "host/app/edge_options.hpp"
#include "host/compare/matter_scene.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::app {

struct LineViewOptions {
  EdgeArguments edges;
  std::string layers = "kind";  // kind, body or none
  bool hidden = false;          // hidden lines, dashed
  struct Hatch {
    double angle = 45;  // degrees on the paper
    double spacing = 1;  // mm
    // Towards it, in the axes of the file; by default from above left, behind the eye.
    std::optional<std::array<double, 3>> light = {};
  };
  std::optional<Hatch> hatch = {};
  // Strokes as text are wanted, their ends this far from the bottom left of the field's surroundings.
  std::optional<double> strokes_margin = {};
  unsigned jobs = 1;  // threads for a view, of an algorithm that can use more than one
};

// One view as drawn.
struct DrawnView {
  registry::LineView view;  // of the edges chosen, before coplanar ones are left out
  std::optional<std::size_t> edges = {};  // chosen, before any was hidden; empty: all of the scene
  std::optional<std::array<std::size_t, picture::edge_kind_count>> by_kind;
  std::size_t pieces = 0;       // drawn, hatching apart
  double visible_length = 0;    // of `view`, see picture::image_length
  std::size_t hatch_lines = 0;  // before any was hidden
  std::size_t hatch_pieces = 0;
  std::size_t strokes = 0;      // straight lines of the drawing, each stretch of paper once
  double drawn_length = 0;      // of all of them, in the unit of the field
  // If wanted: JSON, one line for each stroke. Its ends; its kind and layer; the edges that it comes from, by their ends in the
  // unit of the file; the numbers of the faces at these.
  std::string strokes_text;
  picture::VectorDrawing drawing;
};

class LineViews {
 public:
  // The scene outlives this, and so does `matter`, which is null or the scene's: then its real lines are drawn, not the edges of faces.
  // A warning for bodies that pass through each other, if the algorithm cannot draw that.
  // Error usage: the algorithm does not apply.
  LineViews(const registry::LineAlgorithm& algorithm, const scene::LoadedScene& source, const LineViewOptions& options,
            const compare::MatterScene* matter = nullptr);
  ~LineViews();
  LineViews(const LineViews&) = delete;
  LineViews& operator=(const LineViews&) = delete;

  // Error bad_input: the algorithm does not apply to the view.
  [[nodiscard]] DrawnView at(const scene::PolyCamera& camera, const picture::DrawingField& field);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace sightline::app
