// The masks: in every column of the screen, the highest and the lowest point drawn so far, between which everything
// farther is hidden (Skala 1985, section 3; the floating horizon).
//
// A column is a sample of the screen at one place, not a strip. Lines are evaluated exactly there, and between two
// columns both the line and the masks are straight, so a line ends where it meets the horizon and not at a column.
// Details narrower than the distance of two columns may be missed.
// The method assumes that everything nearer fills one interval of each column. A hole in the surface violates this: what
// is seen through a hole counts as hidden (a documented limit of the method).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/skala/surface.hpp"

namespace sightline::algorithms::skala {

struct Piece {
  Vertex from;
  Vertex to;
};

// The values of the last column that a chain crossed, before the chain changed them, so that a chain never hides itself.
struct Wake {
  int column = -2;
  float top = 0;
  float bottom = 0;
};

class Horizon {
 public:
  explicit Horizon(int columns);

  // Finds the visible pieces of the segment, in its direction, and returns whether there are any. They are valid until
  // the next call. A point is visible if it is more than `slack` outside the masks; if `slack` is negative, also up to
  // -slack inside them.
  bool draw(Vertex from, Vertex to, Wake& wake);                   // also raises the masks
  bool test(Vertex from, Vertex to, float slack, Wake wake = {});  // leaves the masks unchanged
  // draw() from each vertex to the next, collecting all pieces. Precondition: the vertices are monotone in x.
  bool draw_chain(std::span<const Vertex> chain, Wake& wake);
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  // draw() of a segment if the last columns not right of its ends (find_columns) are known. There are pieces only for
  // `parts`. Defined in horizon_edge.hpp.
  enum class Sight : std::uint8_t { hidden, whole, parts };
  [[gnu::always_inline]] Sight draw_edge(Vertex from, Vertex to, int before_from, int before_to, Wake& wake);
  // -1 for a vertex to the left of all columns.
  void find_columns(std::span<const Vertex> vertices, std::vector<std::int32_t>& columns) const;
  // By column.
  [[nodiscard]] std::span<const float> top() const { return std::span(top_).first(columns_); }
  [[nodiscard]] std::span<const float> bottom() const { return std::span(bottom_).first(columns_); }

  static constexpr float usual_slack = 1.0F / 8192;  // in y; above the rounding of a line in a column

 private:
  struct Outside {  // distance of a point above the top and below the bottom; > 0: visible
    float above;
    float below;
  };
  struct Columns {  // the columns that a segment crosses; none if last < first
    int first;
    int last;
  };
  // The code that nearly every segment runs is in one function; the rest is kept out of line.
  [[nodiscard]] Outside outside(Vertex vertex, float slack, const Wake& wake) const;
  [[gnu::noinline]] Columns look(Vertex from, Vertex to, float slack, const Wake& wake);
  void narrow(Vertex from, Vertex to, float slack, const Wake& wake);
  [[gnu::noinline]] void mixed(Vertex left, Vertex right, Columns columns, bool leftwards, float slack);
  void gap(Vertex from, Vertex to, Outside at_from, Outside at_to);
  void add(Vertex from, Vertex to);
  // Stores the halves separately: a whole piece would be loaded before both halves are stored, which stalls.
  void see(Vertex from, Vertex to) {
    Piece& piece = pieces_.emplace_back();
    piece.from = from;
    piece.to = to;
  }
  [[gnu::noinline]] void raise(Columns columns, bool leftwards, Wake& wake);
  [[gnu::noinline]] Sight draw_long(Vertex from, Vertex to, bool leftwards, Wake& wake);

  void measure_chain(std::span<const Vertex> chain);
  void trace_chain(std::span<const Vertex> chain, bool leftwards);
  void compare_chain(Columns columns);
  void ink_chain(std::span<const Vertex> chain, bool leftwards, const Wake& wake);
  void raise_chain(Columns columns, bool leftwards, Wake& wake);

  // Columns are processed in blocks of this size. The last block may reach beyond the masks, so arrays are that much
  // longer than the screen.
  static constexpr std::size_t block = 4;

  std::size_t columns_;
  std::vector<float> top_;
  std::vector<float> bottom_;
  std::vector<float> heights_;  // by column: heights of the line compared last
  // For each vertex of a chain: the last column not right of it (-1 if none), and the slope of the segment after it.
  std::vector<std::int32_t> vertex_columns_;
  std::vector<float> slopes_;
  // By column: how many columns before it are above the top, plus 2^16 times how many are below the bottom.
  std::vector<std::uint32_t> seen_before_;
  std::vector<Piece> pieces_;
  std::size_t first_own_ = 0;  // first piece of the current segment
};

}  // namespace sightline::algorithms::skala
