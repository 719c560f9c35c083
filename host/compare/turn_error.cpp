// See turn_error.hpp.
#include "host/compare/turn_error.hpp"

#include <algorithm>
#include <cmath>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/frame.hpp"

namespace sightline::compare {
namespace {

namespace plantinga = algorithms::plantinga;
using plantinga::EdgeIndex;

// A structure as parts, with ends placed at the frame's angle.
EdgeParts parts_of(const plantinga::FrameMaker& frame, EdgeIndex edge, const plantinga::EdgeStructure& structure) {
  EdgeParts parts;
  for (const plantinga::Piece& piece : structure) {
    const double low = frame.parameter_of(edge, piece.low);
    const double high = frame.parameter_of(edge, piece.high);
    if (low < high) parts.emplace_back(low, high);
  }
  return parts;
}

double in_both(const EdgeParts& a, const EdgeParts& b) {
  double sum = 0;
  for (const auto& [low, high] : a)
    for (const auto& [other_low, other_high] : b) sum += std::max(0.0, std::min(high, other_high) - std::max(low, other_low));
  return sum;
}

}  // namespace

double length_of(const EdgeParts& parts) {
  double sum = 0;
  for (const auto& [low, high] : parts) sum += high - low;
  return sum;
}

std::vector<ExactFrame> exact_frames(const plantinga::RotationModel& model, const std::vector<double>& wanted) {
  std::vector<std::vector<plantinga::Occluder>> occluders;
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) occluders.push_back(model.occluders_of(edge));
  plantinga::FrameMaker maker(model);
  std::vector<ExactFrame> frames;
  for (const double angle : wanted) {
    constexpr double scale = 0x1p20;
    const plantinga::Sight sight{std::llround(scale * std::sin(angle)), std::llround(scale * std::cos(angle))};
    ExactFrame& frame = frames.emplace_back();
    frame.angle = std::atan2(static_cast<double>(sight.x), static_cast<double>(sight.z));
    maker.place(frame.angle);
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
      const plantinga::Segment s = model.segment(edge);
      const auto across = [&](const plantinga::Vector3& p) {
        return static_cast<double>(p[0]) * std::cos(frame.angle) - static_cast<double>(p[2]) * std::sin(frame.angle);
      };
      frame.lengths.push_back(std::hypot(across(s.to) - across(s.from), static_cast<double>(s.to[1] - s.from[1])));
      frame.structures.push_back(plantinga::structure_at(model, edge, occluders[edge], sight));
      frame.parts.push_back(parts_of(maker, edge, frame.structures.back()));
    }
  }
  return frames;
}

TurnError turn_error(const plantinga::RotationModel& model, const plantinga::EventList& list, const std::vector<ExactFrame>& frames,
                     const std::function<double(double)>& shown) {
  plantinga::EdgeStructureGraph graph(list);
  plantinga::FrameMaker maker(model);
  TurnError error;
  for (const ExactFrame& frame : frames) {
    const double angle = shown(frame.angle);
    static_cast<void>(graph.turn_to(angle));
    maker.place(angle);
    bool same = true;
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
      const plantinga::EdgeStructure structure = graph.structure_of(edge);
      same = same && structure == frame.structures[edge];
      const EdgeParts drawn = parts_of(maker, edge, structure);
      const EdgeParts& exact = frame.parts[edge];
      error.wrong_length += frame.lengths[edge] * (length_of(drawn) + length_of(exact) - 2 * in_both(drawn, exact));
      error.seen_length += frame.lengths[edge] * length_of(exact);
      error.all_length += frame.lengths[edge];
    }
    error.wrong_frames += same ? 0 : 1;
  }
  return error;
}

}  // namespace sightline::compare
