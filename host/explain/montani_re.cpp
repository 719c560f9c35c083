#include "host/explain/montani_re.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "host/algorithms/montani_re/trace.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/explain/stage.hpp"
#include "host/geometry/vector.hpp"

namespace sightline::explain {
namespace {

namespace mr = algorithms::montani_re;

constexpr std::size_t chart = 1;
// Further pairs are summarised in one step.
constexpr std::size_t most_pairs = 150;
// On a chart of more faces, only the faces that a caption names have numbers. The image numbers the faces that a step names,
// up to `most_named`.
constexpr std::size_t most_numbered_faces = 60;
constexpr std::size_t most_named = 12;

// The six tests of a pair, by number: section 3 and Table 2 of the paper.
constexpr std::array<std::string_view, 7> tests{
    "",
    "test 1: they have no abscissa in common",
    "test 2: they have no ordinate in common",
    "test 3: all of one lies before all of the other",
    "test 4: one lies on one side of the plane of the other",
    "test 5: the other lies on one side of the plane of the one",
    "test 6: they have an area in common, where one is nearer"};

class MontaniReRecorder final : public mr::Trace {
 public:
  MontaniReRecorder(const scene::PolyCamera& camera, Steps& steps) : steps_(steps) {
    const auto length = [](const scene::PolyPoint& v) { return geometry::length(geometry::real_vector(v)); };
    const double away = camera.perspective ? length(camera.forward) : 1;
    scale_ = {away / length(camera.right), away / length(camera.up)};
    count();
  }

  [[nodiscard]] bool in_pyramids() const { return in_pyramids_; }

  void faces(const mr::FaceSet& set, bool whole) override {
    if (!whole) in_pyramids_ = true;
    set_ = &set;
    count();
    for (std::uint32_t face = 0; face < set.faces.size() && face < 12; ++face) {
      std::vector<Mark> marks;
      add_region(marks, Look::now, set.faces[face].pcs);
      steps_.add(fmt::format("Face {} as a region of {} stripe{}: each ends where the outline has a corner, and lies between a west and an east side.", face + 1,
                             set.faces[face].pcs.bands.size(), set.faces[face].pcs.bands.size() == 1 ? "" : "s"),
                 "section 2", {{image, "face", std::move(marks)},
                              {image, "numbers", names({{face, Look::now}})},
                              {chart, "faces", dots(Look::plain)},
                              {chart, "numbers", names_on_chart({face})}});
    }
    if (set.faces.size() > 12) steps_.add(fmt::format("The other {} faces are made into stripes likewise.", set.faces.size() - 12), "section 2",
                                            {{image, "face", {}}, {image, "numbers", {}}, {chart, "faces", dots(Look::plain)}, {chart, "numbers", {}}});
  }

  void related(const mr::DepthRelations& found) override {
    std::uint64_t pairs = 0;
    for (const auto decided : found.decided_by) pairs += decided;
    std::string decided;
    for (std::size_t test = 1; test < found.decided_by.size(); ++test)
      decided += fmt::format("{}{} by test {}", test == 1 ? "" : ", ", found.decided_by[test], test);
    pairs_ = pairs;
    count();
    steps_.add(fmt::format("Which of two faces hides the other is asked of every pair, by six tests of increasing cost. {} pairs: {}. Tests 1 and 2 find that "
                           "two faces have nothing to do with each other; the others give a relation.",
                           pairs, decided),
               "section 3, Table 2", {{image, "face", {}}, {image, "numbers", {}}, {chart, "numbers", {}}});
    std::size_t shown = 0;
    for (const mr::Relation& relation : found.relations) {
      arrows_.push_back(line(Look::plain, {place(relation.near), place(relation.far)}));
      ++relations_;
      if (++shown > most_pairs) continue;
      count();
      std::vector<Mark> marks;
      add_region(marks, Look::now, set_->faces[relation.near].pcs);
      add_region(marks, Look::other, set_->faces[relation.far].pcs);
      steps_.add(fmt::format("Face {} has priority over face {}, by {}.", relation.near + 1, relation.far + 1, tests[relation.test]), "section 3, Table 2",
                 {{image, "face", std::move(marks)}, {chart, "relations", arrows_}, {chart, "pair", {line(Look::now, {place(relation.near), place(relation.far)})}},
                  {image, "numbers", names({{relation.near, Look::now}, {relation.far, Look::other}})},
                  {chart, "numbers", names_on_chart({relation.near, relation.far})}});
    }
    count();
    if (shown > most_pairs) steps_.add(fmt::format("{} more relations are found.", shown - most_pairs), "section 3, Table 2", {{image, "face", {}}, {image, "numbers", {}}, {chart, "relations", arrows_}, {chart, "pair", {}}, {chart, "numbers", {}}});
  }

