#include "host/programs/stripes/stream.hpp"

#include <fmt/core.h>

#include <string>

namespace sightline::programs::stripes {

namespace {

void put_word(std::vector<std::uint8_t>& bytes, std::uint32_t word) {
  bytes.push_back(static_cast<std::uint8_t>(word));
  bytes.push_back(static_cast<std::uint8_t>(word >> 8U));
}

std::string name_of(const SceneFace& face) { return fmt::format("face {} of body {}", face.index, face.body); }

void put_polygon(std::vector<std::uint8_t>& bytes, const SceneFace& face) {
  for (const std::int32_t part : {face.a, face.b, face.c}) put_word(bytes, static_cast<std::uint32_t>(part));
  put_word(bytes, static_cast<std::uint32_t>(face.d));
  put_word(bytes, static_cast<std::uint32_t>(face.d) >> 16U);
  bytes.push_back(static_cast<std::uint8_t>(face.rings.size()));
  for (const auto& ring : face.rings) {
    bytes.push_back(static_cast<std::uint8_t>(ring.size()));
    for (const Corner& corner : ring)
      for (const std::uint16_t part : {corner.x, corner.y, corner.z}) put_word(bytes, part);
  }
}

void put_stripes(std::vector<std::uint8_t>& bytes, const Stripes& stripes) {
  bytes.push_back(static_cast<std::uint8_t>(stripes.low));
  bytes.push_back(static_cast<std::uint8_t>(stripes.lines.size()));
  for (const Toggles& line : stripes.lines) {
    bytes.insert(bytes.end(), line.begin(), line.end());
    bytes.push_back(picture_size);
  }
}

constexpr std::size_t most_in_byte = 255;

// Reports counts that a record cannot hold.
base::Result<base::Done> check_counts(const SceneFace& face) {
  if (face.rings.size() > most_in_byte)
    return base::Error{"", name_of(face), fmt::format("{} outlines and holes", face.rings.size()), "at most 255"};
  for (const auto& ring : face.rings)
    if (ring.size() > most_in_byte)
      return base::Error{"", name_of(face), fmt::format("an outline of {} corners", ring.size()), "at most 255"};
  return base::Done{};
}

}  // namespace

std::vector<std::uint8_t> framed(std::uint8_t mode, std::size_t faces, const std::vector<std::uint8_t>& body) {
  std::vector<std::uint8_t> bytes{first_byte, version};
  put_word(bytes, static_cast<std::uint32_t>(body.size()));
  bytes.push_back(mode);
  bytes.push_back(static_cast<std::uint8_t>(faces));
  bytes.insert(bytes.end(), body.begin(), body.end());
  unsigned one = 0;
  unsigned two = 0;
  for (const std::uint8_t byte : bytes) {
    one = (one + byte) & 0xFFU;
    two = (two + one) & 0xFFU;
  }
  bytes.push_back(static_cast<std::uint8_t>(one));
  bytes.push_back(static_cast<std::uint8_t>(two));
  return bytes;
}

base::Result<Stream> encode(const ProjectedScene& scene, const StreamOptions& options) {
  if (options.build != Build::plain && options.output == Output::vector)
    return base::usage_error(options.build == Build::coverage ? "the plotter has no greys for antialiasing"
                                                              : "nothing can be overwritten on the plotter");
  if (options.build == Build::coverage && options.stripes == Computer::host)
    return base::usage_error("antialiasing needs the sides of the faces, which the host's stripes do not have");
  if (scene.faces.size() > most_faces)
    return base::Error{"", "faces", fmt::format("{} faces are turned to the eye, {} too many", scene.faces.size(),
                                                scene.faces.size() - most_faces),
                       fmt::format("at most {} for the 8080", most_faces)};
  const bool stripes = options.stripes == Computer::host;
  const bool polygons = !stripes || options.priority == Computer::i8080;
  Stream stream;
  std::vector<std::uint8_t> body;
  for (const SceneFace& face : scene.faces) {
    if (auto counts = check_counts(face); !counts) return counts.error();
    std::size_t longest = 0;
    const Stripes made = stripes_of(face.rings, longest);
    if (longest > most_face_toggles)
      return base::Error{"", name_of(face), fmt::format("{} sides in a line, {} too many", longest, longest - most_face_toggles),
                         fmt::format("at most {} for the 8080", most_face_toggles)};
    const std::size_t begin = body.size();
    put_word(body, 0);
    body.push_back(face.level);
    const std::size_t before = body.size();
    if (polygons) put_polygon(body, face);
    stream.polygon_bytes += body.size() - before;
    const std::size_t lists = body.size();
    if (stripes) put_stripes(body, made);
    stream.stripe_bytes += body.size() - lists;
    const std::size_t length = body.size() - begin;
    body[begin] = static_cast<std::uint8_t>(length);
    body[begin + 1] = static_cast<std::uint8_t>(length >> 8U);
  }
  const std::size_t room = most_body_bytes_of(options.build);
  if (body.size() > room)
    return base::Error{"", "scene",
                       fmt::format("{} bytes ({} of stripes, {} of polygons, 3 a face), {} too many", body.size(),
                                   stream.stripe_bytes, stream.polygon_bytes, body.size() - room),
                       fmt::format("at most {} in the 8080's memory", room),
                       stripes ? "let the 8080 make the stripes" : ""};
  std::uint8_t mode = 0;
  if (options.output == Output::vector) mode |= vector_output;
  if (options.priority == Computer::i8080) mode |= programs::stripes::find_priority;
  if (stripes) mode |= faces_are_stripes;
  stream.bytes = framed(mode, scene.faces.size(), body);
  return stream;
}

}  // namespace sightline::programs::stripes
