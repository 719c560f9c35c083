#include "host/app/commands/skala_session.hpp"

#include <fmt/core.h>

#include <array>
#include <filesystem>
#include <initializer_list>
#include <utility>

#include "host/app/outputs.hpp"
#include "host/programs/skala/session.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/pen_path.hpp"

namespace sightline::app {

namespace {

using programs::skala::Device;
using programs::skala::GuestPicture;

struct Drawn {
  programs::skala::GuestPicture picture;
  std::size_t bytes = 0;
  std::uint64_t points_walked = 0;
};

[[noreturn]] void fail(const SkalaRequest& order, base::ErrorKind kind, const std::string& what) {
  throw base::error_of(kind, fmt::format("{}: {}", order.name, what));
}

// Why a program may fail for want of the clock it is made for; nothing at that clock.
std::string_view clock_hint(const SkalaRequest& order) {
  return order.clock.hertz == core::ClockRate{}.hertz ? "" : "; its timing is made for a clock of 3 MHz";
}

void check(const SkalaRequest& order, const programs::skala::GuestPicture& picture) {
  if (!picture.ended) {
    fail(order, base::ErrorKind::program_failed,
         fmt::format("the program did not end within {:.0f} emulated seconds",
                     core::in_seconds(picture.total, order.clock)));
  }
  if (!picture.faults.empty()) {
    std::string text = "the program and the device do not get along";
    for (const programs::skala::DeviceFault& fault : picture.faults)
      text +=
          fmt::format("{}{}: {}", &fault == &picture.faults.front() ? ": " : ", ", fault.what, fault.count);
    fail(order, base::ErrorKind::program_failed, text.append(clock_hint(order)));
  }
  if (picture.status != programs::skala::Status::complete) {
    const bool timing = picture.status == programs::skala::Status::link_error;
    fail(order, base::ErrorKind::program_failed,
         fmt::format("the program stopped: {}{}", text_of(picture.status), timing ? clock_hint(order) : ""));
  }
}

Drawn drawn(const programs::skala::Session& session, const SkalaRequest& order, bool visibility) {
  programs::skala::View view = order.view;
  view.visibility = visibility;
  const auto stream = programs::skala::stream_of(order.grid, view);
  programs::skala::GuestOptions options;
  options.device = view.device;
  options.link = order.link;
  options.clock = order.clock;
  programs::skala::CheckedPicture run = session.run(stream, options);
  check(order, run.guest);
  if (!run.difference.empty()) {
    fail(order, base::ErrorKind::differs,
         "internal error: the 8080's picture is not the one its native twin makes; " + run.difference);
  }
  return {std::move(run.guest), stream.size(), run.twin.counts.points_walked};
}

// Files BASE.ENDING of which all appear or, if one cannot be written, none: opened together, and put in their
// places when all are written.
class PictureSet {
 public:
  PictureSet(const std::string& base, std::initializer_list<std::string_view> endings) {
    for (const std::string_view ending : endings) {
      paths_.push_back(base + std::string(ending));
      outputs_.emplace_back(paths_.back());
    }
  }

  // By the place of its ending.
  Output& at(std::size_t i) { return outputs_[i]; }

  std::vector<std::string> commit() {
    for (Output& output : outputs_) output.commit();
    return std::move(paths_);
  }

 private:
  std::vector<std::string> paths_;
  std::vector<Output> outputs_;
};

std::string skala_title(const SkalaRequest& order) {
  return fmt::format("{}, {}, Skala 1985 on the 8080, {}", order.name, name_of(order.view.picture),
                     name_of(order.view.device));
}

}  // namespace

std::string_view name_of(programs::skala::Device device) {
  constexpr std::array<std::string_view, 4> names{"EF9365 board", "ALT-256 board", "CalComp 565",
                                                  "Minigraf 0507"};
  return names[static_cast<std::size_t>(device)];
}

std::string_view name_of(programs::skala::PictureKind picture) {
  constexpr std::array<std::string_view, 3> names{"hidden lines", "shaded surface", "contours"};
  return names[static_cast<std::size_t>(picture)];
}

picture::RasterPalette usual_palette(programs::skala::PictureKind picture) {
  return picture == programs::skala::PictureKind::surface ? picture::RasterPalette::grey
                                                        : picture::RasterPalette::colour;
}

SkalaOutcome run_skala_request(const programs::skala::Session& session, const SkalaRequest& order) {
  Drawn asked = drawn(session, order, order.view.visibility);
  SkalaOutcome outcome;
  outcome.bytes = asked.bytes;
  outcome.points_walked = asked.points_walked;
  outcome.points_lit = programs::skala::points_lit(asked.picture);
  outcome.plotter = programs::skala::plotter_work(asked.picture.moves);
  outcome.picture = std::move(asked.picture);
  if (order.view.visibility && order.measure_visibility) {
    const auto plain = static_cast<double>(drawn(session, order, false).picture.drawing.count());
    const auto with = static_cast<double>(outcome.picture.drawing.count());
    if (plain > 0) outcome.visibility_cost = 100 * (with - plain) / plain;
  }
  return outcome;
}

std::vector<std::string> write_skala_pictures(const SkalaFiles& files, const SkalaRequest& order,
                                              const SkalaOutcome& outcome) {
  make_directory(files.directory);
  const std::string base = (std::filesystem::path(files.directory) / files.stem).string();
  const std::string title = skala_title(order);
  const picture::TextEntries text{{"Title", title}, {"Software", "sightline"}};
  if (is_raster(order.view.device)) {
    PictureSet set(base, {".png"});
    write_png(set.at(0), picture::raster_image(outcome.picture.raster, files.palette, files.scale), text);
    return set.commit();
  }
  const auto paths = programs::skala::pen_paths(outcome.picture.moves);
  const picture::PlotterPaper paper =
      order.view.device == programs::skala::Device::calcomp ? picture::calcomp_paper : picture::minigraf_paper;
  PictureSet set(base, {".png", ".svg", ".hpgl"});
  write_png(set.at(0), picture::pen_image(paths, paper, files.scale), text);
  set.at(1).write(picture::pen_svg(paths, paper, title));
  set.at(2).write(picture::hpgl(paths, paper));
  return set.commit();
}

}  // namespace sightline::app
