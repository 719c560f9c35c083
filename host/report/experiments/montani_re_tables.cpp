#include "host/report/experiments/montani_re_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/montani_re/faces.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::montani_re;

// A closed line as in the paper: a starting point and digits, 0 east, 1 north-east, ... 7 south-east.
struct FreemanChain {
  std::array<std::int64_t, 2> start;
  std::string_view links;
};

// Two regions, and a hole in the second. Figure 1 is not legible: the chains begin at the points given in its
// caption.
constexpr std::array<FreemanChain, 3> figure_1{{{{6, 11}, "6666666664222222253666666642222222220710"},
                                                {{12, 2}, "22231222344466666666602222076660"},
                                                {{11, 8}, "23466601"}}};

// The points inside an odd number of the chains.
native::FaceSet face_of(std::span<const FreemanChain> chains) {
  constexpr std::array<std::array<std::int64_t, 2>, 8> steps{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  native::FaceSetBuilder builder(false);
  native::Rings rings;
  for (const FreemanChain& chain : chains) {
    auto& ring = rings.emplace_back();
    std::array<std::int64_t, 2> at = chain.start;
    char before = chain.links.back();
    for (const char link : chain.links) {
      if (link != before) ring.push_back(builder.add_vertex({at[0], at[1], 0}));
      const auto& step = steps[static_cast<std::size_t>(link - '0')];
      at = {at[0] + step[0], at[1] + step[1]};
      before = link;
    }
  }
  builder.add_face(rings, 0, 0);
  return builder.take();
}

// Stripes one step high. No two sides of Figure 1 cross inside one, so each is one band.
std::vector<PrintedStripe> printed_stripes() {
  constexpr std::int64_t step = 65536;    // of a side's abscissas
  constexpr std::int32_t thickness = 16;  // units of a stripe
  const native::FaceSet set = face_of(figure_1);
  const native::StripePcs pcs = native::stripe_pcs(set.image, set.faces[0].pcs, {{1, 1}, {0, 0}, 16, 16}, thickness);
  std::vector<PrintedStripe> rows;
  for (std::int32_t y = pcs.first; const auto& stripe : pcs.stripes) {
    for (const native::StripeBand& band : stripe) {
      std::string sides;
      for (const native::StripeSide& side : band.sides) {
        const int type = side.top > side.bottom ? 1 : side.top == side.bottom ? 2 : 3;  // "/", "|", "\"
        sides += fmt::format("{}{}({})", sides.empty() ? "" : " ", std::min(side.bottom, side.top) / step, type);
      }
      rows.push_back({y, band.sides.size() / 2, sides});
    }
    ++y;
  }
  return rows;
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
  if (!set) throw base::bad_input(set.error().message());
  return *std::move(set);
}

// The letters of SURFACE: rectangles in a row, each overlapping the next. Figure 4 is not legible; Table 3 says which
// of two adjacent letters is in front.
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

std::vector<PrintedRelations> printed_relations(const native::ListedFaces& listed) {
  std::vector<PrintedRelations> rows;
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
    rows.push_back({std::string(1, name), hides, hidden_by, text});
  }
  return rows;
}

std::string names_of(std::span<const native::PriorityClass> classes) {
  std::string text;
  for (const native::PriorityClass& members : classes) {
    if (!text.empty()) text += " / ";
    for (const std::uint32_t face : members) text += fmt::format("{}{}", face == members.front() ? "" : ",", letters[face]);
  }
  return text;
}

std::vector<PrintedLists> printed_steps(const native::PriorityList& list) {
  std::vector<PrintedLists> rows;
  const std::span<const native::PriorityClass> front(list.front);
  const std::span<const native::PriorityClass> back(list.back);
  // FRONT grows at its end, BACK at its beginning.
  for (std::size_t step = 1; step <= std::max(front.size(), back.size()); ++step)
    rows.push_back({step, names_of(front.first(std::min(step, front.size()))), names_of(back.last(std::min(step, back.size())))});
  return rows;
}

FaceCycle cycle_of(const char* what, const std::vector<Corners>& faces) {
  const scene::PolyScene scene = sheets(faces);
  const native::VisibleRegions seen = native::visible_regions(faces_of(scene));
  const auto drawn = native::visible_edges(scene, scene.camera);
  const auto truth = algorithms::oracle::visible_edges(scene, scene.camera);
  return {what, faces.size(), seen.counts.cuts, seen.counts.mutual_parts,
          drawn && picture::image_set(drawn->picture, scene, scene.camera) == picture::image_set(truth, scene, scene.camera)};
}

// A row of a printed table, and the computed row with the same key.
template <class Row>
struct Beside {
  Row paper;
  std::optional<Row> here;
};

template <class Row, class Key>
std::vector<Beside<Row>> beside(const std::vector<Row>& paper, const std::vector<Row>& here, Key Row::*key) {
  std::vector<Beside<Row>> rows;
  for (const Row& row : paper) {
    const auto found = std::find_if(here.begin(), here.end(), equals(key, row.*key));
    rows.push_back({row, found == here.end() ? std::nullopt : std::optional(*found)});
  }
  return rows;
}

template <class Row, class T>
auto of_paper(T Row::*member) {
  return [member](const Beside<Row>& row) { return row.paper.*member; };
}
template <class Row, class T>
auto of_here(T Row::*member) {
  return [member](const Beside<Row>& row) { return row.here ? std::optional((*row.here).*member) : std::nullopt; };
}

template <class Row>
Verdict equal_or_not(const Beside<Row>& row) {
  return row.here == row.paper ? Verdict{true, "equal"} : Verdict{false, "differs"};
}

}  // namespace

