// The manifest of the hard cases, manifest.json: inputs that break programs of this kind, the methods to run on each,
// the expected results, and the section of the paper. The input files are in data/.
//
// Numbers begin with J for cells and openings (Jones 1971), S for slices on a raster (Skala 1985), W for distance as
// priority (Willis 1977), M for stripes and priority lists (Montani and Re 1985), P for events of a turn (Plantinga,
// Seales and Dyer 1990). A case may have several inputs, and several cases may share one.
//
// Left out: checks of an algorithm's internals. A case names the tests that make them, on the same input.
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

// A method's options beside the input; every method reads its own.
struct MethodOptions {
  std::int32_t scale = 512;                           // S of Jones's program
  std::optional<jones_precision::Precision> precision;  // of its twin; empty: the machine's
  registry::FaceOptions faces;
  std::vector<double> stripes{1};  // of Montani and Re's method, in pixels
  algorithms::skala::View view;
};

// Dots of a picture of a height grid that must be lit: those of slices and of the lines across them, `from` and `to`;
// with `row`, at least one dot in it.
struct LitDots {
  std::optional<std::array<std::size_t, 2>> slices;
  std::optional<std::array<std::size_t, 2>> points;
  std::optional<std::array<int, 2>> columns;  // only dots in these
  std::optional<int> row;
  bool alone = false;  // and no other dot
};

// The expected result, in addition to the baseline's picture.
struct Expectation {
  bool refused = false;                               // every reader must refuse the file
  bool program_refuses = false;                       // the program cannot use the eye and must report it
  bool eye_refused = false;                           // the eye is in no valid place
  bool left_over = false;                             // some pairs of faces are not solved and must be named
  std::map<std::string, std::uint64_t> counts;        // by the names that methods give them
  std::vector<SceneSegment> seen;                     // completely visible
  std::vector<SceneSegment> hidden;                   // completely hidden
  std::vector<double> areas;                          // visible area of each body, in their order
  std::optional<std::array<std::size_t, 2>> through;  // bodies that intersect; must be rejected with their names
  std::optional<std::size_t> dots;                    // lit, counted by hand
  std::optional<LitDots> lit;
};

struct HardCase {
  std::string id;     // "J5"
  std::string input;  // a file next to the manifest, a model, a built-in scene; empty: none
  std::string section;
  std::string what;
  std::string expected;
  std::vector<std::string> run;  // methods
  MethodOptions options;
  std::vector<scene::PolyCamera> cameras;         // empty: the scene's own
  bool turn = false;                              // seen from all sides around the vertical
  std::string baseline = "oracle";                // line algorithm whose pictures are the reference
  std::vector<algorithms::oracle::Chain> chains;  // drawn by commands (.txt), in order of depth, nearest first
  Expectation expect;
  std::map<std::string, std::string> found;  // by method: the known wrong result, word for word
  std::vector<std::string> tests;            // of internals: "WillisHardCases.W1..."
};

struct HardCaseGroup {
  std::string id;  // of the paper in papers.json
  std::vector<HardCase> cases;
};

struct FamilyBuild {
  std::string method;
  MethodOptions options;
  std::optional<double> to;     // the last value that it accepts
  std::optional<double> first;  // first known failure
};

// A hard case with a parameter. Its values, from easy to hard, are tried on each build until it fails.
struct Family {
  std::string id;
  std::string parameter;
  std::string input;      // in words
  std::string generator;  // of first_failures.cpp
  std::vector<double> values;
  bool bisect = false;  // a build that fails at a value fails at all later ones
  std::vector<FamilyBuild> builds;
};

struct Manifest {
  std::vector<HardCaseGroup> groups;
  std::vector<Family> families;
};

// The error names file and place.
[[nodiscard]] base::Result<Manifest> read_manifest(std::string_view text, std::string_view file);

// What a case checks, in a few words: "cells 2; mask sides 4; lines seen whole 1".
[[nodiscard]] std::string checks_of(const HardCase& hard);

// The manifest and the inputs that are built into the program: (file name, text).
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> hard_case_files();
// The text of an input; empty if there is no such file.
[[nodiscard]] std::string_view hard_case_text(std::string_view file);

}  // namespace sightline::compare
