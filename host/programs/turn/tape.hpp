// A turning model as words for the PDP-7: the tape that the program of firmware/pdp7/turn reads.
//
// Contains vertices, edges, the edge structure at angle 0 and the events of a full turn (Plantinga, Seales and Dyer 1990,
// sections 3 and 4). host/algorithms/plantinga computes them exactly for the scene standing on the axis;
// firmware/pdp7/turn/SPECIFICATION.md defines the layout. Left out: the program itself (program.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "emulators/core/word.hpp"
#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::turn {

enum class Memory : std::uint8_t { words_8k, words_32k };

// The first address of the model, and the first address after its area.
[[nodiscard]] std::uint32_t model_base(Memory memory);
[[nodiscard]] std::uint32_t model_end(Memory memory);

// The number of words of each part of a tape.
struct Layout {
  std::uint32_t header = 0;
  std::uint32_t vertices = 0;   // forms and places
  std::uint32_t edges = 0;      // slots
  std::uint32_t junctions = 0;  // forms
  std::uint32_t events = 0;
  std::uint32_t display_files = 0;  // all of them
  [[nodiscard]] std::uint32_t model() const { return header + vertices + edges + junctions + events; }
};

struct Tape {
  Memory memory = Memory::words_8k;
  std::vector<core::Word18> words;  // of the model, from model_base
  Layout layout;
  std::uint32_t vertices = 0;
  std::uint32_t edges = 0;
  std::uint32_t slots = 0;
  std::uint32_t junctions = 0;  // pairs of edges
  std::uint32_t events = 0;     // angles at which something changes
  std::uint32_t changes = 0;    // words of changes
  std::uint32_t file_words = 0;  // size of one display file
  std::uint32_t files = 0;       // 2 or 3
  // By slot: the edge of the model, the number of the piece, and whether the slot's first vertex is the edge's second.
  struct Slot {
    std::uint32_t edge = 0;
    std::uint32_t piece = 0;
    bool reversed = false;
  };
  std::vector<Slot> slot_of;
  // By edge: the meaning of the codes 2, 3, ... of its slots, as bits of plantinga::End.
  std::vector<std::vector<std::uint32_t>> partners;
};

// Places a scene on the axis: its middle on the axis, tilted or not.
//
// A tilted scene is turned about x by the angle whose cosine is 12/13, so that its top faces the viewer at angle 0; all
// coordinates are multiplied by 13 and stay whole. Error: they exceed the limit of scenes.
[[nodiscard]] base::Result<scene::PolyScene> stand_on_axis(const scene::PolyScene& scene, bool tilted);

// The distance from the middle of the display to the farthest vertex, in points: 512 minus the effect of rounding.
inline constexpr double points_to_rim = 505;
// A form's words are its coefficients plus this; a point of the display is this many units of a vertex's form.
inline constexpr double form_word_middle = 65535.5;
inline constexpr double points_form_unit = 128;
// Points of the display for one unit of the scene.
[[nodiscard]] double points_per_unit(const algorithms::plantinga::RotationModel& model);
// Twice the height of the middle, which is at point 512 of the display, in units.
[[nodiscard]] std::int64_t twice_middle(const algorithms::plantinga::RotationModel& model);

// The angle of an event in words of 2^18 to a turn, rounded up: a structure that holds from the event on holds at every
// word from this one on, and at none before it.
[[nodiscard]] std::uint32_t event_word(const algorithms::plantinga::Direction& direction);

// `list` must be of `model`. Errors: the model does not fit, with the excess and the size of each part; an edge ends in the
// plane of a face or meets more than 62 others; there are more than 512 pieces of edges.
[[nodiscard]] base::Result<Tape> encode(const algorithms::plantinga::RotationModel& model,
                                        const algorithms::plantinga::EventList& list, Memory memory);

// Makes the tape of a scene: stands it on the axis, finds its events, and lays them out. Errors: those of stand_on_axis, of
// the events and of encode; more edges than can be turned.
[[nodiscard]] base::Result<Tape> make_tape(const scene::PolyScene& scene, Memory memory, bool tilted = true);

// The punched tape: the count of words, the words, and the word that makes the sum of all 0; each in three lines.
[[nodiscard]] base::Bytes punch(const Tape& tape);
[[nodiscard]] core::Word18 checksum(const std::vector<core::Word18>& words);

}  // namespace sightline::programs::turn
