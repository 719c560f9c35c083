// See plain_mesh.hpp.
#include "tests/support/plain_mesh.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace sightline::tests {
namespace {

using Words = std::vector<std::string>;

// Vertices and faces as in the file.
struct RawMesh {
  std::vector<Point3> vertices;
  std::vector<std::vector<std::int64_t>> faces;
  std::vector<std::vector<std::int64_t>> lines;
  int decimals = -1;  // the largest number of decimals of a coordinate; -1: the file is binary
};

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what);
}

Words words_of(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

double number_of(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(value)) fail("found \"" + word + "\", expected a number");
  return value;
}

std::int64_t whole_of(const std::string& word) {
  const double value = number_of(word);
  if (value != std::floor(value) || std::abs(value) > 1e9) fail("found \"" + word + "\", expected a whole number");
  return static_cast<std::int64_t>(value);
}

// The number of digits after the point, without zeros at the end, less the exponent.
int decimals_of(const std::string& word) {
  const std::size_t exponent = std::min(word.find_first_of("eE"), word.size());
  const std::size_t point = std::min(word.find('.'), exponent);
  const std::size_t last = word.find_last_not_of('0', exponent - 1);
  const int digits = point == exponent || last == std::string::npos || last < point ? 0 : static_cast<int>(last - point);
  return digits - (exponent < word.size() ? std::atoi(word.c_str() + exponent + 1) : 0);
}

void add_vertex(RawMesh& mesh, const Words& words, std::size_t first) {
  if (words.size() < first + 3) fail("found a vertex of less than three numbers");
  Point3 point{};
  for (std::size_t a = 0; a < 3; ++a) {
    point[a] = number_of(words[first + a]);
    mesh.decimals = std::max(mesh.decimals, decimals_of(words[first + a]));
  }
  mesh.vertices.push_back(point);
}

std::vector<Words> lines_of(const std::string& text, bool with_comments) {
  std::vector<Words> lines;
  std::istringstream stream(text);
  std::string whole;
  for (std::string line; std::getline(stream, line);) {
    if (with_comments) line.resize(std::min(line.find('#'), line.size()));
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())) != 0) line.pop_back();
    if (!line.empty() && line.back() == '\\' && with_comments) {
      whole += line.substr(0, line.size() - 1) + " ";
      continue;
    }
    Words words = words_of(whole + line);
    whole.clear();
    if (!words.empty()) lines.push_back(std::move(words));
  }
  return lines;
}

RawMesh read_off(const std::string& text) {
  RawMesh mesh;
  const auto lines = lines_of(text, true);
  std::size_t at = 0;
  if (lines.empty() || !lines[0][0].ends_with("OFF")) fail("found no \"OFF\"");
  Words counts(lines[0].begin() + 1, lines[0].end());
  if (counts.empty()) {
    if (lines.size() < 2) fail("found no counts");
    counts = lines[++at];
  }
  if (counts.size() < 2) fail("found less than two counts");
  const std::int64_t vertices = whole_of(counts[0]);
  const std::int64_t faces = whole_of(counts[1]);
  for (std::int64_t i = 0; i < vertices; ++i) {
    if (++at >= lines.size()) fail("the file ends before its last vertex");
    add_vertex(mesh, lines[at], 0);
  }
  for (std::int64_t i = 0; i < faces; ++i) {
    if (++at >= lines.size()) fail("the file ends before its last face");
    const std::int64_t corners = whole_of(lines[at][0]);
    if (corners < 0 || static_cast<std::int64_t>(lines[at].size()) <= corners) fail("found a face without its corners");
    mesh.faces.emplace_back();
    for (std::int64_t c = 1; c <= corners; ++c)
      mesh.faces.back().push_back(whole_of(lines[at][static_cast<std::size_t>(c)]));
  }
  return mesh;
}

RawMesh read_obj(const std::string& text) {
  RawMesh mesh;
  for (const Words& words : lines_of(text, true)) {
    if (words[0] == "v") add_vertex(mesh, words, 1);
    if (words[0] != "f" && words[0] != "l") continue;
    auto& statements = words[0] == "f" ? mesh.faces : mesh.lines;
    statements.emplace_back();
    for (std::size_t c = 1; c < words.size(); ++c) {
      const std::int64_t number = whole_of(words[c].substr(0, words[c].find('/')));
      const auto count = static_cast<std::int64_t>(mesh.vertices.size());
      if (number == 0 || number > count || number < -count) fail("found \"" + words[c] + "\", expected a vertex");
      statements.back().push_back(number > 0 ? number - 1 : count + number);
    }
  }
  return mesh;
}

