// The part of the Python package that is compiled: sightline._core. It takes arrays and options that sightline/__init__.py has
// checked, works without the interpreter's lock (the GIL), and returns what a drawing consists of as NumPy arrays.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "host/bindings/cpp/hidden_lines.hpp"

namespace py = pybind11;

namespace {

using sightline::Drawing;
using sightline::Edge;
using sightline::Line;
using sightline::Part;
using sightline::Scene;

// A call for work from Python, on the thread that made it. Its progress function passes on what is done, and lets Python handle
// signals: Ctrl-C raises KeyboardInterrupt, which ends the work.
class Call {
 public:
  // `progress` is a function or None.
  explicit Call(const py::object& progress) : progress_(progress), outer_(std::exchange(current, this)) {}
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;
  ~Call() { current = outer_; }

  // For the options of the library. It refers to no object of Python: options may live longer than one call.
  static bool tell_current(double done) { return current == nullptr || current->tell(done); }

 private:
  using Clock = std::chrono::steady_clock;
  // Without a function of the user, taking the lock more often would only slow down the other threads.
  static constexpr std::chrono::milliseconds between_signals{20};

  bool tell(double done) {
    const Clock::time_point now = Clock::now();
    if (progress_.is_none() && now - last_ < between_signals) return true;
    last_ = now;
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress_.is_none()) return true;
    const py::object result = progress_(done);
    if (result.is_none()) return true;
    const int truth = PyObject_IsTrue(result.ptr());
    if (truth < 0) throw py::error_already_set();
    return truth != 0;
  }

  static thread_local Call* current;

  const py::object& progress_;
  Call* outer_;
  Clock::time_point last_ = Clock::now();
};

thread_local Call* Call::current = nullptr;

template <class Work>
auto unlocked(const py::object& progress, Work work) {
  const Call call(progress);
  const py::gil_scoped_release released;
  return work();
}

// Raises the class of sightline/_errors.py that belongs to the kind.
void raise_error(const sightline::Error& error) {
  constexpr std::array<std::pair<const char*, const char*>, 4> classes{
      {{"InputError", "bad_input"}, {"InputError", "usage"}, {"FileError", "io"}, {"Cancelled", "cancelled"}}};
  const auto& [name, kind] = classes[static_cast<std::size_t>(error.kind())];
  const std::string message = error.what();
  // A file's name need not be UTF-8.
  const auto text = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(message.data(), static_cast<py::ssize_t>(message.size()), "surrogateescape"));
  const py::object raised = py::module_::import("sightline._errors").attr(name)(text, kind);
  PyErr_SetObject(py::type::of(raised).ptr(), raised.ptr());
}

// ------------------------------------------------------------------------------------------------------ Arrays of a mesh

using Numbers = py::array_t<std::uint32_t, py::array::c_style>;
using Doubles = py::array_t<double, py::array::c_style>;

std::vector<std::uint32_t> vector_of(const Numbers& numbers) { return {numbers.data(), numbers.data() + numbers.size()}; }

sightline::Mesh mesh_of(const Doubles& vertices, const Numbers& corners, const Numbers& ring_sizes, const Numbers& face_rings,
                        const Numbers& bodies, const Numbers& line_points, const Numbers& line_sizes) {
  sightline::Mesh mesh;
  static_assert(sizeof(sightline::Point) == 3 * sizeof(double));
  mesh.vertices.resize(static_cast<std::size_t>(vertices.size()) / 3);
  if (!mesh.vertices.empty()) std::memcpy(mesh.vertices.data(), vertices.data(), mesh.vertices.size() * sizeof(sightline::Point));
  mesh.corners = vector_of(corners);
  mesh.ring_sizes = vector_of(ring_sizes);
  mesh.face_rings = vector_of(face_rings);
  mesh.bodies = vector_of(bodies);
  mesh.line_points = vector_of(line_points);
  mesh.line_sizes = vector_of(line_sizes);
  return mesh;
}

// --------------------------------------------------------------------------------------------------- Arrays of a drawing

