#include "host/programs/flight/cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sightline::programs::flight {

namespace {

namespace willis = algorithms::willis;

class Builder {
 public:
  explicit Builder(const willis::Model& model) : model_(model), numbers_(model.cells.cells, 0), has_pieces_(model.cells.cells, false) {
    for (const willis::Surface& piece : model.pieces) has_pieces_[piece.cell] = true;
    low_.fill(std::numeric_limits<double>::infinity());
    high_.fill(-std::numeric_limits<double>::infinity());
    for (const willis::Surface& piece : model.pieces) {
      for (const willis::Point& point : piece.points) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          low_[axis] = std::min(low_[axis], static_cast<double>(point[axis]));
          high_[axis] = std::max(high_[axis], static_cast<double>(point[axis]));
        }
      }
    }
  }

  Cells build() {
    static_cast<void>(place_of(model_.cells.root));
    if (cells_.planes.empty()) return {};
    cells_.cells = cells_count_;
    for (const willis::Surface& piece : model_.pieces) cells_.of_piece.push_back(numbers_[piece.cell]);
    return std::move(cells_);
  }

 private:
  [[nodiscard]] bool has_pieces(willis::OrderPlace place) const {
    if (place < 0) return has_pieces_[static_cast<std::size_t>(~place)];
    const willis::OrderNode& node = model_.cells.nodes[static_cast<std::size_t>(place)];
    return has_pieces(node.before) || has_pieces(node.in) || has_pieces(node.behind);
  }

  // A plane gets its number before the planes below it do.
  Place place_of(willis::OrderPlace place) {
    if (!has_pieces(place)) return 0;
    if (place < 0) {
      Place& number = numbers_[static_cast<std::size_t>(~place)];
      number = static_cast<Place>(++cells_count_);
      return number;
    }
    const willis::OrderNode& node = model_.cells.nodes[static_cast<std::size_t>(place)];
    const std::array<willis::OrderPlace, 3> below{node.before, node.in, node.behind};
    if (std::count_if(below.begin(), below.end(), [this](willis::OrderPlace p) { return has_pieces(p); }) == 1)
      return place_of(*std::find_if(below.begin(), below.end(), [this](willis::OrderPlace p) { return has_pieces(p); }));
    const std::size_t at = cells_.planes.size();
    cells_.planes.push_back({mirrored(node.plane), {}});
    for (std::size_t i = 0; i < 3; ++i) {
      const Place child = place_of(below[i]);
      cells_.planes[at].places[i] = child;
    }
    return static_cast<Place>(0x80 + at + 1);
  }

  // Far enough from the plane that rounding tilts it little, but not so far that the machine's steps become long.
  [[nodiscard]] std::array<std::array<double, 3>, 2> mirrored(const willis::SurfacePlane& plane) const {
    std::array<double, 3> normal{};
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      normal[axis] = static_cast<double>(plane.normal[axis]);
      square += normal[axis] * normal[axis];
    }
    const double length = std::sqrt(square);
    double at = -static_cast<double>(plane.offset) * willis::lattice_unit;
    double half = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at += normal[axis] * (low_[axis] + high_[axis]) / 2;
      half = std::max(half, (high_[axis] - low_[axis]) / 2);
    }
    std::array<std::array<double, 3>, 2> points{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double foot = (low_[axis] + high_[axis]) / 2 - normal[axis] * at / square;
      points[0][axis] = foot + half * normal[axis] / length;
      points[1][axis] = foot - half * normal[axis] / length;
    }
    return points;
  }

  const willis::Model& model_;
  std::vector<Place> numbers_;  // indexed by the model's cell
  std::vector<bool> has_pieces_;
  std::array<double, 3> low_{};
  std::array<double, 3> high_{};
  Cells cells_;
  std::size_t cells_count_ = 0;
};

}  // namespace

Cells cells_of(const willis::Model& model) { return Builder(model).build(); }

}  // namespace sightline::programs::flight
