// Any bytes as core image or tape, with and without an address. An accepted file must be the same after writing and reading.
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#include "tools/image/octal.hpp"
#include "tools/image/tape.hpp"

namespace {

using namespace sightline;

void check_round_trips(const image::CoreImage& read) {
  const auto octal = image::read_octal(image::write_octal(read), "octal");
  if (!octal || octal.value().words != read.words) std::abort();
  if (const auto tape = image::write_rim(read, "rim")) {
    const auto rim = image::read_rim(tape.value(), "rim");
    if (!rim || rim.value() != read) std::abort();
  }
  if (const auto tape = image::write_hri(read, "hri")) {
    const auto hri = image::read_hri(tape.value(), "hri", read.words.begin()->first);
    if (!hri || hri.value().start != read.start) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  if (const auto read = image::read_image(bytes, "f", {})) check_round_trips(read.value());
  if (const auto read = image::read_image(bytes, "f", 0100)) check_round_trips(read.value());
  if (const auto read = image::read_rim(bytes, "f")) check_round_trips(read.value());
  if (const auto read = image::read_hri(bytes, "f", 077770)) check_round_trips(read.value());
  if (const auto read = image::read_octal({reinterpret_cast<const char*>(data), size}, "f"))
    check_round_trips(read.value());
  return 0;
}
