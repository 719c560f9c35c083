// Jones's program on the PDP-7 and its twin in a hard case.
#pragma once

#include <string>
#include <utility>

#include "host/report/hard_cases/jones.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::harness::report {

// What guest and twin made of the case, held against the cell oracle on the screen: more than one point away
// is wrong.
[[nodiscard]] std::pair<Cell, Cell> run_programs(const JonesHardCase& hard, const scene::CellScene& scene);

// Why a scene of polyhedra cannot be one of the program's.
[[nodiscard]] std::string why_no_machine(const scene::PolyScene& scene);

}  // namespace sightline::harness::report
