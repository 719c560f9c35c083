// Any changes to an image of an RB09: an image of wrong length or with a bad word is rejected, and an accepted image is read
// back from the drive unchanged.
//
// Input: each four bytes change one byte of the image: four times its offset (three bytes, high first), and its value. From
// FA0000 on
// they shorten the image by the excess, or lengthen it if the value is odd.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "host/machines/disk_image.hpp"

namespace {

using namespace sightline;

constexpr std::size_t bytes_of_disk = std::size_t{4} * pdp7::rb09::words_of_disk;

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most_changes = 64, first_of_lengths = 0xFA0000 / 4;
  static machines::Input input{"disk", machines::Bytes(bytes_of_disk)};
  machines::Bytes& bytes = input.bytes;
  for (std::size_t n = 0; n + 4 <= size && n < 4 * most_changes; n += 4) {
    const std::size_t place = std::size_t{data[n]} << 16 | std::size_t{data[n + 1]} << 8 | data[n + 2];
    const std::uint8_t value = data[n + 3];
    if (place >= 4 * first_of_lengths) {
      const std::size_t by = place - 4 * first_of_lengths;
      bytes.resize((value & 1U) != 0 ? bytes.size() + by : bytes.size() - std::min(by, bytes.size()));
    } else if (place / 4 < bytes.size()) {
      bytes[place / 4] = value;
    }
  }
  bool good = bytes.size() == bytes_of_disk;
  for (std::size_t at = 0; good && at < bytes.size(); at += 4) good = bytes[at + 3] == 0 && bytes[at + 2] < 4;
  auto words = machines::read_disk_image(input);
  require(words.has_value() == good);
  if (words) {
    pdp7::Rb09 disk{pdp7::rb09::Choices{.word = core::Duration(6600)}};
    disk.attach(std::move(*words), 0);
    require(machines::disk_image(disk) == bytes);
  } else {
    require(words.error().message().starts_with("disk: "));
  }
  bytes.assign(bytes_of_disk, 0);
  return 0;
}
