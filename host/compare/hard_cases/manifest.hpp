// The manifest of the hard cases, manifest.json: inputs that break programs of this kind, what is run on
// each, what must come out, and where the paper speaks of it. The input files are in data/.
//
// Numbers are J1 to J17 for cells and openings (Jones 1971), S1 to S16 for slices on a raster (Skala 1985),
// W1 to W16 for distance as priority (Willis 1977), M1 to M18 for stripes and priority lists (Montani and Re
// 1985), P1 to P22 for events of a turn (Plantinga, Seales and Dyer 1990). A case may have several inputs,
// and several cases the same one.
//
// Left out: checks of an algorithm's insides. A case names the tests that make them, on the same input.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/algorithms/oracle/column_oracle.hpp"
#include "host/algorithms/registry/faces.hpp"
#include "host/compare/height_methods.hpp"
#include "host/base/result.hpp"
#include "host/compare/jones_precision/precision.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

using SceneSegment = std::array<scene::PolyPoint, 2>;

// What a method is told beside the input; every method reads its own.
struct MethodOptions {
  std::int32_t scale = 512;                           // S of Jones's program
  std::optional<jones_precision::Precision> precision;  // of its twin; none: the machine's
  registry::FaceOptions faces;
  std::vector<double> stripes{1};  // thicknesses of Montani and Re's, in pixels
  algorithms::skala::View view;
};

// Dots of a picture of a height grid that must be lit: those of slices and of the lines across them, from and
// to; all of one row of the screen has one at least.
struct LitDots {
  std::optional<std::array<std::size_t, 2>> slices;
  std::optional<std::array<std::size_t, 2>> points;
  std::optional<std::array<int, 2>> columns;  // only dots in these
  std::optional<int> row;
  bool alone = false;  // and no other dot
};

// What must come out, beside the baseline's picture.
struct Expectation {
  bool refused = false;                               // every reader must refuse the file
  bool program_refuses = false;                       // the program cannot stand there and must say so
  bool eye_refused = false;                           // the eye is in no place to look from
  bool left_over = false;                             // some pairs of faces are, and are named
  std::map<std::string, std::uint64_t> counts;        // by the names that methods give them
  std::vector<SceneSegment> seen;                     // wholly
  std::vector<SceneSegment> hidden;                   // wholly
  std::vector<double> areas;                          // seen of each body, in their order
  std::optional<std::array<std::size_t, 2>> through;  // bodies that pass through each other; refused by name
  std::optional<std::size_t> dots;                    // lit, counted by hand
  std::optional<LitDots> lit;
};

struct HardCase {
  std::string id;     // "J5"
  std::string input;  // a file beside the manifest, a model, a builtin scene; empty: none
  std::string section;
  std::string what;
  std::string expected;
  std::vector<std::string> run;  // methods
  MethodOptions options;
  std::vector<scene::PolyCamera> cameras;         // none: the scene's own
  bool turn = false;                              // seen from all sides around the vertical
  std::string baseline = "oracle";                // line algorithm whose pictures are right
  std::vector<algorithms::oracle::Chain> chains;  // what commands (.txt) draw, nearest first by depth
  Expectation expect;
  std::map<std::string, std::string> found;  // by method: what is known to be wrong, word by word
  std::vector<std::string> tests;            // of insides: "WillisHardCases.W1..."
};

struct HardCaseGroup {
  std::string id;  // of the paper in papers.json
  std::vector<HardCase> cases;
};

struct FamilyBuild {
  std::string method;
  MethodOptions options;
  std::optional<double> to;     // the last value that it can be given
  std::optional<double> first;  // failure, as known
};

// A hard case with a parameter; builds are tried with its values, from easy to hard, until they fail.
struct Family {
  std::string id;
  std::string parameter;
  std::string input;      // in words
  std::string generator;  // of first_failures.cpp
  std::vector<double> values;
  bool bisect = false;  // a build that fails at a value fails at all after it
  std::vector<FamilyBuild> builds;
};

struct Manifest {
  std::vector<HardCaseGroup> groups;
  std::vector<Family> families;
};

// The error names file and place.
[[nodiscard]] base::Result<Manifest> read_manifest(std::string_view text, std::string_view file);

// What is checked of a case, in few words: "cells 2; mask sides 4; lines seen whole 1".
[[nodiscard]] std::string checked(const HardCase& hard);

// The manifest and the inputs that come with the program: (file name, text).
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> hard_case_files();
// The text of an input; empty if there is none of that name.
[[nodiscard]] std::string_view hard_case_text(std::string_view file);

}  // namespace sightline::compare
