// Memory of an 8080: 64K bytes, a record of which of them a file or an assembly has defined, and the raw file formats.
//
// .bin: the bytes from the lowest to the highest defined address, gaps as 00; it has no address. .com: a CP/M program,
// the bytes from 0100 on, started there. Neither distinguishes a gap from a byte 00.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::image {

inline constexpr std::size_t byte_memory_size = 0x10000;
inline constexpr std::uint16_t com_origin = 0x0100;  // start of CP/M's transient program area

class ByteImage {
 public:
  [[nodiscard]] std::uint8_t operator[](std::uint16_t address) const { return bytes_[address]; }
  [[nodiscard]] bool used(std::uint16_t address) const { return used_[address]; }
  // A later byte for the same address replaces the earlier one.
  void put(std::uint16_t address, std::uint8_t byte);

  // All 64K; undefined bytes are 00.
  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return bytes_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  // Of the defined bytes; the image must not be empty.
  [[nodiscard]] std::uint16_t lowest() const { return lowest_; }
  [[nodiscard]] std::uint16_t highest() const { return highest_; }

  std::optional<std::uint16_t> start;

  friend bool operator==(const ByteImage&, const ByteImage&) = default;

 private:
  std::vector<std::uint8_t> bytes_ = std::vector<std::uint8_t>(byte_memory_size);
  std::vector<bool> used_ = std::vector<bool>(byte_memory_size);
  std::size_t count_ = 0;
  std::uint16_t lowest_ = 0xFFFF;
  std::uint16_t highest_ = 0;
};

// Loads the bytes of a file from `address` upward. An error if there are none or if they run past FFFF.
[[nodiscard]] base::Result<ByteImage> read_binary(std::span<const std::uint8_t> bytes, std::string_view file,
                                                  std::uint16_t address);
// Loads the file at 0100, which is also the start address.
[[nodiscard]] base::Result<ByteImage> read_com(std::span<const std::uint8_t> bytes, std::string_view file);

// Both fail on an image without bytes. write_com also fails on a byte below 0100 and on a start address other than 0100.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_binary(const ByteImage& image,
                                                                   std::string_view file);
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_com(const ByteImage& image,
                                                                std::string_view file);

// Upper-case digits with leading zeros.
[[nodiscard]] std::string hexadecimal(std::uint32_t value, unsigned digits);

}  // namespace sightline::image
