// See timing_willis_pictures.hpp.
#include "host/report/timing/willis_pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "host/report/willis_scenes.hpp"
#include "host/picture/png.hpp"

namespace sightline::harness::report {

namespace {

namespace willis = algorithms::willis;

// Greys by face; points at which the order is wrong in red.
picture::Image marked(const picture::PixelGrid& drawn, const picture::PixelGrid& truth) {
  picture::Image image(drawn.width, drawn.height, 3);
  for (int row = 0; row < drawn.height; ++row) {
    for (int column = 0; column < drawn.width; ++column) {
      const std::uint32_t face = drawn.at(column, row);
      const auto grey = static_cast<std::uint8_t>(face == 0 ? 255 : 90 + face * 53 % 120);
      std::uint8_t* const point = &image.pixels[image.index(column, drawn.height - 1 - row)];
      const bool wrong = face != truth.at(column, row);
      point[0] = wrong ? 230 : grey;
      point[1] = point[2] = wrong ? 0 : grey;
    }
  }
  return image;
}

struct Worst {
  std::size_t view = 0;
  std::uint64_t wrong = 0;  // points
  std::uint64_t faces = 0;  // points that show one
};

// The view of the uncut model in which most is wrong; of several, the one in which most is seen.
Worst worst_view(const TrueFaces& views, const willis::Model& uncut) {
  Worst worst;
  for (std::size_t view = 0; view < views.cameras().size(); ++view) {
    const auto& truth = views.truth(view).values;
    const Worst here{view, views.errors_of(views.drawn(uncut, view), view).wrong_inside,
                     static_cast<std::uint64_t>(
                         std::count_if(truth.begin(), truth.end(), [](auto face) { return face != 0; }))};
    if (std::pair(here.wrong, here.faces) > std::pair(worst.wrong, worst.faces)) worst = here;
  }
  return worst;
}

struct Limit {
  int depth;
  std::string_view name;
};
constexpr std::array<Limit, 3> limits{{{0, "nothing cut"}, {1, "cut once"}, {12, "cut up to 12 times"}}};

}  // namespace

Outcome<Gallery> willis_pictures() {
  const WillisScene scene = prisms_in_space();
  const TrueFaces views = true_faces(scene.scene);
  const std::size_t view = worst_view(views, scene.model({.limits = {.depth = 0}})).view;
  const TrueFaces truth(scene.scene, {views.cameras().at(view)}, 256);
  Gallery gallery{"willis-pictures", fmt::format("Willis: {}, wrong points in red", scene.title()), {}};
  for (const auto& [depth, limit] : limits) {
    const willis::Model model = scene.model({.limits = {.depth = depth}});
    const auto corners = random_corners(model, static_cast<std::uint32_t>(view) + 1);
    const auto drawn = ordered_faces(model, truth.cameras().front(), truth.size(), corners);
    const FaceErrors errors = truth.errors_of(drawn, 0);
    auto png = picture::encode_png(marked(drawn, truth.truth(0)));
    if (!png) return ReportError{ErrorKind::file, png.error().message()};
    gallery.figures.push_back(
        {fmt::format("willis-depth-{}", depth), std::string(limit),
         fmt::format("{} pieces, {} pairs left over; points wrong: {} inside faces, {} at edges",
                     model.pieces.size(), model.residual.size(), errors.wrong_inside, errors.wrong_on_edges),
         fmt::format("A town of turned houses from within; {} points in red",
                     errors.wrong_inside + errors.wrong_on_edges),
         "image/png", std::move(*png), false, true});
  }
  return gallery;
}

}  // namespace sightline::harness::report
