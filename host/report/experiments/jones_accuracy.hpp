// Jones's program in various arithmetics, from six eyes per scene: its errors and times.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/experiments/jones_pictures.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

// A build of the program on the PDP-7: 0 to 3 fraction bits, rounded or truncated. Times are means per view.
struct JonesBuild {
  std::string scene;
  int fraction_bits = 0;
  bool rounded = true;
  double eae_view_s = 0;
  double view_s = 0;
  PictureError computed;   // of pieces after clipping
  PictureError displayed;  // of the same pieces between points of the display

  [[nodiscard]] double eae_gain() const { return view_s / eae_view_s; }
};

// A piece that is wrong for more than 20 pixels.
struct JonesWrongPiece {
  std::string scene;
  std::string arithmetic;
  std::string eye;
  bool extra = false;  // drawn, not visible
  double length_px = 0;
  std::string from;
  std::string to;
};

struct JonesAccuracy {
  std::vector<JonesBuild> builds;
  std::vector<JonesWrongPiece> wrong_pieces;

  [[nodiscard]] const JonesBuild& build(std::string_view scene, int fraction_bits, bool rounded = true) const;
};

// In C++: 0 to 8 fraction bits in words of 36 bits (study fractions); words of 12 to 36 bits, each with the most
// fraction bits with which every view is complete (words); float and double (floating); and the exact algorithms,
// whose error is 0 because their pictures equal the oracle's, piece for piece (exact).
struct JonesNumber {
  std::string scene;
  std::string study;
  std::string arithmetic;
  std::optional<int> word_bits;
  std::optional<int> fraction_bits;
  std::optional<bool> rounded;
  PictureError error;
  std::optional<double> view_us;
};

struct JonesNumbers {
  std::vector<JonesNumber> numbers;
};

[[nodiscard]] JonesAccuracy jones_accuracy(const Context& context);
void jones_numbers(const Context& context, JonesNumbers& made);
void jones_accuracy_chapter(Page& page, const JonesAccuracy& machine, const JonesNumbers& native);

}  // namespace sightline::report
