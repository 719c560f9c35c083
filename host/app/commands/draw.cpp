// `sightline draw`: adds all its methods; draws by the methods that find visible lines.
#include "host/app/commands/draw.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/app/command_line.hpp"
#include "host/app/commands/commands.hpp"
#include "host/app/edge_options.hpp"
#include "host/app/outputs.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/base/number.hpp"
#include "host/base/progress.hpp"
#include "host/base/result.hpp"
#include "host/base/threads.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/face_shades.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/png.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/file_units.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

namespace {

// --- --fill: filled faces by a method that also draws lines

struct FillArguments {
  bool fill = false;
  double stripe = 1;  // pixels
  bool antialias = false;
};

struct FilledPicture {
  const scene::LoadedScene& source;
  const scene::PolyCamera& camera;
  std::optional<double> field;  // the result of image_field
  const DrawOutput& output;     // after read_draw_output
  bool json = false;
};

std::vector<registry::FaceCount> write_outlines(const registry::PreparedFaces& prepared,
                                               const FilledPicture& picture, Output& file) {
  const picture::Paper& paper = picture.output.paper;
  const auto micrometres = [&paper](double side) {
    return static_cast<int>(std::lround((side - 2 * paper.margin) * 1000));
  };
  const registry::FaceWindow window =
      registry::face_window(picture.source.scene, picture.camera, micrometres(paper.width),
                           micrometres(paper.height), picture.field);
  auto seen = value_of(prepared.regions(picture.camera, window), picture.source.name);
  const std::vector<picture::Shade> shades = picture::face_shades(picture.source.scene);
  std::vector<picture::FilledArea> areas;
  for (registry::FaceRegion& region : seen.regions) {
    const picture::Shade& shade = shades[region.face - 1];
    areas.push_back({{shade[0], shade[1], shade[2]}, std::move(region.loops)});
  }
  file.write(std::string_view(picture::svg_of(areas, paper, picture.source.name)));
  return seen.counts;
}

// Places an image on white paper, at the bottom left corner inside the margin.
picture::Image on_sheet(const picture::Image& inside, const DrawOutput& output) {
  picture::Image sheet(output.image.width, output.image.height, inside.channels);
  std::fill(sheet.pixels.begin(), sheet.pixels.end(), std::uint8_t{255});
  const int margin = static_cast<int>(std::lround(output.paper.margin * output.image.unit));
  const int top = sheet.height - margin - inside.height;
  const int rows = std::min(inside.height, sheet.height - std::max(top, 0));
  const int columns = std::min(inside.width, sheet.width - margin);
  for (int row = 0; row < rows; ++row) {
    const auto from = inside.pixels.begin() + static_cast<std::ptrdiff_t>(inside.index(0, row));
    std::copy_n(from, columns * inside.channels,
                sheet.pixels.begin() + static_cast<std::ptrdiff_t>(sheet.index(margin, std::max(top, 0) + row)));
  }
  return sheet;
}

// Colours mixed by the parts of each pixel that the faces cover.
class MixedImage {
 public:
  MixedImage(int width, int height, std::vector<picture::Shade> shades)
      : image_(width, height, 3), shades_(std::move(shades)), sums_(image_.pixels.size()) {}

  void add(const registry::FacePart& part) {
    const picture::Shade& shade = shades_[part.face - 1];
    const std::size_t at = image_.index(part.column, image_.height - 1 - part.row);
    for (std::size_t k = 0; k < shade.size(); ++k) sums_[at + k] += part.part * (int{shade[k]} - int{picture::sky[k]});
    whole_ = part.whole;
  }

  [[nodiscard]] picture::Image image() {
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      // Rounded to nearest; parts of a pixel may exceed it by the error of stripes whose sides cross.
      const std::int64_t value = picture::sky[i % picture::sky.size()] + ((sums_[i] + whole_ / 2) >> std::countr_zero(static_cast<std::uint64_t>(whole_)));
      image_.pixels[i] = static_cast<std::uint8_t>(std::clamp<std::int64_t>(value, 0, 255));
    }
    return image_;
  }

 private:
  picture::Image image_;
  std::vector<picture::Shade> shades_;
  std::vector<std::int64_t> sums_;
  std::int64_t whole_ = 1;
};

