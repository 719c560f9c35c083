// The tables of Montani and Re's paper, computed by the programs here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

// A row of Table 1: a stripe of Figures 1 and 2.
struct PrintedStripe {
  std::int32_t y = 0;
  std::size_t substripes = 0;
  std::string sides;  // "2(2) 3(3)": abscissa (type)

  friend bool operator==(const PrintedStripe&, const PrintedStripe&) = default;
};

// A row of Table 3: the depth relations of a face of Figure 4.
struct PrintedRelations {
  std::string face;
  int hides = 0;
  int hidden_by = 0;
  std::string relations;  // "U > S, U < R"

  friend bool operator==(const PrintedRelations&, const PrintedRelations&) = default;
};

// A row of Table 4: the lists after `step` steps.
struct PrintedLists {
  std::size_t step = 0;
  std::string front;
  std::string back;

  friend bool operator==(const PrintedLists&, const PrintedLists&) = default;
};

// Faces that overlap in a cycle (section 5).
struct FaceCycle {
  std::string what;
  std::size_t faces = 0;
  std::uint64_t cuts = 0;
  std::uint64_t parts = 0;
  bool right = false;  // drawn as by the oracle
};

struct MontaniReTables {
  std::vector<PrintedStripe> stripes;
  std::vector<PrintedRelations> relations;
  std::vector<PrintedLists> steps;
  std::string list;  // the priority list
  std::vector<FaceCycle> cycles;
};

[[nodiscard]] MontaniReTables montani_re_tables(const Context& context);

class Page;
// Next to the tables printed in the paper.
void montani_re_printed_tables(Page& page, const MontaniReTables& tables);

}  // namespace sightline::report
