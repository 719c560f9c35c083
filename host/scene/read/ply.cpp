// See ply.hpp.
#include "host/scene/read/ply.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/base/number.hpp"
#include "host/scene/read/poly_text.hpp"
#include "host/scene/read/precision.hpp"

namespace sightline::scene {
namespace {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyTypeName {
  std::string_view name;
  std::string_view other;
  PlyType type;
  std::size_t bytes;
};
constexpr std::array ply_types{
    PlyTypeName{"char", "int8", PlyType::int8, 1},        PlyTypeName{"uchar", "uint8", PlyType::uint8, 1},
    PlyTypeName{"short", "int16", PlyType::int16, 2},     PlyTypeName{"ushort", "uint16", PlyType::uint16, 2},
    PlyTypeName{"int", "int32", PlyType::int32, 4},       PlyTypeName{"uint", "uint32", PlyType::uint32, 4},
    PlyTypeName{"float", "float32", PlyType::float32, 4}, PlyTypeName{"double", "float64", PlyType::float64, 8},
};

std::size_t bytes_of(PlyType type) {
  return ply_types[static_cast<std::size_t>(type)].bytes;
}

// A number that should be a whole one.
std::string whole_text(double value) {
  constexpr double most = 1e15;
  return std::abs(value) < most && std::floor(value) == value ? std::to_string(static_cast<std::int64_t>(value))
                                                              : std::to_string(value);
}

bool is_float(PlyType type) {
  return type == PlyType::float32 || type == PlyType::float64;
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  // of a list: of its elements
  std::optional<PlyType> count;     // of a list: what counts them
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  // The least bytes that one takes: lists may be empty.
  [[nodiscard]] std::uint64_t least_bytes() const {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : properties) bytes += bytes_of(property.count.value_or(property.type));
    return bytes;
  }
};

enum class PlyEncoding : std::uint8_t { text, little_endian, big_endian };

// The values of a file one after the other, whatever the encoding.
class PlyValues {
 public:
  PlyValues(std::string_view body, std::size_t body_at, std::size_t first_line, char line_end, PlyEncoding encoding,
            std::string_view source)
      : body_(body), body_at_(body_at), line_(first_line), line_end_(line_end), encoding_(encoding), source_(source) {}

  [[nodiscard]] bool is_text() const { return encoding_ == PlyEncoding::text; }
  [[nodiscard]] std::size_t bytes_left() const { return body_.size() - at_; }
  [[nodiscard]] std::string_view written() const { return written_; }  // the last value, of a text

  // The next value; empty at the end of the file, or if it is not of the type. Those of float types may be infinite or
  // NaN.
  std::optional<double> next(PlyType type) {
    last_ = at_;
    if (!is_text()) return next_binary(type);
    at_ = std::min(body_.find_first_not_of(" \t\r\n", at_), body_.size());
    line_ += static_cast<std::size_t>(std::count(body_.begin() + static_cast<std::ptrdiff_t>(last_),
                                                 body_.begin() + static_cast<std::ptrdiff_t>(at_), line_end_));
    const std::size_t end = std::min(body_.find_first_of(" \t\r\n", at_), body_.size());
    written_ = body_.substr(at_, end - at_);
    at_ = end;
    if (is_float(type)) return coordinate_of(written_);
    const auto number = base::decimal_number(written_);
    if (!number) return number;
    return std::floor(*number) == *number ? number : std::nullopt;
  }

  // False at the end of the file.
  bool skip(PlyType type) {
    if (is_text()) {
      static_cast<void>(next(PlyType::float64));
      return !written_.empty();
    }
    last_ = at_;
    if (bytes_left() < bytes_of(type)) return false;
    at_ += bytes_of(type);
    return true;
  }

  [[nodiscard]] base::Error error(std::string found, std::string expected) const {
    const std::string place = is_text() ? "line " + std::to_string(line_) : "byte " + std::to_string(body_at_ + last_);
    return {source_, place, std::move(found), std::move(expected)};
  }
  // What is wrong with the value that next() did not return.
  [[nodiscard]] base::Error no_value(PlyType type) const {
    return error(written_.empty() ? "found the end of the file" : "found " + quoted_excerpt(written_),
                 is_float(type) ? "a number" : "a whole number");
  }
  // The same of one that it returned.
  [[nodiscard]] base::Error not_finite() const {
    return error(is_text() ? "found " + quoted_excerpt(written_) : "found a coordinate that is no finite number",
                 "a finite number");
  }

