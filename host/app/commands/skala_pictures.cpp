#include "host/app/commands/skala_pictures.hpp"

#include <fmt/core.h>

#include <array>
#include <filesystem>
#include <initializer_list>
#include <utility>

#include "host/app/outputs.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/pen_path.hpp"

namespace sightline::app {

namespace {

// Files BASE.EXTENSION that are opened together and committed after all have been written: all are written, or none.
class PictureSet {
 public:
  PictureSet(const std::string& base, std::initializer_list<std::string_view> endings) {
    for (const std::string_view ending : endings) {
      paths_.push_back(base + std::string(ending));
      outputs_.emplace_back(paths_.back());
    }
  }

  // The output of the i-th extension.
  Output& at(std::size_t i) { return outputs_[i]; }

  std::vector<std::string> commit() {
    for (Output& output : outputs_) output.commit();
    return std::move(paths_);
  }

 private:
  std::vector<std::string> paths_;
  std::vector<Output> outputs_;
};

std::string skala_title(const SkalaRequest& request) {
  return fmt::format("{}, {}, Skala 1985 on the 8080, {}", request.name, name_of(request.order.view.subject),
                     name_of(request.order.device));
}

}  // namespace

std::string_view name_of(programs::skala::Device device) {
  constexpr std::array<std::string_view, 4> names{"EF9365 board", "ALT-256 board", "CalComp 565",
                                                  "Minigraf 0507"};
  return names[static_cast<std::size_t>(device)];
}

std::string_view name_of(algorithms::skala::Subject picture) {
  constexpr std::array<std::string_view, 3> names{"hidden lines", "shaded surface", "contours"};
  return names[static_cast<std::size_t>(picture)];
}

picture::RasterPalette usual_palette(algorithms::skala::Subject picture) {
  return picture == algorithms::skala::Subject::surface ? picture::RasterPalette::grey
                                                        : picture::RasterPalette::colour;
}

std::vector<std::string> write_skala_pictures(const SkalaFiles& files, const SkalaRequest& request,
                                              const programs::skala::Outcome& outcome) {
  make_directory(files.directory);
  const std::string base = (std::filesystem::path(files.directory) / files.stem).string();
  const std::string title = skala_title(request);
  const picture::TextEntries text{{"Title", title}, {"Software", "sightline"}};
  if (is_raster(request.order.device)) {
    PictureSet set(base, {".png"});
    write_png(set.at(0), picture::raster_image(outcome.picture.raster, files.palette, files.scale), text);
    return set.commit();
  }
  const auto paths = programs::skala::pen_paths(outcome.picture.moves);
  const picture::PlotterPaper paper =
      request.order.device == programs::skala::Device::calcomp ? picture::calcomp_paper : picture::minigraf_paper;
  PictureSet set(base, {".png", ".svg", ".hpgl"});
  write_png(set.at(0), picture::pen_image(paths, paper, files.scale), text);
  set.at(1).write(picture::pen_svg(paths, paper, title));
  set.at(2).write(picture::hpgl(paths, paper));
  return set.commit();
}

}  // namespace sightline::app
