// The Type 342 character generator: the strokes that draw one character.
//
// A stroke is one step of the beam, lit or dark, of 1.5 us; a character begins at the lower left dot of its 5x7 cell and
// ends six steps to the right of it. APPROXIMATE: shapes, and therefore stroke counts, are chosen here (the real letters
// took 17-25); the path goes to the nearest remaining dot. Control codes: 33 line feed is eleven dark steps down, 34
// carriage return clears X, 35 and 36 choose the set, 37 escapes; 00 draws nothing and takes no space.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "../core/glyphs.hpp"
#include "../core/state_visitor.hpp"
#include "words.hpp"

namespace sightline::type340 {

struct CharacterStroke {
  Direction direction;
  bool lit;
};

class CharacterPath {
 public:
  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  [[nodiscard]] constexpr const CharacterStroke& operator[](std::size_t i) const { return strokes_[i]; }

  constexpr void add(Direction d, bool lit) { strokes_[size_++] = {d, lit}; }

  // A direction is stored as 0, 1, 2 for -1, 0, 1.
  void visit_state(core::StateVisitor& visit) {
    visit.count("size", size_, strokes_.size());
    for (std::size_t i = 0; i < std::min(size_, strokes_.size()); ++i) {
      CharacterStroke& stroke = strokes_[i];
      auto x = static_cast<std::uint8_t>(stroke.direction.x + 1);
      auto y = static_cast<std::uint8_t>(stroke.direction.y + 1);
      visit("x", x, std::uint8_t{2});
      visit("y", y, std::uint8_t{2});
      visit("lit", stroke.lit);
      stroke.direction = {static_cast<std::int8_t>(x - 1), static_cast<std::int8_t>(y - 1)};
    }
  }

 private:
  // Every dot is at most six dark steps from the one before, and so is the end point.
  std::array<CharacterStroke, 35 * 6 + 6> strokes_{};
  std::size_t size_ = 0;
};

namespace detail {

inline constexpr int advance = 6;
inline constexpr int line_feed_steps = 11;

struct Dot {
  int x;  // 0..4 from the left
  int y;  // 0..6 from the bottom
};

[[nodiscard]] constexpr int distance(Dot a, Dot b) {
  return std::max(a.x < b.x ? b.x - a.x : a.x - b.x, a.y < b.y ? b.y - a.y : a.y - b.y);
}

[[nodiscard]] constexpr std::uint8_t bit_of(int x) { return static_cast<std::uint8_t>(020 >> x); }
[[nodiscard]] constexpr std::size_t row_of(int y) { return static_cast<std::size_t>(6 - y); }

// The dot of `left` nearest to `from`, lowest and leftmost first; `from` if none is left.
[[nodiscard]] constexpr Dot nearest(const core::Glyph& left, Dot from) {
  Dot best = from;
  int best_distance = 100;
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 5; ++x) {
      if ((left[row_of(y)] & bit_of(x)) == 0 || distance(from, {x, y}) >= best_distance) continue;
      best = {x, y};
      best_distance = distance(from, best);
    }
  }
  return best;
}

[[nodiscard]] constexpr std::int8_t toward(int from, int to) {
  return static_cast<std::int8_t>(from < to ? 1 : (from > to ? -1 : 0));
}

// Steps from `at` to `to`, all dark but the last; one motionless stroke if `at` equals `to` and is lit.
constexpr void walk(CharacterPath& path, Dot at, Dot to, bool lit) {
  do {
    const Direction d{toward(at.x, to.x), toward(at.y, to.y)};
    at = {at.x + d.x, at.y + d.y};
    path.add(d, lit && distance(at, to) == 0);
  } while (distance(at, to) != 0);
}

[[nodiscard]] constexpr CharacterPath draw(core::Glyph left) {
  CharacterPath path;
  Dot at{0, 0};
  while (std::any_of(left.begin(), left.end(), [](std::uint8_t row) { return row != 0; })) {
    const Dot next = nearest(left, at);
    walk(path, at, next, true);
    left[row_of(next.y)] = static_cast<std::uint8_t>(left[row_of(next.y)] & ~bit_of(next.x));
    at = next;
  }
  walk(path, at, {advance, 0}, false);
  return path;
}

}  // namespace detail

// Strokes of a six-bit code; shift_out selects the second set. Control codes (CR, shifts, escape, 00) have none.
[[nodiscard]] constexpr CharacterPath path_of(std::uint8_t six_bits, bool shift_out) {
  if (six_bits == code::line_feed) {
    CharacterPath path;
    for (int i = 0; i < detail::line_feed_steps; ++i) path.add({0, -1}, false);
    return path;
  }
  if (six_bits == code::space) return detail::draw({});
  if (six_bits > code::space) return detail::draw(core::signs_and_digits[six_bits - code::space - 1U]);
  if (six_bits == 0 || six_bits > code::line_feed) return {};
  return detail::draw((shift_out ? core::small_letters : core::capital_letters)[six_bits - 1U]);
}

}  // namespace sightline::type340
