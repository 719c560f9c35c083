// Any bytes as Intel HEX. An accepted file must be the same after writing and reading.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tools/image/intel_hex.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  const auto read = image::read_intel_hex({reinterpret_cast<const char*>(data), size}, "f");
  if (!read) {
    static_cast<void>(read.error().message(base::MessageStyle::compiler));
    return 0;
  }
  image::ByteImage expected = read.value();
  if (expected.start == 0) expected.start.reset();  // an end record with address 0 gives no start address
  const auto again = image::read_intel_hex(image::write_intel_hex(read.value()), "f");
  if (!again || again.value() != expected) std::abort();
  return 0;
}
