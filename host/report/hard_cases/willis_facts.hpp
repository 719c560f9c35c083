// What is checked of the hard cases W1 to W16 by name; see WillisFacts.
#pragma once

#include "host/report/hard_cases/willis.hpp"

namespace sightline::harness::report::willis_facts {

using algorithms::willis::Model;
using scene::PolyScene;

[[nodiscard]] Verdict at_the_length(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict beyond_the_length(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict one_way(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict chain(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict oval_only(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict areas(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict few_pieces(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict common_plane(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict first_not_shown(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict equal_distances(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict both_cut(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict cut_where_they_cross(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict any_representative(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict right_angle(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict beyond_90_degrees(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict on_the_plane(const PolyScene& scene, const Model& model);
[[nodiscard]] Verdict not_overflowing(const PolyScene& scene, const Model& model);

}  // namespace sightline::harness::report::willis_facts
