// Character shapes for the character generators: seven rows of five dots each, top row first; bit 4 of a row is its
// leftmost dot.
//
// APPROXIMATE. DEC's stroke tables and Thomson's character ROM are not available: the shapes are chosen here. Known are the
// 5x7 cell of the Type 342, the codes of its first set (DEC trimmed ASCII), that its second set holds the small letters,
// and that the EF9365 draws ASCII 20h to 7Fh in a 5x8 cell.
#pragma once

#include <array>
#include <cstdint>

namespace sightline::core {

using Glyph = std::array<std::uint8_t, 7>;

// ASCII 41h-5Ah; codes 01-32 of the Type 342, first set.
inline constexpr std::array capital_letters{
    Glyph{016, 021, 021, 037, 021, 021, 021},  // A
    Glyph{036, 021, 021, 036, 021, 021, 036},  // B
    Glyph{016, 021, 020, 020, 020, 021, 016},  // C
    Glyph{036, 021, 021, 021, 021, 021, 036},  // D
    Glyph{037, 020, 020, 036, 020, 020, 037},  // E
    Glyph{037, 020, 020, 036, 020, 020, 020},  // F
    Glyph{016, 021, 020, 023, 021, 021, 016},  // G
    Glyph{021, 021, 021, 037, 021, 021, 021},  // H
    Glyph{016, 004, 004, 004, 004, 004, 016},  // I
    Glyph{001, 001, 001, 001, 001, 021, 016},  // J
    Glyph{021, 022, 024, 030, 024, 022, 021},  // K
    Glyph{020, 020, 020, 020, 020, 020, 037},  // L
    Glyph{021, 033, 025, 021, 021, 021, 021},  // M
    Glyph{021, 021, 031, 025, 023, 021, 021},  // N
    Glyph{016, 021, 021, 021, 021, 021, 016},  // O
    Glyph{036, 021, 021, 036, 020, 020, 020},  // P
    Glyph{016, 021, 021, 021, 025, 022, 015},  // Q
    Glyph{036, 021, 021, 036, 024, 022, 021},  // R
    Glyph{016, 021, 020, 016, 001, 021, 016},  // S
    Glyph{037, 004, 004, 004, 004, 004, 004},  // T
    Glyph{021, 021, 021, 021, 021, 021, 016},  // U
    Glyph{021, 021, 021, 021, 021, 012, 004},  // V
    Glyph{021, 021, 021, 021, 025, 033, 021},  // W
    Glyph{021, 021, 012, 004, 012, 021, 021},  // X
    Glyph{021, 021, 012, 004, 004, 004, 004},  // Y
    Glyph{037, 001, 002, 004, 010, 020, 037},  // Z
};

// ASCII 61h-7Ah; codes 01-32 of the Type 342, second set.
inline constexpr std::array small_letters{
    Glyph{000, 000, 016, 001, 017, 021, 017},  // a
    Glyph{020, 020, 036, 021, 021, 021, 036},  // b
    Glyph{000, 000, 016, 020, 020, 020, 016},  // c
    Glyph{001, 001, 017, 021, 021, 021, 017},  // d
    Glyph{000, 000, 016, 021, 037, 020, 016},  // e
    Glyph{006, 011, 010, 034, 010, 010, 010},  // f
    Glyph{000, 017, 021, 021, 017, 001, 016},  // g
    Glyph{020, 020, 036, 021, 021, 021, 021},  // h
    Glyph{004, 000, 014, 004, 004, 004, 016},  // i
    Glyph{002, 000, 006, 002, 002, 022, 014},  // j
    Glyph{020, 020, 022, 024, 030, 024, 022},  // k
    Glyph{014, 004, 004, 004, 004, 004, 016},  // l
    Glyph{000, 000, 032, 025, 025, 025, 025},  // m
    Glyph{000, 000, 036, 021, 021, 021, 021},  // n
    Glyph{000, 000, 016, 021, 021, 021, 016},  // o
    Glyph{000, 000, 036, 021, 036, 020, 020},  // p
    Glyph{000, 000, 017, 021, 017, 001, 001},  // q
    Glyph{000, 000, 026, 030, 020, 020, 020},  // r
    Glyph{000, 000, 017, 020, 016, 001, 036},  // s
    Glyph{010, 010, 034, 010, 010, 011, 006},  // t
    Glyph{000, 000, 021, 021, 021, 023, 015},  // u
    Glyph{000, 000, 021, 021, 021, 012, 004},  // v
    Glyph{000, 000, 021, 021, 025, 025, 012},  // w
    Glyph{000, 000, 021, 012, 004, 012, 021},  // x
    Glyph{000, 000, 021, 021, 017, 001, 016},  // y
    Glyph{000, 000, 037, 002, 004, 010, 037},  // z
};

// ASCII 21h-3Fh; codes 41-77 of the Type 342, both sets.
inline constexpr std::array signs_and_digits{
    Glyph{004, 004, 004, 004, 004, 000, 004},  // !
    Glyph{012, 012, 012, 000, 000, 000, 000},  // "
    Glyph{012, 012, 037, 012, 037, 012, 012},  // #
    Glyph{004, 017, 024, 016, 005, 036, 004},  // $
    Glyph{030, 031, 002, 004, 010, 023, 003},  // %
    Glyph{010, 024, 024, 010, 025, 022, 015},  // &
    Glyph{004, 004, 004, 000, 000, 000, 000},  // '
    Glyph{002, 004, 010, 010, 010, 004, 002},  // (
    Glyph{010, 004, 002, 002, 002, 004, 010},  // )
    Glyph{000, 004, 025, 016, 025, 004, 000},  // *
    Glyph{000, 004, 004, 037, 004, 004, 000},  // +
    Glyph{000, 000, 000, 000, 014, 004, 010},  // ,
    Glyph{000, 000, 000, 037, 000, 000, 000},  // -
    Glyph{000, 000, 000, 000, 000, 014, 014},  // .
    Glyph{000, 001, 002, 004, 010, 020, 000},  // /
    Glyph{016, 021, 023, 025, 031, 021, 016},  // 0
    Glyph{004, 014, 004, 004, 004, 004, 016},  // 1
    Glyph{016, 021, 001, 002, 004, 010, 037},  // 2
    Glyph{016, 021, 001, 006, 001, 021, 016},  // 3
    Glyph{002, 006, 012, 022, 037, 002, 002},  // 4
    Glyph{037, 020, 036, 001, 001, 021, 016},  // 5
    Glyph{006, 010, 020, 036, 021, 021, 016},  // 6
    Glyph{037, 001, 002, 004, 010, 010, 010},  // 7
    Glyph{016, 021, 021, 016, 021, 021, 016},  // 8
    Glyph{016, 021, 021, 017, 001, 002, 014},  // 9
    Glyph{000, 014, 014, 000, 014, 014, 000},  // :
    Glyph{000, 014, 014, 000, 014, 004, 010},  // ;
    Glyph{002, 004, 010, 020, 010, 004, 002},  // <
    Glyph{000, 000, 037, 000, 037, 000, 000},  // =
    Glyph{010, 004, 002, 001, 002, 004, 010},  // >
    Glyph{016, 021, 001, 002, 004, 000, 004},  // ?
};

// ASCII 5Bh-60h.
inline constexpr std::array signs_after_capitals{
    Glyph{016, 010, 010, 010, 010, 010, 016},  // [
    Glyph{000, 020, 010, 004, 002, 001, 000},  // backslash
    Glyph{016, 002, 002, 002, 002, 002, 016},  // ]
    Glyph{004, 012, 021, 000, 000, 000, 000},  // ^
    Glyph{000, 000, 000, 000, 000, 000, 037},  // _
    Glyph{010, 004, 002, 000, 000, 000, 000},  // `
};

// ASCII 7Bh-7Fh. What the chips draw for 7Fh (delete) is unknown: here a grey cell.
inline constexpr std::array signs_after_small_letters{
    Glyph{002, 004, 004, 010, 004, 004, 002},  // {
    Glyph{004, 004, 004, 004, 004, 004, 004},  // |
    Glyph{010, 004, 004, 002, 004, 004, 010},  // }
    Glyph{000, 000, 010, 025, 002, 000, 000},  // ~
    Glyph{025, 012, 025, 012, 025, 012, 025},  // 7Fh
};

inline constexpr Glyph commercial_at{016, 021, 025, 027, 026, 020, 017};

// The shape of an ASCII code; empty for codes below 21h and above 7Fh.
[[nodiscard]] constexpr Glyph ascii_glyph(std::uint8_t code) {
  if (code < 0x21 || code > 0x7F) return {};
  if (code < 0x40) return signs_and_digits[code - 0x21U];
  if (code == 0x40) return commercial_at;
  if (code <= 'Z') return capital_letters[code - 0x41U];
  if (code <= 0x60) return signs_after_capitals[code - 0x5BU];
  if (code <= 'z') return small_letters[code - 0x61U];
  return signs_after_small_letters[code - 0x7BU];
}

}  // namespace sightline::core
