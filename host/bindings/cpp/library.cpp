// The functions of hidden_lines.hpp: throws what arrays.hpp returns.
#include <exception>
#include <utility>

#include "host/bindings/cpp/arrays.hpp"
#include "host/bindings/cpp/hidden_lines.hpp"
#include "host/hidden_lines/aim.hpp"
#include "host/scene/model/file_units.hpp"

namespace sightline {
namespace {

Error::Kind kind_of(base::ErrorKind kind) {
  switch (kind) {
    case base::ErrorKind::usage: return Error::Kind::usage;
    case base::ErrorKind::io: return Error::Kind::io;
    case base::ErrorKind::cancelled: return Error::Kind::cancelled;
    case base::ErrorKind::bad_input:
    case base::ErrorKind::program_failed:
    case base::ErrorKind::differs: break;
  }
  return Error::Kind::bad_input;
}

template <class Value>
Value value_of(base::Result<Value> result) {
  if (!result) throw Error(kind_of(result.error().kind), result.error().message());
  return *std::move(result);
}

// Watches work that throws nothing for a progress function that may: what it throws ends the work, and is thrown again
// after it.
class Guard {
 public:
  explicit Guard(const Progress& progress) : progress_(progress) {
    if (progress_) watch_ = base::Watch([this](double done) { return tell(done); });
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  [[nodiscard]] const base::Watch& watch() const { return watch_; }

  template <class Value>
  Value value_of(base::Result<Value> result) {
    if (thrown_) std::rethrow_exception(thrown_);
    return sightline::value_of(std::move(result));
  }

 private:
  bool tell(double done) {
    try {
      return progress_(done);
    } catch (...) {
      thrown_ = std::current_exception();
      return false;
    }
  }

  const Progress& progress_;
  base::Watch watch_;
  std::exception_ptr thrown_;
};

template <class Source>
hidden_lines::Scene loaded(const Source& source, const LoadOptions& options) {
  Guard guard(options.progress);
  return guard.value_of(bindings::load(source, options, guard.watch()));
}

}  // namespace

struct Scene::Data {
  hidden_lines::Scene scene;
};

struct Prepared::Data {
  std::shared_ptr<const Scene::Data> scene;
  DrawOptions options;
  hidden_lines::Views views;
};

Scene::Scene(const Mesh& mesh, const LoadOptions& options) : data_(std::make_shared<const Data>(Data{loaded(mesh, options)})) {}

Scene::Scene(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

Scene Scene::load(const std::string& path, const LoadOptions& options) {
  return Scene(std::make_shared<const Data>(Data{loaded(path, options)}));
}

Drawing Scene::draw(const Camera& camera, const DrawOptions& options) const {
  Guard guard(options.progress);
  const auto checked = value_of(bindings::view_options(options, data_->scene));
  const auto views = guard.value_of(hidden_lines::Views::of(data_->scene, checked, {}, guard.watch().part(0, 0.3)));
  return guard.value_of(bindings::draw(data_->scene, views, camera, options, guard.watch().part(0.3, 1)));
}

Prepared Scene::prepare(const DrawOptions& options) const {
  Guard guard(options.progress);
  const auto checked = value_of(bindings::view_options(options, data_->scene));
  auto views = guard.value_of(hidden_lines::Views::of(data_->scene, checked, {}, guard.watch()));
  return Prepared(std::make_shared<const Prepared::Data>(Prepared::Data{data_, options, std::move(views)}));
}

std::size_t Scene::face_count() const { return scene::face_count(data_->scene.scene); }

std::size_t Scene::vertex_count() const { return data_->scene.scene.vertices.size(); }

std::array<Point, 2> Scene::bounds() const {
  const scene::PolyBounds bounds = scene::bounds_of(data_->scene.scene);
  return {scene::file_point(data_->scene.scene, bounds.low), scene::file_point(data_->scene.scene, bounds.high)};
}

std::vector<std::string> Scene::bodies() const {
  std::vector<std::string> names;
  for (const scene::PolyBody& body : data_->scene.scene.bodies) names.push_back(body.name);
  return names;
}

double Scene::step() const { return data_->scene.scene.step; }

std::vector<std::string> Scene::notes() const { return bindings::notes_of(data_->scene); }

Prepared::Prepared(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

Drawing Prepared::draw(const Camera& camera) const {
  Guard guard(data_->options.progress);
  return guard.value_of(bindings::draw(data_->scene->scene, data_->views, camera, data_->options, guard.watch()));
}

std::string Drawing::file(const FileOptions& options) const { return value_of(bindings::file_of(*this, options)); }

std::vector<std::string> view_names() { return hidden_lines::view_names(); }

std::string version() { return SIGHTLINE_VERSION; }

}  // namespace sightline
