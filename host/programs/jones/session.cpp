#include "host/programs/jones/session.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace sightline::programs::jones {

namespace {

std::string difference_of(const GuestView& guest, const View& twin) {
  if (guest.status != twin.status)
    return fmt::format("status {}, the twin's {}", name(guest.status), name(twin.status));
  const auto& a = guest.display_file;
  const auto& b = twin.display_file;
  const auto [here, there] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (here == a.end() && there == b.end()) return "";
  const auto word = [](auto at, const auto& words) {
    return at == words.end() ? std::string("none") : fmt::format("{:06o}", at->value());
  };
  return fmt::format("word {} of the display file is {}, the twin's {}", here - a.begin(), word(here, a),
                     word(there, b));
}

}  // namespace

Session::Session(const scene::CellScene& scene, const ProgramOptions& options, Program program)
    : scene_(scene), options_(options), program_(std::move(program)) {}

base::Result<Session> Session::of(const scene::CellScene& scene, const ProgramOptions& options) {
  auto program = assemble_program(scene, options);
  if (!program) return program.error();
  return Session(scene, options, std::move(*program));
}

base::Result<std::vector<core::Word18>> Session::core_at(const geometry::Point& eye) const {
  const auto view = viewpoint(scene_, eye);
  if (!view) return view.error();
  std::vector<core::Word18> core = program_.core;
  pdp7::Address address = program_.labels.scene;
  for (const std::uint32_t word : header_words(program_.scene, *view)) core[address++] = core::Word18(word);
  return core;
}

CheckedRun Session::run(std::span<const core::Word18> core, GuestOptions options) const {
  options.eae = options_.eae;
  CheckedRun run{run_guest(program_, core, options), twin(core, options), {}};
  run.difference = run.guest.views.empty() ? "the program did not complete a view"
                                           : difference_of(run.guest.views.back(), run.twin);
  return run;
}

View Session::twin(std::span<const core::Word18> core, const GuestOptions& options) const {
  Parameters parameters = default_parameters(core, program_.labels.scene);
  if (options.scale) parameters.scale = *options.scale;
  parameters.stereo = options.stereo;
  parameters.immediate = options.immediate;
  parameters.fraction_bits = static_cast<int>(options_.fraction_bits);
  parameters.truncate = options_.truncate;
  return jones::run(core, program_.labels.scene, parameters);
}

}  // namespace sightline::programs::jones
