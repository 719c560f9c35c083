// The lines of a cell complex: for each cell, the parts of edges on its closure.
//
// There are many lines but few different parts: most are whole edges, and in a building the others repeat. A
// line is stored as the numbers of its edge and its part, in 8 bytes instead of 40: a building of a million
// rooms has 24 million lines. A part that was added recently is found and shared; other repetitions are
// stored again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "host/geometry/rational.hpp"

namespace sightline::scene {

// The part of an edge that lies on a cell's closure: from + s (to - from), low <= s <= high, low < high.
struct ComplexLine {
  std::uint32_t edge = 0;  // index into edges
  geometry::Rational low;
  geometry::Rational high;
};

class ComplexLines {
 public:
  // Returns lines by value.
  class Iterator {
   public:
    Iterator(const ComplexLines& lines, std::size_t at) : lines_(&lines), at_(at) {}
    ComplexLine operator*() const { return (*lines_)[at_]; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

   private:
    const ComplexLines* lines_;
    std::size_t at_;
  };

  // Consecutive lines.
  class Rows {
   public:
    Rows(const ComplexLines& lines, std::size_t first, std::size_t count)
        : lines_(&lines), first_(first), count_(count) {}
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    ComplexLine operator[](std::size_t i) const { return (*lines_)[first_ + i]; }
    // The number of line i's edge, without looking up its part.
    [[nodiscard]] std::uint32_t edge(std::size_t i) const { return lines_->lines_[first_ + i].edge; }
    [[nodiscard]] Iterator begin() const { return {*lines_, first_}; }
    [[nodiscard]] Iterator end() const { return {*lines_, first_ + count_}; }

   private:
    const ComplexLines* lines_;
    std::size_t first_;
    std::size_t count_;
  };

  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  [[nodiscard]] bool empty() const { return lines_.empty(); }
  ComplexLine operator[](std::size_t i) const {
    const Part& part = parts_[lines_[i].part];
    return {lines_[i].edge, part.low, part.high};
  }
  [[nodiscard]] Rows rows(std::size_t first, std::size_t count) const { return {*this, first, count}; }
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, size()}; }

  void push_back(const ComplexLine& line) { lines_.push_back({line.edge, part_of(line)}); }
  void set(std::size_t i, const ComplexLine& line) { lines_[i] = {line.edge, part_of(line)}; }
  // New lines are the whole of edge 0.
  void resize(std::size_t size) { lines_.resize(size); }
  void reserve(std::size_t size) { lines_.reserve(size); }
  void swap(std::size_t i, std::size_t j) { std::swap(lines_[i], lines_[j]); }
  // Sorts lines first..end - 1, no two of one edge. Fast if they are already in order.
  void sort_by_edge(std::size_t first, std::size_t end);

 private:
  struct Part {
    geometry::Rational low;
    geometry::Rational high;

    friend bool operator==(const Part&, const Part&) = default;
  };
  struct Line {
    std::uint32_t edge = 0;
    std::uint32_t part = 0;
  };

  [[nodiscard]] std::uint32_t part_of(const ComplexLine& line);

  std::vector<Line> lines_;
  std::vector<Part> parts_{{0, 1}};    // [0] is the whole edge
  std::vector<std::uint32_t> recent_;  // numbers of parts added recently, by their hash
};

}  // namespace sightline::scene
