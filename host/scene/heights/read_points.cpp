#include "host/scene/heights/read_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::scene {
namespace {

constexpr std::size_t height_field = 2;

// The lines of the file as blocks of equal length; a block is a curve on which field `constant` stays the
// same and field `running` grows or falls.
class Points {
 public:
  Points(const HeightText& text, std::string_view source) : lines_(text.lines), source_(source) {}

  base::Result<HeightGrid> grid() {
    if (!equal_blocks() || !directions() || !places()) return *error_;
    const std::vector<double> curves = coordinates(constant_, length_, lines_.size() / length_);
    const std::vector<double> along = coordinates(running_, 1, length_);
    if (!monotone(curves, constant_, length_) || !monotone(along, running_, 1)) return *error_;
    HeightGrid grid;
    const bool curves_are_slices = constant_ == 1;
    const std::vector<double>& x = curves_are_slices ? along : curves;
    const std::vector<double>& z = curves_are_slices ? curves : along;
    grid.domain_x = domain(x);
    grid.domain_z = domain(z);
    grid.x = in_order(x, grid.domain_x);
    grid.z = in_order(z, grid.domain_z);
    for (std::size_t slice = 0; slice < z.size(); ++slice) {
      const std::size_t s = z.front() > z.back() ? z.size() - 1 - slice : slice;
      for (std::size_t point = 0; point < x.size(); ++point) {
        const std::size_t p = x.front() > x.back() ? x.size() - 1 - point : point;
        const std::size_t line = curves_are_slices ? s * length_ + p : p * length_ + s;
        grid.heights.push_back(value(line, height_field));
      }
    }
    return grid;
  }

 private:
  [[nodiscard]] double value(std::size_t line, std::size_t field) const {
    return lines_[line].fields[field].value;
  }

  bool equal_blocks() {
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= lines_.size(); ++i) {
      if (i < lines_.size() && !lines_[i].after_blank) continue;
      const std::size_t length = i - begin;
      if (length_ == 0) length_ = length;
      if (length != length_) {
        const std::size_t last = begin + std::min(length_, length - 1);
        return fail(last, 0, "a block of " + std::to_string(length) + " points",
                    std::to_string(length_) + " as in the first block");
      }
      begin = i;
    }
    return length_ > 1 ||
           fail(0, 0, "blocks of one point", "blocks of at least two, of constant x or constant y");
  }

  // Which coordinate the first block keeps.
  bool directions() {
    for (const std::size_t field : {std::size_t{0}, std::size_t{1}}) {
      if (value(0, field) != value(1, field)) continue;
      constant_ = field;
      running_ = 1 - field;
      return true;
    }
    return fail(1, 0, "a block in which x and y both change", "one of them constant");
  }

  // Every block has its own constant and the first block's places, all of them numbers.
  bool places() {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      for (const std::size_t field : {constant_, running_}) {
        if (!std::isfinite(value(i, field)))
          return fail(i, field, std::string(name(field)) + " = nan", "a number");
        const std::size_t same_as = field == constant_ ? i - i % length_ : i % length_;
        if (value(i, field) == value(same_as, field)) continue;
        return fail(i, field, std::string(name(field)) + " = " + shortest_text(value(i, field)),
                    shortest_text(value(same_as, field)) + " as in line " + std::to_string(lines_[same_as].number));
      }
    }
    return true;
  }

  [[nodiscard]] std::vector<double> coordinates(std::size_t field, std::size_t stride,
                                                std::size_t count) const {
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(value(i * stride, field));
    return result;
  }

  bool monotone(const std::vector<double>& along, std::size_t field, std::size_t stride) {
    const bool falling = along[0] > along[1];
    for (std::size_t i = 1; i < along.size(); ++i) {
      if (falling ? along[i] < along[i - 1] : along[i] > along[i - 1]) continue;
      return fail(i * stride, field, std::string(name(field)) + " = " + shortest_text(along[i]),
                  std::string(falling ? "less" : "more") + " than the " + shortest_text(along[i - 1]) + " before it");
    }
    const Interval ends = domain(along);
    if (!(ends.high / 2 - ends.low / 2 >= std::numeric_limits<double>::min()))
      return fail(0, field, std::string(name(field)) + " from " + shortest_text(ends.low) + " to " + shortest_text(ends.high),
                  "places that are farther apart");
    return distinct(along, ends, field, stride);
  }

  // Places that differ in the file may not do so in [-1, 1].
  bool distinct(const std::vector<double>& along, Interval ends, std::size_t field, std::size_t stride) {
    const std::vector<double> ascending = in_order(along, ends);
    const auto same = std::adjacent_find(ascending.begin(), ascending.end());
    if (same == ascending.end()) return true;
    const auto n = static_cast<std::size_t>(same - ascending.begin());
    const std::size_t later = along.front() > along.back() ? along.size() - 1 - n : n + 1;
    return fail(later * stride, field,
                std::string(name(field)) + " = " + shortest_text(along[later]) + ", too close to the " +
                    shortest_text(along[later - 1]) + " before it",
                "places that are farther apart");
  }

  static Interval domain(const std::vector<double>& along) {
    return {std::min(along.front(), along.back()), std::max(along.front(), along.back())};
  }

  static std::vector<double> in_order(std::vector<double> along, Interval domain) {
    if (along.front() > along.back()) std::reverse(along.begin(), along.end());
    return normalised(std::move(along), domain);
  }

  static std::string_view name(std::size_t field) { return field == 0 ? "x" : "y"; }
  bool fail(std::size_t line, std::size_t field, std::string found, std::string expected) {
    const HeightLine& where = lines_[line];
    error_ = base::Error{source_, place_of(where.number, where.fields[field].column), std::move(found),
                         std::move(expected)};
    return false;
  }

  const std::vector<HeightLine>& lines_;
  std::string source_;
  std::size_t length_ = 0;    // of a block
  std::size_t constant_ = 0;  // 0: x, 1: y
  std::size_t running_ = 1;
  std::optional<base::Error> error_;
};

}  // namespace

bool is_point_data(const HeightText& text) {
  const auto three = [](const HeightLine& line) { return line.fields.size() == 3; };
  const auto after_blank = [](const HeightLine& line) { return line.after_blank; };
  return !text.separated && std::all_of(text.lines.begin(), text.lines.end(), three) &&
         std::any_of(text.lines.begin(), text.lines.end(), after_blank);
}

base::Result<HeightGrid> read_points(const HeightText& text, std::string_view source) {
  return Points(text, source).grid();
}

}  // namespace sightline::scene