// An array with a row for each of `rows`. `get` returns a row's Value, or std::array of them, in the shape `tail`.
template <class Value, class Row, class Get>
py::array column(const std::vector<Row>& rows, std::vector<py::ssize_t> tail, Get get) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows.size())};
  shape.insert(shape.end(), tail.begin(), tail.end());
  py::array_t<Value> result(std::move(shape));
  char* out = reinterpret_cast<char*>(result.mutable_data());
  for (const Row& row : rows) {
    const auto value = get(row);
    std::memcpy(out, &value, sizeof value);
    out += sizeof value;
  }
  return result;
}

// Where the numbers of each row begin in an array, and where the last ones end.
template <class Row, class Get>
py::array offsets(const std::vector<Row>& rows, std::size_t end, Get first) {
  py::array_t<std::int64_t> result(static_cast<py::ssize_t>(rows.size() + 1));
  std::int64_t* out = result.mutable_data();
  for (const Row& row : rows) *out++ = first(row);
  *out = static_cast<std::int64_t>(end);
  return result;
}

// -1 stands for `none`; no other number is that large.
std::int32_t number(std::uint32_t value) { return static_cast<std::int32_t>(value); }

py::array numbers(const std::vector<std::uint32_t>& values) { return column<std::int32_t>(values, {}, number); }

