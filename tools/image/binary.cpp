#include "tools/image/binary.hpp"

#include <algorithm>

#include "host/base/result.hpp"

namespace sightline::image {
namespace {

std::vector<std::uint8_t> bytes_from(const ByteImage& image, std::size_t first) {
  const auto all = image.bytes();
  return {all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + image.highest() + 1};
}

}  // namespace

void ByteImage::put(std::uint16_t address, std::uint8_t byte) {
  bytes_[address] = byte;
  if (!used_[address]) ++count_;
  used_[address] = true;
  lowest_ = std::min(lowest_, address);
  highest_ = std::max(highest_, address);
}

base::Result<ByteImage> read_binary(std::span<const std::uint8_t> bytes, std::string_view file,
                                    std::uint16_t address) {
  if (bytes.empty()) return base::Error{std::string(file), "", "an empty file", "bytes for memory"};
  const std::size_t room = byte_memory_size - address;
  if (bytes.size() > room) {
    return base::Error{
        std::string(file), "", std::to_string(bytes.size()) + " bytes",
        "at most " + std::to_string(room) + " from address " + hexadecimal(address, 4) + " to FFFF"};
  }
  ByteImage image;
  for (std::size_t i = 0; i < bytes.size(); ++i) image.put(static_cast<std::uint16_t>(address + i), bytes[i]);
  return image;
}

base::Result<ByteImage> read_com(std::span<const std::uint8_t> bytes, std::string_view file) {
  auto read = read_binary(bytes, file, com_origin);
  if (!read) return read;
  ByteImage image = read.value();
  image.start = com_origin;
  return image;
}

base::Result<std::vector<std::uint8_t>> write_binary(const ByteImage& image, std::string_view file) {
  if (image.empty())
    return base::Error{std::string(file), "", "a program without bytes", "at least one byte"};
  return bytes_from(image, image.lowest());
}

base::Result<std::vector<std::uint8_t>> write_com(const ByteImage& image, std::string_view file) {
  if (image.empty())
    return base::Error{std::string(file), "", "a program without bytes", "at least one byte"};
  if (image.lowest() < com_origin) {
    return base::Error{std::string(file), "", "a byte at " + hexadecimal(image.lowest(), 4),
                       "a .com program from 0100 up"};
  }
  if (image.start && *image.start != com_origin) {
    return base::Error{std::string(file), "", "start address " + hexadecimal(*image.start, 4),
                       "0100, where CP/M starts a .com program"};
  }
  return bytes_from(image, com_origin);
}

std::string hexadecimal(std::uint32_t value, unsigned digits) {
  std::string text(digits, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, value >>= 4) {
    *digit = "0123456789ABCDEF"[value & 15U];
  }
  return text;
}

}  // namespace sightline::image