  void ranked(const mr::PriorityClass& front, const mr::PriorityClass& back) override {
    std::vector<Mark> marks;
    std::vector<std::pair<std::uint32_t, Look>> named;
    for (const std::uint32_t face : front) {
      front_.push_back(face);
      named.emplace_back(face, Look::now);
      add_region(marks, Look::now, set_->faces[face].pcs);
    }
    for (const std::uint32_t face : back) {
      back_.insert(back_.begin(), face);
      named.emplace_back(face, Look::other);
      add_region(marks, Look::other, set_->faces[face].pcs);
    }
    count();
    steps_.add(fmt::format("{} {} hidden by none of those left: behind the FRONT list. {} hide{} none of them: before the BACK list. All of them are taken out.",
                           front.size(), front.size() == 1 ? "face is" : "faces are", back.size(), back.size() == 1 ? "s" : ""),
               "section 3, Tables 3 and 4", {{image, "face", std::move(marks)}, {image, "numbers", named.size() <= most_named ? names(named) : std::vector<Mark>()},
                {chart, "faces", dots(Look::plain)}, {chart, "relations", {}}, {chart, "pair", {}}, {chart, "numbers", {}}});
  }

  void cycle(const mr::Relation& deleted, bool cut) override {
    ++cycles_;
    count();
    std::vector<Mark> marks;
    add_region(marks, Look::now, set_->faces[deleted.near].pcs);
    add_region(marks, Look::other, set_->faces[deleted.far].pcs);
    steps_.add(cut ? fmt::format("What is left holds a cycle: each face hides another one of it. Face {} will be cut by face {}, which hides the least of it, and their "
                                 "relation is deleted.",
                                 deleted.far + 1, deleted.near + 1)
                   : fmt::format("A cycle is met. Faces {} and {} have a relation by their planes, but do not overlap in the image: it is deleted.", deleted.near + 1,
                                 deleted.far + 1),
               "section 5", {{image, "face", std::move(marks)}, {image, "numbers", names({{deleted.near, Look::now}, {deleted.far, Look::other}})},
                             {chart, "numbers", names_on_chart({deleted.near, deleted.far})}});
  }

  void subtracted(std::uint32_t face, std::uint32_t near, const mr::TrapezoidPcs& left) override {
    ++subtractions_;
    count();
    std::vector<Mark> marks;
    add_region(marks, Look::hidden, set_->faces[face].pcs);
    if (near != face) add_region(marks, Look::other, set_->faces[near].pcs);
    add_region(marks, Look::now, left);
    steps_.add(left.empty() ? fmt::format("Face {} is taken away from face {}: nothing is left of it.", near + 1, face + 1)
                            : fmt::format("Face {}, which comes before it in the list, is taken away from face {}: {} stripes are left.", near + 1, face + 1, left.bands.size()),
               "section 3", {{image, "face", std::move(marks)}, {image, "numbers", names({{face, Look::now}, {near, Look::other}})},
                             {chart, "numbers", names_on_chart({face, near})}});
  }