 private:
  std::optional<double> next_binary(PlyType type) {
    const std::size_t size = bytes_of(type);
    if (bytes_left() < size) return std::nullopt;
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t place = encoding_ == PlyEncoding::little_endian ? i : size - 1 - i;
      word |= std::uint64_t{static_cast<std::uint8_t>(body_[at_ + i])} << (8 * place);
    }
    at_ += size;
    return value_of_bits(type, word);
  }

  static double value_of_bits(PlyType type, std::uint64_t word) {
    switch (type) {
      case PlyType::int8: return static_cast<std::int8_t>(word);
      case PlyType::int16: return static_cast<std::int16_t>(word);
      case PlyType::int32: return static_cast<std::int32_t>(word);
      case PlyType::float32: return std::bit_cast<float>(static_cast<std::uint32_t>(word));
      case PlyType::float64: return std::bit_cast<double>(word);
      default: return static_cast<double>(word);
    }
  }

  std::string_view body_;
  std::size_t body_at_;  // in the file
  std::size_t line_;
  char line_end_;
  PlyEncoding encoding_;
  std::string source_;
  std::size_t at_ = 0;
  std::size_t last_ = 0;
  std::string_view written_;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, std::string_view source) : bytes_(bytes), source_(source) {}

  base::Result<PolyMesh> run() {
    read_header();
    if (!error_) read_body();
    if (error_) return *error_;
    mesh_.source = source_;
    return std::move(mesh_);
  }

 private:
  // --- the header

  void fail_at_line(const std::string& found, const std::string& expected) {
    if (!error_) error_ = base::Error{source_, "line " + std::to_string(line_), found, expected};
  }

  // The fields of the next line of the header.
  std::vector<std::string_view> header_line() {
    ++line_;
    const std::size_t end = bytes_.find(line_end_, at_);
    if (end == std::string_view::npos) {
      fail_at_line("found no end of the header", "\"end_header\"");
      return {};
    }
    std::vector<std::string_view> fields;
    std::string_view line = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    while (true) {
      const std::size_t first = line.find_first_not_of(" \t\r");
      if (first == std::string_view::npos) return fields;
      line.remove_prefix(first);
      const std::size_t length = std::min(line.find_first_of(" \t\r"), line.size());
      fields.push_back(line.substr(0, length));
      line.remove_prefix(length);
    }
  }

  void read_header() {
    // Old Macintosh programs end lines by CR alone. The byte behind the header may be an LF then, and belongs to the body.
    const std::size_t end = bytes_.find_first_of("\r\n");
    if (end != std::string_view::npos && end + 1 < bytes_.size() && bytes_[end] == '\r' && bytes_[end + 1] != '\n') line_end_ = '\r';
    const auto magic = header_line();
    if (!error_ && (magic.size() != 1 || magic[0] != "ply")) fail_at_line("found another text", "\"ply\"");
    bool format = false;
    while (!error_) {
      const auto fields = header_line();
      if (error_ || fields.empty() || fields[0] == "comment" || fields[0] == "obj_info") continue;
      if (fields[0] == "end_header") break;
      if (fields[0] == "format") {
        format = true;
        read_format(fields);
      } else if (fields[0] == "element") {
        read_element(fields);
      } else if (fields[0] == "property") {
        read_property(fields);
      } else {
        mesh_.notes.push_back("line " + std::to_string(line_) + " of the header, " + quoted_excerpt(fields[0]));
      }
    }
    if (!error_ && !format) fail_at_line("found no format", "\"format ascii 1.0\", binary_little_endian or binary_big_endian");
  }

  void read_format(const std::vector<std::string_view>& fields) {
    const std::string_view name = fields.size() == 3 && fields[2] == "1.0" ? fields[1] : "";
    if (name == "ascii") {
      encoding_ = PlyEncoding::text;
    } else if (name == "binary_little_endian") {
      encoding_ = PlyEncoding::little_endian;
    } else if (name == "binary_big_endian") {
      encoding_ = PlyEncoding::big_endian;
    } else {
      fail_at_line("found another format", "ascii, binary_little_endian or binary_big_endian, and 1.0");
    }
  }

  void read_element(const std::vector<std::string_view>& fields) {
    const auto count = fields.size() == 3 ? base::unsigned_number(fields[2]) : std::nullopt;
    if (!count || *count > std::numeric_limits<std::int32_t>::max())
      return fail_at_line("found " + quoted_excerpt(fields.back()), "element NAME COUNT, below 2147483648");
    elements_.push_back({std::string(fields[1]), *count, {}});
  }

  std::optional<PlyType> type_named(std::string_view name) {
    for (const PlyTypeName& type : ply_types)
      if (name == type.name || name == type.other) return type.type;
    fail_at_line("found " + quoted_excerpt(name), "char, uchar, short, ushort, int, uint, float or double");
    return std::nullopt;
  }

  void read_property(const std::vector<std::string_view>& fields) {
    const bool list = fields.size() == 5 && fields[1] == "list";
    if (elements_.empty() || (!list && fields.size() != 3))
      return fail_at_line("found a property that is none", "property TYPE NAME or property list TYPE TYPE NAME, of an element");
    PlyProperty property;
    property.name = std::string(fields.back());
    const auto type = type_named(fields[list ? 3 : 1]);
    if (!type) return;
    property.type = *type;
    if (list) {
      property.count = type_named(fields[2]);
      if (!property.count) return;
    }
    elements_.back().properties.push_back(std::move(property));
  }

  // --- the body

  void read_body() {
    PlyValues values(bytes_.substr(at_), at_, line_ + 1, line_end_, encoding_, source_);
    const auto has_element = [&](std::string_view name) {
      return std::any_of(elements_.begin(), elements_.end(), [name](const PlyElement& element) { return element.name == name; });
    };
    const bool surface = has_element("face") || has_element("tristrips");
    if (!surface || !has_element("vertex")) {
      error_ = base::Error{source_, "the header", std::string("found no element ") + (surface ? "vertex" : "face"),
                           "vertices and faces",
                           surface ? "" : "a cloud of points has no surface: make a mesh of it first"};
      return;
    }
    mesh_.bodies.emplace_back();
    bool vertices = false;
    bool faces = false;
    bool strips = false;
    for (const PlyElement& element : elements_) {
      if (element.properties.empty() && element.name != "vertex" && element.name != "face") continue;
      const std::uint64_t least = values.is_text() ? 2 * element.properties.size() : element.least_bytes();
      // The last number of a text needs no blank after it.
      if (element.count > 0 && (least == 0 || (values.bytes_left() + 1) / least < element.count)) {
        error_ = base::Error{
            source_, "the header",
            "found " + std::to_string(element.count) + " of the element " + quoted_excerpt(element.name),
            "no more than the file has room for", "the file is cut off, or its header is damaged"};
        return;
      }
      if (element.name == "vertex" && !vertices) {
        vertices = true;
        vertices_ = read_vertices(element, values);
      } else if (element.name == "face" && !faces) {
        faces = true;
        read_faces(element, values);
      } else if (element.name == "tristrips" && !strips) {
        strips = true;
        read_strips(element, values);
      } else {
        if (element.count > 0)
          mesh_.notes.push_back(std::to_string(element.count) + " of the element " +
                                quoted_excerpt(element.name));
        for (std::uint64_t i = 0; i < element.count && !error_; ++i)
          for (const PlyProperty& property : element.properties) pass_over(property, values);
      }
      if (error_) return;
    }
    if (!mesh_.materials.empty()) add_uncoloured();
    if (materials_.size() < 2) mesh_.materials.clear();
    mesh_.materials_are_colours = !mesh_.materials.empty();
    // Faces may come before the vertices.
    for (const PolyFace& face : mesh_.bodies[0].faces)
      for (const VertexIndex v : face.outline)
        if (v >= mesh_.vertices.size() && !error_)
          error_ = base::Error{source_, "", "found vertex " + std::to_string(v),
                               "one below " + std::to_string(mesh_.vertices.size())};
  }

  double value(PlyType type, PlyValues& values) {
    if (error_) return 0;
    const auto number = values.next(type);
    if (!number) error_ = values.no_value(type);
    return number.value_or(0);
  }

  // How long a list is; no longer than the file.
  std::size_t length(const PlyProperty& property, PlyValues& values) {
    const double count = value(*property.count, values);
    if (error_) return 0;
    const std::size_t least = values.is_text() ? 1 : bytes_of(property.type);
    if (!(count >= 0) || std::floor(count) != count || count > static_cast<double>(values.bytes_left() / least)) {
      error_ = values.error("found a list of " + whole_text(count), "no more than the file has room for");
      return 0;
    }
    return static_cast<std::size_t>(count);
  }

  void pass_over(const PlyProperty& property, PlyValues& values) {
    const std::size_t count = property.count ? length(property, values) : 1;
    for (std::size_t i = 0; i < count && !error_; ++i)
      if (!values.skip(property.type))
        error_ = values.error("found the end of the file", "a value of " + quoted_excerpt(property.name));
  }

  bool read_vertices(const PlyElement& element, PlyValues& values) {
    std::array<std::size_t, 3> places{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::string name(1, "xyz"[a]);
      while (places[a] < element.properties.size() && element.properties[places[a]].name != name) ++places[a];
      if (places[a] == element.properties.size() || element.properties[places[a]].count) {
        error_ = base::Error{source_, "the header", "found no property " + name + " of vertices", "x, y and z"};
        return false;
      }
    }
    mesh_.vertices.reserve(static_cast<std::size_t>(element.count));
    TextPrecision precision;
    for (std::uint64_t v = 0; v < element.count && !error_; ++v) {
      std::array<double, 3> point{};
      for (std::size_t p = 0; p < element.properties.size() && !error_; ++p) {
        const auto axis = static_cast<std::size_t>(std::find(places.begin(), places.end(), p) - places.begin());
        if (axis == 3) {
          pass_over(element.properties[p], values);
        } else {
          point[axis] = value(element.properties[p].type, values);
          if (!std::isfinite(point[axis]) && !mesh_.flaw) mesh_.flaw = values.not_finite();
          if (values.is_text()) precision.add(values.written(), point[axis]);
        }
      }
      mesh_.vertices.push_back(point);
    }
    const PlyType type = element.properties[places[0]].type;
    if (values.is_text()) {
      mesh_.precision = precision.result(mesh_.vertices);
    } else if (is_float(type)) {
      mesh_.precision = type == PlyType::float32 ? float32_precision(mesh_.vertices) : float64_precision(mesh_.vertices);
    }
    return true;
  }

  // Which property is the list of vertices; else an error.
  std::optional<std::size_t> list_of_vertices(const PlyElement& element) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.count && (property.name == "vertex_indices" || property.name == "vertex_index")) return p;
    }
    error_ = base::Error{source_, "the header", "found no list of the vertices of the element " + quoted_excerpt(element.name),
                         "vertex_indices or vertex_index"};
    return std::nullopt;
  }

  std::uint32_t material_of(const std::array<double, 3>& colour) {
    return materials_.try_emplace(colour, static_cast<std::uint32_t>(materials_.size())).first->second;
  }

  // Faces without a colour, up to the last one, have one material.
  void add_uncoloured() {
    constexpr std::array<double, 3> none{-2, -2, -2};
    if (mesh_.materials.size() < mesh_.bodies[0].faces.size())
      mesh_.materials.resize(mesh_.bodies[0].faces.size(), material_of(none));
  }

  void read_faces(const PlyElement& element, PlyValues& values) {
    constexpr std::array<std::string_view, 3> colours{"red", "green", "blue"};
    bool coloured = false;
    for (const PlyProperty& property : element.properties)
      coloured = coloured || (!property.count && property.name == colours[0]);
    const auto corners = list_of_vertices(element);
    if (!corners) return;
    std::vector<PolyFace>& faces = mesh_.bodies[0].faces;
    faces.reserve(faces.size() + static_cast<std::size_t>(element.count));
    if (coloured) add_uncoloured();
    for (std::uint64_t f = 0; f < element.count && !error_; ++f) {
      std::array<double, 3> colour{};
      for (std::size_t p = 0; p < element.properties.size() && !error_; ++p) {
        const PlyProperty& property = element.properties[p];
        const auto c = static_cast<std::size_t>(std::find(colours.begin(), colours.end(), property.name) - colours.begin());
        if (p == *corners) {
          faces.push_back(face(property, f, values));
        } else if (c < 3 && !property.count) {
          colour[c] = value(property.type, values);
          if (!std::isfinite(colour[c])) colour[c] = -1;
        } else {
          pass_over(property, values);
        }
      }
      if (coloured) mesh_.materials.push_back(material_of(colour));
    }
  }

  PolyFace face(const PlyProperty& property, std::uint64_t number, PlyValues& values) {
    PolyFace result;
    const std::size_t count = length(property, values);
    if (!error_ && count < 3 && !mesh_.flaw)
      mesh_.flaw = values.error(
          "found face " + std::to_string(number) + " of " + std::to_string(count) + " vertices", "3 or more");
    result.outline.reserve(count);
    const double limit = vertex_limit();
    for (std::size_t i = 0; i < count && !error_; ++i) {
      const double v = value(property.type, values);
      if (is_vertex(v, limit, values)) result.outline.push_back(static_cast<VertexIndex>(v));
    }
    return result;
  }

  // Vertices that are read, or as many as there may be.
  [[nodiscard]] double vertex_limit() const {
    return static_cast<double>(vertices_ ? mesh_.vertices.size() : std::size_t{1} << 31U);
  }

  // Whether there is such a vertex; else an error.
  bool is_vertex(double v, double limit, const PlyValues& values) {
    if (!error_ && !(v >= 0 && v < limit && std::floor(v) == v))
      error_ = values.error("found vertex " + whole_text(v), "0 to " + whole_text(limit - 1));
    return !error_;
  }

  // Strips of triangles: each vertex makes one with the two before it, every other one of them turned; -1 begins a new
  // strip. Triangles with the same vertex twice join parts of a strip, and are none.
  void read_strips(const PlyElement& element, PlyValues& values) {
    const auto corners = list_of_vertices(element);
    if (!corners) return;
    for (std::uint64_t s = 0; s < element.count && !error_; ++s) {
      for (std::size_t p = 0; p < element.properties.size() && !error_; ++p) {
        const PlyProperty& property = element.properties[p];
        if (p != *corners) {
          pass_over(property, values);
          continue;
        }
        std::vector<VertexIndex> strip;
        const std::size_t count = length(property, values);
        for (std::size_t i = 0; i < count && !error_; ++i) {
          constexpr double minus_one = 0xffffffff;  // of an unsigned type
          const double v = value(property.type, values);
          if (v == -1 || (v == minus_one && property.type == PlyType::uint32)) {
            add_strip(strip, values);
            strip.clear();
          } else if (is_vertex(v, vertex_limit(), values)) {
            strip.push_back(static_cast<VertexIndex>(v));
          }
        }
        add_strip(strip, values);
      }
    }
  }

  void add_strip(const std::vector<VertexIndex>& strip, const PlyValues& values) {
    std::vector<PolyFace>& faces = mesh_.bodies[0].faces;
    if (!strip.empty() && strip.size() < 3) {
      if (!mesh_.flaw) mesh_.flaw = values.error("found a strip of " + std::to_string(strip.size()) + " vertices", "3 or more");
      faces.push_back({strip, {}});
    }
    for (std::size_t i = 2; i < strip.size(); ++i) {
      const VertexIndex a = strip[i - (i % 2 == 0 ? 2 : 1)];
      const VertexIndex b = strip[i - (i % 2 == 0 ? 1 : 2)];
      if (a != b && a != strip[i] && b != strip[i]) faces.push_back({{a, b, strip[i]}, {}});
    }
  }

  std::string_view bytes_;
  std::string source_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  PlyEncoding encoding_ = PlyEncoding::text;
  char line_end_ = '\n';
  std::vector<PlyElement> elements_;
  std::map<std::array<double, 3>, std::uint32_t> materials_;  // by colour
  bool vertices_ = false;  // are read
  PolyMesh mesh_;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<PolyMesh> read_ply(std::string_view bytes, std::string_view source) {
  return PlyReader(bytes, source).run();
}

}  // namespace sightline::scene
