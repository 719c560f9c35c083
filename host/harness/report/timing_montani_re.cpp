// Numbers: C. Montani, M. Re, "Vector and Raster Hidden Surface Removal Using Parallel Connected Stripes",
// IEI Pisa, Nota interna B85-08, sections 1, 3 and 5, Tables 1, 3 and 4.
#include "host/harness/report/timing_montani_re.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/harness/report/hard_cases.hpp"
#include "host/harness/report/hard_cases_montani_re_lattice.hpp"
#include "host/harness/report/montani_re_growth.hpp"
#include "host/harness/report/paper_numbers.hpp"
#include "host/scene/read_poly_json.hpp"

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
  const auto read = read_chains(hard_case_text("M18.txt"), "M18.txt");
  if (const auto* const error = std::get_if<scene::SceneError>(&read))
    return ReportError{ErrorKind::bad_input, error->message()};
  std::vector<native::FreemanChain> chains;
  for (const auto& [name, of_region] : std::get<LatticeRegions>(read))
    chains.insert(chains.end(), of_region.begin(), of_region.end());
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
  const auto read = scene::read_poly_json(hard_case_text("M17.json"), "M17.json");
  if (const auto* const error = std::get_if<scene::SceneError>(&read))
    return ReportError{ErrorKind::bad_input, error->message()};
  const auto& scene = std::get<scene::PolyScene>(read);
  auto made = native::faces_of(scene, scene.camera);
  if (const auto* const error = std::get_if<scene::SceneError>(&made))
    return ReportError{ErrorKind::bad_input, error->message()};
  Surface result;
  result.set = std::get<native::FaceSet>(std::move(made));
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
      "in a "
      "row, each of which overlaps the next. Relations are found by the tests on the scene."};
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

Cell milliseconds(double nanoseconds) {
  return nanoseconds > 0 ? Cell(Real{nanoseconds / 1e6}) : Cell();
}

Table growth_table(const std::vector<MontaniReGrowth>& families) {
  Table table;
  table.id = "montani-re-growth";
  table.title = "Montani and Re: a view of larger and larger scenes";
  table.columns = {{"scene", "Scene", "", false},
                   {"faces", "Faces, N", "", false},
                   {"y_complexity", "Faces a face overlaps in X, Y", "", false},
                   {"pairs", "Pairs of these, N Y / 2", "", false},
                   {"relations", "Relations", "", false},
                   {"sides", "Sides seen", "stripes of a pixel", false},
                   {"native_ms", "Exact build", "ms", true},
                   {"stripes_ms", "Stripes of a pixel", "ms", true},
                   {"exact_ms", "exact", "ms", true}};
  for (const MontaniReGrowth& family : families) {
    for (const MontaniReSize& size : family.sizes) {
      table.rows.push_back({fmt::format("{} {}", family.family, size.size),
                            static_cast<std::int64_t>(size.faces), Real{size.overlapped()},
                            static_cast<std::int64_t>(size.pairs), static_cast<std::int64_t>(size.relations),
                            static_cast<std::int64_t>(size.sides_seen), milliseconds(size.native_ns),
                            milliseconds(size.stripes_ns), milliseconds(size.exact_ns)});
    }
  }
  table.notes = {
      "Generated scenes from their own camera, in perspective, on 1024 x 1024 pixels. Faces are those that "
      "take "
      "part: of solids, the ones that face the eye. A view is all of it: faces, sort, relations, list, "
      "differences, and output as pieces of edges (exact build, exact) or as pixels. Times are the "
      "processor's, "
      "medians of interleaved repetitions (scenes of 10000: one), of this computer."};
  return table;
}

