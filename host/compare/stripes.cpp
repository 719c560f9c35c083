#include "host/compare/stripes.hpp"

#include "emulators/core/tstates.hpp"
#include "host/compare/device_raster.hpp"
#include "host/programs/stripes/stripes.hpp"

namespace sightline::compare {

namespace stripes = programs::stripes;

base::Result<StripesFaces> stripes_faces(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                         const registry::FaceWindow& window) {
  constexpr int size = stripes::picture_size;
  StripesFaces result;
  result.faces = picture::PixelGrid(window.width, window.height);
  const stripes::View view = stripes::view_of(camera, window);
  const auto listed = stripes::project_scene(scene, view, true);
  if (!listed) return listed.error();
  result.not_solved = listed->mutual_parts;
  for (const int right : {0, window.width - size}) {
    for (const int up : {0, window.height - size}) {
      stripes::View moved = view;
      moved.left -= right;
      moved.bottom -= up;
      const auto drawn = stripes::run({.scene = scene, .view = moved, .check = true});
      // A program that fails on its machine counts as one that differs from its twin.
      if (!drawn && drawn.error().kind != base::ErrorKind::bad_input) {
        if (result.difference.empty()) result.difference = drawn.error().message();
        continue;
      }
      if (!drawn) return drawn.error();
      if (result.seconds == 0) {
        result.seconds = core::in_seconds(drawn->picture.working());
        result.faces_listed = drawn->scene.faces.size();
      }
      const picture::PixelGrid& faces = *drawn->faces;
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) result.faces.set(x + right, y + up, faces.at(x, y));
    }
  }
  return result;
}

base::Result<StripesPen> stripes_pen(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                     const registry::FaceWindow& window, const picture::PixelGrid& nearest) {
  constexpr int size = stripes::picture_size;
  const stripes::View view = stripes::view_of(camera, window);
  const auto drawn = stripes::run({.scene = scene, .view = view, .options = {.output = stripes::Output::vector}, .check = true});
  const bool differs = !drawn && drawn.error().kind != base::ErrorKind::bad_input;
  if (!drawn && !differs) return drawn.error();
  picture::PixelGrid faces(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) faces.set(x, y, nearest.at(x, y));
  StripesPen pen{stripes_pen_points(faces),
                 differs ? picture::PixelGrid(size + 1, size + 1) : points_of(stripes::pen_paths(drawn->picture.commands), size + 1),
                 {},
                 differs ? core::TStates{} : drawn->picture.working(),
                 differs ? drawn.error().message() : std::string()};
  pen.raster = picture::raster_difference(pen.truth, pen.shown);
  return pen;
}

}  // namespace sightline::compare
