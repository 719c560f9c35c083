// See sweep_guest.hpp.
#include "host/compare/sweep_guest.hpp"

#include <utility>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/base/result.hpp"
#include "host/guests/jones/guest.hpp"
#include "host/guests/jones/program.hpp"
#include "host/guests/jones/twin/twin.hpp"

namespace sightline::compare {

namespace {

namespace oracle = algorithms::oracle;

// From half points about the middle of the screen to points.
std::vector<oracle::ScreenSegment> in_points(const std::vector<guests::jones::Piece>& pieces) {
  constexpr double centre = 512;
  std::vector<oracle::ScreenSegment> segments;
  segments.reserve(pieces.size());
  for (const guests::jones::Piece& piece : pieces) {
    segments.push_back({piece.line.a.x * 0.5 + centre, piece.line.a.y * 0.5 + centre,
                        piece.line.b.x * 0.5 + centre, piece.line.b.y * 0.5 + centre});
  }
  return segments;
}

guests::jones::View twin_view(const guests::jones::Program& program) {
  std::vector<core::Word18> core(guests::jones::core_words);
  for (const auto& [address, word] : program.core) core.at(address) = word;
  return guests::jones::run(core, program.labels.scene,
                            guests::jones::default_parameters(core, program.labels.scene));
}

}  // namespace

SweepGuest::SweepGuest(const scene::CellScene& scene, bool eae, oracle::Matter matter)
    : scene_(&scene), eae_(eae), matter_(std::move(matter)), lines_(matter_.real_lines()) {}

std::optional<SweepGuest> SweepGuest::of(const scene::CellScene& scene, bool eae) {
  auto matter = oracle::Matter::of(scene);
  if (!matter) return std::nullopt;
  return SweepGuest(scene, eae, std::move(*matter));
}

base::Result<SweepGuestView> SweepGuest::view(const geometry::Point& eye) const {
  guests::jones::ProgramOptions program_options;
  program_options.eae = eae_;
  program_options.tape.view = eye;
  const auto assembled = guests::jones::assemble_program(*scene_, program_options);
  if (!assembled) return assembled.error();
  const auto& program = *assembled;
  guests::jones::GuestOptions options;
  options.eae = eae_;
  options.views = 1;
  options.display = false;
  const guests::jones::GuestRun run = guests::jones::run_guest(program, options);
  const guests::jones::View twin = twin_view(program);
  SweepGuestView result;
  result.status = guests::jones::name(twin.status);
  if (!run.views.empty()) {
    const guests::jones::GuestView& guest = run.views.front();
    result.status = guests::jones::name(guest.status);
    result.same_as_twin = guest.status == twin.status && guest.display_file == twin.display_file;
    result.display_words = guest.display_file.size();
    result.pieces = guest.pieces;
    result.visits = guest.visits;
    result.emulated_ns = guest.time.count();
  }
  oracle::Window window;
  window.near = guests::jones::near_plane;
  result.error =
      oracle::drawn_error(oracle::on_screen(oracle::visible_lines(matter_, lines_, eye, window), eye, window),
                          in_points(twin.pieces), 1.0);
  return result;
}

}  // namespace sightline::compare
