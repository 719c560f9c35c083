#include "host/algorithms/jones/visible_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "host/algorithms/jones/search.hpp"
#include "host/algorithms/jones/start_cells.hpp"
#include "host/algorithms/jones/trace.hpp"
#include "host/base/result.hpp"

namespace sightline::algorithms::jones {
namespace {

enum class Width : std::uint8_t { narrow, medium, wide };

// The width of the numbers that a view of the complex needs (arithmetic.hpp); nullopt if no width suffices.
std::optional<Width> width_for(const PreparedComplex& prepared, const scene::PolyCamera& camera) {
  double forward = 0;
  double greatest_forward = 0;
  for (const std::int32_t part : camera.forward) {
    forward += std::fabs(static_cast<double>(part));
    greatest_forward = std::max(greatest_forward, std::fabs(static_cast<double>(part)));
  }
  const double component = prepared.greatest_component();
  const double value = prepared.greatest_value();
  const double m = camera.perspective ? std::max(2 * component * value, greatest_forward)
                                      : 2 * component * component * forward;
  const double c = camera.perspective ? 0 : 2 * component * forward * value;
  const double at_vertex = 3 * 0x1p19 * m + c;
  const double ray = 2 * m * std::max(m, c);
  const double sign = 3 * ray * m;
  if (value >= 0x1p62) return std::nullopt;
  if (sign < 0x1p63 && at_vertex < 0x1p62) return Width::narrow;
  if (sign < 0x1p127 && at_vertex < 0x1p62) return Width::medium;
  if (sign < 0x1p383 && ray < 0x1p255 && at_vertex < 0x1p126) return Width::wide;
  return std::nullopt;
}

bool too_far(const scene::PolyPoint& eye) {
  return std::any_of(eye.begin(), eye.end(), [](std::int32_t coordinate) {
    return std::abs(std::int64_t{coordinate}) >= scene::poly_coordinate_limit;
  });
}

}  // namespace

struct Walker::State {
  explicit State(const PreparedComplex& complex) : prepared(&complex), reached(complex.complex()) {}

  const PreparedComplex* prepared;
  Reached reached;
  Search<NarrowArithmetic> narrow;
  Search<MediumArithmetic> medium;
  Search<WideArithmetic> wide;
};

Walker::Walker(const PreparedComplex& prepared) : state_(std::make_unique<State>(prepared)) {}
Walker::~Walker() = default;
Walker::Walker(Walker&&) noexcept = default;
Walker& Walker::operator=(Walker&&) noexcept = default;

base::Result<View> Walker::visible_edges(const scene::PolyCamera& camera) {
  const PreparedComplex& prepared = *state_->prepared;
  if (too_far(camera.eye)) return base::bad_input(eye_too_far);
  const std::optional<Width> width = width_for(prepared, camera);
  if (!width) return base::bad_input(plane_too_long);
  const std::optional<Start> start = find_start(prepared, camera);
  if (!start) return base::bad_input(eye_in_solid);
  switch (*width) {
    case Width::narrow: return state_->narrow.run(prepared, state_->reached, camera, *start);
    case Width::medium: return state_->medium.run(prepared, state_->reached, camera, *start);
    case Width::wide: break;
  }
  return state_->wide.run(prepared, state_->reached, camera, *start);
}

base::Result<View> visible_edges(const scene::CellComplex& complex, const scene::PolyCamera& camera, Trace& trace) {
  const PreparedComplex prepared(complex);
  if (too_far(camera.eye)) return base::bad_input(eye_too_far);
  if (!width_for(prepared, camera)) return base::bad_input(plane_too_long);
  const std::optional<Start> start = find_start(prepared, camera);
  if (!start) return base::bad_input(eye_in_solid);
  trace.start(start->cells, start->outside);
  Reached reached(complex);
  // The widest numbers suffice for every view and give the same result.
  Search<WideArithmetic, TraceListener> search{TraceListener(trace)};
  return search.run(prepared, reached, camera, *start);
}

base::Result<View> visible_edges(const scene::CellComplex& complex, const scene::PolyCamera& camera) {
  const PreparedComplex prepared(complex);
  return Walker(prepared).visible_edges(camera);
}

}  // namespace sightline::algorithms::jones
