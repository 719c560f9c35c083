// See off.hpp.
#include "host/scene/read/off.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/base/threads.hpp"
#include "host/scene/read/poly_text.hpp"
#include "host/scene/read/precision.hpp"

namespace sightline::scene {
namespace {

// How a file's numbers are laid out.
enum class OffLayout : std::uint8_t {
  lines,   // a line for each vertex and face; numbers of a vertex or face that are not known are ignored
  faces,   // line ends are blanks, but what follows the vertices of a face on its line is its colour
  stream,  // all line ends are blanks, and faces have no colours
};

class OffReader {
 public:
  OffReader(std::string_view text, std::string_view source, OffLayout layout)
      : lines_(text, source), size_(text.size()), layout_(layout) {
    mesh_.source = source;
  }

  base::Result<PolyMesh> run(unsigned jobs) {
    if (read_header() && !(jobs > 1 && read_parts(jobs)) && read_vertices() && read_faces()) {
      if (const std::string_view more = lines_.take(); !more.empty())
        error_ = lines_.unexpected(more, "nothing after the last face");
    }
    if (error_) return *error_;
    if (materials_.size() < 2) mesh_.materials.clear();
    mesh_.materials_are_colours = !mesh_.materials.empty();
    mesh_.precision = precision_.result(mesh_.vertices);
    return std::move(mesh_);
  }

 private:
  bool fail(base::Error error) {
    error_ = std::move(error);
    return false;
  }

  // The keyword, at which `word` begins, is taken from it: ST, C and N in front of OFF, each at most once, in this order or as
  // MeshLab writes them, N first. The first number may stand right behind it.
  bool take_keyword(std::string_view& word) {
    if (word.starts_with("off")) {
      word.remove_prefix(3);
      return word.empty() || base::unsigned_number(word);
    }
    constexpr std::array variants{std::pair{std::string_view("ST"), 2U}, std::pair{std::string_view("C"), 4U},
                                  std::pair{std::string_view("N"), 3U}};
    std::array<bool, variants.size()> taken{};
    for (std::size_t i = 0; i < variants.size();) {
      const auto& [prefix, numbers] = variants[i];
      if (taken[i] || !word.starts_with(prefix)) {
        ++i;
        continue;
      }
      word.remove_prefix(prefix.size());
      more_of_vertex_ += numbers;
      taken[i] = true;
      i = 0;
    }
    if (!word.starts_with("OFF")) return false;
    word.remove_prefix(3);
    return word.empty() || base::unsigned_number(word);
  }

  // The keyword may be missing; the number of edges, too, where everything has a line of its own.
  bool read_header() {
    const std::string_view word = lines_.take();
    if (word.empty()) return fail(lines_.error("found no text, expected OFF"));
    std::string_view vertices = word;
    if (!base::signed_number(word) && !take_keyword(vertices)) {
      const bool off = word.size() > 3 && word.size() < 9 && word.substr(word.size() - 3) == "OFF";
      return fail(lines_.unexpected(word, off ? "OFF, COFF, NOFF, CNOFF or STOFF: points of three dimensions"
                                              : "OFF in the first line"));
    }
    if (vertices.empty()) vertices = lines_.take();
    if (vertices == "BINARY") return fail(lines_.unexpected("BINARY", "OFF as text"));
    const bool one_line = !lines_.rest().empty();
    if (!vertices.empty() && !read_count(vertices, vertices_)) return false;
    const std::string_view faces = lines_.take();
    if (faces.empty()) return fail(lines_.error("expected the numbers of vertices, faces and edges"));
    if (!read_count(faces, faces_)) return false;
    if (layout_ != OffLayout::lines || !one_line || !lines_.rest().empty()) {
      static_cast<void>(lines_.take());
    } else if (lines_.next() && lines_.rest().size() == 1) {
      lines_.pass_over(1);
    }
    if (layout_ == OffLayout::lines && !lines_.rest().empty() && !lines_.at_first_field())
      return fail(lines_.error("expected the numbers of vertices, faces and edges"));
    return true;
  }

