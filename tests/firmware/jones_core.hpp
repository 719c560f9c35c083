// Jones's program in core, assembled once per scene and kind of machine. Tests change the position of the eye in core, as a
// person at the console would deposit it (NOTES.md, "Reading and changing it").
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/programs/jones/jones.hpp"
#include "host/programs/jones/twin/twin.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::programs::jones {

inline constexpr std::array scene_names{"house", "roberts", "street4", "corridor8", "corridor32"};

inline Program assemble_jones(const scene::CellScene& scene, bool eae) {
  auto program = assemble_program(scene, {.eae = eae});
  if (!program) {
    ADD_FAILURE() << program.error().message();
    return {};
  }
  return std::move(*program);
}

inline Program assemble_jones(std::string_view scene, bool eae) {
  return assemble_jones(scene::builtin_scene(scene), eae);
}

// The address of a tag of the program. The tests use only tags that the program's comments explain.
inline pdp7::Address tag(const Program& program, std::string_view name) {
  const auto found = program.symbols.find(name);
  if (found == program.symbols.end()) {
    ADD_FAILURE() << "the program has no tag " << name;
    return 0;
  }
  return found->second;
}

inline core::Word18 word_of(std::int32_t number) {
  return core::Word18(static_cast<std::uint32_t>(number));
}

inline void put_eye(Program& program, const SpacePoint& eye) {
  program.core[program.labels.scene + 2] = word_of(eye.x);
  program.core[program.labels.scene + 3] = word_of(eye.y);
  program.core[program.labels.scene + 4] = word_of(eye.z);
}

// Runs the program with the current contents of core.
inline Outcome outcome_of(const Program& program, const Order& order = {}) {
  auto outcome = run_core(program, program.core, order);
  if (!outcome) {
    ADD_FAILURE() << outcome.error().message();
    return {};
  }
  return std::move(*outcome);
}

// The core that the twin reads: empty where the tapes store nothing.
inline std::vector<core::Word18> image_of(const Program& program) {
  return program.core;
}

inline TwinView twin_view(const Program& program, Parameters parameters = {}) {
  const auto image = image_of(program);
  parameters.eye = default_parameters(image, program.labels.scene).eye;
  return run_twin(image, program.labels.scene, parameters);
}

inline std::string octal(const std::vector<core::Word18>& words, std::size_t at) {
  if (at >= words.size()) return "nothing";
  std::string digits;
  for (int shift = 15; shift >= 0; shift -= 3)
    digits += static_cast<char>('0' + static_cast<int>(words[at].value() >> shift & 7U));
  return digits;
}

// Compares two display files bit for bit.
inline testing::AssertionResult same_words(const std::vector<core::Word18>& guest,
                                           const std::vector<core::Word18>& twin) {
  if (guest == twin) return testing::AssertionSuccess();
  std::size_t at = 0;
  while (at < guest.size() && at < twin.size() && guest[at] == twin[at]) ++at;
  return testing::AssertionFailure() << guest.size() << " words on the machine, " << twin.size()
                                     << " of the twin; word " << at << " is " << octal(guest, at) << ", not "
                                     << octal(twin, at);
}

}  // namespace sightline::programs::jones
