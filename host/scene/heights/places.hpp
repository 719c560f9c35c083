// Places of heights along one axis.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

// Each place once, ascending. Places nearer to each other than 10^-9 of all are one, written with different rounding.
class Places {
 public:
  // Finite, at least one.
  explicit Places(std::vector<double> values);
  [[nodiscard]] const std::vector<double>& all() const { return places_; }
  [[nodiscard]] std::size_t count() const { return places_.size(); }
  [[nodiscard]] Interval domain() const { return {places_.front(), places_.back()}; }
  // Of the place that this value is at; one of the constructor's values.
  [[nodiscard]] std::size_t index(double value) const;

 private:
  std::vector<double> places_;
};

// In [-1, 1]. None: two of them come to the same.
[[nodiscard]] std::optional<std::vector<double>> positions_of(const std::vector<double>& ascending);

}  // namespace sightline::scene
