// Families by name. See scene.hpp.
#include "host/scene/generate/scene.hpp"

#include <array>
#include <string>

#include "host/base/result.hpp"

namespace sightline::scene {
namespace {

struct Family {
  std::string_view name;
  std::size_t largest;
  PolyScene (*generate)(std::size_t n, std::uint64_t seed);
  std::size_t smallest = 1;
};

// The eye of boxes is at 2200 K < 2^18, so K <= 119; of touch and aligned at 1500 n. A town ends at 1000 G,
// rooms at 1000 n, corridors at 400 n, prisms at 22000 sqrt(n / 35). n is K or G to the family's power.
constexpr std::array<Family, 11> families{{
    {"boxes", 119 * 119 * 119, generate_boxes},
    {"edgeon", 119 * 119 * 119, generate_edgeon},
    {"touch", 174, [](std::size_t n, std::uint64_t) { return generate_touch(n); }},
    {"aligned", 174, [](std::size_t n, std::uint64_t) { return generate_aligned(n); }},
    {"town", 262 * 262, generate_town},
    {"triangles", 119 * 119 * 119, generate_triangles},
    {"bricks", 1000, generate_bricks},
    {"rooms", 262, generate_rooms},
    {"big_rooms", 1310, generate_big_rooms},
    {"corridors", 655, [](std::size_t n, std::uint64_t) { return generate_corridors(n); }, 2},
    {"prisms", 12 * 12 * prisms_in_block,
     [](std::size_t n, std::uint64_t seed) { return generate_prisms(n, seed); }},
}};

const Family* find_family(std::string_view name) {
  for (const Family& family : families)
    if (family.name == name) return &family;
  return nullptr;
}

}  // namespace

std::vector<std::string_view> generator_names() {
  std::vector<std::string_view> names;
  for (const Family& family : families) names.push_back(family.name);
  return names;
}

std::size_t largest_generated_size(std::string_view family) {
  const Family* const found = find_family(family);
  return found != nullptr ? found->largest : 0;
}

base::Result<PolyScene> generate_scene(std::string_view family, std::size_t size, std::uint64_t seed) {
  const Family* const found = find_family(family);
  if (found == nullptr) {
    std::string names;
    for (const Family& known : families) names += (names.empty() ? "" : ", ") + std::string(known.name);
    return base::Error{std::string(family), "", "no such family of scenes, expected one of " + names};
  }
  if (size < found->smallest || size > found->largest) {
    return base::Error{std::string(family), "size",
                       "found " + std::to_string(size) + ", expected " + std::to_string(found->smallest) +
                           ".." + std::to_string(found->largest)};
  }
  return found->generate(size, seed);
}

}  // namespace sightline::scene