Table exponents_table(const std::vector<MontaniReGrowth>& families) {
  Table table;
  table.id = "montani-re-exponents";
  table.title = "Montani and Re: exponents of growth with the number of faces";
  table.columns = {{"family", "Scenes", "", false},
                   {"sizes", "From, to", "faces", false},
                   {"paper_pairs", "N Y, the paper's claim", "", false},
                   {"relations", "Relations", "", false},
                   {"native", "Exact build, time", "", true},
                   {"stripes", "Stripes of a pixel, time", "", true},
                   {"exact", "exact, time", "", true}};
  for (const MontaniReGrowth& family : families) {
    const bool timed = family.sizes.front().native_ns > 0;
    const auto time = [&](double MontaniReSize::*of) {
      return timed ? Cell(Real{exponent_over_faces(family, of), 2}) : Cell();
    };
    table.rows.push_back({std::string(family.family),
                          fmt::format("{}, {}", family.sizes.front().faces, family.sizes.back().faces),
                          Real{exponent_over_faces(family, &MontaniReSize::pairs), 2},
                          Real{exponent_over_faces(family, &MontaniReSize::relations), 2},
                          time(&MontaniReSize::native_ns), time(&MontaniReSize::stripes_ns),
                          time(&MontaniReSize::exact_ns)});
  }
  table.notes = {
      "The paper claims work linear with N Y, which it calls almost linear with N: that is so where Y stays "
      "the "
      "same. In these scenes a face overlaps more others in X the more there are, as in any scene that grows "
      "to "
      "all sides, so that N Y grows faster than N. Least squares of logarithms over the sizes of the table "
      "above."};
  return table;
}

std::vector<PaperNumber> numbers(const std::vector<MontaniReGrowth>& families) {
  std::vector<double> claims;
  std::uint64_t pairs = 0;
  std::uint64_t decided = 0;
  for (const MontaniReGrowth& family : families) {
    claims.push_back(exponent_over_faces(family, &MontaniReSize::pairs));
    pairs += family.sizes.back().pairs;
    decided += family.sizes.back().relations;
  }
  const auto [least, greatest] = std::minmax_element(claims.begin(), claims.end());
  const MontaniReSize& boxes = families.front().sizes.front();
  return {
      {"abstract", "\"low memory requirements\"; two PCS in main storage, faces on secondary storage",
       static_cast<std::int64_t>(boxes.silhouette_sides), static_cast<std::int64_t>(boxes.sides_seen),
       "sides",
       fmt::format(
           "boxes {}, stripes of a pixel on 1024 x 1024: the last silhouette; all that is seen of all faces",
           boxes.size),
       "the silhouette is the larger of the two at a time; no number is given, and secondary storage is not "
       "modelled"},
      {"1, introduction", "\"almost linear with the number of faces\"", Real{*least, 2}, Real{*greatest, 2},
       "exponent of N Y", "boxes and towns, growing to all sides",
       "linear only where Y does not grow with N"},
      {"3, algorithm", "\"complexity linear with the product of N*Y\"", static_cast<std::int64_t>(decided),
       static_cast<std::int64_t>(pairs), "relations, pairs", "the largest boxes and town together",
       "pairs that overlap in X are what tests 2 to 6 are for; what it comes to in time: table of exponents"},
      {"5, cyclic overlaps",
       "\"for, at least, three faces\"; \"unable to solve\" Figure 10",
       std::int64_t{2},
       {},
       "faces",
       "part 3, M1 to M3",
       "cycles as the paper solves them, and Figure 10, part by part"},
      {"4, raster", "stripes as thick as a pixel \"or a multiple\"", Real{0.25}, Real{8}, "pixels a stripe",
       "part 2, speed against error", "what it costs is measured there"},
      {"whole",
       "no running time, no computer, no size of a scene is given",
       {},
       {},
       "",
       "",
       "cannot be compared: nothing to compare with"},
  };
}

}  // namespace

Outcome<std::vector<Block>> timing_of_montani_re(const Context& context) {
  auto stripes = stripes_table();
  if (auto* const error = std::get_if<ReportError>(&stripes)) return std::move(*error);
  auto made = surface();
  if (auto* const error = std::get_if<ReportError>(&made)) return std::move(*error);
  const auto& faces = std::get<Surface>(made);
  std::vector<std::size_t> sizes{100, 1000};
  if (context.full) sizes.push_back(10000);
  const int rounds = !context.host_times ? 0 : context.full ? 5 : 3;
  std::vector<MontaniReGrowth> families;
  for (const std::string_view family : {"boxes", "town"})
    families.push_back(montani_re_growth(family, sizes, rounds, context.progress));
  std::vector<Block> blocks;
  blocks.emplace_back(Heading{"Montani and Re"});
  blocks.emplace_back(paper_table("montani-re-paper", "Montani and Re 1985: what it says of work and size",
                                  numbers(families)));
  blocks.emplace_back(std::get<Table>(std::move(stripes)));
  blocks.emplace_back(relations_table(faces));
  blocks.emplace_back(steps_table(faces));
  blocks.emplace_back(growth_table(families));
  blocks.emplace_back(exponents_table(families));
  return blocks;
}

}  // namespace sightline::harness::report
