// A model turning on the emulated PDP-7 beside the twin: assembled once, the tape in core, run picture by picture, each
// compared with its twin's word for word, and summed up.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/programs/turn/guest.hpp"
#include "host/programs/turn/tape.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::turn {

// What a run of pictures comes to. Times are the machine's.
struct Summary {
  std::uint32_t pictures = 0;
  double frames_per_second_mean = 0;
  double frames_per_second_worst = 0;
  double computing_mean = 0;  // seconds a picture without waiting
  double computing_worst = 0;
  double waiting_fraction = 0;
  double refreshes_per_second = 0;
  double junctions_mean = 0;  // T-junctions drawn
  double lines_mean = 0;
  std::uint32_t display_words_most = 0;
};

struct TurnRun {
  std::vector<GuestPicture> pictures;  // without display files unless they are asked for
  std::vector<Picture> twins;          // likewise
  Summary summary;
  std::string difference;  // where a picture is not its twin's; empty: nowhere
  std::vector<ShownPass> shown;  // if strokes are kept
  bool stopped = false;    // the machine halted or made no picture
};

struct RunOptions {
  std::uint32_t pictures = 0;
  std::function<std::uint32_t(std::uint32_t picture)> switches;
  bool keep_files = false;
  bool keep_strokes = false;
};

class Session {
 public:
  Session(const Tape& tape, bool eae);

  [[nodiscard]] const Program& program() const { return program_; }
  [[nodiscard]] const Tape& tape() const { return tape_; }
  [[nodiscard]] TurnRun run(const RunOptions& options) const;
  // The step, in words of 2^18 to a turn, at which one turn takes `seconds` nearest: found by turning.
  [[nodiscard]] std::uint32_t step_for(double seconds, bool wire) const;
  // Pictures of one turn at a step.
  [[nodiscard]] static std::uint32_t pictures_of_turn(std::uint32_t step);

 private:
  Tape tape_;
  Program program_;
};

// A scene as a tape: it stands on the axis, its events are found and laid out. Errors: those of stand_on_axis, of the events and of
// encode; more edges than can be turned.
[[nodiscard]] base::Result<Tape> make_tape(const scene::PolyScene& scene, Memory memory, bool tilted = true);

// A turn with hidden lines removed and the same pictures as wire frames.
struct TurnMeasure {
  std::uint32_t step = 0;  // from picture to picture, 2^18 a turn
  TurnRun hidden;
  TurnRun wire;
  // Mean time of a picture with hidden lines removed over that of a wire frame: the paper's claim.
  [[nodiscard]] double cost_against_wire_frame() const;
  // Seconds a turn takes.
  [[nodiscard]] double turn_seconds() const;
};
// One turn at the step that takes nearest to 8 s, or so many pictures of it (0: all).
[[nodiscard]] TurnMeasure measure_turn(const Session& session, std::uint32_t pictures = 0, bool keep_strokes = false);

// The first difference between a picture and its twin, empty if there is none.
[[nodiscard]] std::string difference_of(const GuestPicture& guest, const Picture& twin);

}  // namespace sightline::programs::turn
