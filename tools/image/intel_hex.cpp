#include "tools/image/intel_hex.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "host/base/result.hpp"

namespace sightline::image {
namespace {

constexpr std::size_t bytes_a_record = 16;
constexpr char end_of_text = 0x1A;

enum RecordType : std::uint8_t {
  data = 0,
  end_of_file = 1,
  extended_segment = 2,
  start_segment = 3,
  extended_linear = 4,
  start_linear = 5,
};

std::optional<std::uint8_t> digit_value(char c) {
  if (c >= '0' && c <= '9') return static_cast<std::uint8_t>(c - '0');
  if (c >= 'A' && c <= 'F') return static_cast<std::uint8_t>(c - 'A' + 10);
  if (c >= 'a' && c <= 'f') return static_cast<std::uint8_t>(c - 'a' + 10);
  return std::nullopt;
}

std::string quoted(char c) {
  if (c >= ' ' && c < 0x7F) return std::string("'") + c + "'";
  return "byte " + hexadecimal(static_cast<std::uint8_t>(c), 2);
}

class IntelHexReader {
 public:
  IntelHexReader(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  // The addresses to which a later record gave another byte.
  [[nodiscard]] std::vector<std::string> warnings() const {
    if (!first_replaced_) return {};
    const std::string count = replaced_ == 1 ? "this address has" : std::to_string(replaced_) + " addresses have";
    return {first_replaced_->file + ":" + first_replaced_->place + ": found " + first_replaced_->found + ", expected " +
            first_replaced_->expected + ": " + count + " the byte of the later record, as after a loader"};
  }

  base::Result<ByteImage> read() {
    while (next_line()) {
      if (auto problem = record()) return *problem;
      if (ended_) return trailing();
    }
    return problem(0, "the end of the file", "an end record, :00000001FF");
  }

 private:
  // The next line that is not blank.
  bool next_line() {
    while (at_ < text_.size() && text_[at_] != end_of_text) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      line_ = text_.substr(at_, end - at_);
      at_ = std::min(end + 1, text_.size());
      ++number_;
      while (!line_.empty() && (line_.back() == '\r' || line_.back() == ' ' || line_.back() == '\t'))
        line_.remove_suffix(1);
      if (!line_.empty()) return true;
    }
    line_ = {};
    return false;
  }

  std::optional<base::Error> record() {
    if (line_[0] != ':') return problem(0, quoted(line_[0]), "':' at the start of a record");
    if (auto wrong = decode()) return wrong;
    const std::size_t length = bytes_[0];
    if (bytes_.size() != length + 5) {
      return problem(1, std::to_string(bytes_.size()) + " bytes in the record",
                     std::to_string(length + 5) + " as its length " + hexadecimal(bytes_[0], 2) + " says");
    }
    unsigned sum = 0;
    for (std::size_t i = 0; i + 1 < bytes_.size(); ++i) sum += bytes_[i];
    const auto checksum = static_cast<std::uint8_t>(0U - sum);
    if (bytes_.back() != checksum) {
      return problem(line_.size() - 2, "checksum " + hexadecimal(bytes_.back(), 2), hexadecimal(checksum, 2));
    }
    return act(bytes_[3], static_cast<std::uint16_t>(bytes_[1] << 8 | bytes_[2]));
  }

  std::optional<base::Error> decode() {
    bytes_.clear();
    for (std::size_t i = 1; i < line_.size(); i += 2) {
      const auto high = digit_value(line_[i]);
      if (!high) return problem(i, quoted(line_[i]), "a hexadecimal digit");
      if (i + 1 == line_.size()) return problem(i, "half a byte at the end of the line", "two digits");
      const auto low = digit_value(line_[i + 1]);
      if (!low) return problem(i + 1, quoted(line_[i + 1]), "a hexadecimal digit");
      bytes_.push_back(static_cast<std::uint8_t>(*high << 4 | *low));
    }
    if (bytes_.size() < 5) {
      return problem(0, "a record of " + std::to_string(bytes_.size()) + " bytes",
                     "at least 5: length, address, type, checksum");
    }
    return std::nullopt;
  }

  std::optional<base::Error> act(std::uint8_t type, std::uint16_t address) {
    switch (type) {
      case data: return bytes_[0] == 0 ? end(address) : store(address);
      case end_of_file:
        if (bytes_[0] != 0) return problem(1, "data in an end record", "length 00");
        return end(address);
      case extended_segment: return set_base(4);
      case extended_linear: return set_base(16);
      case start_segment: return set_start(4);
      case start_linear: return set_start(16);
      default: return problem(7, "record type " + hexadecimal(type, 2), "00 data, 01 end, or 02 to 05");
    }
  }

