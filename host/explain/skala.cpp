#include "host/explain/skala.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "host/algorithms/skala/draw.hpp"
#include "host/explain/stage.hpp"

namespace sightline::explain {
namespace {

using algorithms::skala::Piece;
using algorithms::skala::Vertex;

constexpr int columns = 256;  // of a mask, as in the paper
constexpr float nothing = 1e29F;
constexpr double extent = 255;
// The first slices have a step for each line; each further slice is one step.
constexpr std::size_t rows_in_full = 2;

Point place(Vertex vertex) { return {(static_cast<double>(vertex.x) + 0.5) * extent / columns, static_cast<double>(vertex.y)}; }

class SkalaRecorder final : public algorithms::skala::Trace {
 public:
  explicit SkalaRecorder(Steps& steps) : steps_(steps) { count(); }

  void line(std::span<const Vertex> points, std::span<const Piece> pieces) override {
    ++lines_;
    std::vector<Point> whole;
    for (const Vertex vertex : points) whole.push_back(place(vertex));
    now_.push_back(explain::line(Look::hidden, std::move(whole)));
    for (const Piece& piece : pieces) {
      now_.push_back(explain::line(Look::now, {place(piece.from), place(piece.to)}));
      seen_.push_back(explain::line(Look::seen, {place(piece.from), place(piece.to)}));
      ++pieces_;
    }
    if (pieces.empty()) ++hidden_;
    count();
    if (row_ >= rows_in_full) return;
    steps_.add(pieces.empty() ? "The next line lies between the masks in every column: it is hidden."
                              : fmt::format("The next line is compared with the masks column by column. {} visible {}: above the upper mask or below the "
                                            "lower one.",
                                            pieces.size(), pieces.size() == 1 ? "piece is" : "pieces are"),
               "section 3", {{0, "now", std::vector<Mark>(now_)}});
  }

  void row_ended(std::span<const float> top, std::span<const float> bottom) override {
    const std::size_t hidden = hidden_ - hidden_before_;
    hidden_before_ = hidden_;
    ++row_;
    count();
    if (row_ > rows_in_full) {
      steps_.add(fmt::format("Slice {} and the edges beside it: what lies above the upper mask or below the lower mask is drawn, what lies between them "
                             "is hidden.{}",
                             row_, hidden == 0 ? std::string() : fmt::format(" {} lines are hidden wholly.", hidden)),
                 "section 3", {{0, "now", std::move(now_)}});
    }
    now_.clear();
    steps_.add(row_ == 1 ? "The first slice has nothing before it. In every column its height is now both the upper and the lower mask."
                         : "The masks grow: in every column the highest and the lowest point drawn so far.",
               "section 3", {{0, "now", {}}, {0, "seen", seen_}, {0, "masks", masks(top, bottom)}});
  }

 private:
  static void add_mask(std::vector<Mark>& marks, std::span<const float> heights) {
    std::vector<Point> run;
    const auto flush = [&] {
      if (run.size() > 1) marks.push_back(explain::line(Look::mask, run));
      run.clear();
    };
    for (std::size_t column = 0; column < heights.size(); ++column) {
      if (std::abs(heights[column]) > nothing) flush();
      else run.push_back(place({static_cast<float>(column), heights[column]}));
    }
    flush();
  }
  static std::vector<Mark> masks(std::span<const float> top, std::span<const float> bottom) {
    std::vector<Mark> marks;
    add_mask(marks, top);
    add_mask(marks, bottom);
    return marks;
  }
  void count() {
    steps_.count("slices", row_);
    steps_.count("lines compared", lines_);
    steps_.count("hidden wholly", hidden_);
    steps_.count("pieces drawn", pieces_);
  }

  Steps& steps_;
  std::vector<Mark> now_;
  std::vector<Mark> seen_;
  std::size_t row_ = 0, lines_ = 0, hidden_ = 0, hidden_before_ = 0, pieces_ = 0;
};

}  // namespace

base::Result<Lesson> explain_skala(const scene::HeightGrid& grid, double rotation, double elevation) {
  algorithms::skala::View view;
  view.rotation = rotation;
  view.elevation = elevation;
  view.columns = columns;
  Lesson lesson{"skala", "Skala 1985: the floating horizon, by two masks", {}, {}, {}};
  lesson.sheets = {{"The picture; in orange the two masks", {-4, -4}, {extent + 4, extent + 4}}};
  Steps steps(lesson);
  SkalaRecorder recorder(steps);
  const auto plain = [&] {
    view.visibility = false;
    const auto drawing = algorithms::skala::draw(grid, view);
    view.visibility = true;
    std::vector<Mark> marks;
    for (const auto& each : drawing.lines) {
      std::vector<Point> points;
      for (std::uint32_t i = 0; i < each.count; ++i) {
        const auto& p = drawing.points[each.first + i];
        points.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
      }
      marks.push_back(line(Look::faint, std::move(points)));
    }
    return marks;
  };
  steps.add("All slices of the surface, none of them hidden. They are drawn from the foreground to the background, so that each meets only what "
            "may hide it.",
            "section 2", {{0, "all", plain()}});
  const auto drawing = algorithms::skala::draw(grid, view, recorder);
  std::vector<Mark> seen;
  for (const auto& each : drawing.lines) {
    std::vector<Point> points;
    for (std::uint32_t i = 0; i < each.count; ++i) {
      const auto& p = drawing.points[each.first + i];
      points.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
    }
    seen.push_back(points.size() > 1 ? line(Look::seen, std::move(points)) : dot(Look::seen, points.front()));
  }
  steps.add("Every slice has been compared with the masks: the picture is complete.", "section 6",
            {{0, "all", {}}, {0, "masks", {}}, {0, "now", {}}, {0, "seen", std::move(seen)}});
  return lesson;
}

}  // namespace sightline::explain
