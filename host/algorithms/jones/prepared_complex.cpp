#include "host/algorithms/jones/prepared_complex.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace sightline::algorithms::jones {
namespace {

std::vector<geometry::Plane> in_lowest_terms(std::vector<geometry::Plane> planes) {
  for (geometry::Plane& plane : planes) {
    std::int64_t divisor = plane.offset;
    for (const std::int64_t part : plane.normal) divisor = std::gcd(divisor, part);
    if (divisor <= 1) continue;
    for (std::int64_t& part : plane.normal) part /= divisor;
    plane.offset /= divisor;
  }
  return planes;
}

}  // namespace

PreparedComplex::PreparedComplex(const scene::CellComplex& complex)
    : complex_(&complex),
      planes_(in_lowest_terms(complex.planes)),
      index_(complex, planes_),
      crowded_(complex, planes_) {
  measure();
  find_entrances();
}

void PreparedComplex::measure() {
  for (const geometry::Plane& plane : planes_) {
    double sum = 0;
    for (const std::int64_t part : plane.normal) {
      const double magnitude = std::fabs(static_cast<double>(part));
      greatest_component_ = std::max(greatest_component_, magnitude);
      sum += magnitude;
    }
    greatest_value_ = std::max(greatest_value_, sum * geometry::predicate_coordinate_limit +
                                                    std::fabs(static_cast<double>(plane.offset)));
  }
}

void PreparedComplex::find_entrances() {
  for (std::size_t o = 0; o < complex_->openings.size(); ++o) {
    const auto& cells = complex_->openings[o].cells;
    if (cells[0] == scene::outside || cells[1] == scene::outside)
      entrances_.push_back(static_cast<std::uint32_t>(o));
  }
  for (std::size_t side = 0; side < 6; ++side) {
    const std::size_t axis = side / 2;
    const bool high = side % 2 == 1;
    const std::int32_t at = high ? complex_->outer.high[axis] : complex_->outer.low[axis];
    OuterFace& face = outer_faces_[side];
    face.plane.normal[axis] = high ? 1 : -1;
    face.plane.offset = high ? at : -std::int64_t{at};
    for (std::size_t e = 0; e < complex_->edges.size(); ++e) {
      const scene::ComplexEdge& edge = complex_->edges[e];
      if (complex_->vertices[edge.from][axis] == at && complex_->vertices[edge.to][axis] == at)
        face.edges.push_back(static_cast<std::uint32_t>(e));
    }
  }
}

}  // namespace sightline::algorithms::jones
