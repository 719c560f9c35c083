// The row of `exact` in the table of lines.hpp.
#pragma once

#include "host/algorithms/registry/lines.hpp"

namespace sightline::registry {

[[nodiscard]] base::Result<PreparedScene> prepare_exact(const scene::PolyScene& scene);
[[nodiscard]] base::Result<PreparedScene> prepare_exact_threads(const scene::PolyScene& scene, unsigned jobs, bool of_chosen);

inline constexpr LineAlgorithm exact_lines{"exact", "Exact visible edges of any scene, fast: for a correct drawing today",
                                           [](const scene::PolyScene&) { return std::optional<std::string>(); },
                                           prepare_exact, false, nullptr, nullptr, true, prepare_exact_threads};

}  // namespace sightline::registry