// The members of sightline.Drawing, by their names, and what its files are made from.
py::tuple drawing_of(Drawing drawing) {
  py::dict columns;
  columns["lines"] = column<double>(drawing.lines, {2, 2}, [](const Line& l) { return std::array{l.from, l.to}; });
  columns["line_kinds"] = column<std::uint8_t>(drawing.lines, {}, [](const Line& l) { return l.kind; });
  columns["line_hidden"] = column<bool>(drawing.lines, {}, [](const Line& l) { return l.hidden; });
  columns["line_edges"] = numbers(drawing.line_edges);
  columns["line_edge_offsets"] = offsets(drawing.lines, drawing.line_edges.size(), [](const Line& l) { return l.first_edge; });
  columns["part_edges"] = column<std::int32_t>(drawing.parts, {}, [](const Part& p) { return number(p.edge); });
  columns["part_fractions"] = column<std::int64_t>(drawing.parts, {2, 2}, [](const Part& p) {
    return std::array{p.low.numerator, p.low.denominator, p.high.numerator, p.high.denominator};
  });
  columns["part_hidden"] = column<bool>(drawing.parts, {}, [](const Part& p) { return p.hidden; });
  columns["part_hidden_by"] = column<std::int32_t>(drawing.parts, {}, [](const Part& p) { return number(p.hidden_by); });
  columns["edge_kinds"] = column<std::uint8_t>(drawing.edges, {}, [](const Edge& e) { return e.kind; });
  columns["edge_ends"] = column<double>(drawing.edges, {2, 3}, [](const Edge& e) { return e.ends; });
  columns["edge_vertices"] = column<std::int32_t>(drawing.edges, {2}, [](const Edge& e) { return e.vertices; });
  columns["edge_faces"] = numbers(drawing.faces);
  columns["edge_face_offsets"] = offsets(drawing.edges, drawing.faces.size(), [](const Edge& e) { return e.first_face; });
  columns["edge_bodies"] = column<std::int32_t>(drawing.edges, {}, [](const Edge& e) { return number(e.body); });
  columns["perspective"] = drawing.perspective;
  columns["eye"] = py::array_t<double>(3, drawing.eye.data());
  columns["axes"] = py::array_t<double>({3, 3}, drawing.axes.front().data());
  columns["scale"] = drawing.scale;
  columns["low"] = py::array_t<double>(2, drawing.low.data());
  columns["camera_error"] = drawing.camera_error;
  columns["width"] = drawing.width;
  columns["height"] = drawing.height;
  columns["notes"] = drawing.notes;
  columns["certificate"] = drawing.certificate;
  Drawing picture;
  picture.picture = std::move(drawing.picture);
  return py::make_tuple(columns, std::move(picture));
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of the package sightline.";
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const sightline::Error& error) {
      raise_error(error);
    }
  });
  module.def("view_names", &sightline::view_names);
  module.def("version", &sightline::version);

  py::class_<sightline::LoadOptions>(module, "LoadOptions")
      .def(py::init([] { return sightline::LoadOptions{.progress = Call::tell_current}; }))
      .def_readwrite("mend", &sightline::LoadOptions::mend)
      .def_readwrite("weld", &sightline::LoadOptions::weld)
      .def_readwrite("planar_tolerance", &sightline::LoadOptions::planar_tolerance)
      .def_readwrite("eye", &sightline::LoadOptions::eye)
      .def_readwrite("jobs", &sightline::LoadOptions::jobs);

  py::class_<sightline::Camera>(module, "Camera")
      .def(py::init<>())
      .def_readwrite("view", &sightline::Camera::view)
      .def_readwrite("perspective", &sightline::Camera::perspective)
      .def_readwrite("direction", &sightline::Camera::direction)
      .def_readwrite("eye", &sightline::Camera::eye)
      .def_readwrite("look_at", &sightline::Camera::look_at)
      .def_readwrite("up", &sightline::Camera::up)
      .def_readwrite("vertical", &sightline::Camera::vertical);

  py::class_<sightline::DrawOptions>(module, "DrawOptions")
      .def(py::init([] { return sightline::DrawOptions{.progress = Call::tell_current}; }))
      .def_readwrite("edges", &sightline::DrawOptions::edges)
      .def_readwrite("crease", &sightline::DrawOptions::crease)
      .def_readwrite("hidden", &sightline::DrawOptions::hidden)
      .def_readwrite("width", &sightline::DrawOptions::width)
      .def_readwrite("height", &sightline::DrawOptions::height)
      .def_readwrite("scale", &sightline::DrawOptions::scale)
      .def_readwrite("field", &sightline::DrawOptions::field)
      .def_readwrite("min_length", &sightline::DrawOptions::min_length)
      .def_readwrite("jobs", &sightline::DrawOptions::jobs)
      .def_readwrite("certificate", &sightline::DrawOptions::certificate);

  py::class_<sightline::FileOptions>(module, "FileOptions")
      .def(py::init<>())
      .def_readwrite("format", &sightline::FileOptions::format)
      .def_readwrite("title", &sightline::FileOptions::title)
      .def_readwrite("margin", &sightline::FileOptions::margin)
      .def_readwrite("pen", &sightline::FileOptions::pen)
      .def_readwrite("dpi", &sightline::FileOptions::dpi)
      .def_readwrite("as_found", &sightline::FileOptions::as_found);

  py::class_<Drawing>(module, "Picture").def("file", [](const Drawing& picture, const sightline::FileOptions& options) {
    return py::bytes(unlocked(py::none(), [&] { return picture.file(options); }));
  });

  py::class_<sightline::Prepared>(module, "Prepared")
      .def("draw", [](const sightline::Prepared& prepared, const sightline::Camera& camera, const py::object& progress) {
        return drawing_of(unlocked(progress, [&] { return prepared.draw(camera); }));
      });

  py::class_<Scene>(module, "Scene")
      .def(py::init([](const Doubles& vertices, const Numbers& corners, const Numbers& ring_sizes, const Numbers& face_rings,
                       const Numbers& bodies, const Numbers& line_points, const Numbers& line_sizes,
                       const sightline::LoadOptions& options, const py::object& progress) {
        const sightline::Mesh mesh = mesh_of(vertices, corners, ring_sizes, face_rings, bodies, line_points, line_sizes);
        return unlocked(progress, [&] { return Scene(mesh, options); });
      }))
      .def_static("load",
                  [](const std::string& path, const sightline::LoadOptions& options, const py::object& progress) {
                    return unlocked(progress, [&] { return Scene::load(path, options); });
                  })
      .def("draw",
           [](const Scene& scene, const sightline::Camera& camera, const sightline::DrawOptions& options,
              const py::object& progress) {
             return drawing_of(unlocked(progress, [&] { return scene.draw(camera, options); }));
           })
      .def("prepare",
           [](const Scene& scene, const sightline::DrawOptions& options, const py::object& progress) {
             return unlocked(progress, [&] { return scene.prepare(options); });
           })
      .def_property_readonly("face_count", &Scene::face_count)
      .def_property_readonly("vertex_count", &Scene::vertex_count)
      .def_property_readonly("bounds",
                             [](const Scene& scene) {
                               const std::array<sightline::Point, 2> bounds = scene.bounds();
                               return py::array_t<double>({2, 3}, bounds.front().data());
                             })
      .def_property_readonly("bodies", &Scene::bodies)
      .def_property_readonly("step", &Scene::step)
      .def_property_readonly("notes", &Scene::notes);
}
