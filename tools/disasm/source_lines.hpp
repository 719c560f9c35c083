// The lines of a disassembly: an origin before each run of consecutive addresses, one word per line, comments in one column.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host/base/number.hpp"
#include "tools/image/core_image.hpp"

namespace sightline::disassembler {

class SourceLines {
 public:
  // True if this address begins a new run of words. Every bank begins one, because the location does not run over its end.
  bool origin_if_needed(std::uint32_t address) {
    const bool new_run = address != next_ || (address & image::field_mask) == 0;
    if (new_run) text_ += base::octal(address, 5) + "/\n";
    next_ = address + 1;
    return new_run;
  }

  void add(const std::string& word, const std::string& comment) {
    constexpr std::size_t comment_column = 24;
    std::string line = "        " + word;
    if (line.size() < comment_column) line.resize(comment_column, ' ');
    text_ += line + " / " + comment + "\n";
  }

  [[nodiscard]] std::string finish(std::optional<std::uint32_t> start) {
    if (start) text_ += "        start " + base::octal(*start, 5) + "\n";
    return std::move(text_);
  }

 private:
  std::string text_;
  std::uint32_t next_ = image::last_address + 1;
};

}  // namespace sightline::disassembler