// Reads numbers of a binary file.
class Bytes {
 public:
  Bytes(const std::string& text, std::size_t at, bool big_endian) : text_(text), at_(at), big_endian_(big_endian) {}

  template <class Value>
  [[nodiscard]] double next() {
    std::array<char, sizeof(Value)> bytes{};
    if (text_.size() - at_ < sizeof(Value)) fail("the file ends too early");
    std::memcpy(bytes.data(), text_.data() + at_, sizeof(Value));
    at_ += sizeof(Value);
    if (big_endian_ == (std::endian::native == std::endian::little)) std::reverse(bytes.begin(), bytes.end());
    return static_cast<double>(std::bit_cast<Value>(bytes));
  }
  [[nodiscard]] double next(const std::string& type) {
    if (type == "char" || type == "int8") return next<std::int8_t>();
    if (type == "uchar" || type == "uint8") return next<std::uint8_t>();
    if (type == "short" || type == "int16") return next<std::int16_t>();
    if (type == "ushort" || type == "uint16") return next<std::uint16_t>();
    if (type == "int" || type == "int32") return next<std::int32_t>();
    if (type == "uint" || type == "uint32") return next<std::uint32_t>();
    if (type == "float" || type == "float32") return next<float>();
    if (type == "double" || type == "float64") return next<double>();
    fail("found the type \"" + type + "\"");
  }
  void skip(std::size_t bytes) { at_ = std::min(at_ + bytes, text_.size()); }

 private:
  const std::string& text_;
  std::size_t at_;
  bool big_endian_;
};

RawMesh read_stl(const std::string& text) {
  RawMesh mesh;
  constexpr std::size_t header = 80;
  constexpr std::size_t facet = 50;
  std::size_t count = 0;
  bool binary = false;
  if (text.size() >= header + 4) {
    count = static_cast<std::size_t>(Bytes(text, header, false).next<std::uint32_t>());
    binary = text.size() == header + 4 + facet * count;
  }
  if (binary) {
    Bytes bytes(text, header + 4, false);
    for (std::size_t i = 0; i < count; ++i) {
      bytes.skip(12);
      mesh.faces.emplace_back();
      for (int corner = 0; corner < 3; ++corner) {
        mesh.faces.back().push_back(static_cast<std::int64_t>(mesh.vertices.size()));
        const double x = bytes.next<float>();
        const double y = bytes.next<float>();
        mesh.vertices.push_back({x, y, bytes.next<float>()});
      }
      bytes.skip(2);
    }
    return mesh;
  }
  for (const Words& words : lines_of(text, false)) {
    if (words[0] != "vertex") continue;
    if (mesh.vertices.size() % 3 == 0) mesh.faces.emplace_back();
    mesh.faces.back().push_back(static_cast<std::int64_t>(mesh.vertices.size()));
    add_vertex(mesh, words, 1);
  }
  if (mesh.vertices.size() % 3 != 0) fail("found a facet of less than three vertices");
  return mesh;
}

