#include "host/explain/explain.hpp"

#include <algorithm>
#include <array>

#include "host/explain/exact.hpp"
#include "host/explain/jones.hpp"
#include "host/explain/skala.hpp"

namespace sightline::explain {
namespace {

constexpr std::array<Explainer, 3> rows{{
    {"exact", "Every edge against the faces that may hide it: the reference, with no paper", explain_exact, nullptr},
    {"jones", "Jones 1971: from cell to cell through portals, with the mask that is left", explain_jones, nullptr},
    {"skala", "Skala 1985: slices from the foreground to the background against two masks", nullptr, explain_skala},
}};

}  // namespace

std::span<const Explainer> explainers() { return rows; }

const Explainer* find_explainer(std::string_view algorithm) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Explainer& row) { return row.algorithm == algorithm; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace sightline::explain