 private:
  // The position of a face on the chart: in its list (FRONT at the left, BACK at the right), or else in the middle.
  [[nodiscard]] Point place(std::uint32_t face) const {
    const auto in = [&](const std::vector<std::uint32_t>& list, double x) -> Point {
      const auto at = std::find(list.begin(), list.end(), face) - list.begin();
      return {x, 1 - (static_cast<double>(at) + 0.5) / static_cast<double>(std::max<std::size_t>(list.size(), 1))};
    };
    if (std::find(front_.begin(), front_.end(), face) != front_.end()) return in(front_, 0.1);
    if (std::find(back_.begin(), back_.end(), face) != back_.end()) return in(back_, 0.9);
    const double angle = 6.283185307179586 * face / static_cast<double>(set_->faces.size());
    return {0.5 + 0.28 * std::cos(angle), 0.5 + 0.42 * std::sin(angle)};
  }
  // The labels of faces on the image, each once.
  [[nodiscard]] std::vector<Mark> names(const std::vector<std::pair<std::uint32_t, Look>>& faces) const {
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto [face, look] = faces[i];
      if (i != 0 && face == faces[0].first) continue;
      std::vector<Mark> region;
      add_region(region, look, set_->faces[face].pcs);
      // The largest stripe has the most room.
      const auto widest = std::max_element(region.begin(), region.end(), [](const Mark& a, const Mark& b) { return extent(a) < extent(b); });
      if (widest != region.end()) marks.push_back(label(look, label_point(widest->points), fmt::format("face {}", face + 1)));
    }
    return marks;
  }
  // The area of a stripe.
  static double extent(const Mark& mark) {
    const auto& p = mark.points;
    return (p[1][0] - p[0][0] + p[2][0] - p[3][0]) * (p[2][1] - p[1][1]);
  }
  // Labels on the chart, if it does not number all faces.
  [[nodiscard]] std::vector<Mark> names_on_chart(const std::vector<std::uint32_t>& faces) const {
    std::vector<Mark> marks;
    if (set_->faces.size() > most_numbered_faces)
      for (const std::uint32_t face : faces) marks.push_back(text(Look::now, place(face), std::to_string(face + 1)));
    return marks;
  }
  [[nodiscard]] std::vector<Mark> dots(Look look) const {
    std::vector<Mark> marks{text(Look::plain, {0.05, 1.02}, "FRONT"), text(Look::plain, {0.85, 1.02}, "BACK")};
    for (std::uint32_t face = 0; face < set_->faces.size(); ++face) {
      marks.push_back(dot(look, place(face)));
      if (set_->faces.size() <= most_numbered_faces) marks.push_back(text(Look::plain, place(face), std::to_string(face + 1)));
    }
    return marks;
  }
  void add_region(std::vector<Mark>& marks, Look look, const mr::TrapezoidPcs& region) const {
    for (const mr::Band& band : region.bands) {
      const double low = band.low.middle();
      const double high = band.high.middle();
      const auto sides = region.sides_of(band);
      for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
        const auto at = [&](std::uint32_t of, double y) -> Point { return {set_->image.abscissa(of, y) * scale_[0], y * scale_[1]}; };
        marks.push_back(area(look, {at(sides[k].line, low), at(sides[k + 1].line, low), at(sides[k + 1].line, high), at(sides[k].line, high)}));
      }
    }
  }
  void count() {
    steps_.count("faces", set_ != nullptr ? set_->faces.size() : 0);
    steps_.count("pairs tested", pairs_);
    steps_.count("relations", relations_);
    steps_.count("in FRONT", front_.size());
    steps_.count("in BACK", back_.size());
    steps_.count("cycles met", cycles_);
    steps_.count("subtractions", subtractions_);
  }

  Steps& steps_;
  Point scale_{};
  const mr::FaceSet* set_ = nullptr;
  bool in_pyramids_ = false;
  std::vector<Mark> arrows_;
  std::vector<std::uint32_t> front_;
  std::vector<std::uint32_t> back_;
  std::uint64_t pairs_ = 0, relations_ = 0, cycles_ = 0, subtractions_ = 0;
};

}  // namespace

base::Result<Lesson> explain_montani_re(const scene::PolyScene& scene, const scene::PolyCamera& camera, const scene::CellComplex*) {
  Lesson lesson{"montani-re", "Montani and Re 1985: a list by priority, and regions of stripes", scene.name, {}, {}};
  const ImageStage stage(scene, camera);
  lesson.sheets = {stage.sheet("The image"), {"Faces and relations; the FRONT list on the left, the BACK list on the right", {0, -0.03}, {1, 1.08}, true}};
  Steps steps(lesson);
  MontaniReRecorder recorder(camera, steps);
  steps.add("The wire frame. Faces that look away hide nothing and are left out; each of the others becomes a region of stripes between its corners.", "section 2",
            {{image, "wire", stage.wire_frame()}});
  auto view = mr::visible_edges(scene, camera, &recorder);
  if (!view) return std::move(view.error());
  if (recorder.in_pyramids()) {
    return base::Error{"", "montani-re", "some faces reach from before the eye to behind it, so the picture is made in pieces",
                       "an eye outside the scene, or a view in parallel projection"};
  }
  std::vector<Mark> seen;
  for (const auto& piece : view->picture.pieces) stage.add_piece(seen, Look::seen, piece);
  steps.add("What is left of each face is what is seen of it. Its own sides are the lines of the picture.", "section 4",
            {{image, "face", {}}, {image, "numbers", {}}, {image, "seen", std::move(seen)}, {chart, "numbers", {}}});
  return lesson;
}

}  // namespace sightline::explain