std::vector<registry::FaceCount> write_stripes(const registry::PreparedFaces& prepared, bool antialias,
                                              const FilledPicture& picture, Output& file) {
  const DrawOutput& output = picture.output;
  int width = output.image.width;
  int height = output.image.height;
  std::optional<double> field = picture.field;
  if (output.is_sheet()) {
    const auto pixels = [&](double side) {
      return std::max(1, static_cast<int>(std::lround((side - 2 * output.paper.margin) * output.image.unit)));
    };
    width = pixels(output.paper.width);
    height = pixels(output.paper.height);
    // A whole number of pixels, at the same scale.
    const double shorter = (std::min(output.paper.width, output.paper.height) - 2 * output.paper.margin) * output.image.unit;
    if (field && !picture.camera.perspective) *field *= std::min(width, height) / shorter;
  }
  const registry::FaceWindow window = registry::face_window(picture.source.scene, picture.camera, width, height, field);
  const auto shades = picture::face_shades(picture.source.scene);
  picture::Image image;
  std::vector<registry::FaceCount> counts;
  if (antialias) {
    MixedImage mixed(width, height, shades);
    counts = value_of(prepared.coverage(picture.camera, window, [&mixed](const registry::FacePart& part) { mixed.add(part); }),
                      picture.source.name);
    image = mixed.image();
  } else {
    auto seen = value_of(prepared.view(picture.camera, window), picture.source.name);
    image = picture::shaded_image(seen.faces, shades);
    counts = std::move(seen.counts);
  }
  const auto bytes = picture::encode_png(output.is_sheet() ? on_sheet(image, output) : image,
                                         {{"Title", picture.source.name}, {"Software", "sightline"}}, output.image.unit);
  if (!bytes) throw base::io_error(bytes.error().message());
  file.write(std::span<const std::uint8_t>(*bytes));
  return counts;
}

