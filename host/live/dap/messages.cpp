#include "host/live/dap/messages.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "host/base/number.hpp"
#include "host/base/text.hpp"

namespace sightline::live::dap {

using base::Json;

namespace {

constexpr std::string_view digits64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

base::Result<std::optional<Json>> Framing::next() {
  constexpr std::string_view blank_line = "\r\n\r\n";
  constexpr std::size_t longest_header = 4096;
  const std::size_t end = buffer_.find(blank_line);
  if (end == std::string::npos) {
    if (buffer_.size() <= longest_header) return std::optional<Json>();
    return base::bad_input(fmt::format("found {} bytes without an empty line, expected headers of at most {}", buffer_.size(),
                                  longest_header));
  }
  std::optional<std::uint64_t> length;
  std::string_view headers = std::string_view(buffer_).substr(0, end);
  while (!headers.empty()) {
    const std::string_view line = base::take_line(headers);
    const std::size_t colon = line.find(':');
    if (base::lower_case(line.substr(0, colon)) == "content-length" && colon != std::string_view::npos)
      length = base::count_number(base::without_blanks(line.substr(colon + 1)));
  }
  constexpr std::uint64_t longest = 16U << 20;
  if (!length || *length > longest)
    return base::bad_input(fmt::format("found no Content-Length, or one that is no number of at most {}, expected one in the headers of "
                                  "a message", longest));
  const std::size_t begin = end + blank_line.size();
  if (buffer_.size() - begin < *length) return std::optional<Json>();
  auto json = base::parse_json(std::string_view(buffer_).substr(begin, *length), "message");
  buffer_.erase(0, begin + *length);
  if (!json) return json.error();
  if (!json->is_object()) return base::bad_input("found " + describe(*json) + ", expected an object as a message");
  return std::optional<Json>(std::move(*json));
}

std::string framed(const Json& message) {
  const std::string text = message.dump();
  return fmt::format("Content-Length: {}\r\n\r\n{}", text.size(), text);
}

const Json& member(const Json& object, std::string_view name) {
  static const Json nothing;
  const Json* const found = object.is_object() ? object.find(name) : nullptr;
  return found == nullptr ? nothing : *found;
}
std::string text_in(const Json& object, std::string_view name) {
  const std::string* const text = member(object, name).text();
  return text == nullptr ? std::string() : *text;
}
std::int64_t integer_in(const Json& object, std::string_view name, std::int64_t otherwise) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  return std::clamp(member(object, name).integer().value_or(otherwise), -most, most);
}
bool flag_in(const Json& object, std::string_view name) {
  return member(object, name).boolean().value_or(false);
}

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t n = 0; n < 3; ++n) group = group << 8 | (n < count ? bytes[at + n] : 0U);
    for (std::size_t n = 0; n < 4; ++n) text += n <= count ? digits64[group >> (18 - 6 * n) & 63U] : '=';
  }
  return text;
}
std::optional<std::vector<std::uint8_t>> bytes_of_base64(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  if (text.size() % 4 != 0) return std::nullopt;
  while (text.ends_with('=')) text.remove_suffix(1);
  std::uint32_t group = 0;
  unsigned bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits64.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<std::uint8_t>(group >> bits));
  }
  return bytes;
}

}  // namespace sightline::live::dap
