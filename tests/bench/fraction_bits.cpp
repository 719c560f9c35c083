// The effect of the fraction bits of Jones's program on the screen, from many random positions in each scene: the length that
// the Type 340's vectors, between whole points, draw wrongly, as a share of the visible length.
//
//   sightline_fraction_bits [VIEWS]      (default: 1,000 views per scene; several minutes)
//
// Prints the mean over the views and its paired differences from 0 bits with their standard errors. The default of
// `sightline jones --fraction` is the smallest number of bits that is not worse within these errors.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "host/compare/sweep_views.hpp"
#include "host/compare/jones_precision/study.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline {
namespace {

namespace jones = programs::jones;
namespace jones_precision = compare::jones_precision;

constexpr int most_bits = 3;
using Shares = std::array<double, most_bits + 1>;  // per cent, by fraction bits

struct Views {
  std::vector<Shares> display;   // by view
  std::vector<Shares> numbers;   // of the pieces after clipping
  std::array<int, most_bits + 1> named{};
  int left_out = 0;              // eyes that the program rejects, and views that do not fit
};

// False if some number of fraction bits cannot complete the view, or no line is visible.
bool measure(const scene::CellScene& scene, const geometry::Point& eye, Views& views) {
  const auto study = jones_precision::PrecisionStudy::of(scene, std::array<geometry::Point, 1>{eye});
  if (!study) return false;
  Shares display{};
  Shares numbers{};
  std::array<int, most_bits + 1> named{};
  for (int bits = 0; bits <= most_bits; ++bits) {
    const auto measured = study->measure_on_machine(bits, false);
    if (!measured || !measured->displayed->complete() || measured->displayed->visible <= 0) return false;
    const auto at = static_cast<std::size_t>(bits);
    display[at] = 100 * measured->displayed->share();
    numbers[at] = 100 * measured->clipped.share();
    named[at] = static_cast<int>(measured->displayed->named.size());
  }
  views.display.push_back(display);
  views.numbers.push_back(numbers);
  for (std::size_t at = 0; at < named.size(); ++at) views.named[at] += named[at];
  return true;
}

Views measure_scene(const std::string& name, std::size_t wanted, std::uint64_t seed) {
  const auto cells = scene::load_cell_scene(name);
  const scene::PolyScene polyhedra = scene::poly_scene_of(*cells);
  Views views;
  for (std::uint64_t number = 0; views.display.size() < wanted && number < 20 * wanted; ++number) {
    const scene::PolyCamera camera = compare::sweep_camera(polyhedra, &*cells, false, seed, number);
    if (!measure(*cells, camera.eye, views)) ++views.left_out;
  }
  return views;
}

struct Mean {
  double value = 0;
  double error = 0;  // standard error
};
Mean mean_of(const std::vector<Shares>& views, std::size_t bits, bool against_none) {
  double sum = 0;
  double squares = 0;
  for (const Shares& view : views) {
    const double value = view[bits] - (against_none ? view[0] : 0);
    sum += value;
    squares += value * value;
  }
  const auto n = static_cast<double>(views.size());
  const double mean = sum / n;
  return {mean, std::sqrt((squares / n - mean * mean) / (n - 1))};
}

void print(const char* what, const std::vector<Shares>& views) {
  std::printf("  %-10s", what);
  for (std::size_t bits = 0; bits <= most_bits; ++bits) {
    const Mean mean = mean_of(views, bits, false);
    std::printf("  %.4f +- %.4f", mean.value, mean.error);
  }
  std::printf("\n  %-10s  %16s", "  less f=0", "");
  for (std::size_t bits = 1; bits <= most_bits; ++bits) {
    const Mean mean = mean_of(views, bits, true);
    std::printf(" %+.4f +- %.4f", mean.value, mean.error);
  }
  std::printf("\n");
}

}  // namespace
}  // namespace sightline

int main(int argc, char** argv) {
  using namespace sightline;
  const long wanted = argc > 1 ? std::atol(argv[1]) : 1000;
  if (wanted < 2 || argc > 2) {
    std::fprintf(stderr, "usage: sightline_fraction_bits [VIEWS, at least 2]\n");
    return 2;
  }
  std::printf("wrong share of the visible length, per cent, mean and standard error, for 0 to %d fraction bits\n", most_bits);
  std::vector<std::pair<std::string, std::future<Views>>> scenes;
  for (const auto& six : jones_precision::six_views) {
    const std::string name(six.scene);
    scenes.emplace_back(name, std::async(std::launch::async, measure_scene, name, static_cast<std::size_t>(wanted), 1));
  }
  for (auto& [name, measured] : scenes) {
    const Views views = measured.get();
    std::printf("%s: %zu views, %d left out; stretches of more than 20 points wrong: %d %d %d %d\n", name.c_str(),
                views.display.size(), views.left_out, views.named[0], views.named[1], views.named[2], views.named[3]);
    if (views.display.size() < 2) continue;
    print("display", views.display);
    print("numbers", views.numbers);
  }
  return 0;
}