  bool read_count(std::string_view field, std::size_t& count) {
    const auto number = base::signed_number(field);
    if (!number || *number < 0 || *number > std::numeric_limits<std::int32_t>::max())
      return fail(lines_.unexpected(field, "a number of vertices or faces"));
    count = static_cast<std::size_t>(*number);
    return true;
  }

  // A line of which nothing was taken.
  bool find_line() { return !lines_.rest().empty() || lines_.next(); }

  bool read_coordinate(std::string_view field, std::size_t i, std::array<double, 3>& point) {
    const auto number = i < 3 ? precision_.read(field) : coordinate_of(field);
    if (!number) return fail(lines_.unexpected(field, "a number"));
    if (i >= 3) return true;
    if (!std::isfinite(*number) && !mesh_.flaw) mesh_.flaw = lines_.unexpected(field, "a finite number");
    point[i] = *number;
    return true;
  }

  bool read_vertices() {
    mesh_.vertices.reserve(std::min(vertices_, size_ / 6));  // "0 0 0\n"
    for (std::size_t v = 0; v < vertices_; ++v) {
      if (!find_line()) {
        return fail(
            lines_.error("found " + std::to_string(v) + " vertices, expected " + std::to_string(vertices_)));
      }
      if (!read_vertex(mesh_.vertices.emplace_back())) return false;
    }
    return true;
  }

  bool read_vertex(std::array<double, 3>& point) {
    if (layout_ == OffLayout::lines) {
      const auto& fields = lines_.fields();
      if (fields.size() < 3)
        return fail(lines_.error("found " + std::to_string(fields.size()) + " numbers, expected x, y and z"));
      for (std::size_t i = 0; i < fields.size(); ++i)
        if (!read_coordinate(fields[i], i, point)) return false;
      lines_.pass_over(fields.size());
    } else {
      for (std::size_t i = 0; i < 3 + more_of_vertex_; ++i)
        if (!read_coordinate(lines_.take(), i, point)) return false;
    }
    return true;
  }

  bool read_faces() {
    mesh_.bodies.emplace_back();
    auto& faces = mesh_.bodies.back().faces;
    faces.reserve(std::min(faces_, size_ / 8));
    for (std::size_t f = 0; f < faces_; ++f) {
      if (!find_line()) {
        return fail(
            lines_.error("found " + std::to_string(f) + " faces, expected " + std::to_string(faces_)));
      }
      if (!read_face(faces.emplace_back())) return false;
    }
    return true;
  }

  // By several threads, if all vertices and faces have a line of their own and nothing is wrong with any. False: nothing was read, and
  // what is wrong has to be found from the first line on. A thread reads every so many-th part, as vertices take longer than faces.
  bool read_parts(unsigned jobs) {
    if (layout_ != OffLayout::lines || !lines_.rest().empty()) return false;
    const std::size_t count = std::size_t{8} * jobs;
    const std::vector<std::string_view> texts = lines_.parts(count);
    std::vector<std::size_t> first(count + 1);  // line of each part
    base::for_parts(jobs, jobs, [&](std::size_t job, std::size_t, std::size_t) {
      for (std::size_t part = job; part < count; part += jobs) first[part + 1] = count_lines(texts[part]);
    });
    for (std::size_t part = 0; part < count; ++part) first[part + 1] += first[part];
    if (first[count] != vertices_ + faces_) return false;
    std::vector<std::array<double, 3>> points(vertices_);
    std::vector<PolyFace> faces(faces_);
    std::vector<std::optional<OffReader>> readers(count);  // empty: something is wrong
    base::for_parts(jobs, jobs, [&](std::size_t job, std::size_t, std::size_t) {
      for (std::size_t part = job; part < count; part += jobs) {
        OffReader reader(texts[part], {}, layout_);
        reader.vertices_ = vertices_;
        bool read = true;
        for (std::size_t line = first[part]; read && line < first[part + 1]; ++line)
          read = reader.lines_.next() && (line < vertices_ ? reader.read_vertex(points[line]) : reader.read_face(faces[line - vertices_]));
        if (read && !reader.mesh_.flaw) readers[part] = std::move(reader);
      }
    });
    for (const auto& reader : readers)
      if (!reader) return false;
    mesh_.vertices = std::move(points);
    mesh_.bodies.emplace_back().faces = std::move(faces);
    for (const auto& reader : readers) take_materials(*reader);
    return true;
  }

