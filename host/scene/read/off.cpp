// See off.hpp.
#include "host/scene/read/off.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/scene/read/poly_text.hpp"
#include "host/scene/read/precision.hpp"

namespace sightline::scene {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, std::string_view source) : lines_(text, source), size_(text.size()) {
    mesh_.source = source;
  }

  base::Result<PolyMesh> run() {
    if (read_header() && read_vertices() && read_faces() && lines_.next())
      error_ = lines_.unexpected(lines_.fields()[0], "nothing after the last face");
    if (error_) return *error_;
    return std::move(mesh_);
  }

 private:
  bool fail(base::Error error) {
    error_ = std::move(error);
    return false;
  }

  // ST, C and N in front of OFF, each at most once and in this order.
  static bool known_variant(std::string_view word) {
    for (const std::string_view prefix : {"ST", "C", "N"})
      if (word.substr(0, prefix.size()) == prefix) word.remove_prefix(prefix.size());
    return word == "OFF";
  }

  bool read_header() {
    if (!lines_.next()) return fail(lines_.error("found no text, expected OFF"));
    const std::string_view word = lines_.fields()[0];
    if (!known_variant(word)) {
      const bool off = word.size() > 3 && word.size() < 9 && word.substr(word.size() - 3) == "OFF";
      return fail(lines_.unexpected(word, off ? "OFF, COFF, NOFF, CNOFF or STOFF: points of three dimensions"
                                              : "OFF in the first line"));
    }
    std::size_t first = 1;
    if (lines_.fields().size() > 1 && lines_.fields()[1] == "BINARY")
      return fail(lines_.unexpected("BINARY", "OFF as text"));
    if (lines_.fields().size() == 1) {
      if (!lines_.next()) return fail(lines_.error("expected the numbers of vertices, faces and edges"));
      first = 0;
    }
    const auto& fields = lines_.fields();
    if (fields.size() < first + 2 || fields.size() > first + 3)
      return fail(lines_.error("expected the numbers of vertices, faces and edges"));
    return read_count(fields[first], vertices_) && read_count(fields[first + 1], faces_);
  }

  bool read_count(std::string_view field, std::size_t& count) {
    const auto number = base::signed_number(field);
    if (!number || *number < 0 || *number > std::numeric_limits<std::int32_t>::max())
      return fail(lines_.unexpected(field, "a number of vertices or faces"));
    count = static_cast<std::size_t>(*number);
    return true;
  }

  bool read_vertices() {
    mesh_.vertices.reserve(std::min(vertices_, size_ / 6));  // "0 0 0\n"
    for (std::size_t v = 0; v < vertices_; ++v) {
      if (!lines_.next()) {
        return fail(
            lines_.error("found " + std::to_string(v) + " vertices, expected " + std::to_string(vertices_)));
      }
      const auto& fields = lines_.fields();
      if (fields.size() < 3)
        return fail(lines_.error("found " + std::to_string(fields.size()) + " numbers, expected x, y and z"));
      std::array<double, 3> point{};
      for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto number = base::decimal_number(fields[i]);
        if (!number) return fail(lines_.unexpected(fields[i], "a number"));
        if (i >= 3) continue;
        point[i] = *number;
        precision_.add(fields[i], *number);
      }
      mesh_.vertices.push_back(point);
    }
    mesh_.precision = precision_.result(mesh_.vertices);
    return true;
  }

  bool read_faces() {
    mesh_.bodies.emplace_back();
    auto& faces = mesh_.bodies.back().faces;
    faces.reserve(std::min(faces_, size_ / 8));
    for (std::size_t f = 0; f < faces_; ++f) {
      if (!lines_.next()) {
        return fail(
            lines_.error("found " + std::to_string(f) + " faces, expected " + std::to_string(faces_)));
      }
      if (!read_face(faces.emplace_back())) return false;
    }
    if (materials_.size() < 2) mesh_.materials.clear();
    return true;
  }

  bool read_face(PolyFace& face) {
    const auto& fields = lines_.fields();
    const auto count = base::signed_number(fields[0]);
    if (!count || *count < 3)
      return fail(lines_.unexpected(fields[0], "how many vertices the face has, 3 or more"));
    if (static_cast<std::uint64_t>(*count) > fields.size() - 1) {
      return fail(lines_.error("found " + std::to_string(fields.size() - 1) + " vertices, expected " +
                               std::to_string(*count)));
    }
    face.outline.reserve(static_cast<std::size_t>(*count));
    for (std::size_t i = 1; i <= static_cast<std::size_t>(*count); ++i) {
      const auto vertex = base::signed_number(fields[i]);
      if (!vertex || *vertex < 0 || static_cast<std::size_t>(*vertex) >= vertices_)
        return fail(lines_.unexpected(fields[i], "a vertex below " + std::to_string(vertices_)));
      face.outline.push_back(static_cast<VertexIndex>(*vertex));
    }
    // What follows is a colour, in numbers or as the place in a map.
    std::string colour;
    for (std::size_t i = static_cast<std::size_t>(*count) + 1; i < fields.size(); ++i) colour += std::string(fields[i]) + ' ';
    mesh_.materials.push_back(materials_.try_emplace(colour, static_cast<std::uint32_t>(materials_.size())).first->second);
    return true;
  }

  PolyLines lines_;
  std::size_t size_;
  PolyMesh mesh_;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  std::map<std::string, std::uint32_t> materials_;  // by the colour as written
  TextPrecision precision_;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<PolyMesh> read_off(std::string_view text, std::string_view source) {
  return OffReader(text, source).run();
}

}  // namespace sightline::scene
