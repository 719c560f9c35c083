// The inputs of the hard cases (host/compare/hard_cases/data), for tests at the level of an algorithm: the report names the test
// of such a
// case, which reads the same file.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::scene {

inline std::string hard_case_text(const std::string& file) {
  std::ifstream stream(SIGHTLINE_SOURCE_DIR "/host/compare/hard_cases/data/" + file, std::ios::binary);
  EXPECT_TRUE(stream) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline PolyScene hard_case_scene(const std::string& file) {
  auto read = read_poly_json(hard_case_text(file), file);
  if (!read) {
    ADD_FAILURE() << read.error().message();
    return {};
  }
  return std::move(*read);
}

}  // namespace sightline::scene
