#include "tools/image/octal.hpp"

#include <optional>

#include "host/base/number.hpp"
#include "host/base/result.hpp"

namespace sightline::image {
namespace {

bool blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

std::optional<std::uint32_t> octal_digits(std::string_view text) {
  std::uint32_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '7') return std::nullopt;
    value = value << 3 | static_cast<std::uint32_t>(c - '0');
  }
  return value;
}

// A token as a message shows it: short, and without bytes that would garble a terminal.
std::string quoted(std::string_view token) {
  std::string text = "'";
  for (const char c : token.substr(0, 20)) text += (c > ' ' && c < 0x7f) ? c : '?';
  return text + (token.size() > 20 ? "...'" : "'");
}

class OctalReader {
 public:
  OctalReader(std::string_view text, std::string_view file, std::uint32_t address)
      : text_(text), file_(file), address_(address) {}

  base::Result<CoreImage> read() {
    while (skip_blanks()) {
      const std::string_view token = take_token();
      if (auto problem = token.back() == ':' ? set_address(token) : store(token)) return *problem;
    }
    return image_;
  }

 private:
  bool skip_blanks() {
    for (; at_ < text_.size() && blank(text_[at_]); ++at_) {
      if (text_[at_] == '\n') {
        ++line_;
        line_start_ = at_ + 1;
      }
    }
    return at_ < text_.size();
  }

  // `NNNNN:` needs no blank after it.
  std::string_view take_token() {
    token_start_ = at_;
    while (at_ < text_.size() && !blank(text_[at_])) {
      if (text_[at_++] == ':') break;
    }
    return text_.substr(token_start_, at_ - token_start_);
  }

  std::optional<base::Error> set_address(std::string_view token) {
    const std::string_view digits = token.substr(0, token.size() - 1);
    const auto address = octal_digits(digits);
    if (digits.empty() || digits.size() > 5 || !address) {
      return problem(quoted(token), "an address of one to five octal digits and ':'");
    }
    address_ = *address;
    return std::nullopt;
  }

  std::optional<base::Error> store(std::string_view token) {
    const auto word = octal_digits(token);
    if (token.size() != 6 || !word) return problem(quoted(token), "a word of six octal digits");
    if (address_ > last_address) return problem("a word after address 77777", "the end of the image");
    image_.words.insert_or_assign(address_++, core::Word18(*word));
    return std::nullopt;
  }

  base::Error problem(std::string found, std::string expected) const {
    return base::Error{std::string(file_),
                       std::to_string(line_) + ":" + std::to_string(token_start_ - line_start_ + 1),
                       std::move(found), std::move(expected)};
  }

  std::string_view text_;
  std::string_view file_;
  std::uint32_t address_;
  CoreImage image_;
  std::size_t at_ = 0;
  std::size_t token_start_ = 0;
  std::size_t line_start_ = 0;
  std::size_t line_ = 1;
};

}  // namespace

base::Result<CoreImage> read_octal(std::string_view text, std::string_view file, std::uint32_t address) {
  return OctalReader(text, file, address).read();
}

std::string write_octal(const CoreImage& image) {
  std::string text;
  std::uint32_t next = 0;
  unsigned on_line = 0;
  for (const auto& [address, word] : image.words) {
    if (on_line == 0 || on_line == 8 || address != next) {
      if (on_line != 0) text += '\n';
      text += base::octal(address, 5) + ":";
      on_line = 0;
    }
    text += ' ';
    text += base::octal(word.value(), 6);
    next = address + 1;
    ++on_line;
  }
  if (on_line != 0) text += '\n';
  return text;
}

}  // namespace sightline::image
