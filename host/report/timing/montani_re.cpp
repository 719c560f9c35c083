// Numbers: C. Montani, M. Re, "Vector and Raster Hidden Surface Removal Using Parallel Connected Stripes",
// IEI Pisa, Nota interna B85-08, Tables 1, 3 and 4.
#include "host/report/timing/montani_re.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/report/hard_cases/manifest.hpp"
#include "host/report/lattice_chains.hpp"
#include "host/report/montani_re_growth.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::montani_re;

struct PrintedStripe {
  std::int32_t y = 0;
  std::int64_t substripes = 0;
  std::string_view sides;  // abscissa (type), west and east
};
constexpr std::string_view lowest = "2(2) 3(2) 5(2) 6(2) 8(2) 9(2) 11(2) 12(2)";
constexpr std::array<PrintedStripe, 9> table_1{{{10, 3, "2(2) 3(3) 4(1) 6(2) 8(2) 11(3)"},
                                                {9, 3, "2(2) 6(2) 8(2) 9(2) 10(3) 12(2)"},
                                                {8, 5, "2(2) 3(2) 3(3) 4(1) 5(2) 6(2) 8(2) 9(2) 11(2) 12(2)"},
                                                {7, 4, "2(2) 3(2) 5(2) 6(2) 8(2) 9(2) 10(1) 12(2)"},
                                                {6, 3, "2(2) 3(2) 5(2) 6(2) 8(2) 11(1)"},
                                                {5, 4, "2(2) 3(2) 5(2) 6(2) 8(2) 9(2) 10(3) 11(3)"},
                                                {4, 4, lowest},
                                                {3, 4, lowest},
                                                {2, 4, lowest}}};

// A face's row in Table 3: whom it hides, who hides it.
struct PrintedFace {
  char name = ' ';
  std::int64_t hides = 0;      // NMIN
  std::int64_t hidden_by = 0;  // NMAX
  std::string_view relations;
};
constexpr std::array<PrintedFace, 7> table_3{{{'S', 1, 0, "S < U"},
                                              {'U', 1, 1, "U > S, U < R"},
                                              {'R', 1, 1, "R > U, R < F"},
                                              {'F', 0, 2, "F > R, F > A"},
                                              {'A', 1, 1, "A < F, A > C"},
                                              {'C', 1, 1, "C < A, C > E"},
                                              {'E', 1, 0, "E < C"}}};

struct PrintedStep {
  std::string_view front;
  std::string_view back;
};
constexpr std::array<PrintedStep, 2> table_4{{{"S,E", "F"}, {"S,E / U,C", "R,A / F"}}};

Verdict same(bool equal) {
  return equal ? Verdict{true, "equal"} : Verdict{false, "differs"};
}

std::string sides_of(const native::LatticeStripe& stripe) {
  std::string text;
  for (const native::LatticeSide& side : stripe.sides)
    text += fmt::format("{}{}({})", text.empty() ? "" : " ", side.abscissa(), static_cast<int>(side.type()));
  return text;
}

Outcome<Table> stripes_table() {
  const auto read = read_chains(sightline::report::hard_case_text("M18.txt"), "M18.txt");
  if (!read) return ReportError{ErrorKind::bad_input, read.error().message()};
  std::vector<native::FreemanChain> chains;
  for (const auto& [name, of_region] : *read) chains.insert(chains.end(), of_region.begin(), of_region.end());
  const auto pcs = native::lattice_pcs(chains);
  const auto stripes = pcs ? native::whole_stripes(*pcs) : std::nullopt;
  if (!stripes) return ReportError{ErrorKind::bad_input, "M18.txt: a chain does not close"};
  Table table;
  table.id = "montani-re-table-1";
  table.title = "Montani and Re, Table 1: stripes of two regions and a hole";
  table.columns = {{"y", "Y", "", false},
                   {"substripes_paper", "N, paper", "substripes", false},
                   {"substripes_here", "N, here", "substripes", false},
                   {"sides_paper", "Paper", "abscissa (type)", false},
                   {"sides_here", "Here", "abscissa (type)", false},
                   {"verdict", "Comparison", "", false}};
  for (const PrintedStripe& printed : table_1) {
    const auto found = std::find_if(stripes->begin(), stripes->end(),
                                    [&printed](const native::LatticeStripe& s) { return s.y == printed.y; });
    const std::string here = found == stripes->end() ? "" : sides_of(*found);
    const auto count = found == stripes->end() ? 0 : static_cast<std::int64_t>(found->sides.size() / 2);
    table.rows.push_back({std::int64_t{printed.y}, printed.substripes, count, std::string(printed.sides),
                          here, same(here == printed.sides && count == printed.substripes)});
  }
  table.notes = {fmt::format(
      "{} stripes here, {} in the paper. Figure 1 is not legible; the chains are those of M18 in part "
      "3, which begin at the paper's points. The last heading, SUBSTRIPES, is taken for SUBSTRIPE5.",
      stripes->size(), table_1.size())};
  return table;
}

// The scene of M17 as the algorithm sees it: names are those of its faces.
struct Surface {
  std::string names;
  native::FaceSet set;
  native::ListedFaces listed;
};

