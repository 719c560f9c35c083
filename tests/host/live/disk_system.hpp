// The test system of tests/data/disk_system on an RB09 image: its kernel on track 180.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tools/asm/pdp7.hpp"

namespace sightline::test {

inline constexpr std::size_t bytes_of_disk = 4'096'000;
inline constexpr std::size_t words_per_track = 80 * 64;

inline std::filesystem::path disk_system_file(const char* name) {
  return std::filesystem::path(SIGHTLINE_TEST_DATA) / "disk_system" / name;
}

inline assembler::Assembly assembled_file(const std::filesystem::path& path) {
  std::ifstream stream(path);
  const std::vector<assembler::SourceFile> sources{
      {path.filename().string(), {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}}};
  auto assembly = assembler::assemble_pdp7(sources, {});
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << assembler::to_string(diagnostic);
  return assembly;
}

inline void put_disk_word(std::string& image, std::size_t place, std::uint32_t word) {
  for (unsigned n = 0; n < 4; ++n) image[4 * place + n] = static_cast<char>(word >> (8 * n));
}

inline std::string disk_system_image() {
  std::string image(bytes_of_disk, '\0');
  for (const auto& [address, word] : assembled_file(disk_system_file("kernel.s")).image.words) {
    EXPECT_LT(address, 256U);
    put_disk_word(image, 180 * words_per_track + address, word.value());
  }
  return image;
}

}  // namespace sightline::test
