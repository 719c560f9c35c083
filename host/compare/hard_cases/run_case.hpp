// One hard case by all methods that it names: what the command, the report and the tests show and check.
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
  std::optional<bool> right;  // none: the method does not apply
  std::string text;
  bool as_recorded = true;  // right, not applicable, or wrong word by word as the manifest says
};

struct CaseOutcome {
  std::vector<MethodOutcome> methods;
  // If pictures are asked for: that of the first method that is wrong, or else of the first that has one, and the right one beside it.
  std::optional<picture::Image> correct;
  std::optional<picture::Image> found;
  std::string found_by;
  bool found_is_wrong = false;

  [[nodiscard]] bool as_recorded() const;
};

// `image_side`: of the pictures, in pixels (those of dots have 256); 0: none.
[[nodiscard]] CaseOutcome run_case(const HardCase& hard, int image_side = 0);

// Of a grid and of Willis's, in the words of the commands' options: "family x, rotation 0, elevation 30".
[[nodiscard]] std::string options_of(const HardCase& hard);

// "sightline hard J5-strip": runs the case, and others on the same file.
[[nodiscard]] std::string hard_command(const HardCase& hard);

// "sightline compare J12.json --scale 511": the case's input in the view of the case, or in the command's usual one where the oracle
// does not know that. Empty if the command does not take the input.
[[nodiscard]] std::string compare_command(const HardCase& hard);

// What a text is that neither readers of scenes nor of grids take, but tests or the 8080: "commands of Skala's program". Empty if it is
// none of these.
[[nodiscard]] std::string_view kind_of_commands(std::string_view text);

}  // namespace sightline::compare
