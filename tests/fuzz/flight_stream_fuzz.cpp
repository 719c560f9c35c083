// Flight streams, as given and made valid with one byte changed: the program on the 8080 acts as its twin does and rejects
// damaged streams.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "host/programs/flight/check.hpp"
#include "host/programs/flight/packing.hpp"

namespace {

namespace flight = sightline::programs::flight;

// Numbers from the input, then zeros.
class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] std::uint32_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : 0U; }
  [[nodiscard]] bool more() const { return at_ < bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

// With precision 3 the squares of the high bytes must sum to less than 2^16.
std::vector<std::uint32_t> point_of(Input& input, flight::Precision precision, std::size_t axes) {
  std::vector<std::uint32_t> point;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    std::uint32_t value = input.byte();
    if (precision == flight::Precision::bits_12) value |= (input.byte() & 0x0FU) << 8U;
    if (precision == flight::Precision::bits_16) value |= input.byte() % 148 << 8U;
    point.push_back(value);
  }
  return point;
}

void expect_twin(const std::vector<std::uint8_t>& stream, bool facing, std::optional<bool> complete = {}) {
  const flight::MachineFlight machine = flight::run_machine(flight::resident_program(facing), stream);
  if (!flight::difference_from_twin(machine, flight::run_twin(stream, facing)).empty()) std::abort();
  if (complete && *complete != (machine.status == flight::Status::complete)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 300) return 0;
  Input input({data, size});
  const auto precision = static_cast<flight::Precision>(input.byte() % 3 + 1);
  const std::size_t axes = input.byte() % 2 + 2;
  const std::size_t pieces = input.byte() % 40 + 1;
  const std::uint32_t where = input.byte() << 8U | input.byte();
  const auto change = static_cast<std::uint8_t>(input.byte());
  const std::uint32_t shape = input.byte();
  const std::size_t planes = shape % 12;
  // 0 directions: the build without the facing test.
  const std::size_t directions = shape / 12 % 6;
  const std::size_t points = pieces + 2 * planes + (directions > 0 ? directions + 1 : 0);
  flight::StreamWriter writer(precision, axes, pieces, planes, directions);
  for (std::size_t i = 0; i < points; ++i) writer.point(point_of(input, precision, axes));
  // A chain of planes, each with two cells.
  for (std::size_t plane = 1; plane <= planes; ++plane) {
    writer.place(static_cast<std::uint8_t>(2 * plane));
    writer.place(static_cast<std::uint8_t>(2 * plane + 1));
    writer.place(plane < planes ? static_cast<std::uint8_t>(0x81 + plane) : 0);
  }
  for (std::size_t i = 0; planes > 0 && i < pieces; ++i) writer.place(static_cast<std::uint8_t>(input.byte() % 127 + 1));
  for (std::size_t direction = 0; direction < directions; ++direction) {
    std::vector<std::uint32_t> limits;
    for (std::size_t piece = direction; piece < pieces; piece += directions) limits.push_back(input.byte() << 8U | input.byte());
    std::sort(limits.begin(), limits.end());
    writer.direction(limits.size());
    const int shift = 8 * (static_cast<int>(precision) - 1);
    for (std::size_t i = 0; i < limits.size(); ++i) writer.entry(limits[i] << shift, static_cast<std::uint8_t>(direction + i * directions + 1), input.byte() % 2 != 0);
  }
  writer.check();
  for (int eyes = 0; eyes < 4 && input.more(); ++eyes) writer.eye(point_of(input, precision, axes));
  std::vector<std::uint8_t> stream = writer.end();
  const bool facing = directions > 0;
  expect_twin(stream, facing, true);
  std::uint8_t& damaged = stream[where % stream.size()];
  damaged = static_cast<std::uint8_t>(damaged ^ change);
  expect_twin(stream, facing, change == 0);
  // Arbitrary words with precision 3 may give undefined keys.
  if (size < 3 || data[2] != 3) expect_twin({data, data + size}, facing);
  return 0;
}
