// The C interface of the WebAssembly module for JavaScript: arrays and options in, columns out, for one scene at a time.
// module.js is the only caller.
//
// Names and texts are written to the buffer of `buffer`, one after the other, and their lengths are arguments. A function that
// returns 0 has failed: get("error.found") and its likes tell why. The only function imported is `progress`.
#include <wasi/api.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/watch.hpp"
#include "host/bindings/cpp/arrays.hpp"
#include "host/bindings/npm/options.hpp"
#include "host/picture/png.hpp"
#include "host/scene/model/file_units.hpp"

#define SIGHTLINE_EXPORT_AS(name) extern "C" __attribute__((export_name(#name)))

// Gets the part of the work that is done; 0: end the work.
extern "C" __attribute__((import_module("sightline"), import_name("progress"))) int sightline_progress(double done);

namespace sightline::picture {

base::Result<base::Bytes> encode_png(const Image&, const TextEntries&, double) {
  return base::Error{.file = "format", .found = "found \"png\"", .expected = "svg, pdf, dxf, hpgl or steps", .kind = base::ErrorKind::usage};
}

}  // namespace sightline::picture

namespace {

using namespace sightline;

// --------------------------------------------------------------------------------------------------------- Pictures

// What Drawing::file needs as bytes, so that JavaScript can keep it. Read by the same module only.
class Bytes {
 public:
  template <class Value>
  void add(const Value& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class Value>
  void add_all(const std::vector<Value>& values) {
    add(static_cast<std::uint32_t>(values.size()));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class BytesReader {
 public:
  explicit BytesReader(std::string_view bytes) : bytes_(bytes) {}

  template <class Value>
  Value next() {
    Value value{};
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
    return value;
  }
  template <class Container>
  Container next_all() {
    Container values;
    values.resize(next<std::uint32_t>());
    const std::size_t size = values.size() * sizeof(values[0]);
    if (size != 0) std::memcpy(values.data(), bytes_.data(), size);
    bytes_.remove_prefix(size);
    return values;
  }

 private:
  std::string_view bytes_;
};

std::string bytes_of(const Drawing::Picture& picture) {
  Bytes bytes;
  bytes.add(picture.width);
  bytes.add(picture.height);
  const picture::VectorDrawing& drawing = picture.drawing;
  bytes.add(drawing.width);
  bytes.add(drawing.height);
  bytes.add_all(drawing.points);
  bytes.add_all(drawing.lines);
  bytes.add(static_cast<std::uint32_t>(drawing.layers.size()));
  for (const picture::DrawingLayer& layer : drawing.layers) {
    bytes.add_all(std::vector<char>(layer.label.begin(), layer.label.end()));
    bytes.add(layer.colour);
    bytes.add(layer.dash);
  }
  return bytes.take();
}

Drawing::Picture picture_of(std::string_view given) {
  BytesReader bytes(given);
  Drawing::Picture result;
  result.width = bytes.next<double>();
  result.height = bytes.next<double>();
  picture::VectorDrawing& drawing = result.drawing;
  drawing.width = bytes.next<double>();
  drawing.height = bytes.next<double>();
  drawing.points = bytes.next_all<std::vector<picture::DrawingPoint>>();
  drawing.lines = bytes.next_all<std::vector<picture::DrawingLine>>();
  drawing.layers.resize(bytes.next<std::uint32_t>());
  for (picture::DrawingLayer& layer : drawing.layers) {
    layer.label = bytes.next_all<std::string>();
    layer.colour = bytes.next<picture::Colour>();
    layer.dash = bytes.next<double>();
  }
  return result;
}

// ------------------------------------------------------------------------------------------------------------ State

struct Module {
  std::string buffer;
  std::string answer;
  base::Error error;
  Mesh mesh;
  npm::Options options;
  std::optional<hidden_lines::Scene> scene;
  std::optional<hidden_lines::Views> views;  // of the scene
  std::string views_text;                    // npm::Options::draw_text of the views
  Drawing drawing;
};

bool memory_exhausted = false;

Module& module() {
  static Module the_module;
  return the_module;
}

[[noreturn]] void exhaust_memory() {
  memory_exhausted = true;
  __builtin_trap();
}

// Resizes an array and returns its data.
template <class Number>
void* resized(std::vector<Number>& numbers, std::size_t count) {
  if (count > numbers.max_size()) exhaust_memory();
  numbers.resize(count);
  return numbers.data();
}

int fail(base::Error error) {
  module().error = std::move(error);
  return 0;
}

const char* kind_text(base::ErrorKind kind) {
  switch (kind) {
    case base::ErrorKind::usage: return "usage";
    case base::ErrorKind::io: return "io";
    case base::ErrorKind::cancelled: return "cancelled";
    case base::ErrorKind::bad_input:
    case base::ErrorKind::program_failed:
    case base::ErrorKind::differs: break;
  }
  return "bad_input";
}

base::Watch progress_watch() {
  return base::Watch([](double done) { return sightline_progress(done) != 0; });
}

// --------------------------------------------------------------------------------------------------------- Answers

// One value for each row, as bytes.
template <class Row, class Get>
std::string column(const std::vector<Row>& rows, const Get& get) {
  std::string bytes;
  bytes.reserve(rows.size() * sizeof(get(std::declval<const Row&>())));
  for (const Row& row : rows) {
    const auto value = get(row);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return bytes;
}

// Where the numbers of each row begin, and where those of the last one end.
template <class Row>
std::string offsets(const std::vector<Row>& rows, std::uint32_t Row::*count) {
  std::vector<std::uint32_t> all{0};
  for (const Row& row : rows) all.push_back(all.back() + row.*count);
  return column(all, [](std::uint32_t at) { return at; });
}

template <class... Numbers>
std::string bytes_of_numbers(const Numbers&... numbers) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
  return bytes;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

struct Getter {
  std::string_view name;
  std::string (*get)(const Module& m);
};

constexpr auto number = [](std::uint32_t n) { return n; };

constexpr Getter getters[] = {
    {"error.kind", [](const Module& m) -> std::string { return kind_text(m.error.kind); }},
    {"error.argument", [](const Module& m) { return m.error.file; }},
    {"error.place", [](const Module& m) { return m.error.place; }},
    {"error.found", [](const Module& m) { return m.error.found; }},
    {"error.expected", [](const Module& m) { return m.error.expected; }},
    {"error.message", [](const Module& m) { return m.error.message(); }},
    {"scene.counts", [](const Module& m) {
       const scene::PolyScene& scene = m.scene->scene;
       return bytes_of_numbers(static_cast<std::uint32_t>(scene::face_count(scene)), static_cast<std::uint32_t>(scene.vertices.size()));
     }},
    {"scene.bounds", [](const Module& m) {
       const scene::PolyBounds bounds = scene::bounds_of(m.scene->scene);
       return bytes_of_numbers(scene::file_point(m.scene->scene, bounds.low), scene::file_point(m.scene->scene, bounds.high));
     }},
    {"scene.step", [](const Module& m) { return bytes_of_numbers(m.scene->scene.step); }},
    {"scene.notes", [](const Module& m) { return joined(bindings::notes_of(*m.scene)); }},
    {"lines", [](const Module& m) { return column(m.drawing.lines, [](const Line& l) { return std::array{l.from, l.to}; }); }},
    {"kinds", [](const Module& m) { return column(m.drawing.lines, [](const Line& l) { return l.kind; }); }},
    {"hidden", [](const Module& m) { return column(m.drawing.lines, [](const Line& l) { return l.hidden; }); }},
    {"lineEdges", [](const Module& m) { return column(m.drawing.line_edges, number); }},
    {"lineEdgeOffsets", [](const Module& m) { return offsets(m.drawing.lines, &Line::edge_count); }},
    {"parts.edges", [](const Module& m) { return column(m.drawing.parts, [](const Part& p) { return p.edge; }); }},
    {"parts.fractions",
     [](const Module& m) { return column(m.drawing.parts, [](const Part& p) { return std::array{p.low, p.high}; }); }},
    {"parts.hidden", [](const Module& m) { return column(m.drawing.parts, [](const Part& p) { return p.hidden; }); }},
    {"parts.hiddenBy", [](const Module& m) { return column(m.drawing.parts, [](const Part& p) { return p.hidden_by; }); }},
    {"edges.kinds", [](const Module& m) { return column(m.drawing.edges, [](const Edge& e) { return e.kind; }); }},
    {"edges.ends", [](const Module& m) { return column(m.drawing.edges, [](const Edge& e) { return e.ends; }); }},
    {"edges.vertices", [](const Module& m) { return column(m.drawing.edges, [](const Edge& e) { return e.vertices; }); }},
    {"edges.bodies", [](const Module& m) { return column(m.drawing.edges, [](const Edge& e) { return e.body; }); }},
    {"edges.faces", [](const Module& m) { return column(m.drawing.faces, number); }},
    {"edges.faceOffsets", [](const Module& m) { return offsets(m.drawing.edges, &Edge::face_count); }},
    // Perspective (1 or 0), eye, axes, scale, low, error.
    {"camera", [](const Module& m) {
       const Drawing& d = m.drawing;
       return bytes_of_numbers(d.perspective ? 1.0 : 0.0, d.eye, d.axes, d.scale, d.low, d.camera_error);
     }},
    {"notes", [](const Module& m) { return joined(m.drawing.notes); }},
    {"picture", [](const Module& m) { return bytes_of(*m.drawing.picture); }},
};

// Rows are taken as bytes.
static_assert(sizeof(Fraction) == 16 && sizeof(bool) == 1);

}  // namespace

// ---------------------------------------------------------------------------------------------------- The functions

// Called first.
SIGHTLINE_EXPORT_AS(begin) void begin() { std::set_new_handler(exhaust_memory); }

// A buffer for `bytes` bytes, valid until the next call.
SIGHTLINE_EXPORT_AS(buffer) char* buffer(std::uint32_t bytes) {
  module().buffer.resize(bytes);
  return module().buffer.data();
}
// After a trap: whether there was no memory left.
SIGHTLINE_EXPORT_AS(exhausted) int exhausted() { return memory_exhausted ? 1 : 0; }

// The mesh's vertices, three doubles each.
SIGHTLINE_EXPORT_AS(vertices) void* vertices(std::uint32_t count) { return resized(module().mesh.vertices, count); }
// Another array of the mesh: 0 corners, 1 ring_sizes, 2 face_rings, 3 bodies, 4 line_points, 5 line_sizes.
SIGHTLINE_EXPORT_AS(numbers) void* numbers(int array, std::uint32_t count) {
  Mesh& mesh = module().mesh;
  std::vector<std::uint32_t>* const arrays[] = {&mesh.corners, &mesh.ring_sizes,  &mesh.face_rings,
                                                &mesh.bodies,  &mesh.line_points, &mesh.line_sizes};
  return resized(*arrays[array], count);
}

// Sets an option of a call, a npm::Call, by its name. `type` and the numbers, or the text behind the name, are a npm::Value.
SIGHTLINE_EXPORT_AS(option) int option(int call, std::uint32_t name_size, int type, double x, double y, double z, std::uint32_t text_size) {
  Module& m = module();
  const std::string_view given = m.buffer;
  const npm::Value value{static_cast<npm::Value::Type>(type), {x, y, z}, std::string(given.substr(name_size, text_size))};
  auto done = m.options.set(static_cast<npm::Call>(call), given.substr(0, name_size), value);
  return done ? 1 : fail(std::move(done.error()));
}
// Before the options of a call.
SIGHTLINE_EXPORT_AS(reset_options) void reset_options() { module().options = {}; }

// Makes the scene of the mesh, which is then empty again.
SIGHTLINE_EXPORT_AS(load) int load() {
  Module& m = module();
  m.views.reset();
  m.scene.reset();
  auto loaded = bindings::load(std::exchange(m.mesh, {}), m.options.load, progress_watch());
  if (!loaded) return fail(std::move(loaded.error()));
  m.scene = *std::move(loaded);
  return 1;
}

// Makes the drawing. What views with equal options share is computed once.
SIGHTLINE_EXPORT_AS(draw) int draw() {
  Module& m = module();
  m.drawing = {};
  const base::Watch watch = progress_watch();
  const bool prepared = m.views && m.views_text == m.options.draw_text();
  if (!prepared) {
    m.views.reset();
    const auto checked = bindings::view_options(m.options.draw, *m.scene);
    if (!checked) return fail(checked.error());
    auto views = hidden_lines::Views::of(*m.scene, *checked, {}, watch.part(0, 0.3));
    if (!views) return fail(std::move(views.error()));
    m.views = *std::move(views);
    m.views_text = m.options.draw_text();
  }
  auto drawn = bindings::draw(*m.scene, *m.views, m.options.camera, m.options.draw, prepared ? watch : watch.part(0.3, 1));
  if (!drawn) return fail(std::move(drawn.error()));
  m.drawing = *std::move(drawn);
  return 1;
}

// Makes a file of the picture in the buffer, `bytes` bytes; it is the answer.
SIGHTLINE_EXPORT_AS(file) int file(std::uint32_t bytes) {
  Module& m = module();
  Drawing drawing;
  drawing.picture = std::make_shared<const Drawing::Picture>(picture_of(std::string_view(m.buffer).substr(0, bytes)));
  auto written = bindings::file_of(drawing, m.options.file);
  if (!written) return fail(std::move(written.error()));
  m.answer = *std::move(written);
  return 1;
}

// The answer becomes what has the name in the buffer.
SIGHTLINE_EXPORT_AS(get) void get(std::uint32_t name_size) {
  Module& m = module();
  const std::string_view name = std::string_view(m.buffer).substr(0, name_size);
  for (const Getter& each : getters)
    if (each.name == name) m.answer = each.get(m);
}
SIGHTLINE_EXPORT_AS(answer_data) const char* answer_data() { return module().answer.data(); }
SIGHTLINE_EXPORT_AS(answer_size) std::uint32_t answer_size() { return static_cast<std::uint32_t>(module().answer.size()); }

// The system below the C library, of which only errors are reached: there are no files.
__wasi_errno_t __wasi_fd_close(__wasi_fd_t) { return __WASI_ERRNO_BADF; }
__wasi_errno_t __wasi_fd_seek(__wasi_fd_t, __wasi_filedelta_t, __wasi_whence_t, __wasi_filesize_t*) { return __WASI_ERRNO_BADF; }
__wasi_errno_t __wasi_fd_write(__wasi_fd_t, const __wasi_ciovec_t*, std::size_t, __wasi_size_t*) { return __WASI_ERRNO_BADF; }

// Debian's runtime library for wasm32 is compiled with stack protection, but does not define its symbols.
extern "C" {
std::uintptr_t __stack_chk_guard = 0x5349474C;
void __stack_chk_fail() { __builtin_trap(); }
}
