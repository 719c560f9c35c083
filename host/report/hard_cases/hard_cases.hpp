// Part 3 of the report: the hard cases of the papers' algorithms, each with its exact input, what must come
// out, and what every build makes of it, decided by running it.
//
// Numbers are those of the suite's list of hard cases: J1 to J17 for cells and openings (Jones 1971), S1 to
// S16 for slices on a raster (Skala 1985), W1 to W16 for distance as priority (Willis 1977), M1 to M18 for
// stripes and priority lists (Montani and Re 1985), P1 to P22 for events of a turn (Plantinga, Seales and Dyer
// 1990). A case may have several inputs. A program that is wrong in a hard case is a result to be shown; an
// exact one must never be.
#pragma once

#include <span>
#include <string_view>
#include <utility>

#include "host/report/report.hpp"

namespace sightline::harness::report {

[[nodiscard]] Outcome<Section> hard_cases(const Context& context);

// (file name, text) of the inputs that come with the program: scenes as JSON, grids as numbers.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> hard_case_files();

// The text of one of them; empty if there is none of that name.
[[nodiscard]] std::string_view hard_case_text(std::string_view file);

}  // namespace sightline::harness::report
