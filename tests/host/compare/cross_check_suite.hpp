// The agreement of all algorithms as tests: one for each pair and scene.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <string_view>
#include <tuple>

#include "host/compare/cross_check.hpp"

namespace sightline::compare {

inline std::size_t pair_count() {
  return participants().size() * (participants().size() - 1) / 2;
}

// How many scenes are not surfaces of functions; they come first.
inline std::size_t polyhedra_count() {
  const auto names = common_scene_names();
  return static_cast<std::size_t>(
      std::count_if(names.begin(), names.end(), [](std::string_view name) { return name.starts_with("C"); }));
}

// A scene's number in common_scene_names, and a pair's in SceneCrossCheck::cells.
class AgreementOn : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {
 protected:
  // Of a scene once, for all of its pairs.
  static const SceneCrossCheck& agreement_of(std::size_t scene) {
    static std::map<std::size_t, SceneCrossCheck> known;
    const auto found = known.find(scene);
    if (found != known.end()) return found->second;
    return known.emplace(scene, cross_check(common_scene(common_scene_names()[scene]))).first->second;
  }

  static void expect_agreement(std::size_t scene_number, std::size_t pair) {
    const CrossCheckCell& cell = agreement_of(scene_number).cells[pair];
    const CommonScene scene = common_scene(common_scene_names()[scene_number]);
    std::size_t listed_views = 0;
    for (const CrossCheckView& view : scene.views) {
      listed_views += !listed_reason(cell.first, scene.name, view.camera.perspective) &&
                      !listed_reason(cell.second, scene.name, view.camera.perspective);
    }
    EXPECT_EQ(cell.state, listed_views > 0 ? CrossCheckState::agrees : CrossCheckState::not_applicable)
        << cell.first << " and " << cell.second << ", " << scene.name << ", " << cell.text;
    EXPECT_EQ(cell.views, listed_views) << cell.text;
    EXPECT_FALSE(cell.text.empty());
  }
};

inline std::string agreement_name(const testing::TestParamInfo<std::tuple<std::size_t, std::size_t>>& info) {
  auto [scene, pair] = info.param;
  std::string name(common_scene_names()[scene]);
  std::size_t first = 0;
  for (std::size_t others = participants().size() - 1; pair >= others; pair -= others--) ++first;
  name += "_" + std::string(participants()[first].name) + "_" +
          std::string(participants()[first + 1 + pair].name);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

}  // namespace sightline::compare
