#include "host/explain/explain.hpp"

#include <algorithm>
#include <array>

#include "host/explain/exact.hpp"

namespace sightline::explain {
namespace {

constexpr std::array<Explainer, 1> rows{{
    {"exact", "Every edge against the faces that may hide it: the reference, with no paper", explain_exact, nullptr},
}};

}  // namespace

std::span<const Explainer> explainers() { return rows; }

const Explainer* find_explainer(std::string_view algorithm) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Explainer& row) { return row.algorithm == algorithm; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace sightline::explain
