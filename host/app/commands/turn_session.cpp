#include "host/app/commands/turn_session.hpp"

#include <fmt/core.h>

#include "host/app/command.hpp"
#include "host/app/outputs.hpp"

namespace sightline::app {

namespace turn = programs::turn;

turn::Tape turn_tape(const scene::PolyScene& scene, const std::string& source, bool large, bool tilted) {
  auto tape = turn::make_tape(scene, large ? turn::Memory::words_32k : turn::Memory::words_8k, tilted);
  if (tape) return std::move(*tape);
  base::Error error = tape.error();
  error.file = source;
  throw base::bad_input(error.message());
}

void write_turn_tape(const scene::PolyScene& scene, const std::string& source, bool large, const std::string& path) {
  Output output(path);
  output.write(turn::punch(turn_tape(scene, source, large)));
  output.commit();
}

TurnMeasure measure_turn(const turn::Session& session, const std::string& source, std::uint32_t pictures,
                         bool keep_strokes) {
  TurnMeasure measure = turn::measure_turn(session, pictures, keep_strokes);
  for (const turn::TurnRun* run : {&measure.hidden, &measure.wire}) {
    if (!run->difference.empty())
      throw base::difference(fmt::format("{}: internal error: a picture on the PDP-7 is not the one its native twin computes: {}",
                                source, run->difference));
    if (run->stopped) throw base::program_failed(fmt::format("{}: the machine makes no more pictures", source));
  }
  return measure;
}

}  // namespace sightline::app
