// Animated PNG: a sequence of pictures of equal size, each shown for a common or an individual time, repeated forever.
//
// A reader without animation shows the first picture. Every frame is complete; unchanged parts are not omitted. There is
// no time stamp and no host name: equal pictures give equal bytes.
// Source: PNG specification, third edition (W3C), sections 11.3.6 (acTL, fcTL, fdAT) and 5.6 (order). The pictures
// themselves are encoded by png.hpp, because Debian's libpng does not write animations.
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

// Frames are added one by one, so only their compressed bytes are kept.
class ApngWriter {
 public:
  // The text is written once. `plays` 0: endless.
  explicit ApngWriter(FrameTime time = {}, std::uint32_t plays = 0, TextEntries text = {});

  // Error: encode_png does not accept the picture, or its size or channels differ from those of the first one.
  [[nodiscard]] base::Result<base::Done> add(const Image& image) { return add(image, time_); }
  // The same, with an individual time.
  [[nodiscard]] base::Result<base::Done> add(const Image& image, FrameTime time);

  // The file. Error: there is no frame.
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
