// A scene as the words that the PDP-7 program works on: the data elements of Fig. 6 (Jones 1971), with a layout chosen
// here.
//
// In core, from the base address on:
// - header: address of the initial cell; number of cells; eye x, y, z; the box in which the eye may move: low
//   x, high x, low y, high y, low z, high z (the initial cell less 1 on each side: the
//   program's near plane is at z = 1).
// - cells: X Y Z n, n vectors, the opening list. X Y Z is the start of the first line (the cell's low corner
//   if it has none). A vector is F(0) A(1-2) magnitude(3-17), the magnitude signed, 15 bits, A = 1, 2, 3 for
//   i, j, k. A list entry is L(0) address(5-17): the address of the word of the opening-element that names
//   the far cell, L on the last. A cell without openings has the single word 400000.
// - openings: 400000 + cell on the low side, cell on the high side, X Y Z n, n vectors of the closed ring.
// Numbers are two's complement.
//
// A tape for the walk (SPECIFICATION.md section 9) has the openings before the cells, five words for the program's record
// before each opening, and the planes of the cells: the origin of a cell is the corner of its box nearest to the first line,
// and the three words before it are the corner opposite. The initial cell and the box of the eye are 0 in its header: the
// program finds them.
//
// The chain of a cell's lines: always the line whose nearer end takes the fewest dummy vectors to reach, in a tie the first
// in the scene's order, its `from` end first. Dummies go i, then j, then k. A vector beyond +-16383 becomes several.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/programs/jones/specification.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::programs::jones {

inline constexpr std::size_t scene_header_words = 11;

enum class Tape { view, walk };

// The eye's position: its cell, and the box in which it may move, ends included, near_z inside the cell.
struct Viewpoint {
  geometry::Point eye{};
  std::size_t cell = 0;
  geometry::Box limits;
};
// Error: the eye is in no cell, or outside the limits of its cell (it would see through the near plane).
[[nodiscard]] base::Result<Viewpoint> viewpoint(const scene::CellScene& scene, const geometry::Point& eye);

// One word, and its text on the source tape.
struct EncodedWord {
  std::uint32_t value = 0;  // 18 bits
  std::string tag;          // symbol defined at this word, or empty
  std::string expression;   // "777716", "400000+c3"
  std::string comment;      // without the "/"
};

struct EncodedScene {
  std::uint32_t base = 0;
  Tape tape = Tape::view;
  std::vector<EncodedWord> words;                // words[n] is at address base + n
  std::vector<std::uint32_t> cell_addresses;     // by cell number: its X
  std::vector<std::uint32_t> opening_addresses;  // by opening number: its word 0
  Viewpoint view;
  std::size_t cell_words = 0;     // words in all cell-elements
  std::size_t opening_words = 0;  // words in all opening-elements
};

// Without an eye, the scene's default view is used; the initial cell is that of the eye. Precondition: check_scene(scene)
// found no error. Errors: those of viewpoint(); the scene does not fit between base and the end of core; a cell is too thin
// for a walk.
[[nodiscard]] base::Result<EncodedScene> encode(const scene::CellScene& scene, std::optional<geometry::Point> eye = {},
                                                std::uint32_t base = 0, Tape tape = Tape::view);

// The words of the header for another viewpoint: the only words of a scene that depend on it.
[[nodiscard]] std::array<std::uint32_t, scene_header_words> header_words(const EncodedScene& scene,
                                                                         const Viewpoint& view);

// The symbolic source tape of a scene, which is assembled after the program and loaded into core with it: encode(scene,
// eye) one word per line, numbers in octal, in decimal in the comments; tags scene, c0.., o0... The first line is a comment
// with the scene's name and counts. Errors are those of encode.
[[nodiscard]] base::Result<std::string> write_tape(const scene::CellScene& scene, std::optional<geometry::Point> eye = {},
                                                   Tape tape = Tape::view);

}  // namespace sightline::programs::jones
