#include "host/compare/stripes.hpp"

#include "emulators/core/tstates.hpp"
#include "host/compare/device_raster.hpp"
#include "host/programs/stripes/session.hpp"

namespace sightline::compare {
namespace {

const programs::stripes::Session& session() {
  static const programs::stripes::Session once;
  return once;
}

}  // namespace

base::Result<StripesFaces> stripes_faces(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                         const registry::FaceWindow& window) {
  namespace stripes = programs::stripes;
  constexpr int size = stripes::picture_size;
  StripesFaces result;
  result.faces = picture::PixelGrid(window.width, window.height);
  const stripes::View view{camera, window.scale, window.left, window.height - window.top};
  const auto listed = stripes::project_scene(scene, view, true);
  if (!listed) return listed.error();
  result.not_solved = listed->mutual_parts;
  for (const int right : {0, window.width - size}) {
    for (const int up : {0, window.height - size}) {
      stripes::View moved = view;
      moved.left -= right;
      moved.bottom -= up;
      const auto drawn = session().draw(scene, moved, {stripes::Output::raster, stripes::Computer::i8080, stripes::Computer::i8080});
      if (!drawn) return drawn.error();
      if (result.difference.empty()) result.difference = drawn->picture.difference;
      if (result.seconds == 0) {
        result.seconds = core::in_seconds(drawn->picture.guest.working());
        result.faces_listed = drawn->scene.faces.size();
      }
      const picture::PixelGrid faces = drawn->faces();
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) result.faces.set(x + right, y + up, faces.at(x, y));
    }
  }
  return result;
}

base::Result<StripesPen> stripes_pen(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                     const registry::FaceWindow& window, const picture::PixelGrid& nearest) {
  namespace stripes = programs::stripes;
  constexpr int size = stripes::picture_size;
  const stripes::View view{camera, window.scale, window.left, window.height - window.top};
  const auto drawn = session().draw(scene, view, {stripes::Output::vector, stripes::Computer::i8080, stripes::Computer::i8080});
  if (!drawn) return drawn.error();
  picture::PixelGrid faces(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) faces.set(x, y, nearest.at(x, y));
  StripesPen pen{stripes_pen_points(faces),
                 points_of(stripes::pen_paths(drawn->picture.guest.commands), size + 1),
                 {},
                 drawn->picture.guest.working(),
                 drawn->picture.difference};
  pen.raster = picture::raster_difference(pen.truth, pen.shown);
  return pen;
}

}  // namespace sightline::compare
