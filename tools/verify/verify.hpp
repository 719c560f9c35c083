// Checks a certificate of `sightline draw exact --certificate`: a proof of which parts of a drawing's edges are visible.
// README.md describes the format, what is proven and why. Shares no code with the rest of this repository.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sightline::verifier {

struct Verdict {
  enum class Kind { proved, refuted, malformed };

  Kind kind = Kind::proved;
  std::size_t line = 0;  // of the first fault, from 1
  std::string reason;    // of the fault, as a clause
  std::size_t edges = 0;
  std::size_t visible = 0;  // intervals
  std::size_t hidden = 0;   // edges without a visible interval
};

[[nodiscard]] Verdict verify(std::string_view certificate);

// "proved: 12 edges, 9 visible intervals, 3 edges hidden", or "line 7: REASON".
[[nodiscard]] std::string sentence(const Verdict& verdict);

}  // namespace sightline::verifier
