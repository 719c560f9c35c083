#include "host/app/commands/stripes_session.hpp"

#include <fmt/core.h>

#include "host/algorithms/registry/faces.hpp"
#include "host/app/command.hpp"

namespace sightline::app {

namespace stripes = programs::stripes;

stripes::View stripes_view(const scene::PolyScene& scene, const scene::PolyCamera& camera, std::optional<double> extent) {
  const registry::FaceWindow window =
      registry::face_window(scene, camera, stripes::picture_size, stripes::picture_size, extent);
  return {camera, window.scale, window.left, window.height - window.top};
}

stripes::DrawnScene draw_stripes(const stripes::Session& session, const scene::PolyScene& scene, const std::string& source,
                                 const stripes::View& view, const stripes::StreamOptions& options) {
  auto drawn = session.draw(scene, view, options);
  if (!drawn) {
    base::Error error = drawn.error();
    error.file = source;
    throw base::bad_input(error.message());
  }
  const stripes::GuestPicture& guest = drawn->picture.guest;
  if (!guest.ended) throw base::program_failed(fmt::format("{}: the program on the 8080 did not end", source));
  if (!drawn->picture.difference.empty())
    throw base::difference(fmt::format("{}: internal error: the picture on the 8080 is not the one its native twin computes: {}", source,
                              drawn->picture.difference));
  if (!guest.faults.empty())
    throw base::program_failed(fmt::format("{}: {}: {}", source, guest.faults.front().what, guest.faults.front().count));
  if (guest.status != stripes::Status::complete)
    throw base::program_failed(fmt::format("{}: the program stopped: {}", source, text_of(guest.status)));
  return std::move(*drawn);
}

}  // namespace sightline::app
