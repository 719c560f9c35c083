// The masks of horizon.hpp for surfaces with holes and for several surfaces: the occluders in a column are a set of
// intervals. Lines are tested but change no mask; a triangle, or a cell, becomes an occluder when all of its far edges
// are drawn.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/algorithms/skala/coverage.hpp"
#include "host/algorithms/skala/horizon.hpp"

namespace sightline::algorithms::skala {

class GappedHorizon {
 public:
  explicit GappedHorizon(int columns) : coverage_(columns) {}

  // As in Horizon. What is less than 1/64 of a unit behind an outline is visible.
  bool draw(Vertex from, Vertex to, Wake&) { return test(from, to, 0); }
  bool test(Vertex from, Vertex to, float) {
    pieces_.clear();
    const auto at = [&](double t) {
      if (t == 0) return from;
      if (t == 1) return to;
      return Vertex{static_cast<float>(from.x + t * (double{to.x} - double{from.x})), static_cast<float>(from.y + t * (double{to.y} - double{from.y}))};
    };
    if (from == to) {
      // A point: decided by what is a little to its left and right.
      const Vertex left{from.x - 0.25F, from.y};
      const Vertex right{from.x + 0.25F, from.y};
      if (!coverage_.visible(left, right).empty()) pieces_.push_back({from, to});
    } else {
      for (const LinePart& part : coverage_.visible(from, to)) pieces_.push_back({at(part.from), at(part.to)});
    }
    return !pieces_.empty();
  }
  void cover(std::span<const Vertex> outline) { coverage_.add(outline); }
  [[nodiscard]] Coverage::Saved saved(float from, float to) const { return coverage_.saved(from, to); }
  void restore(const Coverage::Saved& saved) { coverage_.restore(saved); }
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

  [[nodiscard]] std::span<const float> top() const { return hull(top_, [this](std::size_t i) { return coverage_.top(i); }); }
  [[nodiscard]] std::span<const float> bottom() const { return hull(bottom_, [this](std::size_t i) { return coverage_.bottom(i); }); }

 private:
  template <class Of>
  std::span<const float> hull(std::vector<float>& into, const Of& of) const {
    into.resize(coverage_.columns());
    for (std::size_t i = 0; i < into.size(); ++i) into[i] = of(i);
    return into;
  }

  Coverage coverage_;
  std::vector<Piece> pieces_;
  mutable std::vector<float> top_;
  mutable std::vector<float> bottom_;
};

}  // namespace sightline::algorithms::skala
