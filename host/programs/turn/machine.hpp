// Runs the program of firmware/pdp7/turn on the emulated PDP-7 with its Type 340, picture by picture. Each picture is
// measured from the store into `file` that ended the one before to the store that ends it. An observer measures; nothing is
// added to the program.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"
#include "host/base/file.hpp"
#include "host/programs/turn/program.hpp"
#include "host/programs/turn/specification.hpp"
#include "host/programs/turn/tape.hpp"

namespace sightline::programs::turn {

// The first pass of the display through a picture's file.
struct ShownPass {
  std::uint32_t picture = 0;  // from 0
  std::vector<core::Stroke> strokes;
};

// One picture, read from the machine.
struct Picture {
  std::uint32_t angle = 0;
  bool wire = false;
  Status status = Status::right;
  core::Duration time{};       // 0 for the first picture
  core::Duration waiting{};    // part of `time`, until the display had taken over a file
  std::uint32_t passes = 0;    // passes of the display begun in that time
  std::uint32_t lines = 0;     // drawn
  std::uint32_t junctions = 0;  // T-junctions drawn
  std::vector<core::Word18> display_file;
  std::vector<ShownPass> shown;  // those that ended in that time, if strokes are kept
};

class Machine {
 public:
  // What is observed in addition to the times; each costs host time.
  struct Observation {
    bool strokes = false;      // keep the first pass through each picture's file
    bool torn_stores = false;  // count them
  };

  // The model is in core, and the program is started after its reading of the tape.
  Machine(const Program& program, const Tape& tape, Observation observation);
  Machine(const Program& program, const Tape& tape) : Machine(program, tape, Observation()) {}
  // The tape is in the reader.
  Machine(const Program& program, const base::Bytes& tape);
  ~Machine();
  Machine(Machine&&) noexcept;

  // Sets the switches and runs until a picture is complete. False: the machine halted, or completed none in `limit` of
  // emulated time; status() tells more.
  [[nodiscard]] bool next(std::uint32_t switches, Picture& picture, core::Duration limit = core::seconds(2));
  [[nodiscard]] Status status() const;
  [[nodiscard]] bool halted() const;
  [[nodiscard]] core::Instant now() const;
  [[nodiscard]] core::Word18 peek(pdp7::Address address) const;
  // Stores into a display file while the display draws it or it waits to be drawn; 0 unless the program has an error.
  [[nodiscard]] std::uint64_t torn_stores() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace sightline::programs::turn
