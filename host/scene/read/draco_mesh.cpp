// See draco_mesh.hpp.
#include "host/scene/read/draco_mesh.hpp"

#include <draco/compression/decode.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "host/scene/read/poly_text.hpp"

namespace sightline::scene {
namespace {

base::Error draco_damage(std::string found, std::string expected) {
  return {"", "", std::move(found), std::move(expected), export_again};
}

// A number of seven bits per byte, the lowest first; empty at the end of the bytes.
std::optional<std::uint64_t> take_varint(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (unsigned shift = 0; shift < 35 && !bytes.empty(); shift += 7) {
    const auto byte = static_cast<std::uint8_t>(bytes.front());
    bytes.remove_prefix(1);
    number |= std::uint64_t{byte & 0x7fU} << shift;
    if ((byte & 0x80U) == 0) return number;
  }
  return std::nullopt;
}

// libdraco makes room for as many faces as the header says, so the header is checked first. DracoHeader and the first fields of the
// connectivity, sections 3.1 and 4.
base::Result<std::uint64_t> draco_face_count(std::string_view bytes) {
  constexpr std::size_t header = 11;
  if (bytes.size() < header || !bytes.starts_with("DRACO")) return draco_damage("found no header of Draco", "\"DRACO\"");
  const unsigned version = 256U * static_cast<std::uint8_t>(bytes[5]) + static_cast<std::uint8_t>(bytes[6]);
  if (version != 0x202)
    return draco_damage("found version " + std::to_string(version / 256) + "." + std::to_string(version % 256) + " of Draco",
                        "2.2");
  if (bytes[7] != 1) return draco_damage("found no triangles in the compressed data", "a mesh");
  if ((static_cast<std::uint8_t>(bytes[10]) & 0x80U) != 0) return draco_damage("found metadata in the compressed data", "none");
  const bool edgebreaker = bytes[8] == 1;
  bytes.remove_prefix(edgebreaker ? header + 1 : header);
  auto count = take_varint(bytes);
  if (count && edgebreaker) count = take_varint(bytes);  // after that of the vertices
  if (!count) return draco_damage("found the end of the compressed data", "its number of faces");
  return *count;
}

base::Result<DracoMesh> mesh_of_draco(draco::Mesh& decoded, std::uint32_t id) {
  const draco::PointAttribute* const attribute = decoded.GetAttributeByUniqueId(id);
  if (attribute == nullptr || attribute->num_components() != 3)
    return draco_damage("found no positions with the id " + std::to_string(id), "an attribute of three components");
  DracoMesh mesh;
  for (draco::PointIndex p(0); p < decoded.num_points(); ++p) {
    const draco::AttributeValueIndex value = attribute->mapped_index(p);
    if (value.value() >= attribute->size()) return draco_damage("found a point without a position", "a position for each point");
    std::array<float, 3> point{};
    if (!attribute->ConvertValue<float, 3>(value, point.data()))
      return draco_damage("found positions of an unknown type", "numbers");
    mesh.vertices.push_back({double{point[0]}, double{point[1]}, double{point[2]}});
  }
  for (draco::FaceIndex f(0); f < decoded.num_faces(); ++f) {
    for (const draco::PointIndex& corner : decoded.face(f)) {
      if (corner.value() >= mesh.vertices.size())
        return draco_damage("found a face with point " + std::to_string(corner.value()), "a point of the mesh");
      mesh.corners.push_back(corner.value());
    }
  }
  return mesh;
}

}  // namespace

base::Result<DracoMesh> read_draco(std::string_view bytes, std::uint32_t attribute, std::size_t most_faces) {
  const auto faces = draco_face_count(bytes);
  if (!faces) return faces.error();
  constexpr std::uint64_t always_possible = 1'000'000;
  constexpr std::uint64_t most_per_byte = 100;
  if (*faces > most_faces || *faces > std::max(always_possible, most_per_byte * bytes.size()))
    return draco_damage("found " + std::to_string(*faces) + " faces in " + std::to_string(bytes.size()) + " bytes", "fewer");
  try {
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok())
      return draco_damage("found damage: " + printable_name(decoded.status().error_msg_string()), "data that Draco can read");
    return mesh_of_draco(*decoded.value(), attribute);
  } catch (const std::exception&) {
    return draco_damage("found sizes that need more memory than there is", "");
  }
}

}  // namespace sightline::scene
