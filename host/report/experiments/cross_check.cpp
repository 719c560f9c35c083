// All algorithms compared with each other on the common scenes.
//
//   cells     a pair of methods on a scene: how they agree, or that they do not
//   failures  the cells that differ or could not be run, with the first difference
//   scenes    a scene each: size, views, cells listed to run and run
//   reasons   what does not apply, as listed
//   pictures  the first view of each scene by every method, side by side
//   single    each of these by itself
#include "host/report/experiments/cross_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "host/picture/line_drawing.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/report/hard_cases/case_images.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::report {

namespace {

using compare::CrossCheckCell;
using compare::CrossCheckState;

constexpr int side = 200;  // pixels of one picture
constexpr int gap = 8;

std::string lower_case(std::string_view text) {
  std::string lower;
  for (const char c : text) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

Value verdict_of(const CrossCheckCell& cell) {
  switch (cell.state) {
    case CrossCheckState::agrees: return Verdict{true, cell.how};
    case CrossCheckState::differs: return Verdict{false, "differs"};
    case CrossCheckState::not_run: return Verdict{false, "not run"};
    case CrossCheckState::not_applicable: return "n/a";
  }
  return {};
}

picture::Image lines_image(const compare::CommonScene& scene, const compare::CrossCheckView& view,
                           const picture::LinePicture& lines) {
  const auto window = view.window();
  const double half = window.width / 2.0 / window.scale;
  picture::DrawingField field;
  field.extent = view.camera.perspective ? 360 / std::numbers::pi * std::atan(half) : 2 * half;
  return picture::image_of(picture::line_drawing(lines, scene.scene, view.camera, field), {side, side, 1.0});
}

picture::Image side_by_side(const std::vector<picture::Image>& images) {
  const auto count = static_cast<int>(images.size());
  picture::Image all(count * (side + gap) - gap, side, 3);
  std::fill(all.pixels.begin(), all.pixels.end(), std::uint8_t{255});
  for (int i = 0; i < count; ++i) {
    const picture::Image& image = images[static_cast<std::size_t>(i)];
    const auto from = [&](int row, int value) {
      return image.pixels[image.index(value / 3, row) + (image.channels == 3 ? static_cast<std::size_t>(value % 3) : 0)];
    };
    for (int row = 0; row < side; ++row)
      for (int value = 0; value < 3 * side; ++value)
        all.pixels[all.index(i * (side + gap), row) + static_cast<std::size_t>(value)] = from(row, value);
  }
  return all;
}

void add_pictures(RowSet& pictures, RowSet& single, const compare::CommonScene& scene,
                  const compare::SceneCrossCheck& agreement) {
  std::vector<picture::Image> images;
  std::string names;
  for (std::size_t who = 0; who < compare::participants().size(); ++who) {
    const compare::CrossCheckPicture& picture = agreement.pictures[who].front();
    const auto add = [&](picture::Image image, std::string_view what) {
      single.add({{"id", fmt::format("{}-{}", lower_case(scene.name), images.size() + 1)},
                  {"scene", scene.name},
                  {"title", scene.title},
                  {"method", fmt::format("{}{}", compare::participants()[who].name, what)},
                  {"picture", png_picture(image)}});
      images.push_back(std::move(image));
      names += fmt::format("{}{}{}", names.empty() ? "" : ", ", compare::participants()[who].name, what);
    };
    if (picture.lines) add(lines_image(scene, scene.views.front(), *picture.lines), "");
    if (picture.faces) add(faces_image(*picture.faces, side), picture.lines ? " (faces)" : "");
  }
  if (images.empty())
    throw Failure(ErrorKind::differs, fmt::format("{}: no method has a picture", scene.name));
  pictures.add({{"scene", scene.name},
                {"id", lower_case(scene.name)},
                {"title", scene.title},
                {"methods", names},
                {"pictures", images.size()},
                {"strip", png_picture(side_by_side(images))}});
}

}  // namespace

void add_cross_check(Records& records, const compare::CommonScene& scene,
                     const compare::SceneCrossCheck& agreement) {
  RowSet& failures = records["failures"];
  if (failures.keys().empty()) failures = RowSet({"scene", "pair", "first"});
  std::size_t run = 0;
  for (const CrossCheckCell& cell : agreement.cells) {
    const std::string pair = fmt::format("{} and {}", cell.first, cell.second);
    records["cells"].add({{"scene", scene.name},
                          {"column", lower_case(scene.name)},
                          {"pair", pair},
                          {"verdict", verdict_of(cell)}});
    run += cell.state == CrossCheckState::agrees || cell.state == CrossCheckState::differs ? 1U : 0U;
    if (cell.state == CrossCheckState::differs || cell.state == CrossCheckState::not_run)
      failures.add({{"scene", scene.name}, {"pair", pair}, {"first", cell.text}});
  }
  const auto perspective =
      std::count_if(scene.views.begin(), scene.views.end(),
                    [](const compare::CrossCheckView& view) { return view.camera.perspective; });
  const std::size_t listed = compare::listed_cells(scene);
  const bool good = agreement.agrees() && run == listed;
  records["scenes"].add({{"scene", scene.name},
                         {"what", scene.title},
                         {"edges", picture::edges_of(scene.scene).size()},
                         {"faces", scene::face_count(scene.scene)},
                         {"parallel", static_cast<std::int64_t>(scene.views.size()) - perspective},
                         {"perspective", perspective},
                         {"listed", listed},
                         {"run", run},
                         {"result", Verdict{good, good ? "all agree" : "not all agree"}}});
  add_pictures(records["pictures"], records["single"], scene, agreement);
}

Records cross_check(const Context& context) {
  Records records;
  for (const std::string_view name : compare::common_scene_names()) {
    const compare::CommonScene scene = compare::common_scene(name);
    add_cross_check(records, scene, compare::cross_check(scene, {}, context.progress));
  }
  for (const compare::NotApplicable& listed : compare::not_applicable()) {
    const bool all = listed.views == compare::NotApplicable::Views::all;
    records["reasons"].add({{"method", listed.who},
                            {"scenes", listed.scenes},
                            {"views", all ? "all" : "in perspective"},
                            {"reason", listed.reason}});
  }
  return records;
}

}  // namespace sightline::report
