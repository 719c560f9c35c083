// The drawing half of the EF9365: the pen, vectors with their line styles, characters and blocks, on three bit planes.
//
// X and Y are 12 bits and wrap; a dot is written only where both are below 256. Both end dots of a vector are drawn, and a
// vector of no length is one dot. Of two equally near dots a vector takes the one on its starting side, in either
// direction. Every vector begins its line style anew.
//
// Unknown for the chip and chosen here: that rounding; the place of the eighth row of a character (below, for the tails of
// g j p q y); that vertical writing is horizontal writing turned by 90 degrees, leaning letters included; that the 4x4
// block leaves a column's gap like a character (as the emulator used as a source does). Shapes of characters are
// approximate: see glyphs.hpp. Sources: the register and command tables on which MAME's ef9365 device and Wikipedia's
// article agree.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "../core/glyphs.hpp"
#include "../core/raster.hpp"
#include "../core/state_visitor.hpp"

namespace sightline::devices::ef9365 {

// CTRL1, low half.
struct Pen {
  static constexpr std::uint8_t is_down = 0x01;
  static constexpr std::uint8_t writes = 0x02;  // 0: the eraser
};

// CTRL2.
struct Style {
  static constexpr std::uint8_t line = 0x03;
  static constexpr std::uint8_t leaning = 0x04;
  static constexpr std::uint8_t vertical = 0x08;
};

// Five bits a row, bit 4 leftmost, bottom row first.
struct Symbol {
  std::array<std::uint8_t, 8> rows{};
  int columns = 5;
  int height = 8;
};

inline constexpr Symbol block_5x8{{0x1F, 0x1F, 0x1F, 0x1F, 0x1F, 0x1F, 0x1F, 0x1F}, 5, 8};
inline constexpr Symbol block_4x4{{0x1F, 0x1F, 0x1F, 0x1F, 0, 0, 0, 0}, 4, 4};

[[nodiscard]] constexpr Symbol character(std::uint8_t ascii) {
  const bool tail = ascii == 'g' || ascii == 'j' || ascii == 'p' || ascii == 'q' || ascii == 'y';
  const core::Glyph glyph = core::ascii_glyph(ascii);
  Symbol symbol;
  for (std::size_t row = 0; row < glyph.size(); ++row) symbol.rows[row + (tail ? 0U : 1U)] = glyph[6 - row];
  return symbol;
}

class Drawing {
 public:
  // Coordinates of 12 bits.
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  std::uint8_t pen = 0;    // CTRL1, see Pen
  std::uint8_t style = 0;  // CTRL2, see Style
  std::uint8_t size = 0;   // CSIZE: P (width factor) in the high half, Q (height) in the low; 0 means 16
  std::uint8_t colour = 0;  // of the planes' latch, 0..7

  [[nodiscard]] const core::Raster& raster() const { return raster_; }
  [[nodiscard]] bool outside() const { return ((x | y) & 0xF00U) != 0; }

  // Dots written into the planes, and dots outside them, with the pen down.
  [[nodiscard]] std::uint64_t dots() const { return dots_; }
  [[nodiscard]] std::uint64_t dots_outside() const { return dots_outside_; }

  void visit_state(core::StateVisitor& visit) {
    constexpr std::uint16_t largest = 0xFFF;
    visit("x", x, largest);
    visit("y", y, largest);
    visit("pen", pen, std::uint8_t{3});
    visit("style", style, std::uint8_t{0x0F});
    visit("size", size);
    visit("colour", colour, std::uint8_t{7});
    visit("dots", dots_);
    visit("dots_outside", dots_outside_);
    visit.part("raster", raster_);
  }

  void clear() { raster_.fill(0); }
  // Screen scanning: sets every dot to what the pen or the eraser would write, whether it is down or not.
  void fill() { raster_.fill(ink()); }

  // A vector of no length.
  void single_dot() {
    if ((pen & Pen::is_down) != 0) dot(x, y);
  }
  // Draws from the pen's position by (dx, dy), each -255..255. Returns the number of dots scanned.
  std::size_t vector(int dx, int dy) {
    if ((pen & Pen::is_down) != 0) draw(dx, dy);
    x = wrap(x + dx);
    y = wrap(y + dy);
    return static_cast<std::size_t>(std::max(std::abs(dx), std::abs(dy))) + 1;
  }

  // Draws at the pen's position, then moves the pen by the symbol's columns and one. Returns the number of dots scanned.
  std::int64_t symbol(const Symbol& shape) {
    const int width_factor = factor(size >> 4);
    const int height_factor = factor(size & 0x0FU);
    if ((pen & Pen::is_down) != 0) {
      for (int up = 0; up < shape.height * height_factor; ++up) {
        const unsigned row = shape.rows[static_cast<std::size_t>(up / height_factor)];
        for (int right = 0; right < shape.columns * width_factor; ++right)
          if ((row & (0x10U >> (right / width_factor))) != 0) symbol_dot(right, up);
      }
    }
    const int advance = (shape.columns + 1) * width_factor;
    std::uint16_t& moves_on = (style & Style::vertical) != 0 ? y : x;
    moves_on = wrap(moves_on + advance);
    return std::int64_t{advance} * shape.height * height_factor;
  }

 private:
  // Bit n of a style says whether dot n (modulo 16) is drawn: all; 2 on, 2 off; 4 and 4; 10 on, 2 off, 2 on, 2 off.
  static constexpr std::array<std::uint16_t, 4> styles{0xFFFF, 0x3333, 0x0F0F, 0x33FF};

  static constexpr std::uint16_t wrap(int coordinate) {
    return static_cast<std::uint16_t>(coordinate & 0xFFF);
  }
  static constexpr int factor(int half) { return half == 0 ? 16 : half; }

  // The eraser clears all planes; the pen sets each as the latch tells.
  [[nodiscard]] std::uint8_t ink() const { return (pen & Pen::writes) != 0 ? colour : std::uint8_t{0}; }

  void dot(std::uint16_t at_x, std::uint16_t at_y) {
    if (((at_x | at_y) & 0xF00U) != 0) {
      ++dots_outside_;
      return;
    }
    ++dots_;
    raster_.set(static_cast<std::uint8_t>(at_x), static_cast<std::uint8_t>(at_y), ink());
  }

  void draw(int dx, int dy) {
    const int step_x = dx < 0 ? -1 : 1;
    const int step_y = dy < 0 ? -1 : 1;
    const bool steep = std::abs(dy) > std::abs(dx);
    const int along = steep ? std::abs(dy) : std::abs(dx);
    const int across = steep ? std::abs(dx) : std::abs(dy);
    const unsigned pattern = styles[style & Style::line];
    int at_x = x;
    int at_y = y;
    int error = 2 * across - along;
    for (int n = 0; n <= along; ++n) {
      if ((pattern >> (n & 15) & 1U) != 0) dot(wrap(at_x), wrap(at_y));
      const bool both = error > 0;
      error += 2 * (both ? across - along : across);
      if (!steep || both) at_x += step_x;
      if (steep || both) at_y += step_y;
    }
  }

  // A dot `right` of and `up` from the symbol's lower left corner, before leaning and turning.
  void symbol_dot(int right, int up) {
    if ((style & Style::leaning) != 0) right += up;
    if ((style & Style::vertical) != 0)
      dot(wrap(x - up), wrap(y + right));
    else
      dot(wrap(x + right), wrap(y + up));
  }

  core::Raster raster_;
  std::uint64_t dots_ = 0;
  std::uint64_t dots_outside_ = 0;
};

}  // namespace sightline::devices::ef9365
