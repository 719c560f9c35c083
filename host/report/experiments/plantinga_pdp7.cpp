// Solids turning with hidden lines on the PDP-7 (firmware/pdp7/turn): the on-line phase of Plantinga, Seales and Dyer on a
// machine of 1965. One turn in 8 emulated seconds, with the EAE and without, beside the same turn as a wire frame.
//
//   turns      a model, with the EAE or without, each. Pictures are there of runs with the EAE: a picture of the turn as the
//              display drew it.
#include <fmt/core.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "host/guests/turn/session.hpp"
#include "host/picture/raster_image.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::report {

// The embedded files.
std::span<const std::pair<std::string_view, std::string_view>> turn_model_files();

namespace {

namespace turn = guests::turn;

turn::Tape tape_of(std::string_view file, std::string_view text) {
  const auto read = scene::read_poly(text, file, scene::PolyFormat::off);
  if (!read) throw Failure(ErrorKind::bad_input, read.error().message());
  auto tape = turn::make_tape(read->scene, turn::Memory::words_8k);
  if (!tape) throw Failure(ErrorKind::bad_input, fmt::format("{}: {}", file, tape.error().message()));
  return std::move(*tape);
}

}  // namespace

Records plantinga_pdp7(const Context& context) {
  Records records;
  for (const auto& [file, text] : turn_model_files()) {
    const std::string model(file.substr(0, file.rfind('.')));
    context.progress(fmt::format("{} turning on the PDP-7", model));
    const turn::Tape tape = tape_of(file, text);
    for (const bool eae : {true, false}) {
      const turn::Session session(tape, eae);
      const turn::TurnMeasure measure = turn::measure_turn(session, 0, eae);
      for (const turn::TurnRun* run : {&measure.hidden, &measure.wire}) {
        if (!run->difference.empty()) throw Failure(ErrorKind::differs, fmt::format("{}: {}", model, run->difference));
        if (run->stopped) throw Failure(ErrorKind::guest_failed, fmt::format("{}: the machine stopped", model));
      }
      const turn::Summary& hidden = measure.hidden.summary;
      const turn::Layout& layout = tape.layout;
      records["turns"].add({{"model", model},
                            {"eae", eae},
                            {"edges", tape.edges},
                            {"events", tape.events},
                            {"used_words", session.program().words + layout.model() + layout.display_files},
                            {"turn_s", measure.turn_seconds()},
                            {"frames_a_second", hidden.frames_per_second_mean},
                            {"worst_frames_a_second", hidden.frames_per_second_worst},
                            {"wire_frames_a_second", measure.wire.summary.frames_per_second_mean},
                            {"cost", measure.cost_against_wire_frame()},
                            {"junctions", hidden.junctions_mean},
                            {"waiting_percent", 100 * hidden.waiting_fraction},
                            {"refreshes_a_second", hidden.refreshes_per_second},
                            {"screen", eae ? Value(png_picture(picture::crisp_raster(
                                                 measure.hidden.shown[measure.hidden.shown.size() / 8].strokes)))
                                           : Value()}});
    }
  }
  return records;
}

}  // namespace sightline::report
