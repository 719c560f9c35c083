// The stroke log: a text line for every flash, `t_ns x y intensity address`.
//
// Time, coordinates and intensity are decimal counts; the address is a core address and stands
// in octal, five digits. One space between fields, one line feed after each line, nothing else. Passes are
// not marked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "host/base/file.hpp"
#include "host/base/result.hpp"

namespace sightline::picture {

// With its line feed.
void append_stroke_line(std::string& text, const core::Stroke& stroke);

// A sink that writes while the machine runs; the file appears at commit().
class StrokeLogWriter {
 public:
  static constexpr bool consumes = true;

  explicit StrokeLogWriter(base::AtomicFile file) : file_(std::move(file)) {}

  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& stroke) {
    append_stroke_line(buffer_, stroke);
    if (buffer_.size() >= block_size) flush();
  }
  void end_pass(core::Instant) {}
  [[nodiscard]] base::Result<base::Done> commit() {
    flush();
    return file_.commit();
  }

 private:
  static constexpr std::size_t block_size = 65536;
  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }

  base::AtomicFile file_;
  std::string buffer_;
};

// `name` names the file in error messages. Every line must be exactly as written above; values must fit
// the display (x and y 0..1023, intensity 0..7, address up to 77777 octal).
[[nodiscard]] base::Result<std::vector<core::Stroke>> parse_stroke_log(std::string_view text,
                                                                       const std::string& name);

}  // namespace sightline::picture
