// Regions on the lattice as text: a line a chain, with the name of its region, its starting point and its
// links.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/montani_re/lattice_pcs.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::harness::report {

// Chains by the name of their region, in the order of the text, which they point into.
using LatticeRegions = std::map<std::string, std::vector<algorithms::montani_re::FreemanChain>, std::less<>>;

// Errors name the line, what was found and what was expected. That chains close is not checked.
[[nodiscard]] base::Result<LatticeRegions> read_chains(std::string_view text, std::string_view source);

}  // namespace sightline::harness::report
