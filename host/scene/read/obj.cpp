// See obj.hpp.
#include "host/scene/read/obj.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/scene/read/poly_text.hpp"
#include "host/scene/read/precision.hpp"

namespace sightline::scene {
namespace {

class ObjReader {
  static constexpr std::size_t longest_word = 40;
  static constexpr std::size_t most_notes = 8;
  static constexpr std::size_t no_group = std::numeric_limits<std::size_t>::max();

 public:
  ObjReader(std::string_view text, std::string_view source) : lines_(text, source) { mesh_.source = source; }

  base::Result<PolyMesh> run() {
    while (!error_ && lines_.next()) read_statement();
    if (error_) return *error_;
    if (mesh_.vertices.empty()) return lines_.error("found no vertices, expected lines \"v x y z\"");
    if (last_ahead_ > mesh_.vertices.size()) {
      ahead_.found += expected_vertex();
      return ahead_;
    }
    gather();
    return std::move(mesh_);
  }

 private:
  struct NamedFace {
    std::size_t object = 0;  // into names_; 0: before the first
    std::size_t group = 0;
    std::size_t material = 0;
    PolyFace face;
  };

  void read_statement() {
    const std::string_view word = lines_.fields()[0];
    if (word == "v") {
      read_vertex();
    } else if (word == "f" || word == "fo") {
      read_face();
    } else if (word == "l" && lines_.fields().size() > 2) {
      read_polyline();
    } else if (word == "o") {
      object_ = name();
      has_objects_ = true;
    } else if (word == "g") {
      group_ = name();
      has_groups_ = true;
    } else if (word == "usemtl") {
      material_ = name();
    } else if (word != "vn" && word != "vt" && word != "s" && word != "mtllib") {
      ++others_[std::string(word.substr(0, longest_word))];
    }
  }

  // The statement's name, words joined by blanks, as a number; what is not printable ASCII becomes "?".
  std::size_t name() {
    std::string text;
    for (std::size_t i = 1; i < lines_.fields().size(); ++i)
      text += (i > 1 ? " " : "") + std::string(lines_.fields()[i]);
    return numbers_.try_emplace(printable_name(std::move(text)), numbers_.size() + 1).first->second;
  }

  void read_vertex() {
    const auto& fields = lines_.fields();
    if (fields.size() < 4) {
      error_ = lines_.error("found " + std::to_string(fields.size() - 1) + " numbers, expected x, y and z");
      return;
    }
    std::array<double, 3> point{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto number = precision_.read(fields[a + 1]);
      if (!number) {
        error_ = lines_.unexpected(fields[a + 1], "a number");
        return;
      }
      if (!std::isfinite(*number) && !mesh_.flaw) mesh_.flaw = lines_.unexpected(fields[a + 1], "a finite number");
      point[a] = *number;
    }
    mesh_.vertices.push_back(point);
  }

  void read_face() {
    const auto& fields = lines_.fields();
    if (fields.size() < 4 && !mesh_.flaw)
      mesh_.flaw = lines_.error("found " + std::to_string(fields.size() - 1) + " vertices, expected 3 or more");
    NamedFace face{object_, group_, material_, {read_corners(), {}}};
    if (!error_) faces_.push_back(std::move(face));
  }

  void read_polyline() {
    const std::vector<VertexIndex> vertices = read_corners();
    for (std::size_t i = 1; i < vertices.size(); ++i) mesh_.wires.push_back({vertices[i - 1], vertices[i]});
  }

  // The vertices that the statement names; an error if one is none.
  std::vector<VertexIndex> read_corners() {
    const auto& fields = lines_.fields();
    std::vector<VertexIndex> vertices;
    for (std::size_t i = 1; i < fields.size(); ++i) {
      const auto vertex = vertex_of(fields[i]);
      if (!vertex) {
        error_ = lines_.unexpected(fields[i], expected_vertex());
        break;
      }
      vertices.push_back(*vertex);
    }
    return vertices;
  }

  [[nodiscard]] std::string expected_vertex() const {
    const std::string count = std::to_string(mesh_.vertices.size());
    return "a vertex 1.." + count + " or the same from behind, -" + count + "..-1";
  }

