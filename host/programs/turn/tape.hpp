// A turning model as words for the PDP-7: the tape that the program of firmware/pdp7/turn reads.
//
// Vertices, edges, the edge structure at angle 0 and the events of a full turn (Plantinga, Seales and Dyer 1990,
// sections 3 and 4), found exactly by host/algorithms/plantinga on the scene where it stands on the axis, and laid out
// as firmware/pdp7/turn/SPECIFICATION.md says. Left out: the program itself (program.hpp).
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

// Where the model begins, and the first address behind it that it must not use.
[[nodiscard]] std::uint32_t model_base(Memory memory);
[[nodiscard]] std::uint32_t model_end(Memory memory);

// How the words of a tape are used.
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
  std::uint32_t file_words = 0;  // room of one display file
  std::uint32_t files = 0;       // 2 or 3
  // By slot: the edge of the model, which of its pieces, and whether the slot's first vertex is the edge's second.
  struct Slot {
    std::uint32_t edge = 0;
    std::uint32_t piece = 0;
    bool reversed = false;
  };
  std::vector<Slot> slot_of;
  // By edge: what the codes 2, 3, ... of its slots stand for, as bits of plantinga::End.
  std::vector<std::vector<std::uint32_t>> partners;
};

// How a scene stands on the axis: its middle on the axis, tilted or not.
//
// Tilted, it is turned about x by the angle whose cosine is 12/13, so that its top faces the viewer at angle 0; all
// coordinates become 13 times as large, and stay whole. Error: they leave the limit of scenes.
[[nodiscard]] base::Result<scene::PolyScene> stand_on_axis(const scene::PolyScene& scene, bool tilted);

// From the middle of the display to the vertex farthest from it, in points: 512 less what rounding moves it.
inline constexpr double points_to_rim = 505;
// A form's words are its coefficients and this; a point of the display has so many units of a vertex's form.
inline constexpr double form_word_middle = 65535.5;
inline constexpr double points_form_unit = 128;
// Points of the display for one unit of the scene.
[[nodiscard]] double points_per_unit(const algorithms::plantinga::RotationModel& model);
// The height of the middle, which is at point 512 of the display, in units; twice it.
[[nodiscard]] std::int64_t twice_middle(const algorithms::plantinga::RotationModel& model);

// The angle of an event in words of 2^18 to a turn, rounded up: a structure that holds from the event on holds at every
// word from this one on, and at none before it.
[[nodiscard]] std::uint32_t event_word(const algorithms::plantinga::Direction& direction);

// `list` is of `model`. Errors: the model does not fit, by how many words and which part is how large; an edge ends in the
// plane of a face or meets more than 62 others; there are more than 512 pieces of edges.
[[nodiscard]] base::Result<Tape> encode(const algorithms::plantinga::RotationModel& model,
                                        const algorithms::plantinga::EventList& list, Memory memory);

// A scene as a tape: it stands on the axis, its events are found and laid out. Errors: those of stand_on_axis, of the events and of
// encode; more edges than can be turned.
[[nodiscard]] base::Result<Tape> make_tape(const scene::PolyScene& scene, Memory memory, bool tilted = true);

// As punched: the count of words, the words, and the word that makes the sum of all 0; each in three lines.
[[nodiscard]] base::Bytes punch(const Tape& tape);
[[nodiscard]] core::Word18 checksum(const std::vector<core::Word18>& words);

}  // namespace sightline::programs::turn
