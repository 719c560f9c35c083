// Animated PNG: pictures of one size, one after the other, each for the same time or for its own, repeated forever.
//
// The first picture is also what a reader without animation shows. Every frame is whole: nothing is said of
// what stayed the same. No time stamp, no host name: equal pictures give equal bytes.
// Source: PNG specification, third edition (W3C), sections 11.3.6 (acTL, fcTL, fdAT) and 5.6 (order); the
// pictures themselves are encoded as png.hpp does. Debian's libpng does not write animations.
#pragma once

#include <cstdint>
#include <string>

#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "host/picture/image.hpp"
#include "host/picture/png.hpp"

namespace sightline::picture {

struct FrameTime {  // numerator / denominator seconds
  std::uint16_t numerator = 1;
  std::uint16_t denominator = 25;  // not 0
};

// Frames are added one by one, so that only their compressed bytes are kept.
class ApngWriter {
 public:
  // The text is written once. `plays` 0: without end.
  explicit ApngWriter(FrameTime time = {}, std::uint32_t plays = 0, TextEntries text = {});

  // An error if encode_png does not accept the picture, or it is not of the size and channels of the first one.
  [[nodiscard]] base::Result<base::Done> add(const Image& image) { return add(image, time_); }
  // The same, shown for a time of its own.
  [[nodiscard]] base::Result<base::Done> add(const Image& image, FrameTime time);

  // The file: an error if there is no frame.
  [[nodiscard]] base::Result<base::Bytes> finish() const;

  [[nodiscard]] std::uint32_t frames() const { return frames_; }

 private:
  FrameTime time_;
  std::uint32_t plays_;
  TextEntries text_;
  std::uint32_t frames_ = 0;
  std::uint32_t sequence_ = 0;
  int width_ = 0;
  int height_ = 0;
  int channels_ = 0;
  base::Bytes head_;  // chunks before acTL
  base::Bytes body_;  // chunks after it, without IEND
};

}  // namespace sightline::picture
