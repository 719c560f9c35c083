#include "host/app/jones_session.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "host/app/command.hpp"
#include "host/picture/crisp_raster.hpp"
#include "host/picture/phosphor.hpp"
#include "host/picture/png.hpp"
#include "host/picture/svg.hpp"

namespace sightline::app {

namespace {

picture::Bytes png_bytes(const picture::Image& image, const std::string& title, const std::string& what) {
  auto bytes =
      picture::encode_png(image, {{"Title", title}, {"Description", what}, {"Software", "sightline"}});
  if (!bytes) throw Failure(ExitCode::io, bytes.error().message());
  return *bytes;
}

template <class Content>
void write_file(const std::string& path, const Content& content) {
  Output output(path);
  output.write(content);
  output.commit();
}

void make_directory(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw Failure(ExitCode::io, directory + ": " + error.message());
}

}  // namespace

harness::jones::Program assembled(const scene::CellScene& scene, const std::string& source,
                                  const harness::jones::ProgramOptions& options) {
  auto program = harness::jones::assemble_program(scene, options);
  if (auto* error = std::get_if<scene::SceneError>(&program)) {
    error->source = source;
    throw Failure(ExitCode::bad_input, error->message());
  }
  return std::get<harness::jones::Program>(std::move(program));
}

std::string title_of(const std::string& scene_name, bool eae) {
  return scene_name + ", Jones 1971 on the PDP-7 " + (eae ? "with" : "without") + " EAE";
}

double seconds(core::Duration time) {
  return std::chrono::duration<double>(time).count();
}

double refreshes_per_second(const harness::jones::GuestRun& run) {
  return run.refresh_period.count() > 0 ? 1.0 / seconds(run.refresh_period) : 0.0;
}

std::vector<std::string> write_jones_pictures(const std::string& directory, const std::string& stem,
                                              const std::string& title, const harness::jones::GuestRun& run) {
  make_directory(directory);
  const std::string base = (std::filesystem::path(directory) / stem).string();
  std::vector<std::string> paths{base + ".png", base + ".svg"};
  write_file(paths[0], std::span<const std::uint8_t>(png_bytes(picture::crisp_raster(run.pass), title,
                                                               "every point lit in one complete pass")));
  write_file(paths[1], std::string_view(picture::svg_drawing(run.pass, title)));
  if (!run.photograph.empty()) {
    picture::PhosphorPhotograph photograph(run.shutter_close - photograph_time, run.shutter_close);
    photograph.expose(run.photograph);
    paths.push_back(base + "-phosphor.png");
    write_file(paths.back(), std::span<const std::uint8_t>(png_bytes(
                                 photograph.develop(), title, "the P7 screen, shutter open for 0.2 s")));
  }
  return paths;
}

std::string file_stem(const std::string& scene_name) {
  std::string stem = scene_name;
  std::replace_if(
      stem.begin(), stem.end(),
      [](char c) {
        return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                 c == '_');
      },
      '_');
  return stem;
}

}  // namespace sightline::app
