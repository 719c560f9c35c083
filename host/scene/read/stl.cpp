// See stl.hpp.
#include "host/scene/read/stl.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "host/scene/model/vertex_pool.hpp"
#include "host/scene/read/poly_text.hpp"
#include "host/scene/read/precision.hpp"

namespace sightline::scene {
namespace {

constexpr std::size_t stl_header_bytes = 80;
constexpr std::size_t stl_triangles_at = stl_header_bytes + 4;
constexpr std::size_t stl_triangle_bytes = 50;  // normal, three vertices, two bytes

std::uint32_t little_endian_32(std::string_view bytes, std::size_t at) {
  // Without a loop: compilers make one load of this.
  const auto byte = [&](std::size_t i) { return std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])}; };
  return byte(0) | byte(1) << 8U | byte(2) << 16U | byte(3) << 24U;
}

base::Result<PolyMesh> read_binary_stl(std::string_view bytes, std::string_view source, unsigned jobs) {
  const auto error = [&](std::size_t at, std::string found, std::string expected, std::string remedy = "") {
    return base::Error{std::string(source), "byte " + std::to_string(at), std::move(found), std::move(expected),
                       std::move(remedy)};
  };
  if (bytes.size() < stl_triangles_at) {
    return error(bytes.size(), "found the end of the file",
                 "\"solid\" in the first line of a text, or the 84 bytes of a binary header");
  }
  const std::uint64_t triangles = little_endian_32(bytes, stl_header_bytes);
  const std::uint64_t expected = stl_triangles_at + triangles * stl_triangle_bytes;
  if (bytes.size() < expected) {
    return error(bytes.size(), "found the end of the file after " + std::to_string(bytes.size()) + " bytes",
                 std::to_string(expected) + ", as byte 80 says " + std::to_string(triangles) + " triangles",
                 "export the file again, or write it as text");
  }
  const std::uint64_t rest = bytes.size() - expected;
  if (triangles == 0) {
    return error(stl_header_bytes, "found no faces" + (rest > 0 ? ", and " + std::to_string(rest) + " bytes after them" : ""),
                 "a mesh", rest >= stl_triangle_bytes ? "if the file has triangles, export it again with their number" : "");
  }
  PolyMesh mesh;
  if (rest > 0) mesh.notes.push_back(std::to_string(rest) + (rest == 1 ? " byte" : " bytes") + " after the last triangle");
  std::vector<PolyFace>& faces = mesh.bodies.emplace_back().faces;
  faces.assign(static_cast<std::size_t>(triangles), {{0, 0, 0}, {}});
  // Of the corners of all triangles.
  const auto place_of = [](std::size_t corner) { return stl_triangles_at + corner / 3 * stl_triangle_bytes + 12 * (corner % 3 + 1); };
  const auto point_of = [&](std::size_t corner) {
    std::array<double, 3> point{};
    for (std::size_t a = 0; a < 3; ++a) point[a] = std::bit_cast<float>(little_endian_32(bytes, place_of(corner) + 4 * a));
    return point;
  };
  const auto likely = static_cast<std::size_t>(triangles / 2 + 2);  // of a closed surface about half as many
  pool_points<double>(3 * faces.size(), point_of, likely, jobs, mesh.vertices,
                      [&faces](std::size_t corner, VertexIndex vertex) { faces[corner / 3].outline[corner % 3] = vertex; });
  if (2 * mesh.vertices.size() < mesh.vertices.capacity()) mesh.vertices.shrink_to_fit();
  const auto not_finite = [](const std::array<double, 3>& p) {
    return std::find_if_not(p.begin(), p.end(), [](double c) { return std::isfinite(c); }) - p.begin();
  };
  const bool all_finite = std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const auto& p) { return not_finite(p) == 3; });
  for (std::size_t corner = 0; !all_finite && !mesh.flaw; ++corner) {
    const auto axis = static_cast<std::size_t>(not_finite(point_of(corner)));
    if (axis == 3) continue;
    const std::string found = "found a coordinate of triangle " + std::to_string(corner / 3) + " that is no finite number";
    mesh.flaw = error(place_of(corner) + 4 * axis, found, "a number");
  }
  mesh.precision = float32_precision(mesh.vertices);
  return mesh;
}

bool same_word(std::string_view field, std::string_view lower) {
  if (field.size() != lower.size()) return false;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const char c = field[i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != lower[i]) return false;
  }
  return true;
}

// solid NAME, facet normal, outer loop, three times vertex, endloop, endfacet, endsolid NAME.
class TextStl {
 public:
  TextStl(std::string_view text, std::string_view source) : lines_(text, source), pool_(mesh_.vertices) {}

