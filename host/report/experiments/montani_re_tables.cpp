// What the tables of Montani and Re's paper print, made by the programs here.
//
//   stripes      Table 1: the stripes of Figures 1 and 2
//   relations    Table 3: the depth relations of the faces of Figure 4
//   steps        Table 4: the lists, step by step
//   list         the priority list
//   thicknesses  section 4: of the stripes of montani-re-stripes
//   cycles       section 5: faces that overlap in a cycle; `right` if drawn as the oracle draws them
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/montani_re/lattice_pcs.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/montani_re_stripes.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::montani_re;

// Two regions, and a hole in the second. Figure 1 is not legible: the chains begin where its caption says.
constexpr std::array<native::FreemanChain, 3> figure_1{{{{6, 11}, "6666666664222222253666666642222222220710"},
                                                        {{12, 2}, "22231222344466666666602222076660"},
                                                        {{11, 8}, "23466601"}}};

void add_stripes(RowSet& rows) {
  const auto pcs = native::lattice_pcs(figure_1);
  const auto stripes = pcs ? native::whole_stripes(*pcs) : std::nullopt;
  if (!stripes) throw Failure(ErrorKind::bad_input, "Montani and Re, Figure 1: a chain does not close");
  for (const native::LatticeStripe& stripe : *stripes) {
    std::string sides;
    for (const native::LatticeSide& side : stripe.sides)
      sides +=
          fmt::format("{}{}({})", sides.empty() ? "" : " ", side.abscissa(), static_cast<int>(side.type()));
    rows.add({{"y", stripe.y}, {"substripes", stripe.sides.size() / 2}, {"sides", sides}});
  }
}

using Corners = std::vector<scene::PolyPoint>;

// Sheets of one face each, seen along z without perspective.
scene::PolyScene sheets(const std::vector<Corners>& faces) {
  scene::PolyScene scene;
  scene.camera.perspective = false;
  scene.camera.eye = {0, 0, -1000};
  for (const Corners& corners : faces) {
    scene::PolyFace face;
    for (const scene::PolyPoint& corner : corners) {
      face.outline.push_back(static_cast<scene::VertexIndex>(scene.vertices.size()));
      scene.vertices.push_back(corner);
    }
    scene.bodies.push_back({"", true, {face}});
  }
  return scene;
}

native::FaceSet faces_of(const scene::PolyScene& scene) {
  auto set = native::faces_of(scene, scene.camera);
  if (!set) throw Failure(ErrorKind::bad_input, set.error().message());
  return *std::move(set);
}

// The letters of SURFACE: rectangles in a row, each of which overlaps the next. Figure 4 is not legible;
// Table 3 says which letter is before its neighbour.
constexpr std::string_view letters = "SURFACE";
constexpr std::array<std::int32_t, 7> depths{0, 1, 2, 3, 2, 1, 0};

scene::PolyScene figure_4() {
  std::vector<Corners> faces;
  for (std::int32_t i = 0; const std::int32_t z : depths) {
    const std::int32_t x = 8 * i++;
    faces.push_back({{x, 0, z}, {x + 10, 0, z}, {x + 10, 10, z}, {x, 10, z}});
  }
  return sheets(faces);
}

void add_relations(RowSet& rows, const native::ListedFaces& listed) {
  for (const char name : letters) {
    int hides = 0;
    int hidden_by = 0;
    std::string text;
    for (const char other : letters) {  // the columns of the table
      for (const native::Relation& relation : listed.relations) {
        const bool before = letters[relation.near] == name && letters[relation.far] == other;
        if (!before && !(letters[relation.far] == name && letters[relation.near] == other)) continue;
        ++(before ? hides : hidden_by);
        text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", name, before ? '<' : '>', other);
      }
    }
    rows.add(
        {{"face", std::string(1, name)}, {"hides", hides}, {"hidden_by", hidden_by}, {"relations", text}});
  }
}

std::string names_of(std::span<const native::PriorityClass> classes) {
  std::string text;
  for (const native::PriorityClass& members : classes) {
    if (!text.empty()) text += " / ";
    for (const std::uint32_t face : members)
      text += fmt::format("{}{}", face == members.front() ? "" : ",", letters[face]);
  }
  return text;
}

void add_steps(Records& records, const native::PriorityList& list) {
  const std::span<const native::PriorityClass> front(list.front);
  const std::span<const native::PriorityClass> back(list.back);
  // FRONT grows at its end, BACK at its beginning.
  for (std::size_t step = 1; step <= std::max(front.size(), back.size()); ++step)
    records["steps"].add({{"step", step},
                          {"front", names_of(front.first(std::min(step, front.size())))},
                          {"back", names_of(back.last(std::min(step, back.size())))}});
  records["list"].add({{"list", names_of(list.classes())}});
}

void add_cycle(RowSet& rows, const char* what, const std::vector<Corners>& faces) {
  const scene::PolyScene scene = sheets(faces);
  const native::VisibleRegions seen = native::visible_regions(faces_of(scene));
  const auto drawn = native::visible_edges(scene, scene.camera);
  const auto truth = algorithms::oracle::visible_edges(scene, scene.camera);
  rows.add({{"what", what},
            {"faces", faces.size()},
            {"cuts", seen.counts.cuts},
            {"parts", seen.counts.mutual_parts},
            {"right", drawn && picture::image_set(drawn->picture, scene, scene.camera) ==
                                   picture::image_set(truth, scene, scene.camera)}});
}

}  // namespace

Records montani_re_tables(const Context& context) {
  context.progress("Montani and Re: the tables of the paper");
  Records records;
  add_stripes(records["stripes"]);
  const native::ListedFaces listed = native::listed_faces(faces_of(figure_4()));
  add_relations(records["relations"], listed);
  add_steps(records, listed.list);
  // Planes z = x, z = x and z = 40 - x - y.
  add_cycle(records["cycles"], "three faces, each before the next: planes z = x, z = x, z = 40 - x - y",
            {{{0, 0, 0}, {30, 0, 30}, {30, 10, 30}, {0, 10, 0}},
             {{20, 0, 0}, {30, 0, 0}, {30, 30, 30}, {20, 30, 30}},
             {{0, 0, 40}, {10, 0, 30}, {10, 20, 10}, {30, 20, -10}, {30, 30, -20}, {0, 30, 10}}});
  // A strip z = x - 5 through a U at z = 10.
  add_cycle(records["cycles"], "Figure 10: a strip through a U, each before the other in one place",
            {{{0, 0, 10},
              {30, 0, 10},
              {30, 30, 10},
              {20, 30, 10},
              {20, 10, 10},
              {10, 10, 10},
              {10, 30, 10},
              {0, 30, 10}},
             {{-5, 15, -10}, {35, 15, 30}, {35, 25, 30}, {-5, 25, -10}}});
  for (const std::int32_t units : stripe_units) records["thicknesses"].add({{"thickness_px", 16.0 / units}});
  return records;
}

}  // namespace sightline::report
