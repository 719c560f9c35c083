// The events that a search reports to a listener. A search without a listener is compiled separately and has no cost for
// it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/jones/sight_plane.hpp"
#include "host/algorithms/jones/stretch.hpp"
#include "host/scene/model/cell_complex.hpp"

namespace sightline::algorithms::jones {

enum class PortalTest : std::uint8_t {
  faces_away,    // the eye is not on the cell's side of the portal
  nothing_left,  // nothing of the portal is inside the mask
  waits,         // the cell beyond is pending, seen through what is left of the portal
};

class Trace {
 public:
  // A plane of sight (a, b, c, d): seen points have a x + b y + c z >= d.
  using Plane = std::array<double, 4>;

  virtual ~Trace() = default;
  // If true, the search ends before the next cell, and the picture is incomplete.
  [[nodiscard]] virtual bool enough() const { return false; }
  virtual void start(std::span<const scene::CellNumber> cells, bool outside) = 0;
  // The search enters a cell, which it sees within these planes.
  virtual void entered(scene::CellNumber cell, std::uint32_t depth, std::span<const Plane> mask) = 0;
  // A line of the cell on the edge between two vertices: the mask leaves [low, high] of the edge, or nothing if not
  // `seen`.
  virtual void line(scene::VertexIndex from, scene::VertexIndex to, bool seen, double low, double high) = 0;
  // A portal of the cell. With PortalTest::waits, `mask` holds the planes of the mask that is left.
  virtual void portal(std::uint32_t number, scene::CellNumber beyond, PortalTest result, std::span<const Plane> mask) = 0;
};

// The listener that does nothing.
struct NoListener {
  static constexpr bool enough() { return false; }
  template <class Planes>
  void entered(scene::CellNumber, std::uint32_t, const Planes&) {}
  void portal(std::uint32_t, scene::CellNumber, PortalTest) {}
  template <class Sides, class Planes>
  void waits(std::uint32_t, scene::CellNumber, const Sides&, const Planes&) {}
  void hidden(scene::VertexIndex, scene::VertexIndex) {}
  template <class Part>
  void seen(scene::VertexIndex, scene::VertexIndex, const Part&) {}
};

// Forwards everything to a Trace.
class TraceListener {
 public:
  explicit TraceListener(Trace& trace) : trace_(&trace) {}

  [[nodiscard]] bool enough() const { return trace_->enough(); }

  template <class Planes>
  void entered(scene::CellNumber cell, std::uint32_t depth, const Planes& planes) {
    std::vector<Trace::Plane> mask;
    for (const auto& plane : planes) mask.push_back(plane_of(plane));
    trace_->entered(cell, depth, mask);
  }
  void portal(std::uint32_t number, scene::CellNumber beyond, PortalTest result) { trace_->portal(number, beyond, result, {}); }
  template <class Sides, class Planes>
  void waits(std::uint32_t number, scene::CellNumber beyond, const Sides& sides, const Planes& planes) {
    std::vector<Trace::Plane> mask;
    for (const auto& side : sides) mask.push_back(plane_of(planes[side.plane]));
    trace_->portal(number, beyond, PortalTest::waits, mask);
  }
  void hidden(scene::VertexIndex from, scene::VertexIndex to) { trace_->line(from, to, false, 0, 0); }
  template <class Part>
  void seen(scene::VertexIndex from, scene::VertexIndex to, const Part& part) {
    trace_->line(from, to, true, value_of(part.low), value_of(part.high));
  }

 private:
  template <class Number>
  static Trace::Plane plane_of(const SightPlane<Number>& plane) {
    return {static_cast<double>(plane.normal[0]), static_cast<double>(plane.normal[1]), static_cast<double>(plane.normal[2]),
            static_cast<double>(plane.offset)};
  }
  template <class Number>
  static double value_of(const Fraction<Number>& fraction) {
    return static_cast<double>(fraction.numerator) / static_cast<double>(fraction.denominator);
  }

  Trace* trace_;
};

}  // namespace sightline::algorithms::jones
