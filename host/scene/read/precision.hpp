// How exactly a file says where its vertices are: PolyMesh::precision.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace sightline::scene {

// The distance of neighbouring numbers of the type at the largest finite coordinate; 0 without coordinates.
[[nodiscard]] double float32_precision(std::span<const std::array<double, 3>> vertices);
[[nodiscard]] double float64_precision(std::span<const std::array<double, 3>> vertices);

// Of coordinates written as decimal numbers: the finest last decimal among those that are at least about a tenth
// of the largest one, as smaller ones are often written with more decimals than the others have. Where the numbers
// of the largest decade have as many digits as any of these, six or more, all were written with so many (as printf
// does by %e and %g), and the last digit of that decade counts. If none of these has more than 9 digits they may have
// been float32, and count as no finer than that. Whole numbers are exact, unless the mesh is so large (2^18) that they
// are rounded anyway.
class TextPrecision {
 public:
  // Reads a coordinate (coordinate_of), which counts if it is finite.
  [[nodiscard]] std::optional<double> read(std::string_view field);
  // A coordinate as written, and its value; one that is not finite does not count.
  void add(std::string_view written, double value);
  // All that `other` has seen.
  void add(const TextPrecision& other);
  // 0: all are whole numbers, or there are none.
  [[nodiscard]] double result(std::span<const std::array<double, 3>> vertices) const;

 private:
  struct Seen {
    int last_decimal = 0;  // the last digit stands for 10 to this power; at most 0
    int digits = 0;        // most significant digits of one number

    void add(const Seen& other);
  };
  void add(double value, const Seen& seen);
  // `decade`: the first digit stands for 10 to this power less 1.
  void add_top(const Seen& seen, int decade);

  static constexpr int lowest = -1100;
  static constexpr int highest = 1100;
  std::vector<Seen> seen_ = std::vector<Seen>(highest - lowest);  // by binary exponent of the value
  // The numbers whose first digit stands for the highest power of ten; here last_decimal may be above 0.
  Seen top_;
  int top_decade_ = std::numeric_limits<int>::min();
};

}  // namespace sightline::scene
