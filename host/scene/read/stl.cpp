// See stl.hpp.
#include "host/scene/read/stl.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "host/base/number.hpp"
#include "host/scene/model/vertex_pool.hpp"
#include "host/scene/read/poly_text.hpp"
#include "host/scene/read/precision.hpp"

namespace sightline::scene {
namespace {

constexpr std::size_t stl_header_bytes = 80;
constexpr std::size_t stl_triangles_at = stl_header_bytes + 4;
constexpr std::size_t stl_triangle_bytes = 50;  // normal, three vertices, two bytes

std::uint32_t little_endian_32(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
  return word;
}

base::Result<PolyMesh> read_binary_stl(std::string_view bytes, std::string_view source) {
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
  if (bytes.size() != expected) {
    return error(bytes.size() < expected ? bytes.size() : static_cast<std::size_t>(expected),
                 bytes.size() < expected ? "found the end of the file after " + std::to_string(bytes.size()) + " bytes"
                                         : "found " + std::to_string(bytes.size()) + " bytes",
                 std::to_string(expected) + ", as byte 80 says " + std::to_string(triangles) + " triangles",
                 "export the file again, or write it as text");
  }
  if (triangles == 0) return error(stl_header_bytes, "found no triangles", "a mesh");
  PolyMesh mesh;
  mesh.bodies.emplace_back().faces.reserve(static_cast<std::size_t>(triangles));
  VertexPool<double> pool(mesh.vertices);
  std::size_t at = stl_triangles_at;
  for (std::uint64_t t = 0; t < triangles; ++t, at += stl_triangle_bytes) {
    PolyFace face;
    face.outline.reserve(3);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<double, 3> point{};
      for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t place = at + 12 * (corner + 1) + 4 * a;
        point[a] = std::bit_cast<float>(little_endian_32(bytes, place));
        if (!std::isfinite(point[a]))
          return error(place, "found a coordinate that is no finite number", "a number",
                       "triangle " + std::to_string(t) + " is damaged");
      }
      face.outline.push_back(pool.add(point));
    }
    mesh.bodies[0].faces.push_back(std::move(face));
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

// solid NAME, facet normal, outer loop, three times vertex, endloop, endfacet, endsolid: a statement a line.
class TextStl {
 public:
  TextStl(std::string_view text, std::string_view source) : lines_(text, source), pool_(mesh_.vertices) {}

  base::Result<PolyMesh> run() {
    while (!error_ && lines_.next()) read_solid();
    if (!error_ && mesh_.vertices.empty()) error_ = lines_.error("found no triangles, expected \"facet\"");
    if (error_) return *error_;
    std::erase_if(mesh_.bodies, [](const PolyBody& body) { return body.faces.empty(); });
    mesh_.grouped = mesh_.bodies.size() > 1;
    mesh_.precision = precision_.result(mesh_.vertices);
    return std::move(mesh_);
  }

 private:
  // The words of a statement, and how many fields follow.
  bool statement(std::string_view first, std::string_view second, std::size_t numbers) {
    const auto& fields = lines_.fields();
    const std::size_t words = second.empty() ? 1 : 2;
    const bool fits = fields.size() >= words && same_word(fields[0], first) && (words == 1 || same_word(fields[1], second));
    if (!fits || fields.size() != words + numbers) {
      std::string expected = "\"" + std::string(first) + (words == 1 ? "" : " " + std::string(second)) + "\"";
      if (numbers > 0) expected += " and " + std::to_string(numbers) + " numbers";
      error_ = fits ? lines_.error("found " + std::to_string(fields.size() - words) + " fields after it, expected " + expected)
                    : lines_.unexpected(fields[0], expected);
    }
    return !error_;
  }

  // The next line; a file may not end here.
  bool line(std::string_view expected) {
    if (!error_ && !lines_.next()) error_ = lines_.error("found the end of the file, expected \"" + std::string(expected) + "\"");
    return !error_;
  }

  void read_solid() {
    if (!same_word(lines_.fields()[0], "solid")) {
      error_ = lines_.unexpected(lines_.fields()[0], "\"solid\"");
      return;
    }
    PolyBody& body = mesh_.bodies.emplace_back();
    for (std::size_t i = 1; i < lines_.fields().size(); ++i)
      body.name += (i > 1 ? " " : "") + std::string(lines_.fields()[i]);
    body.name = printable_name(body.name);
    while (line("endsolid") && !same_word(lines_.fields()[0], "endsolid")) read_facet(body);
  }

  void read_facet(PolyBody& body) {
    const auto& fields = lines_.fields();
    if (!same_word(fields[0], "facet")) {
      error_ = lines_.unexpected(fields[0], "\"facet\" or \"endsolid\"");
      return;
    }
    if (!line("outer loop") || !statement("outer", "loop", 0)) return;
    PolyFace face;
    face.outline.reserve(3);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (!line("vertex") || !statement("vertex", "", 3)) return;
      std::array<double, 3> point{};
      for (std::size_t a = 0; a < 3; ++a) {
        const std::string_view field = lines_.fields()[a + 1];
        const auto number = base::decimal_number(field);
        if (!number) {
          error_ = lines_.unexpected(field, "a number");
          return;
        }
        point[a] = *number;
        precision_.add(field, *number);
      }
      face.outline.push_back(pool_.add(point));
    }
    if (!line("endloop")) return;
    if (same_word(lines_.fields()[0], "vertex")) {
      error_ = lines_.error("found a fourth vertex, expected triangles");
      return;
    }
    if (!statement("endloop", "", 0) || !line("endfacet") || !statement("endfacet", "", 0)) return;
    body.faces.push_back(std::move(face));
  }

  PolyLines lines_;
  PolyMesh mesh_;
  VertexPool<double> pool_;
  TextPrecision precision_;
  std::optional<base::Error> error_;
};

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= stl_triangles_at &&
         bytes.size() == stl_triangles_at + std::uint64_t{little_endian_32(bytes, stl_header_bytes)} * stl_triangle_bytes;
}

base::Result<PolyMesh> read_stl(std::string_view bytes, std::string_view source) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool text = first != std::string_view::npos && same_word(bytes.substr(first, 5), "solid");
  auto mesh = !is_binary_stl(bytes) && text ? TextStl(bytes, source).run() : read_binary_stl(bytes, source);
  if (!mesh) return mesh;
  mesh->source = source;
  mesh->vertical = 2;
  return mesh;
}

}  // namespace sightline::scene
