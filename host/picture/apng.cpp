// A frame's IDAT chunks are copied from the encoded PNG; those of later frames become fdAT.
#include "host/picture/apng.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include "host/base/crc32.hpp"
#include "host/base/file.hpp"
#include "host/base/result.hpp"

namespace sightline::picture {

namespace {

constexpr std::size_t signature_size = 8;

void put32(base::Bytes& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void put16(base::Bytes& bytes, std::uint16_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

std::uint32_t get32(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | bytes[i];
  return value;
}

// Length, type, data, and the checksum of type and data.
void put_chunk(base::Bytes& bytes, std::string_view type, std::span<const std::uint8_t> data) {
  put32(bytes, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = bytes.size();
  bytes.insert(bytes.end(), type.begin(), type.end());
  bytes.insert(bytes.end(), data.begin(), data.end());
  put32(bytes, base::crc32(std::span(bytes).subspan(begin)));
}

struct Chunk {
  std::string_view type;
  std::span<const std::uint8_t> data;
  std::span<const std::uint8_t> whole;
};

// Visits the chunks of a PNG that was just encoded and is therefore well-formed.
template <class Visit>
void for_chunks(const base::Bytes& png, Visit&& visit) {
  std::size_t at = signature_size;
  while (at + 12 <= png.size()) {
    const std::span<const std::uint8_t> rest = std::span(png).subspan(at);
    const std::size_t length = get32(rest);
    visit(Chunk{{reinterpret_cast<const char*>(rest.data()) + 4, 4},
                rest.subspan(8, length),
                rest.subspan(0, length + 12)});
    at += length + 12;
  }
}

void append(base::Bytes& bytes, std::span<const std::uint8_t> more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

}  // namespace

ApngWriter::ApngWriter(FrameTime time, std::uint32_t plays, TextEntries text)
    : time_(time), plays_(plays), text_(std::move(text)) {}

base::Result<base::Done> ApngWriter::add(const Image& image, FrameTime time) {
  if (frames_ > 0 && (image.width != width_ || image.height != height_ || image.channels != channels_)) {
    return base::Error{"APNG", "frame " + std::to_string(frames_),
                       std::to_string(image.width) + " by " + std::to_string(image.height),
                       std::to_string(width_) + " by " + std::to_string(height_) + " as the first one"};
  }
  const auto png = encode_png(image, frames_ == 0 ? text_ : TextEntries());
  if (!png) return png.error();
  width_ = image.width;
  height_ = image.height;
  channels_ = image.channels;
  base::Bytes control;
  put32(control, sequence_++);
  put32(control, static_cast<std::uint32_t>(width_));
  put32(control, static_cast<std::uint32_t>(height_));
  put32(control, 0);  // at the left
  put32(control, 0);  // and top
  put16(control, time.numerator);
  put16(control, time.denominator);
  control.push_back(0);  // keep this frame when the next one comes
  control.push_back(0);  // replace instead of blending
  put_chunk(body_, "fcTL", control);
  if (frames_ == 0) append(head_, std::span(*png).first(signature_size));
  for_chunks(*png, [&](const Chunk& chunk) {
    if (chunk.type == "IDAT" && frames_ > 0) {
      base::Bytes data;
      put32(data, sequence_++);
      append(data, chunk.data);
      put_chunk(body_, "fdAT", data);
    } else if (chunk.type == "IDAT") {
      append(body_, chunk.whole);
    } else if (frames_ == 0 && chunk.type != "IEND") {
      append(head_, chunk.whole);
    }
  });
  ++frames_;
  return base::Done{};
}

base::Result<base::Bytes> ApngWriter::finish() const {
  if (frames_ == 0) return base::Error{"APNG", "", "no frame", "one or more"};
  base::Bytes bytes = head_;
  base::Bytes animation;
  put32(animation, frames_);
  put32(animation, plays_);
  put_chunk(bytes, "acTL", animation);
  append(bytes, body_);
  put_chunk(bytes, "IEND", {});
  return bytes;
}

}  // namespace sightline::picture
