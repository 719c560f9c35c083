// Jones's program with a scene, assembled from its source tapes: the words for the machine's core, and the addresses of its
// labels.
//
// The program's tapes (firmware/pdp7/jones) are embedded, so that the command needs no files. The sources are
// assembled again for each scene, as the paper describes ("assembled and loaded into core together with the
// program").
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/word.hpp"
#include "emulators/pdp7/state.hpp"
#include "host/base/result.hpp"
#include "host/programs/jones/encode.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::programs::jones {

// (file name, text) of the program's tapes in assembly order.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> firmware_tapes();

// Labels of the program (NOTES.md maps the paper's terms to them).
struct Labels {
  pdp7::Address start = 0;       // start address of the machine
  pdp7::Address clock = 0;       // clkop: CLON, or CLOF to run without the clock
  pdp7::Address scale = 0;       // scale0: S of the first view
  pdp7::Address search = 0;      // a view begins
  pdp7::Address visit = 0;       // a cell is visited
  pdp7::Address opening = 0;     // an opening is tested
  pdp7::Address line = 0;        // clip2: a line is clipped (its second word; the first holds the return)
  pdp7::Address piece = 0;       // drawn: a piece goes into the file
  pdp7::Address file = 0;        // the current display file; a store here publishes a view
  pdp7::Address views = 0;       // counts complete views
  pdp7::Address file_begun = 0;  // dfs: first word of the file under construction
  pdp7::Address status = 0;      // of the last view
  pdp7::Address scene = 0;       // header of the scene
  std::uint32_t file_words = 0;  // size of one display file
  pdp7::Address eye = 0;         // ex: the eye of the last view, three words
  // Only with Build::walk.
  pdp7::Address steps = 0;  // step: the steps of the view that begins, three words; a fourth for rotation
  pdp7::Address stops = 0;  // the axes along which a wall stopped the eye
  // Only with Build::rotation.
  pdp7::Address first_angle = 0;  // angle0: of the first view, degrees
  pdp7::Address angle = 0;        // of the last view, 0..359
};

// The instruction to store at Labels::clock for a program without the clock.
inline constexpr std::uint32_t clock_off = 0700004;  // CLOF

struct Build {
  bool eae = true;                  // -D EAE, for a machine with an EAE
  std::uint32_t fraction_bits = 3;  // -D FRACTION, 0..3: of a coordinate on the screen
  bool truncate = false;            // -D TRUNCATE: quotients and points are truncated, not rounded
  bool walk = false;                // -D WALK: the eye walks from cell to cell
  bool rotation = false;            // -D ROTATE, only with walk: the view turns about the vertical
};

struct Program {
  Build build;
  std::vector<core::Word18> core;  // indexed by address, core_words of them; 0 where the tapes have no word
  std::map<std::string, std::uint32_t, std::less<>> symbols;  // all tags, for tests of single routines
  Labels labels;
  EncodedScene scene;               // based at labels.scene: the words of each cell
  std::uint32_t program_words = 0;  // instructions, variables and constants
  std::uint32_t words_used = 0;  // all but the free words between the constants and the tables
};

// Without an eye, the scene's default view is used. Errors: the eye is not in a cell, or the scene does not fit into core
// with the program.
[[nodiscard]] base::Result<Program> assemble_program(const scene::CellScene& scene, const Build& build = {},
                                                     std::optional<geometry::Point> eye = {});

}  // namespace sightline::programs::jones
