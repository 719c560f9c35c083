// Is a line of the scene seen whole, or not at all? Asked of exact pictures, and decided exactly.
#pragma once

#include "host/report/hard_cases/jones.hpp"
#include "host/picture/line_picture.hpp"

namespace sightline::harness::report {

enum class SegmentSeen { whole, in_part, nothing };

// What of the segment is covered by visible pieces of edges that lie on its line.
[[nodiscard]] SegmentSeen seen_of(const SceneSegment& segment, const picture::LinePicture& picture,
                                  const scene::PolyScene& scene);

}  // namespace sightline::harness::report