  // A positive number may be that of a vertex that follows.
  [[nodiscard]] std::optional<VertexIndex> vertex_of(std::string_view corner) {
    const std::string_view whole = corner;
    const std::size_t slash = corner.find('/');
    const auto number = base::signed_number(corner.substr(0, slash));
    if (!number) return std::nullopt;
    while (corner.find('/') != std::string_view::npos) {  // vt and vn are integers or left out
      corner.remove_prefix(corner.find('/') + 1);
      const std::string_view part = corner.substr(0, corner.find('/'));
      if (!part.empty() && !base::signed_number(part)) return std::nullopt;
    }
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    if (*number < -count || *number > std::numeric_limits<std::int32_t>::max() || *number == 0) return std::nullopt;
    if (*number > count && static_cast<std::uint64_t>(*number) > last_ahead_) {
      last_ahead_ = static_cast<std::size_t>(*number);
      ahead_ = lines_.unexpected(whole, "");
    }
    return static_cast<VertexIndex>(*number > 0 ? *number - 1 : *number + count);
  }

  // Whether a vertex belongs to faces of two groups: then the groups are parts of one surface, not bodies.
  [[nodiscard]] bool groups_share_vertices() const {
    std::vector<std::size_t> group_of(mesh_.vertices.size(), no_group);
    for (const NamedFace& face : faces_) {
      for (const VertexIndex v : face.face.outline) {
        if (group_of[v] != no_group && group_of[v] != face.group) return true;
        group_of[v] = face.group;
      }
    }
    return false;
  }

  void gather() {
    const bool of_groups = !has_objects_ && has_groups_ && !groups_share_vertices();
    mesh_.grouped = has_objects_ || of_groups;
    mesh_.precision = precision_.result(mesh_.vertices);
    note_others();
    std::vector<std::string> names(numbers_.size() + 1);
    for (const auto& [text, number] : numbers_) names[number] = text;
    std::map<std::size_t, std::size_t> bodies;  // by number of the name
    std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> materials;
    std::vector<std::vector<std::uint32_t>> materials_of;  // the faces of each body
    std::vector<std::vector<std::uint32_t>> numbers_of;    // in the file
    for (std::uint32_t number = 0; number < faces_.size(); ++number) {
      NamedFace& face = faces_[number];
      const std::size_t key = has_objects_ ? face.object : of_groups ? face.group : 0;
      const auto [place, added] = bodies.try_emplace(key, mesh_.bodies.size());
      if (added) {
        mesh_.bodies.push_back({names[key], false, {}});
        materials_of.emplace_back();
        numbers_of.emplace_back();
      }
      numbers_of[place->second].push_back(number);
      mesh_.bodies[place->second].faces.push_back(std::move(face.face));
      const std::pair<std::size_t, std::size_t> look{face.material, of_groups ? 0 : face.group};
      materials_of[place->second].push_back(
          materials.try_emplace(look, static_cast<std::uint32_t>(materials.size())).first->second);
    }
    if (numbers_of.size() > 1)
      for (const auto& of_body : numbers_of) mesh_.face_in_file.insert(mesh_.face_in_file.end(), of_body.begin(), of_body.end());
    if (materials.size() < 2) return;
    for (const auto& of_body : materials_of) mesh_.materials.insert(mesh_.materials.end(), of_body.begin(), of_body.end());
  }

  void note_others() {
    for (const auto& [word, count] : others_) {
      if (mesh_.notes.size() == most_notes) {
        mesh_.notes.push_back("others of " + std::to_string(others_.size() - most_notes) + " kinds");
        break;
      }
      mesh_.notes.push_back(std::to_string(count) + (count == 1 ? " statement " : " statements ") + quoted_excerpt(word));
    }
  }

  PolyLines lines_;
  PolyMesh mesh_;
  std::map<std::string, std::size_t> numbers_;
  std::vector<NamedFace> faces_;
  std::size_t object_ = 0;
  std::size_t group_ = 0;
  std::size_t material_ = 0;
  bool has_objects_ = false;
  bool has_groups_ = false;
  TextPrecision precision_;
  std::map<std::string, std::size_t> others_;  // statements that are passed over, and how many
  std::size_t last_ahead_ = 0;  // the highest number of a vertex that was named before it was there
  base::Error ahead_;           // if it never comes: where it was named
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<PolyMesh> read_obj(std::string_view text, std::string_view source) {
  return ObjReader(text, source).run();
}

}  // namespace sightline::scene