struct PlyProperty {
  std::string name;
  std::string type;
  std::string count_type;  // of a list
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

RawMesh read_ply(const std::string& text) {
  RawMesh mesh;
  constexpr std::string_view end_of_header = "end_header";
  const std::size_t end = text.find(end_of_header);
  const std::size_t data = text.find('\n', end == std::string::npos ? text.size() : end);
  if (!text.starts_with("ply") || data == std::string::npos) fail("found no header");
  std::string format;
  std::vector<PlyElement> elements;
  for (const Words& words : lines_of(text.substr(0, end), false)) {
    if (words[0] == "format" && words.size() > 1) format = words[1];
    if (words[0] == "element" && words.size() > 2) elements.push_back({words[1], whole_of(words[2]), {}});
    if (words[0] != "property" || elements.empty()) continue;
    if (words.size() == 3) elements.back().properties.push_back({words[2], words[1], ""});
    if (words.size() == 5) elements.back().properties.push_back({words[4], words[3], words[2]});
  }
  const bool text_format = format == "ascii";
  std::istringstream numbers(text_format ? text.substr(data) : "");
  Bytes bytes(text, data + 1, format == "binary_big_endian");
  int decimals = 0;
  const auto next = [&](const std::string& type) {
    if (!text_format) return bytes.next(type);
    std::string word;
    if (!(numbers >> word)) fail("the file ends too early");
    decimals = decimals_of(word);
    return number_of(word);
  };
  for (const PlyElement& element : elements) {
    for (std::int64_t i = 0; i < element.count; ++i) {
      Point3 point{};
      for (const PlyProperty& property : element.properties) {
        const bool is_list = !property.count_type.empty();
        const auto count = static_cast<std::int64_t>(is_list ? next(property.count_type) : 1);
        const bool is_face = element.name == "face" && is_list && property.name.starts_with("vertex_ind");
        if (is_face) mesh.faces.emplace_back();
        for (std::int64_t k = 0; k < count; ++k) {
          const double value = next(property.type);
          if (is_face) mesh.faces.back().push_back(static_cast<std::int64_t>(value));
          if (property.name.size() != 1 || property.name < "x" || property.name > "z") continue;
          point[static_cast<std::size_t>(property.name[0] - 'x')] = value;
          if (text_format && element.name == "vertex") mesh.decimals = std::max(mesh.decimals, decimals);
        }
      }
      if (element.name == "vertex") mesh.vertices.push_back(point);
    }
  }
  return mesh;
}

double size_of(const PlainMesh& mesh) {
  double size = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto [low, high] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                                 [a](const Point3& p, const Point3& q) { return p[a] < q[a]; });
    size = std::max(size, (*high)[a] - (*low)[a]);
  }
  return size;
}

// Merges equal vertices. Leaves out corners equal to the corner before them, faces with fewer than three corners, repeated
// faces, and vertices without faces.
PlainMesh plain(const RawMesh& raw) {
  PlainMesh mesh;
  std::map<Point3, std::uint32_t> numbers;
  std::set<std::vector<std::uint32_t>> known;
  double largest = 0;
  const auto vertex = [&](std::int64_t corner) {
    if (corner < 0 || corner >= static_cast<std::int64_t>(raw.vertices.size())) fail("found a corner that is no vertex");
    Point3 point = raw.vertices[static_cast<std::size_t>(corner)];
    for (double& c : point) {
      c += 0.0;  // no -0
      largest = std::max(largest, std::abs(c));
    }
    const auto [place, is_new] = numbers.emplace(point, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(point);
    return place->second;
  };
  for (const auto& corners : raw.faces) {
    std::vector<std::uint32_t> face;
    for (const std::int64_t corner : corners) {
      const std::uint32_t number = vertex(corner);
      if (face.empty() || face.back() != number) face.push_back(number);
    }
    while (face.size() > 1 && face.back() == face.front()) face.pop_back();
    std::vector<std::uint32_t> sorted = face;
    std::sort(sorted.begin(), sorted.end());
    if (face.size() >= 3 && known.insert(sorted).second) mesh.faces.push_back(std::move(face));
  }
  for (const auto& line : raw.lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const std::array<std::uint32_t, 2> step{vertex(line[i - 1]), vertex(line[i])};
      if (step[0] != step[1]) mesh.lines.push_back(step);
    }
  }
  if (mesh.faces.empty() && mesh.lines.empty()) fail("found no face and no line");
  const double of_float = std::ldexp(largest, -23);
  // Integers are exact. Numbers with few decimals are taken as exact, too, because half a last digit would be much of the mesh.
  mesh.precision = raw.decimals > 0 ? std::max(std::pow(10.0, -raw.decimals), of_float) : of_float;
  mesh.precision = std::min(mesh.precision, size_of(mesh) / 4000);
  return mesh;
}

}  // namespace

PlainMesh read_plain_mesh(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  std::string ending = path.substr(std::min(path.rfind('.'), path.size()));
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".off") return plain(read_off(text));
  if (ending == ".obj") return plain(read_obj(text));
  if (ending == ".stl") return plain(read_stl(text));
  if (ending == ".ply") return plain(read_ply(text));
  fail("found the ending \"" + ending + "\", expected .off, .obj, .stl or .ply");
}

}  // namespace sightline::tests
