#include "host/explain/explain.hpp"

#include <algorithm>
#include <array>

#include "host/explain/exact.hpp"
#include "host/explain/jones.hpp"
#include "host/explain/montani_re.hpp"
#include "host/explain/plantinga.hpp"
#include "host/explain/skala.hpp"
#include "host/explain/willis.hpp"

namespace sightline::explain {
namespace {

constexpr std::array<Explainer, 6> rows{{
    {"exact", "Every edge against the faces that may hide it: the reference, with no paper", explain_exact, nullptr},
    {"jones", "Jones 1971: from cell to cell through portals, with the mask that is left", explain_jones, nullptr},
    {"skala", "Skala 1985: slices from the foreground to the background against two masks", nullptr, explain_skala},
    {"montani-re", "Montani and Re 1985: faces as stripes, in a list by priority", explain_montani_re, nullptr},
    {"willis", "Willis 1977: surfaces cut until their distance from the eye is their order", explain_willis, nullptr},
    {"plantinga", "Plantinga, Seales and Dyer 1990: the events of a full turn", explain_plantinga, nullptr},
}};

}  // namespace

std::span<const Explainer> explainers() { return rows; }

const Explainer* find_explainer(std::string_view algorithm) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Explainer& row) { return row.algorithm == algorithm; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace sightline::explain
