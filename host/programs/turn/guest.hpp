// Runs the program of firmware/pdp7/turn on the emulated PDP-7 with its Type 340, one picture after the other, and
// measures each: from the store into `file` that ended the picture before to the one that ends this. An observer
// measures; nothing is added to the program.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "emulators/core/word.hpp"
#include "host/base/file.hpp"
#include "host/programs/turn/program.hpp"
#include "host/programs/turn/tape.hpp"
#include "host/programs/turn/twin/twin.hpp"

namespace sightline::programs::turn {

// The first pass of the display through a picture's file.
struct ShownPass {
  std::uint32_t picture = 0;  // from 0
  std::vector<core::Stroke> strokes;
};

struct GuestPicture {
  std::uint32_t angle = 0;
  bool wire = false;
  Status status = Status::right;
  core::Duration time{};     // 0 of the first picture
  core::Duration waiting{};  // of that, until the display had taken up a file
  std::uint32_t passes = 0;  // of the display begun in that time
  std::vector<core::Word18> display_file;
  std::vector<ShownPass> shown;  // ended in that time, if strokes are kept
};

class Guest {
 public:
  enum class Strokes : std::uint8_t { dropped, kept };

  // The model is in core and the program is started behind its reading of the tape.
  Guest(const Program& program, const Tape& tape, Strokes strokes = Strokes::dropped);
  // The tape is in the reader.
  Guest(const Program& program, const base::Bytes& tape, Strokes strokes = Strokes::dropped);
  ~Guest();
  Guest(Guest&&) noexcept;

  // Sets the switches and runs until a picture is complete. False: the machine halted, or made none in `limit` of its
  // time; status() says more.
  [[nodiscard]] bool next(std::uint32_t switches, GuestPicture& picture, core::Duration limit = core::seconds(2));
  [[nodiscard]] Status status() const;
  [[nodiscard]] bool halted() const;
  [[nodiscard]] core::Instant now() const;
  [[nodiscard]] core::Word18 peek(pdp7::Address address) const;
  // Stores into a display file while the display draws it, or while it waits to be drawn: none, if all is well.
  [[nodiscard]] std::uint64_t torn_stores() const;

 private:
  class Machine;
  std::unique_ptr<Machine> machine_;
};

}  // namespace sightline::programs::turn
