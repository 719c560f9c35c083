// One checked session with Jones's program: assembled once for a scene and a kind of machine, run from any
// place of the scene on the emulated PDP-7, and compared with its twin word for word.
//
// Another eye changes the header of the scene in core and nothing else (SPECIFICATION.md section 7), so the
// program is not assembled again. Another scene is another session: the constants follow the scene, and
// their addresses are all over the program.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/programs/jones/guest.hpp"

namespace sightline::programs::jones {

// The program's run, and its last view by the twin.
struct CheckedRun {
  GuestRun guest;
  View twin;
  // Where the last view is not its twin's: the status, or the first word of the display file. Empty: the
  // same.
  std::string difference;
};

class Session {
 public:
  // The scene is a checked one. Errors: as of assemble_program.
  [[nodiscard]] static base::Result<Session> of(const scene::CellScene& scene, const ProgramOptions& options);

  // As assembled, with the eye that the options gave.
  [[nodiscard]] const Program& program() const { return program_; }
  // Core with the eye somewhere else: what assembling the program with that eye gives, word for word. Error:
  // as of viewpoint().
  [[nodiscard]] base::Result<std::vector<core::Word18>> core_at(const geometry::Point& eye) const;

  // On the machine that the program was assembled for, whatever `eae` of the options says. The switches must
  // be at rest: the twin knows nothing of what happens between views.
  [[nodiscard]] CheckedRun run(const GuestOptions& options) const { return run(program_.core, options); }
  // `core` as of core_at.
  [[nodiscard]] CheckedRun run(std::span<const core::Word18> core, GuestOptions options) const;
  // The twin alone, on such words.
  [[nodiscard]] View twin(std::span<const core::Word18> core, const GuestOptions& options) const;

 private:
  Session(const scene::CellScene& scene, const ProgramOptions& options, Program program);

  scene::CellScene scene_;
  ProgramOptions options_;
  Program program_;
};

}  // namespace sightline::programs::jones
