// Any bytes as faces for the twin of the stripes program: a mode, a number of faces and a body, in a frame with correct check
// sums, so that the records are reached; then the same bytes as a whole stream. The twin must end, report its status, and leave a
// state that its specification allows.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "host/programs/stripes/stream.hpp"
#include "host/programs/stripes/twin/twin.hpp"

namespace {

namespace stripes = sightline::programs::stripes;

void require(bool holds) {
  if (!holds) std::abort();
}

// The pen stays on the lattice of the picture, alternates between down and up, and ends up.
void check_pen(const stripes::TwinPicture& picture) {
  constexpr std::array<std::array<int, 2>, 8> moves{
      {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};
  int x = 0;
  int y = 0;
  bool down = false;
  std::uint64_t links = 0;
  for (const std::uint8_t command : picture.commands) {
    require(command <= 9);
    if (command >= 8) {
      require(down != (command == 9));
      down = command == 9;
      continue;
    }
    x += moves[command][0];
    y += moves[command][1];
    require(x >= 0 && x <= stripes::picture_size && y >= 0 && y <= stripes::picture_size);
    if (down) links += command % 2 == 0 ? 1U : 2U;
  }
  if (picture.status != stripes::Status::complete) return;
  require(!down && links == picture.counts.links);
}

void check(std::span<const std::uint8_t> stream) {
  const stripes::TwinPicture picture = stripes::run_twin(stream);
  require(picture.status != stripes::Status::running && picture.status < stripes::Status::no_device);
  const auto dots = picture.raster.points();
  require(std::all_of(dots.begin(), dots.end(), [](std::uint8_t level) { return level < 8; }));
  check_pen(picture);
  if (picture.status != stripes::Status::complete) return;
  const std::size_t faces = stream[stripes::header_bytes - 1];
  std::vector<std::uint8_t> order = picture.order;
  std::sort(order.begin(), order.end());
  require(order.size() == faces);
  for (std::size_t k = 0; k < order.size(); ++k) require(order[k] == k);
  require(std::all_of(picture.items.begin(), picture.items.end(), [faces](std::uint8_t item) { return item <= faces; }));
  require(picture.counts.silhouette_most <= stripes::most_silhouette_toggles);
  require(picture.fault == 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  check(bytes);
  if (size < 2) return 0;
  const auto body = bytes.subspan(2, std::min(size - 2, stripes::most_body_bytes));
  check(stripes::framed(data[0], data[1], {body.begin(), body.end()}));
  return 0;
}
