#include "host/report/experiments/plantinga_models.hpp"

#include <fmt/core.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "host/algorithms/plantinga/event_file.hpp"
#include "host/base/file.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::plantinga;

std::pair<native::EventList, double> study(const Context& context, std::string_view name,
                                           const native::RotationModel& model, unsigned threads) {
  native::BuildOptions options;
  options.threads = threads;
  options.progress = [&](std::size_t done, std::size_t of) {
    if (done % 64 == 0)
      context.progress(fmt::format("events of {}, {}: {} of {} edges", name,
                                   threads == 1 ? "one core" : "all cores", done, of));
  };
  const auto begun = std::chrono::steady_clock::now();
  auto built = native::build_event_list(model, options);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
  if (!built) throw base::difference(fmt::format("{}: {}", name, built.error().message()));
  return {std::move(*built), taken.count()};
}

struct CacheFiles {
  std::string events;
  std::string times;
};

std::optional<CacheFiles> files_of(const Context& context, std::string_view name) {
  if (context.cache.empty()) return std::nullopt;
  const std::filesystem::path stem = std::filesystem::path(context.cache) / name;
  return CacheFiles{stem.string() + ".events", stem.string() + ".seconds"};
}

// One line: the time with one core, and with all.
std::optional<StudyTimes> read_times(const std::string& path) {
  const auto bytes = base::read_file(path, 200);
  if (!bytes) return std::nullopt;
  StudyTimes times;
  const std::string text(bytes->begin(), bytes->end());
  if (std::sscanf(text.c_str(), "%lf %lf", &times.one_core_s, &times.all_cores_s) != 2) return std::nullopt;
  const auto possible = [](double s) { return s >= 0 && s < 1e6; };
  if (!possible(times.one_core_s) || !possible(times.all_cores_s)) return std::nullopt;
  return times;
}

// False if a file is missing or is not of this model.
bool read_cache(const Context& context, const CacheFiles& files, StudiedModel& studied) {
  auto list = native::read_events(files.events, studied.model);
  if (!list || list->tolerance != 0) return false;
  if (context.host_times) {
    studied.times = read_times(files.times);
    if (!studied.times) return false;
  }
  studied.list = std::move(*list);
  studied.from_cache = true;
  return true;
}

// Errors are ignored: the report does not need the cache.
void write_cache(const CacheFiles& files, const StudiedModel& studied) {
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path(files.events).parent_path(), ignored);
  if (!native::write_events(files.events, studied.list) || !studied.times) return;
  static_cast<void>(base::write_file_atomically(
      files.times, std::string_view(fmt::format("{:.6f} {:.6f}\n", studied.times->one_core_s,
                                                studied.times->all_cores_s))));
}

}  // namespace

std::vector<std::string_view> plantinga_models_of(const Context& context) {
  std::vector<std::string_view> names = scene::builtin_model_names();
  if (!context.full) names.pop_back();
  return names;
}

std::vector<std::string_view> plantinga_turned_models(const Context& context) {
  if (context.full) return {"squares", "grid", "objects", "tori"};
  return {"squares", "grid"};
}

scene::PolyScene plantinga_scene(std::string_view name) {
  const auto text = scene::builtin_scene_text(name);
  if (!text) throw base::bad_input(fmt::format("{}: no such model", name));
  auto read = scene::read_poly(*text, std::string(name), scene::PolyFormat::off);
  if (!read) throw base::bad_input(read.error().message());
  return std::move(read->scene);
}

StudiedModel study_model(const Context& context, std::string_view name) {
  StudiedModel studied{std::string(name), native::RotationModel(plantinga_scene(name)), {}, {}, false};
  const auto files = files_of(context, name);
  if (files && read_cache(context, *files, studied)) return studied;
  auto [list, all_cores] = study(context, name, studied.model, 0);
  studied.list = std::move(list);
  if (context.host_times) studied.times = StudyTimes{study(context, name, studied.model, 1).second, all_cores};
  if (files) write_cache(*files, studied);
  return studied;
}

}  // namespace sightline::report