  std::optional<base::Error> end(std::uint16_t address) {
    ended_ = true;
    if (address != 0) image_.start = address;
    return std::nullopt;
  }

  std::optional<base::Error> store(std::uint16_t address) {
    const std::size_t first = base_ + address;
    if (first + bytes_[0] > byte_memory_size) {
      return problem(3,
                     std::to_string(bytes_[0]) + " bytes from " + hexadecimal(address, 4) +
                         (base_ == 0 ? "" : " above base " + hexadecimal(base_, 8)),
                     "none past FFFF: an 8080 has 64K");
    }
    for (std::size_t i = 0; i < bytes_[0]; ++i) {
      const auto to = static_cast<std::uint16_t>(first + i);
      const std::uint8_t byte = bytes_[4 + i];
      if (image_.used(to) && image_[to] != byte && replaced_++ == 0) {
        first_replaced_ = problem(9 + 2 * i, "byte " + hexadecimal(byte, 2) + " for address " + hexadecimal(to, 4), hexadecimal(image_[to], 2) + " as in an earlier record");
      }
      image_.put(to, byte);
    }
    return std::nullopt;
  }

  std::optional<base::Error> set_base(unsigned shift) {
    if (bytes_[0] != 2) return problem(1, "length " + hexadecimal(bytes_[0], 2), "02 for this record type");
    base_ = static_cast<std::uint32_t>(bytes_[4] << 8 | bytes_[5]) << shift;
    if (base_ < byte_memory_size) return std::nullopt;
    return problem(9, "base address " + hexadecimal(base_, 8), "one below 10000: an 8080 has 64K");
  }

  // Type 03 gives CS and IP, type 05 a 32-bit address.
  std::optional<base::Error> set_start(unsigned shift) {
    if (bytes_[0] != 4) return problem(1, "length " + hexadecimal(bytes_[0], 2), "04 for this record type");
    const std::uint32_t high = static_cast<std::uint32_t>(bytes_[4] << 8 | bytes_[5]) << shift;
    const std::uint64_t start = std::uint64_t{high} + static_cast<std::uint32_t>(bytes_[6] << 8 | bytes_[7]);
    if (start >= byte_memory_size)
      return problem(9, "a start address above FFFF", "one within the 64K of an 8080");
    image_.start = static_cast<std::uint16_t>(start);
    return std::nullopt;
  }

  base::Result<ByteImage> trailing() {
    if (next_line()) return problem(0, quoted(line_[0]) + " after the end record", "the end of the file");
    return std::move(image_);
  }

  base::Error problem(std::size_t offset, std::string found, std::string expected) const {
    return {std::string(file_),
            std::to_string(std::max<std::size_t>(number_, 1)) + ":" + std::to_string(offset + 1),
            std::move(found), std::move(expected)};
  }

  std::string_view text_;
  std::string_view file_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  std::string_view line_;
  std::vector<std::uint8_t> bytes_;
  std::uint32_t base_ = 0;
  bool ended_ = false;
  std::size_t replaced_ = 0;  // bytes
  std::optional<base::Error> first_replaced_;
  ByteImage image_;
};

void add_record(std::string& text, std::uint16_t address, RecordType type,
                std::span<const std::uint8_t> bytes) {
  unsigned sum = 0;
  const auto add = [&](unsigned byte) {
    text += hexadecimal(byte & 0xFFU, 2);
    sum += byte & 0xFFU;
  };
  text += ':';
  add(static_cast<unsigned>(bytes.size()));
  add(address >> 8U);
  add(address);
  add(type);
  for (const std::uint8_t byte : bytes) add(byte);
  add(0U - sum);
  text += '\n';
}

}  // namespace

base::Result<ByteImage> read_intel_hex(std::string_view text, std::string_view file, std::vector<std::string>* warnings) {
  IntelHexReader reader(text, file);
  auto image = reader.read();
  if (image && warnings != nullptr) *warnings = reader.warnings();
  return image;
}

std::string write_intel_hex(const ByteImage& image) {
  std::string text;
  for (std::size_t at = 0; at < byte_memory_size;) {
    std::size_t end = at;
    while (end < byte_memory_size && end - at < bytes_a_record && image.used(static_cast<std::uint16_t>(end)))
      ++end;
    if (end > at) add_record(text, static_cast<std::uint16_t>(at), data, image.bytes().subspan(at, end - at));
    at = end > at ? end : at + 1;
  }
  add_record(text, image.start.value_or(0), end_of_file, {});
  return text;
}

}  // namespace sightline::image
