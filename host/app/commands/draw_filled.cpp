// See draw_filled.hpp.
#include "host/app/commands/draw_filled.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "host/app/commands/face_shades.hpp"
#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/picture/png.hpp"
#include "host/picture/region_svg.hpp"

namespace sightline::app {

namespace {

template <class Value>
Value filled_checked(base::Result<Value> result, const SceneSource& source) {
  if (!result) {
    result.error().file = source.name;
    throw Failure(ExitCode::bad_input, result.error().message());
  }
  return std::move(*result);
}

std::vector<harness::FaceCount> write_outlines(const harness::PreparedFaces& prepared,
                                               const FilledPicture& picture, Output& file) {
  const picture::Paper& paper = picture.output.paper;
  const auto micrometres = [&paper](double side) {
    return static_cast<int>(std::lround((side - 2 * paper.margin) * 1000));
  };
  const harness::FaceWindow window =
      harness::face_window(picture.source.scene, picture.camera, micrometres(paper.width),
                           micrometres(paper.height), picture.field);
  auto seen = filled_checked(prepared.regions(picture.camera, window), picture.source);
  const std::vector<Shade> shades = face_shades(picture.source.scene);
  std::vector<picture::FilledArea> areas;
  for (harness::FaceRegion& region : seen.regions) {
    const Shade& shade = shades[region.face - 1];
    areas.push_back({{shade[0], shade[1], shade[2]}, std::move(region.loops)});
  }
  file.write(std::string_view(picture::svg_of(areas, paper, picture.source.name)));
  return seen.counts;
}

std::vector<harness::FaceCount> write_stripes(const harness::PreparedFaces& prepared,
                                              const FilledPicture& picture, Output& file) {
  const picture::ImageSize& size = picture.output.image;
  const harness::FaceWindow window =
      harness::face_window(picture.source.scene, picture.camera, size.width, size.height, picture.field);
  const auto seen = filled_checked(prepared.view(picture.camera, window), picture.source);
  const auto bytes = picture::encode_png(shaded(seen.faces, face_shades(picture.source.scene)),
                                         {{"Title", picture.source.name}, {"Software", "sightline"}});
  if (!bytes) throw Failure(ExitCode::io, bytes.error().message());
  file.write(std::span<const std::uint8_t>(*bytes));
  return seen.counts;
}

void print_filled_summary(const harness::FaceAlgorithm& algorithm, const FilledPicture& picture,
                          const std::vector<harness::FaceCount>& counts) {
  base::Json object = base::Json::object();
  for (const auto& count : counts) object[std::string(count.name)] = count.value;
  const base::Json document{{"schema", "sightline/draw/1"},
                            {"algorithm", algorithm.name},
                            {"scene", picture.source.name},
                            {"output", picture.output.file},
                            {"filled", true},
                            {"counts", object}};
  print_json(document);
}

}  // namespace

void add_fill_options(const Command& command, FillArguments& arguments) {
  const Option fill =
      command.flag("--fill", arguments.fill,
                   "Faces filled instead of lines: outlines with holes in .svg, stripes of pixels in .png");
  const std::vector<double> thicknesses(harness::stripe_thicknesses.begin(), harness::stripe_thicknesses.end());
  command.option("--stripe", arguments.stripe, "Thickness of stripes in pixels, with --fill to .png")
      .one_of_numbers(thicknesses)
      .default_value()
      .value("")
      .needs(fill);
}

ExitCode draw_filled(const harness::FaceAlgorithm& algorithm, const FillArguments& arguments,
                     const FilledPicture& picture, DrawingFormat format) {
  if (format == DrawingFormat::hpgl)
    throw Failure(ExitCode::usage, fmt::format("{}: expected a name that ends in .svg or .png with --fill",
                                               picture.output.file));
  if (format == DrawingFormat::svg) refuse_option(picture.output, "--stripe", "a name that ends in .png");
  harness::FaceOptions options;
  options.stripe = arguments.stripe;
  const auto prepared = filled_checked(algorithm.prepare(picture.source.scene, options), picture.source);
  Output file(picture.output.file);
  const auto counts = format == DrawingFormat::svg ? write_outlines(prepared, picture, file)
                                                   : write_stripes(prepared, picture, file);
  file.commit();
  if (picture.json) print_filled_summary(algorithm, picture, counts);
  return ExitCode::ok;
}

}  // namespace sightline::app