MontaniReTables montani_re_tables(const Context& context) {
  context.progress("Montani and Re: the tables of the paper");
  MontaniReTables tables;
  tables.stripes = printed_stripes();
  const native::ListedFaces listed = native::listed_faces(faces_of(figure_4()));
  tables.relations = printed_relations(listed);
  tables.steps = printed_steps(listed.list);
  tables.list = names_of(listed.list.classes());
  // Planes z = x, z = x and z = 40 - x - y.
  tables.cycles.push_back(cycle_of("three faces, each before the next: planes z = x, z = x, z = 40 - x - y",
                                   {{{0, 0, 0}, {30, 0, 30}, {30, 10, 30}, {0, 10, 0}},
                                    {{20, 0, 0}, {30, 0, 0}, {30, 30, 30}, {20, 30, 30}},
                                    {{0, 0, 40}, {10, 0, 30}, {10, 20, 10}, {30, 20, -10}, {30, 30, -20}, {0, 30, 10}}}));
  // A strip z = x - 5 through a U at z = 10.
  tables.cycles.push_back(
      cycle_of("Figure 10: a strip through a U, each before the other in one place",
               {{{0, 0, 10}, {30, 0, 10}, {30, 30, 10}, {20, 30, 10}, {20, 10, 10}, {10, 10, 10}, {10, 30, 10}, {0, 30, 10}},
                {{-5, 15, -10}, {35, 15, 30}, {35, 25, 30}, {-5, 25, -10}}}));
  return tables;
}

void montani_re_printed_tables(Page& page, const MontaniReTables& tables) {
  const PrintedTable& table_1 = page.papers().table("montani_re_table_1");
  std::vector<PrintedStripe> stripes;
  for (std::size_t i = 0; i < table_1.rows.size(); ++i)
    stripes.push_back({static_cast<std::int32_t>(table_1.number(i, "y")),
                       static_cast<std::size_t>(table_1.number(i, "substripes")), table_1.text(i, "sides")});
  page.table("montani-re-table-1", "Montani and Re, Table 1: stripes of two regions and a hole",
             beside(stripes, tables.stripes, &PrintedStripe::y),
             {{"y", "Y", of_paper(&PrintedStripe::y)},
              {"substripes_paper", "N, paper", "substripes", of_paper(&PrintedStripe::substripes)},
              {"substripes_here", "N, here", "substripes", of_here(&PrintedStripe::substripes)},
              {"sides_paper", "Paper", "abscissa (type)", of_paper(&PrintedStripe::sides)},
              {"sides_here", "Here", "abscissa (type)", of_here(&PrintedStripe::sides)},
              {"verdict", "Comparison", &equal_or_not<PrintedStripe>}},
             {.notes = {page.claim(tables.stripes.size() == stripes.size(),
                                   fmt::format("The stripes are as many as the paper's, {}.", stripes.size()),
                                   fmt::format("there are {}", tables.stripes.size())) +
                        " Figure 1 is not legible; the chains, those of hard case M18, begin at the paper's points. The last "
                        "heading, SUBSTRIPES, is taken for SUBSTRIPE5."}});

  const PrintedTable& table_3 = page.papers().table("montani_re_table_3");
  std::vector<PrintedRelations> relations;
  for (std::size_t i = 0; i < table_3.rows.size(); ++i)
    relations.push_back({table_3.text(i, "face"), static_cast<int>(table_3.number(i, "nmin")),
                         static_cast<int>(table_3.number(i, "nmax")), table_3.text(i, "relations")});
  page.table("montani-re-table-3", "Montani and Re, Table 3: depth relations of the faces of Figure 4",
             beside(relations, tables.relations, &PrintedRelations::face),
             {{"face", "Face", of_paper(&PrintedRelations::face)},
              {"nmin_paper", "NMIN, paper", of_paper(&PrintedRelations::hides)},
              {"nmin_here", "NMIN, here", of_here(&PrintedRelations::hides)},
              {"nmax_paper", "NMAX, paper", of_paper(&PrintedRelations::hidden_by)},
              {"nmax_here", "NMAX, here", of_here(&PrintedRelations::hidden_by)},
              {"relations_paper", "Paper", of_paper(&PrintedRelations::relations)},
              {"relations_here", "Here", of_here(&PrintedRelations::relations)},
              {"verdict", "Comparison", &equal_or_not<PrintedRelations>}},
             {.notes = {"F < G: F has priority, it may hide G. Figure 4 is not legible; the scene, that of hard case M17, has "
                        "rectangles in a row, each of which overlaps the next. Relations are found by the tests on the scene."}});

  const PrintedTable& table_4 = page.papers().table("montani_re_table_4");
  std::vector<PrintedLists> steps;
  for (std::size_t i = 0; i < table_4.rows.size(); ++i)
    steps.push_back({static_cast<std::size_t>(table_4.number(i, "step")), table_4.text(i, "front"), table_4.text(i, "back")});
  const std::string& list = page.papers().table("montani_re_list").text(0, "list");
  page.table("montani-re-table-4", "Montani and Re, Table 4: FRONT and BACK lists, step by step",
             beside(steps, tables.steps, &PrintedLists::step),
             {{"step", "Step", of_paper(&PrintedLists::step)},
              {"front_paper", "FRONT, paper", of_paper(&PrintedLists::front)},
              {"front_here", "FRONT, here", of_here(&PrintedLists::front)},
              {"back_paper", "BACK, paper", of_paper(&PrintedLists::back)},
              {"back_here", "BACK, here", of_here(&PrintedLists::back)},
              {"verdict", "Comparison", &equal_or_not<PrintedLists>}},
             {.notes = {fmt::format("Priority list, paper: {}; here: {}. ", list, tables.list) +
                        page.claim(tables.list == list, "They are equal.")}});
}

}  // namespace sightline::report
