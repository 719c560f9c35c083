// Shows a solid turning on the emulated PDP-7 with hidden lines removed: takes a tape and an order, returns the pictures of
// a turn.
//
// run() assembles the program, puts the words of the tape into core, finds the step at which a turn takes about eight
// seconds, and reads the pictures of a turn from the machine, with hidden lines removed and as wire frames. make_tape
// (tape.hpp) makes the tape of a scene. The native twin (twin/twin.hpp) runs only if the order asks for a check.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/programs/turn/machine.hpp"
#include "host/programs/turn/program.hpp"
#include "host/programs/turn/tape.hpp"
#include "host/programs/turn/twin/twin.hpp"

namespace sightline::programs::turn {

struct Order {
  bool eae = true;
  std::uint32_t pictures = 0;  // of each kind; 0: those of one turn
  bool strokes = false;        // keep the first pass of the display through each picture's file
  // Compares every picture with the twin's, word for word, and checks that no display file is changed while it is shown.
  bool check = false;
};

// The summary of a run of pictures. Times are emulated.
struct Summary {
  std::uint32_t pictures = 0;
  double frames_per_second_mean = 0;
  double frames_per_second_worst = 0;
  double computing_mean = 0;  // seconds per picture, without waiting
  double computing_worst = 0;
  double waiting_fraction = 0;
  double refreshes_per_second = 0;
  double junctions_mean = 0;  // T-junctions drawn
  double lines_mean = 0;
};

struct Pictures {
  std::vector<Picture> pictures;  // without display files unless requested
  std::vector<ShownPass> shown;   // if strokes are kept
  Summary summary;
};

struct Outcome {
  std::uint32_t program_words = 0;
  std::uint32_t core_words = 0;  // program, model and display files
  std::uint32_t step = 0;        // from picture to picture, in 2^18 to a turn
  Pictures hidden;               // hidden lines removed
  Pictures wire;                 // the same pictures as wire frames

  // The mean time of a picture with hidden lines removed, divided by that of a wire frame: the paper's claim.
  [[nodiscard]] double cost_against_wire_frame() const;
  // The duration of a turn in seconds.
  [[nodiscard]] double turn_seconds() const;
};

// Errors: program_failed, the machine makes no more pictures; differs, a picture is not its twin's.
[[nodiscard]] base::Result<Outcome> run(const Tape& tape, const Order& order = {});

// --- One kind of pictures, with chosen switches for each

struct PicturesOrder {
  std::uint32_t pictures = 0;
  std::function<std::uint32_t(std::uint32_t picture)> switches;
  bool display_files = false;  // keep them
  bool strokes = false;
  bool check = false;
};
// The program must be assembled for the memory of the tape. Errors: as of run().
[[nodiscard]] base::Result<Pictures> run_pictures(const Program& program, const Tape& tape, const PicturesOrder& order);

// The step, in words of 2^18 to a turn, at which a turn takes closest to `seconds`; found by running turns. Error: as of
// run().
[[nodiscard]] base::Result<std::uint32_t> step_for(const Program& program, const Tape& tape, double seconds, bool wire);
// The number of pictures of one turn at a step.
[[nodiscard]] std::uint32_t pictures_of_turn(std::uint32_t step);

// The first difference between a picture of the machine and its twin's, empty if there is none.
[[nodiscard]] std::string difference_of(const Picture& picture, const TwinPicture& twin);

}  // namespace sightline::programs::turn
