// Any bytes as the XML of a model, alone in a 3MF archive: see poly_fuzz.hpp.
#include <initializer_list>
#include <span>
#include <utility>

#include "host/base/crc32.hpp"
#include "tests/fuzz/poly_fuzz.hpp"

namespace {

using Field = std::pair<std::uint64_t, int>;  // a number and its bytes

void put(std::string& bytes, std::initializer_list<Field> fields) {
  for (const auto& [number, count] : fields)
    for (int i = 0; i < count; ++i) bytes += i < 8 ? static_cast<char>(number >> (8 * i)) : '\0';
}

// A ZIP archive with one stored file: PKWARE, APPNOTE.TXT 4.3.
std::string archive_of(std::string_view model) {
  const std::string name = "3D/3dmodel.model";
  const std::uint32_t crc = sightline::base::crc32(std::span(reinterpret_cast<const std::uint8_t*>(model.data()), model.size()));
  const auto put_common = [&](std::string& bytes) {
    put(bytes, {{20, 2}, {0, 8}, {crc, 4}, {model.size(), 4}, {model.size(), 4}, {name.size(), 2}, {0, 2}});
  };
  std::string archive = "PK\3\4";
  put_common(archive);
  archive += name;
  archive += model;
  const std::size_t directory = archive.size();
  archive += "PK\1\2";
  put(archive, {{20, 2}});
  put_common(archive);
  put(archive, {{0, 14}});
  archive += name;
  const std::size_t end = archive.size();
  archive += "PK\5\6";
  put(archive, {{0, 4}, {1, 2}, {1, 2}, {end - directory, 4}, {directory, 4}, {0, 2}});
  return archive;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string archive = archive_of(std::string_view(reinterpret_cast<const char*>(data), size));
  sightline::fuzz::fuzz_poly(reinterpret_cast<const std::uint8_t*>(archive.data()), archive.size(),
                             sightline::scene::PolyFormat::threemf);
  return 0;
}