void print_filled_summary(const registry::FaceAlgorithm& algorithm, const FilledPicture& picture,
                          const std::vector<registry::FaceCount>& counts) {
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

void add_fill_options(const Command& command, FillArguments& arguments) {
  const Option fill =
      command.flag("--fill", arguments.fill,
                   "Draw filled faces instead of lines: outlines with holes in .svg, stripes of pixels in .png");
  const std::vector<double> thicknesses(registry::stripe_thicknesses.begin(),
                                        registry::stripe_thicknesses.end());
  command.option("--stripe", arguments.stripe, "Thickness of stripes in pixels, with --fill to .png")
      .one_of_numbers(thicknesses)
      .default_value()
      .value("")
      .needs(fill);
  command.flag("--antialias", arguments.antialias,
               "Mix the colours of the faces in a pixel by the parts that they cover, with --fill to .png")
      .needs(fill);
}

ExitCode draw_filled(const registry::FaceAlgorithm& algorithm, const FillArguments& arguments,
                     const FilledPicture& picture, hidden_lines::Format format) {
  if (format != hidden_lines::Format::svg && format != hidden_lines::Format::png)
    throw base::usage_error(fmt::format("{}: expected a name that ends in .svg or .png with --fill",
                                               picture.output.file));
  if (format == hidden_lines::Format::svg) {
    reject_option(picture.output, "--stripe", "a name that ends in .png");
    reject_option(picture.output, "--antialias", "a name that ends in .png");
  }
  registry::FaceOptions options;
  options.stripe = arguments.stripe;
  const auto prepared = value_of(algorithm.prepare(picture.source.scene, options), picture.source.name);
  Output file(picture.output.file);
  const auto counts = format == hidden_lines::Format::svg ? write_outlines(prepared, picture, file)
                                                   : write_stripes(prepared, arguments.antialias, picture, file);
  file.commit();
  if (picture.json) {
    print_filled_summary(algorithm, picture, counts);
  } else {
    report_written(picture.output.file, fmt::format("{} filled, {}", count_text(scene::face_count(picture.source.scene), "face"), size_text(picture.output, format)));
  }
  return ExitCode::ok;
}

// --- lines

using base::Json;

struct DrawLinesArguments {
  std::string scene;
  MeshArguments mesh;
  CameraArguments camera;
  std::optional<double> field;
  EdgeArguments edges;
  std::string layers;  // empty: the default of the format
  bool hidden = false;
  std::string hatch;  // "ANGLE,SPACING"
  std::string light;  // "X,Y,Z"
  double min_length = 0;
  std::string strokes;      // name of a file
  std::string certificate;  // name of a file
  int turntable = 1;
  std::vector<std::string> views;  // of a sheet
  bool first_angle = false;
  std::vector<std::string> section;  // "x=12.5"
  bool go_on = false;
  bool json = false;
  DrawOutput output;
  FillArguments filled;
};

// The unit is 1 mm on paper; in an image it is about 1 mm on a screen.
picture::DrawingField field_of(const DrawLinesArguments& arguments, hidden_lines::Format format, std::optional<double> extent,
                               std::optional<double> scale) {
  picture::DrawingField field;
  field.extent = extent;
  field.scale = scale;
  field.min_length = arguments.min_length;
  if (format == hidden_lines::Format::png && !arguments.output.is_sheet()) {
    constexpr double pixels_per_unit = 4;
    field.width = arguments.output.image.width / pixels_per_unit;
    field.height = arguments.output.image.height / pixels_per_unit;
  } else {
    field.width = arguments.output.paper.width - 2 * arguments.output.paper.margin;
    field.height = arguments.output.paper.height - 2 * arguments.output.paper.margin;
  }
  return field;
}

// The length on paper of a step of the scene's grid, in mm; empty: the picture is fitted. Error usage: the picture has no
// scale.
std::optional<double> scale_of(const DrawOutput& output, const scene::LoadedScene& source, const scene::PolyCamera& camera) {
  if (output.scale.empty()) return std::nullopt;
  if (camera.perspective)
    throw base::usage_error(fmt::format("--scale: found {} in perspective, which has no scale, expected --view or --orthographic",
                                               output.scale));
  return scale_argument(output.scale) * scene::millimetres(source.report.unit) * source.scene.step;
}

// Error usage: a plotter's margin is wider than the margin for which --field was given, which would reduce the scale.
void reject_wider_margin(const DrawLinesArguments& arguments, const scene::PolyCamera& camera) {
  const picture::Paper& paper = arguments.output.paper;
  const double margin = arguments.output.margin;
  if (!arguments.field || camera.perspective || paper.margin <= margin || !arguments.output.scale.empty()) return;
  const double shorter = std::min(paper.width, paper.height);
  throw base::usage_error(fmt::format("--field: found {:g} with the usual margin of {:g} mm, where {} needs {:g}, expected --margin {:g} as well; "
                            "--field {:g} then has the scale that was asked for",
                            *arguments.field, margin, arguments.output.plotter()->name, paper.margin, paper.margin,
                            *arguments.field * (shorter - 2 * paper.margin) / (shorter - 2 * margin)));
}

// Parses `count` numbers separated by commas. Error usage.
std::vector<double> numbers_argument(std::string_view option, const std::string& text, std::size_t count,
                                     std::string_view expected) {
  std::vector<double> numbers;
  std::string_view rest = text;
  while (numbers.size() < count) {
    const std::size_t comma = rest.find(',');
    const auto number = base::decimal_number(rest.substr(0, comma));
    if (!number || (comma == std::string_view::npos) != (numbers.size() + 1 == count))
      throw base::usage_error(fmt::format("{}: found \"{}\", expected {}", option, text, expected));
    numbers.push_back(*number);
    rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
  }
  return numbers;
}

// Error usage: the angle or spacing is out of range.
std::optional<hidden_lines::HatchOptions> hatching(const DrawLinesArguments& arguments) {
  if (arguments.hatch.empty()) return std::nullopt;
  const auto numbers = numbers_argument("--hatch", arguments.hatch, 2, "ANGLE,SPACING in degrees and mm, such as 45,1.5");
  constexpr double least_spacing = 0.05;
  if (std::abs(numbers[0]) > 360 || numbers[1] < least_spacing || numbers[1] > 1000)
    throw base::usage_error(fmt::format("--hatch: found \"{}\", expected an angle up to 360 and a spacing from {} to 1000 mm",
                                        arguments.hatch, least_spacing));
  hidden_lines::HatchOptions hatch{numbers[0], numbers[1]};
  if (!arguments.light.empty()) {
    const auto light = numbers_argument("--light", arguments.light, 3, "X,Y,Z, the direction towards the light");
    hatch.light = {light[0], light[1], light[2]};
    if (*hatch.light == std::array<double, 3>{}) throw base::usage_error("--light: found 0,0,0, expected a direction");
  }
  return hatch;
}

Json summary_of(const registry::LineAlgorithm& algorithm, const std::string& file, const scene::LoadedScene& source,
                const AimedCamera& camera, const hidden_lines::Drawing& drawn) {
  Json counts = Json::object();
  for (const auto& count : drawn.counts) counts[std::string(count.name)] = count.value;
  Json document{{"schema", "sightline/draw/1"},
                {"algorithm", algorithm.name},
                {"scene", source.name},
                {"output", file},
                {"camera", camera_json(source.scene, camera)},
                {"step", source.scene.step},
                {"largest_shift", source.report.largest_shift},
                {"edges", drawn.edges ? *drawn.edges : picture::edges_of(source.scene).size()},
                {"pieces", drawn.visible.pieces.size()},
                {"pieces_drawn", drawn.pieces},
                {"strokes", drawn.stroke_count},
                {"visible_length", drawn.visible_length},
                {"counts", counts}};
  if (drawn.by_kind) {
    Json kinds = Json::object();
    for (std::size_t k = 0; k < picture::edge_kind_count; ++k)
      if ((*drawn.by_kind)[k] > 0) kinds[std::string(picture::edge_kind_names[k])] = (*drawn.by_kind)[k];
    document["edges_by_kind"] = kinds;
  }
  if (drawn.hatch_lines > 0) document["hatching"] = {{"lines", drawn.hatch_lines}, {"pieces", drawn.hatch_pieces}};
  return document;
}

// part-07.svg for part.svg, with as many digits as the last number has.
std::string numbered(const std::string& file, int number, int count) {
  if (count == 1 || file == "-") return file;
  const std::filesystem::path path(file);
  const std::string digits = std::to_string(count);
  return (path.parent_path() / fmt::format("{}-{:0{}}{}", path.stem().string(), number, digits.size(), path.extension().string()))
      .string();
}

// The value of a result; an error about a view option is thrown with the name of the command's option.
template <class Value>
Value value_of_view(base::Result<Value> result) {
  if (!result && result.error().file == "hatch") result.error().file = "--hatch";
  return value_of(std::move(result));
}

hidden_lines::Views views_of(const scene::LoadedScene& source, const hidden_lines::ViewOptions& options,
                             std::span<const scene::PolyCamera> cameras) {
  hidden_lines::Views views = value_of_view(hidden_lines::Views::of(source, options, cameras));
  for (const std::string& note : views.notes()) warn(note);
  return views;
}

// The planes of --section. What lies between the eye and a plane is taken away. Error usage: no plane, or one that is seen edge on.
std::vector<scene::SectionPlane> section_planes(const std::vector<std::string>& texts, const scene::PolyScene& scene,
                                                const scene::PolyCamera& camera) {
  std::vector<scene::SectionPlane> planes;
  const std::array<double, 3> eye = scene::file_point(scene, camera.eye);
  for (const std::string& text : texts) {
    const auto at = text.size() > 2 && text[1] == '=' ? base::decimal_number(std::string_view(text).substr(2)) : std::nullopt;
    if (!at || text[0] < 'x' || text[0] > 'z')
      throw base::usage_error(fmt::format("--section: found \"{}\", expected an axis and a place in the unit of the file, such as x=12.5", text));
    scene::SectionPlane plane{static_cast<std::size_t>(text[0] - 'x'), *at, true};
    const double towards = camera.perspective ? *at - eye[plane.axis] : static_cast<double>(camera.forward[plane.axis]);
    if (towards == 0) {
      throw base::usage_error(fmt::format("--section: found {}, which this view sees edge on, expected a plane across the view or another "
                                          "view, such as --view iso", text));
    }
    plane.keep_above = towards > 0;
    planes.push_back(plane);
  }
  return planes;
}

// The part of a scene behind the planes of --section. `aimed`: the camera, of the whole scene; then of that part.
scene::Section cut_open(const DrawLinesArguments& arguments, const scene::LoadedScene& whole, AimedCamera& aimed) {
  const auto planes = section_planes(arguments.section, whole.scene, aimed.camera);
  scene::PolyImportOptions options;
  if (aimed.camera.perspective) options.eye = scene::file_point(whole.scene, aimed.camera.eye);
  scene::Section section = value_of(scene::section_of(whole, planes, options), whole.name);
  for (const std::string& note : section.notes) warn(fmt::format("{}: {}", whole.name, note));
  const scene::PolyScene& scene = section.loaded.scene;
  // Without perspective the eye is only the origin of the image.
  const auto eye = scene::grid_point(scene, scene::file_point(whole.scene, aimed.camera.eye));
  aimed.camera.eye = eye ? *eye : scene::bounds_of(scene).middle();
  return section;
}

// Converts the options of the command to options of the views.
hidden_lines::ViewOptions view_options(const registry::LineAlgorithm& algorithm, const DrawLinesArguments& arguments) {
  hidden_lines::ViewOptions options;
  options.algorithm = algorithm.name;
  options.edges = arguments.edges.options();
  options.hidden = arguments.hidden;
  options.layers = arguments.layers == "body" ? hidden_lines::Layers::body
                   : arguments.layers == "none" ? hidden_lines::Layers::one
                                                : hidden_lines::Layers::kind;
  options.hatch = hatching(arguments);
  options.strokes = !arguments.strokes.empty();
  options.proof = !arguments.certificate.empty();
  options.jobs = base::useful_threads(arguments.mesh.jobs);
  return options;
}

hidden_lines::Side side_of(std::string_view view) {
  using hidden_lines::Side;
  constexpr std::array<std::pair<std::string_view, Side>, 6> sides{{{"front", Side::front},
                                                                    {"back", Side::back},
                                                                    {"left", Side::left},
                                                                    {"right", Side::right},
                                                                    {"top", Side::top},
                                                                    {"bottom", Side::bottom}}};
  for (const auto& [name, side] : sides)
    if (name == view) return side;
  return Side::free;
}

// Several views on one sheet of paper.
ExitCode draw_sheet(const registry::LineAlgorithm& algorithm, const DrawLinesArguments& arguments, const scene::LoadedScene& source,
                    hidden_lines::ViewOptions options, hidden_lines::Format format) {
  std::vector<AimedCamera> aimed;
  std::vector<scene::PolyCamera> cameras;
  std::vector<hidden_lines::SheetView> views;
  for (const std::string& name : arguments.views) {
    CameraArguments camera;
    camera.view = name;
    camera.vertical = arguments.camera.vertical;
    aimed.push_back(aimed_camera_of(camera, source.scene, source.name));
    cameras.push_back(aimed.back().camera);
    views.push_back({aimed.back().camera, side_of(name)});
    if (std::count(arguments.views.begin(), arguments.views.end(), name) > 1)
      throw base::usage_error(fmt::format("--views: found {} twice, expected each view once", name));
  }
  options.field = field_of(arguments, format, std::nullopt, scale_of(arguments.output, source, cameras.front()));
  const hidden_lines::SheetLayout layout(source.scene, views, options.field, arguments.first_angle);
  options.field = layout.field();
  std::optional<Output> file;
  std::optional<Output> strokes;
  const std::array outputs{NamedOutput{&arguments.output.file, &file}, NamedOutput{&arguments.strokes, &strokes}};
  static_cast<void>(open_outputs(outputs, arguments.json, "-: named by --output and --strokes"));
  const hidden_lines::Views prepared = views_of(source, options, cameras);
  std::vector<hidden_lines::Drawing> drawings;
  std::vector<Json> documents;
  std::size_t stroke_count = 0;
  double length = 0;
  base::ProgressLine line;
  for (std::size_t i = 0; i < views.size(); ++i) {
    line.show(fmt::format("view {} of {}", i + 1, views.size()));
    drawings.push_back(value_of_view(prepared.at(cameras[i])));
    stroke_count += drawings.back().stroke_count;
    length += drawings.back().drawn_length;
    if (!arguments.json) continue;
    Json document = summary_of(algorithm, arguments.output.file, source, aimed[i], drawings.back());
    document["view"] = arguments.views[i];
    documents.push_back(std::move(document));
  }
  const picture::VectorDrawing sheet = layout.sheet(drawings);
  if (!arguments.output.scale.empty()) require_room(sheet, arguments.output);
  const auto plot = write_drawing(sheet, arguments.output, format, source.name, *file);
  if (strokes) {
    std::string lines;
    for (const hidden_lines::Drawing& drawing : drawings) lines += hidden_lines::json_lines(drawing, arguments.output.paper.margin);
    strokes->write(std::string_view(lines));
    strokes->commit();
  }
  if (arguments.json) {
    Json all = Json::array();
    for (Json& document : documents) {
      if (plot) document["plot"] = *plot;  // of the sheet
      all.push_back(std::move(document));
    }
    print_json(all);
    return ExitCode::ok;
  }
  const double unit = scene::millimetres(source.report.unit) * source.scene.step;
  std::string summary = count_text(stroke_count, "line");
  if (format != hidden_lines::Format::png || arguments.output.is_sheet())
    summary += fmt::format(", {:.3g} m in all, {} views at a scale of {:.4g}:1", length / 1000, views.size(), *options.field.scale / unit);
  report_written(arguments.output.file, fmt::format("{}, {}", summary, size_text(arguments.output, format)));
  report_written(arguments.strokes, count_text(stroke_count, "line"));
  return ExitCode::ok;
}

ExitCode run_draw_lines(const registry::LineAlgorithm& algorithm, DrawLinesArguments arguments) {
  const hidden_lines::Format format = read_draw_output(arguments.output);
  if (arguments.output.file == "-" && (arguments.json || arguments.turntable > 1))
    throw base::usage_error(fmt::format("--output: found - with {}, expected a file",
                                               arguments.json ? "--json" : "--turntable"));
  const bool on_paper = format != hidden_lines::Format::png || arguments.output.is_sheet();
  if (!on_paper)
    for (const char* option : {"--strokes", "--min-length"})
      reject_option(arguments.output, option, "--size, or a name that does not end in .png");
  if (arguments.strokes == "-" && arguments.turntable > 1)
    throw base::usage_error("--strokes: found - with --turntable, expected a file");
  if (!arguments.output.scale.empty() && format == hidden_lines::Format::png && !arguments.output.is_sheet())
    throw base::usage_error("--scale: found without --size, or a name that does not end in .png");
  check_edges(arguments.edges);
  // The CalComp has only one pen.
  if (arguments.layers.empty()) arguments.layers = format == hidden_lines::Format::steps ? "none" : "kind";
  hidden_lines::ViewOptions options = view_options(algorithm, arguments);
  arguments.mesh.eye = eye_of(arguments.camera);
  const scene::LoadedScene whole =
      load_scene(arguments.scene, arguments.mesh, algorithm.draws_crossings ? Wires::keep : Wires::remove);
  if (whole.cells && algorithm.draws_crossings && (options.edges.are_given() || !arguments.section.empty()))
    warn(fmt::format("{}: the outer box is left out: {}", whole.name,
                     arguments.section.empty() ? "--edges, --crease and --all-edges choose among the edges of solids and walls"
                                               : "--section draws the edges of solids and walls"));
  AimedCamera aimed;
  if (arguments.views.empty()) aimed = camera_anywhere(arguments.camera, whole.scene);
  std::optional<scene::Section> section;
  if (!arguments.section.empty()) {
    section = cut_open(arguments, whole, aimed);
    options.cut_material = section->cut_material;
    if (whole.scene.surfaces.empty() && !options.edges.crease) options.edges.crease = 0;
  }
  const scene::LoadedScene& source = section ? section->loaded : whole;
  const std::size_t faces = scene::face_count(source.scene);
  reject_long_work(source, algorithm.name, algorithm.mesh_time, arguments.go_on);
  if (!arguments.views.empty()) return draw_sheet(algorithm, arguments, source, std::move(options), format);
  require_free_eye(source.scene, aimed.camera, source.name);
  const std::optional<double> extent = image_field(arguments.field, source.scene, aimed.camera);
  options.field = field_of(arguments, format, extent, scale_of(arguments.output, source, aimed.camera));
  reject_wider_margin(arguments, aimed.camera);
  if (arguments.filled.fill) {
    return draw_filled(*registry::find_face_algorithm(algorithm.name), arguments.filled,
                       {source, aimed.camera, extent, arguments.output, arguments.json}, format);
  }
  const scene::SceneFrame frame = frame_of(arguments.camera, source.scene);
  std::vector<scene::PolyCamera> cameras;
  for (int i = 0; i < arguments.turntable; ++i) {
    cameras.push_back(view_of_turn(frame, source.scene, aimed.camera, i, arguments.turntable));
    if (auto error = scene::eye_error(source.scene, cameras.back())) {
      error->file = source.name;
      throw base::bad_input(error->message());
    }
  }
  std::optional<hidden_lines::Views> views;
  std::optional<base::ProgressLine> line(std::in_place);
  // All drawings are checked to fit before the first one is written.
  if (options.field.scale && cameras.size() > 1) {
    views = views_of(source, options, cameras);
    for (const scene::PolyCamera& camera : cameras) require_room(value_of_view(views->at(camera)).picture, arguments.output);
  }
  Json documents = Json::array();
  std::size_t strokes_drawn = 0;
  double length_drawn = 0;
  for (int i = 0; i < arguments.turntable; ++i) {
    AimedCamera camera = aimed;
    camera.camera = cameras[static_cast<std::size_t>(i)];
    if (arguments.turntable > 1) line->show(fmt::format("view {} of {}", i + 1, arguments.turntable));
    DrawOutput output = arguments.output;
    output.file = numbered(arguments.output.file, i + 1, arguments.turntable);
    const std::string strokes_name = arguments.strokes.empty() ? "" : numbered(arguments.strokes, i + 1, arguments.turntable);
    std::optional<Output> file;
    std::optional<Output> strokes;
    std::optional<Output> certificate;
    const std::array outputs{NamedOutput{&output.file, &file}, NamedOutput{&strokes_name, &strokes},
                             NamedOutput{&arguments.certificate, &certificate}};
    static_cast<void>(open_outputs(outputs, arguments.json, "-: named by two of --output, --strokes and --certificate"));
    std::optional<base::ProgressClock> clock;
    if (arguments.turntable == 1) clock.emplace(fmt::format("{}: {} faces", algorithm.name, faces));
    if (!views) views = views_of(source, options, cameras);
    const hidden_lines::Drawing drawn = value_of_view(views->at(camera.camera));
    clock.reset();
    if (options.field.scale) require_room(drawn.picture, output);
    const auto plot = write_drawing(drawn.picture, output, format, source.name, *file);
    if (strokes) {
      strokes->write(std::string_view(hidden_lines::json_lines(drawn, output.paper.margin)));
      strokes->commit();
    }
    if (certificate) {
      certificate->write(std::string_view(views->certificate(camera.camera, drawn)));
      certificate->commit();
    }
    strokes_drawn += drawn.stroke_count;
    length_drawn += drawn.drawn_length;
    if (!arguments.json) continue;
    Json document = summary_of(algorithm, output.file, source, camera, drawn);
    if (plot) document["plot"] = *plot;
    documents.push_back(std::move(document));
  }
  line.reset();
  if (arguments.json) {
    print_json(arguments.turntable == 1 ? documents[0] : documents);
    return ExitCode::ok;
  }
  std::string summary = count_text(strokes_drawn, "line");
  if (on_paper) summary += fmt::format(", {:.3g} m in all", length_drawn / 1000);
  if (arguments.turntable > 1) summary += fmt::format(", {} drawings", arguments.turntable);
  const auto written = [&arguments](const std::string& name) {
    if (arguments.turntable == 1 || name.empty()) return name;
    return fmt::format("{} ... {}", numbered(name, 1, arguments.turntable), numbered(name, arguments.turntable, arguments.turntable));
  };
  report_written(written(arguments.output.file), fmt::format("{}, {}", summary, size_text(arguments.output, format)));
  report_written(written(arguments.strokes), count_text(strokes_drawn, "line"));
  report_written(arguments.certificate, "check it with `sightline verify`");
  return ExitCode::ok;
}

void add_draw_lines(const Command& command, const registry::LineAlgorithm& algorithm) {
  const auto arguments = std::make_shared<DrawLinesArguments>();
  command.option("SCENE", arguments->scene, scene_help).required();
  add_camera_options(command, arguments->camera);
  add_field_option(command, arguments->field, "everything");
  const Option turntable =
      command
          .option("--turntable", arguments->turntable,
                  "Make this many numbered drawings, once around the vertical axis through the middle of the scene")
          .range(1, 9999)
          .default_value()
          .value("N")
          .group("View");
  if (algorithm.draws_crossings) {
    const Option views =
        command
            .option("--views", arguments->views,
                    "Draw several views, as --view names them, on one sheet at one scale in third-angle projection: front,top,right,iso")
            .separated_by(',')
            .one_of(hidden_lines::view_names())
            .value("NAME,...")
            .group("View")
            .excludes(turntable);
    for (const char* other : {"--view", "--eye", "--look-at", "--orthographic", "--up", "--forward", "--right", "--perspective", "--field"})
      views.excludes(command.find_option(other));
    command.flag("--first-angle", arguments->first_angle, "Arrange the views of --views in first-angle projection").needs(views).group("View");
    command
        .option("--section", arguments->section,
                "Remove the part of the scene in front of this plane, in the unit of the file, and hatch the cut faces")
        .separated_by(',')
        .value("x=X,...")
        .group("View")
        .excludes(turntable)
        .excludes(views);
  }
  add_edge_options(command, arguments->edges);
  const Option hidden =
      command.flag("--hidden", arguments->hidden, "Draw hidden lines, dashed, in a separate layer").group("Edges");
  command
      .option("--layers", arguments->layers, "One layer for each kind of edge (kind) or for each body, or one layer for all (none)")
      .one_of({"kind", "body", "none"})
      .default_value("kind; for .steps none")
      .group("Edges");
  if (algorithm.draws_crossings) {
    const Option hatch =
        command
            .option("--hatch", arguments->hatch,
                    "Shade faces by lines at this angle on the paper, with this distance where they are dense")
            .value("DEGREES,MM")
            .group("Hatching");
    command.option("--light", arguments->light, "The direction towards the light")
        .default_value("from above left, behind the eye")
        .value("X,Y,Z")
        .needs(hatch)
        .group("Hatching");
  }
  const Option min_length =
      command
          .option("--min-length", arguments->min_length,
                  "Omit lines shorter than this on the paper, in mm, unless they join two others: stray ticks on smooth meshes")
          .range(0.0, 1000.0)
          .default_value()
          .value("MM")
          .group("Edges");
  add_mesh_options(command, arguments->mesh);
  if (algorithm.mesh_time.seconds > 0) add_go_on_option(command, arguments->go_on);
  if (registry::find_face_algorithm(algorithm.name) != nullptr) {
    add_fill_options(command, arguments->filled);
    if (algorithm.draws_crossings) command.find_option("--fill").excludes(command.find_option("--hatch"));
    command.find_option("--fill").excludes(command.find_option("--all-edges")).excludes(hidden);
  }
  add_draw_output_options(command, arguments->output);
  const Option scale =
      command
          .option("--scale", arguments->output.scale,
                  "The scale on paper, such as 1:50 or 2:1, in parallel projection; it refers to the unit of the scene's file (--unit), or to "
                  "millimetres if it has none")
          .value("N:M")
          .excludes(command.find_option("--field"))
          .group("Paper");
  if (algorithm.prepare_threads != nullptr)
    command.option("--jobs", arguments->mesh.jobs, "Threads; the drawing is the same for any number")
        .range(1U, 1024U)
        .default_value()
        .value("N");
  const Option strokes =
      command
          .option("--strokes", arguments->strokes,
                  "Also write each straight line of the drawing as a line of JSON: its ends on the paper in mm from the bottom left, "
                  "its kind, its layer, its edges and faces")
          .value("FILE");
  if (registry::find_face_algorithm(algorithm.name) != nullptr)
    command.find_option("--fill").excludes(scale).excludes(min_length).excludes(strokes);
  if (algorithm.name == "exact") {
    const Option certificate =
        command
            .option("--certificate", arguments->certificate,
                    "Also write a proof of which parts of the edges are visible in this view, for `sightline verify`")
            .value("FILE");
    for (const char* other : {"--turntable", "--views"}) certificate.excludes(command.find_option(other));
  }
  command.flag("--json", arguments->json, "Print what was drawn as one JSON document on standard output");
  command.run([arguments, &algorithm] { return run_draw_lines(algorithm, *arguments); });
}

}  // namespace

