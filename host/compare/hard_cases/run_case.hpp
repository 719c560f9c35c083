// Runs one hard case by all methods that it names: the results that the command, the report and the tests show and
// check.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/compare/hard_cases/manifest.hpp"
#include "host/compare/hard_cases/runner.hpp"
#include "host/picture/image.hpp"

namespace sightline::compare {

struct MethodOutcome {
  std::string method;
  std::optional<bool> right;  // empty: the method does not apply
  std::string text;
  bool as_recorded = true;  // right, not applicable, or wrong word for word as in the manifest
};

struct CaseOutcome {
  std::vector<MethodOutcome> methods;
  // If pictures are requested: the picture of the first wrong method, or else of the first that has one, and the
  // correct one.
  std::optional<picture::Image> correct;
  std::optional<picture::Image> found;
  std::string found_by;
  bool found_is_wrong = false;

  [[nodiscard]] bool as_recorded() const;
};

// `image_side`: side of the pictures in pixels (those of dots have 256); 0: no pictures.
[[nodiscard]] CaseOutcome run_case(const HardCase& hard, int image_side = 0);

// The options of height grids and of Willis's method, in the form of the commands' options: "family x, rotation 0,
// elevation 30".
[[nodiscard]] std::string options_of(const HardCase& hard);

// "sightline hard J5-strip": runs the case, and others on the same file.
[[nodiscard]] std::string hard_command(const HardCase& hard);

// "sightline compare J12.json --scale 511": the case's input in the view of the case, or in the command's default
// view if the oracle cannot take that one. Empty if the command does not take the input.
[[nodiscard]] std::string compare_command(const HardCase& hard);

// The kind of a text that is neither a scene nor a grid, but input of tests or of the 8080: "commands of Skala's
// program". Empty for other texts.
[[nodiscard]] std::string_view kind_of_commands(std::string_view text);

}  // namespace sightline::compare