  // Those of the next part, and how exactly its numbers are written.
  void take_materials(const OffReader& part) {
    precision_.add(part.precision_);
    std::vector<const std::string*> colours(part.materials_.size());
    for (const auto& [colour, number] : part.materials_) colours[number] = &colour;
    std::vector<std::uint32_t> numbers;
    for (const std::string* colour : colours)
      numbers.push_back(materials_.try_emplace(*colour, static_cast<std::uint32_t>(materials_.size())).first->second);
    for (const std::uint32_t material : part.mesh_.materials) mesh_.materials.push_back(numbers[material]);
  }

  bool read_face(PolyFace& face) {
    // Within a line a small number is rather the sign of a layout that is another one.
    const std::int64_t least = lines_.at_first_field() ? 0 : 3;
    const std::string_view corners = lines_.take();
    const auto count = base::signed_number(corners);
    if (!count || *count < least) return fail(lines_.unexpected(corners, how_many));
    if (*count < 3 && !mesh_.flaw) mesh_.flaw = lines_.unexpected(corners, how_many);
    if (layout_ == OffLayout::lines && static_cast<std::uint64_t>(*count) > lines_.rest().size()) {
      return fail(lines_.error("found " + std::to_string(lines_.rest().size()) + " vertices, expected " +
                               std::to_string(*count)));
    }
    face.outline.reserve(std::min(static_cast<std::size_t>(*count), lines_.rest().size()));
    for (std::int64_t i = 0; i < *count; ++i) {
      const std::string_view field = lines_.take();
      const auto vertex = base::signed_number(field);
      if (!vertex || *vertex < 0 || static_cast<std::size_t>(*vertex) >= vertices_)
        return fail(lines_.unexpected(field, "a vertex below " + std::to_string(vertices_)));
      face.outline.push_back(static_cast<VertexIndex>(*vertex));
    }
    if (layout_ == OffLayout::stream) return true;
    // What follows is a colour, in numbers or as the place in a map.
    colour_.clear();
    for (const std::string_view field : lines_.rest()) (colour_ += field) += ' ';
    lines_.pass_over(lines_.rest().size());
    // Most faces have that of the face before.
    if (materials_.empty() || last_material_->first != colour_)
      last_material_ = materials_.try_emplace(colour_, static_cast<std::uint32_t>(materials_.size())).first;
    mesh_.materials.push_back(last_material_->second);
    return true;
  }

  static constexpr const char* how_many = "how many vertices the face has, 3 or more";

  PolyLines lines_;
  std::size_t size_;
  OffLayout layout_;
  PolyMesh mesh_;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  std::size_t more_of_vertex_ = 0;  // numbers behind x, y and z
  std::map<std::string, std::uint32_t> materials_;  // by the colour as written
  std::map<std::string, std::uint32_t>::const_iterator last_material_;
  std::string colour_;
  TextPrecision precision_;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<PolyMesh> read_off(std::string_view text, std::string_view source, unsigned jobs) {
  auto mesh = OffReader(text, source, OffLayout::lines).run(jobs);
  for (const OffLayout layout : {OffLayout::faces, OffLayout::stream}) {
    if (mesh) break;
    if (auto other = OffReader(text, source, layout).run(jobs)) return other;
  }
  return mesh;
}

}  // namespace sightline::scene
