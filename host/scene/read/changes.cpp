#include "host/scene/read/changes.hpp"

#include <fmt/core.h>

#include <cstddef>
#include <string_view>
#include <vector>

#include "host/base/text.hpp"

namespace sightline::scene {

std::string changes_text(const PolyImportReport& report) {
  const MendReport& faces = report.faces;
  std::vector<std::string> said;
  const auto say = [&said](std::size_t count, std::string_view one, std::string_view many) {
    if (count > 0) said.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
  };
  say(faces.merged_vertices, "equal vertex merged", "equal vertices merged");
  say(faces.joined_vertices, "vertex joined to one less than a step away", "vertices joined to others less than a step away");
  say(faces.divided_edges, "edge divided at vertices of other faces", "edges divided at vertices of other faces");
  say(faces.dropped_vertices, "unused vertex left out", "unused vertices left out");
  say(faces.dropped_faces, "face without area left out", "faces without area left out");
  say(faces.duplicate_faces, "face left out that was there twice", "faces left out that were there twice");
  if (faces.split_faces > 0) {
    const bool flat = faces.largest_deviation == 0;
    said.push_back(fmt::format("{} {} became triangles", faces.split_faces,
                               faces.split_faces == 1 ? flat ? "face whose outline touches itself" : "face that is not planar"
                               : flat                 ? "faces whose outlines touch themselves"
                                                      : "faces that are not planar"));
    if (!flat) said.back() += fmt::format(", the farthest vertex {:.3g} off its plane", faces.largest_deviation);
  }
  say(faces.turned_faces, "face turned the right side out", "faces turned the right side out");
  say(faces.one_sided, "part has but one side", "parts have but one side");
  say(faces.crowded_edges, "edge has three or more faces", "edges have three or more faces");
  say(faces.dropped_wires, "line without length left out", "lines without length left out");
  if (faces.crossing_faces > 0) {
    said.push_back(fmt::format("{} {} left out, the first is face {} of the file", faces.crossing_faces,
                               faces.crossing_faces == 1 ? "face whose outline crosses itself"
                                                         : "faces whose outlines cross themselves",
                               faces.first_crossing + 1));
  }
  for (const std::string& note : report.notes) said.push_back(note + " passed over");
  if (said.empty()) return "";
  return (report.mended ? "mended: " : "") + base::joined(said, "; ");
}

}  // namespace sightline::scene