  base::Result<PolyMesh> run() {
    bool inside = false;
    while (!error_) {
      const std::string_view word = lines_.take();
      if (word.empty()) break;
      if (inside && same_word(word, "facet")) {
        read_facet();
      } else if (same_word(word, "solid")) {
        unfinished_ += inside ? 1U : 0U;
        inside = true;
        begin_solid();
      } else if (inside && same_word(word, "endsolid")) {
        inside = false;
        pass_over_name();
      } else {
        error_ = lines_.unexpected(word, inside ? "\"facet\" or \"endsolid\"" : "\"solid\"");
      }
    }
    if (!error_ && mesh_.vertices.empty()) error_ = lines_.error("found no faces, expected a mesh");
    if (error_) return *error_;
    unfinished_ += inside ? 1U : 0U;
    if (unfinished_ == 1) mesh_.notes.push_back("a missing \"endsolid\"");
    if (unfinished_ > 1) mesh_.notes.push_back(std::to_string(unfinished_) + " missing \"endsolid\"");
    std::erase_if(mesh_.bodies, [](const PolyBody& body) { return body.faces.empty(); });
    mesh_.grouped = mesh_.bodies.size() > 1;
    mesh_.precision = precision_.result(mesh_.vertices);
    return std::move(mesh_);
  }

 private:
  // The next word; a file may not end before it.
  bool expect(std::string_view word) {
    const std::string_view found = lines_.take();
    if (same_word(found, word)) return true;
    error_ = lines_.unexpected(found, "\"" + std::string(word) + "\"");
    return false;
  }

  // Where on this line a facet begins, or how many fields are left.
  [[nodiscard]] std::size_t facet_in_line() const {
    const auto rest = lines_.rest();
    std::size_t at = 0;
    while (at < rest.size() &&
           !(same_word(rest[at], "facet") && at + 1 < rest.size() && same_word(rest[at + 1], "normal")))
      ++at;
    return at;
  }

  void begin_solid() {
    std::string& name = mesh_.bodies.emplace_back().name;
    const auto rest = lines_.rest();
    const std::size_t words = facet_in_line();
    std::size_t taken = 0;
    for (; taken < words && !same_word(rest[taken], "endsolid"); ++taken)
      name += (taken > 0 ? " " : "") + std::string(rest[taken]);
    name = printable_name(name);
    lines_.pass_over(taken);
  }

  // Another solid may begin on the line.
  void pass_over_name() {
    const auto rest = lines_.rest();
    std::size_t words = rest.size();
    if (const std::size_t facet = facet_in_line(); facet < rest.size())
      for (words = facet; words > 0 && !same_word(rest[words], "solid");) --words;
    lines_.pass_over(words);
  }

  void read_facet() {
    // The normal is passed over, however many numbers it has.
    constexpr int most = 8;
    std::string_view word = lines_.take();
    for (int i = 0; i < most && !word.empty() && !same_word(word, "outer"); ++i) word = lines_.take();
    if (!same_word(word, "outer")) {
      error_ = lines_.unexpected(word, "\"outer loop\"");
      return;
    }
    if (!expect("loop")) return;
    PolyFace face;
    face.outline.reserve(3);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (!expect("vertex")) return;
      std::array<double, 3> point{};
      for (std::size_t a = 0; a < 3; ++a) {
        const std::string_view field = lines_.take();
        const auto number = precision_.read(field);
        if (!number) {
          error_ = lines_.unexpected(field, "a number");
          return;
        }
        if (!std::isfinite(*number) && !mesh_.flaw) mesh_.flaw = lines_.unexpected(field, "a finite number");
        point[a] = *number;
      }
      face.outline.push_back(pool_.add(point));
    }
    word = lines_.take();
    if (same_word(word, "vertex")) {
      error_ = lines_.error("found a fourth vertex, expected triangles");
    } else if (!same_word(word, "endloop")) {
      error_ = lines_.unexpected(word, "\"endloop\"");
    } else if (expect("endfacet")) {
      mesh_.bodies.back().faces.push_back(std::move(face));
    }
  }

  PolyLines lines_;
  PolyMesh mesh_;
  VertexPool<double> pool_;
  TextPrecision precision_;
  std::size_t unfinished_ = 0;  // solids without "endsolid"
  std::optional<base::Error> error_;
};

// Whether the first word is "solid". The fourth byte of the count of a binary file is 0 below 16 million triangles; that of a
// text never is.
bool begins_as_text(std::string_view bytes) {
  if (bytes.size() >= stl_triangles_at && bytes[stl_triangles_at - 1] == '\0') return false;
  while (true) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return false;
    bytes.remove_prefix(first);
    if (bytes[0] != '#') return same_word(bytes.substr(0, 5), "solid");
    bytes.remove_prefix(std::min(bytes.find_first_of("\r\n"), bytes.size()));
  }
}

}  // namespace

bool begins_as_binary_stl(std::string_view bytes) {
  return bytes.size() >= stl_triangles_at &&
         bytes.size() >= stl_triangles_at + std::uint64_t{little_endian_32(bytes, stl_header_bytes)} * stl_triangle_bytes;
}

bool is_binary_stl(std::string_view bytes) {
  return begins_as_binary_stl(bytes) && (bytes.size() - stl_triangles_at) ==
                                            std::uint64_t{little_endian_32(bytes, stl_header_bytes)} * stl_triangle_bytes;
}

base::Result<PolyMesh> read_stl(std::string_view bytes, std::string_view source, unsigned jobs) {
  const bool text = !begins_as_binary_stl(bytes) && begins_as_text(bytes);
  auto mesh = text ? TextStl(bytes, source).run() : read_binary_stl(bytes, source, jobs);
  if (!mesh) return mesh;
  mesh->source = source;
  mesh->vertical = 2;
  return mesh;
}

}  // namespace sightline::scene