void add_draw_command(const Command& program) {
  std::string methods;
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms())
    methods += std::string(algorithm.name) + ", ";
  for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms())
    if (registry::find_line_algorithm(algorithm.name) == nullptr)
      methods += std::string(algorithm.name) + ", ";
  for (const registry::HeightAlgorithm& algorithm : registry::height_algorithms()) methods += std::string(algorithm.name) + ", ";
  methods.resize(methods.size() - 2);
  const Command command = program.add_command("draw", help_page("draw", {{"methods", methods}}));
  const auto add_method = [&command](const auto& algorithm, std::string_view page) {
    return command.add_command(std::string(algorithm.name),
                               help_page(page, {{"summary", std::string(algorithm.description)},
                                                {"method", std::string(algorithm.name)},
                                                {"camera", help_page("camera").summary}}));
  };
  // The algorithms come from the registries; a new one needs no change here.
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms())
    add_draw_lines(add_method(algorithm, algorithm.why_not_view == nullptr ? "draw_lines" : "draw_parallel"),
                   algorithm);
  for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms())
    if (registry::find_line_algorithm(algorithm.name) == nullptr)
      add_draw_faces(add_method(algorithm, "draw_faces"), algorithm);
  for (const registry::HeightAlgorithm& algorithm : registry::height_algorithms()) {
    const std::string name(algorithm.name);
    add_draw_heights(command.add_command(name, help_page("draw_" + name)), algorithm);
  }
  command.list_shared_options();
}

}  // namespace sightline::app
