// Numbers: C. Montani, M. Re, "Vector and Raster Hidden Surface Removal Using Parallel Connected Stripes",
// IEI Pisa, Nota interna B85-08, sections 1, 3, 4 and 5.
#include "host/report/montani_re_growth.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "host/report/timing/montani_re.hpp"
#include "host/report/timing/paper_numbers.hpp"

namespace sightline::harness::report {

namespace {

Cell milliseconds(double nanoseconds) {
  return nanoseconds > 0 ? Cell(Real{nanoseconds / 1e6}) : Cell();
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

Table montani_re_paper_table(const std::vector<MontaniReGrowth>& families) {
  return paper_table("montani-re-paper", "Montani and Re 1985: what it says of work and size",
                     numbers(families));
}

Table montani_re_growth_table(const std::vector<MontaniReGrowth>& families) {
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
      "take part: of solids, the ones that face the eye. A view is all of it: faces, sort, relations, list, "
      "differences, and output as pieces of edges (exact build, exact) or as pixels. Times are the "
      "processor's, medians of interleaved repetitions (scenes of 10000: one), of this computer."};
  return table;
}

Table montani_re_exponents_table(const std::vector<MontaniReGrowth>& families) {
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
      "the same. In these scenes a face overlaps more others in X the more there are, as in any scene that "
      "grows to all sides, so that N Y grows faster than N. Least squares of logarithms over the sizes of "
      "the table above."};
  return table;
}

}  // namespace sightline::harness::report
