// Any bytes as a ZIP archive: its directory, and the beginning of each file in it.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "host/scene/read/zip.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view archive(reinterpret_cast<const char*>(data), size);
  const auto entries = sightline::scene::zip_entries(archive);
  if (!entries) return 0;
  constexpr std::size_t most = 4096;
  for (const auto& entry : *entries)
    if (sightline::scene::zip_beginning(archive, entry, most).size() > most) std::abort();
  return 0;
}