Outcome<Surface> surface() {
  const auto read = scene::read_poly_json(sightline::report::hard_case_text("M17.json"), "M17.json");
  if (!read) return ReportError{ErrorKind::bad_input, read.error().message()};
  const auto& scene = *read;
  auto made = native::faces_of(scene, scene.camera);
  if (!made) return ReportError{ErrorKind::bad_input, made.error().message()};
  Surface result;
  result.set = std::move(*made);
  for (const native::Face& face : result.set.faces) result.names += scene.bodies[face.body].name;
  result.listed = native::listed_faces(result.set);
  return result;
}

Table relations_table(const Surface& surface) {
  Table table;
  table.id = "montani-re-table-3";
  table.title = "Montani and Re, Table 3: depth relations of the faces of Figure 4";
  table.columns = {{"face", "Face", "", false},
                   {"nmin_paper", "NMIN, paper", "", false},
                   {"nmin_here", "NMIN, here", "", false},
                   {"nmax_paper", "NMAX, paper", "", false},
                   {"nmax_here", "NMAX, here", "", false},
                   {"relations_paper", "Paper", "", false},
                   {"relations_here", "Here", "", false},
                   {"verdict", "Comparison", "", false}};
  for (const PrintedFace& printed : table_3) {
    std::int64_t hides = 0;
    std::int64_t hidden_by = 0;
    // In the order of the table's columns.
    std::string text;
    for (const char other : surface.names) {
      for (const native::Relation& relation : surface.listed.relations) {
        const char near = surface.names[relation.near];
        const char far = surface.names[relation.far];
        const bool before = near == printed.name && far == other;
        if (!before && !(far == printed.name && near == other)) continue;
        ++(before ? hides : hidden_by);
        text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", printed.name, before ? '<' : '>', other);
      }
    }
    table.rows.push_back(
        {std::string(1, printed.name), printed.hides, hides, printed.hidden_by, hidden_by,
         std::string(printed.relations), text,
         same(hides == printed.hides && hidden_by == printed.hidden_by && text == printed.relations)});
  }
  table.notes = {
      "F < G: F has priority, it may hide G. Figure 4 is not legible; the scene is M17 of part 3, rectangles "
      "in a row, each of which overlaps the next. Relations are found by the tests on the scene."};
  return table;
}

std::string classes(const std::string& names, std::span<const native::PriorityClass> list) {
  std::string text;
  for (const native::PriorityClass& members : list) {
    if (!text.empty()) text += " / ";
    for (const std::uint32_t face : members)
      text += fmt::format("{}{}", face == members.front() ? "" : ",", names[face]);
  }
  return text;
}

Table steps_table(const Surface& surface) {
  Table table;
  table.id = "montani-re-table-4";
  table.title = "Montani and Re, Table 4: FRONT and BACK lists, step by step";
  table.columns = {{"step", "Step", "", false},
                   {"front_paper", "FRONT, paper", "", false},
                   {"front_here", "FRONT, here", "", false},
                   {"back_paper", "BACK, paper", "", false},
                   {"back_here", "BACK, here", "", false},
                   {"verdict", "Comparison", "", false}};
  const std::span<const native::PriorityClass> front(surface.listed.list.front);
  const std::span<const native::PriorityClass> back(surface.listed.list.back);
  for (std::size_t step = 1; step <= table_4.size(); ++step) {
    // FRONT grows at its end, BACK at its beginning.
    const std::string in_front = classes(surface.names, front.first(std::min(step, front.size())));
    const std::string behind = classes(surface.names, back.last(std::min(step, back.size())));
    const PrintedStep& printed = table_4[step - 1];
    table.rows.push_back({static_cast<std::int64_t>(step), std::string(printed.front), in_front,
                          std::string(printed.back), behind,
                          same(in_front == printed.front && behind == printed.back)});
  }
  table.notes = {"Priority list, paper: S,E / U,C / R,A / F; here: " +
                 classes(surface.names, surface.listed.list.classes()) + "."};
  return table;
}

}  // namespace

Outcome<std::vector<Block>> timing_of_montani_re(const Context& context) {
  auto stripes = stripes_table();
  if (!stripes) return std::move(stripes.error());
  auto made = surface();
  if (!made) return std::move(made.error());
  const auto& faces = *made;
  std::vector<std::size_t> sizes{100, 1000};
  if (context.full) sizes.push_back(10000);
  const int rounds = !context.host_times ? 0 : context.full ? 5 : 3;
  std::vector<MontaniReGrowth> families;
  for (const std::string_view family : {"boxes", "town"})
    families.push_back(montani_re_growth(family, sizes, rounds, context.progress));
  std::vector<Block> blocks;
  blocks.emplace_back(Heading{"Montani and Re"});
  blocks.emplace_back(montani_re_paper_table(families));
  blocks.emplace_back(std::move(*stripes));
  blocks.emplace_back(relations_table(faces));
  blocks.emplace_back(steps_table(faces));
  blocks.emplace_back(montani_re_growth_table(families));
  blocks.emplace_back(montani_re_exponents_table(families));
  return blocks;
}

}  // namespace sightline::harness::report
