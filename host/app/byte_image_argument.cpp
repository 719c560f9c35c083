// See byte_image_argument.hpp.
#include "host/app/byte_image_argument.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/command.hpp"
#include "host/base/file.hpp"
#include "tools/image/intel_hex.hpp"

namespace sightline::app {

namespace {

constexpr std::string_view hexadecimal_digits = "0123456789abcdefABCDEF";

// A lone colon may as well be an 8080's LDA.
bool begins_with_hex_record(const base::Bytes& bytes) {
  constexpr std::size_t shortest = 11;  // `:`, then length, address, type and checksum of no bytes at all
  return bytes.size() >= shortest && bytes.front() == ':' &&
         std::all_of(bytes.begin() + 1, bytes.begin() + shortest, [](std::uint8_t byte) {
           return hexadecimal_digits.find(static_cast<char>(byte)) != std::string_view::npos;
         });
}

ByteFormat format_of(const base::Bytes& bytes, const std::string& path) {
  if (const auto named = byte_format_of_name(path)) return *named;
  return begins_with_hex_record(bytes) ? ByteFormat::hex : ByteFormat::bin;
}

}  // namespace

std::string_view without_hexadecimal_mark(std::string_view text) {
  if (text.starts_with("0x") || text.starts_with("0X")) return text.substr(2);
  if (text.ends_with('h') || text.ends_with('H')) text.remove_suffix(1);
  return text;
}

ByteFormat byte_format_named(std::string_view name) {
  return name == "com" ? ByteFormat::com : name == "bin" ? ByteFormat::bin : ByteFormat::hex;
}

std::optional<ByteFormat> byte_format_of_name(std::string_view path) {
  if (path.ends_with(".com") || path.ends_with(".COM")) return ByteFormat::com;
  if (path.ends_with(".bin") || path.ends_with(".BIN")) return ByteFormat::bin;
  if (path.ends_with(".hex") || path.ends_with(".HEX")) return ByteFormat::hex;
  return std::nullopt;
}

ByteImageArgument byte_image_argument(const std::string& option, const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos) return {text, std::nullopt};
  const std::string_view digits = without_hexadecimal_mark(std::string_view(text).substr(at + 1));
  if (digits.empty() || digits.find_first_not_of(hexadecimal_digits) != std::string_view::npos)
    return {text, std::nullopt};
  std::uint32_t address = 0;
  for (const char c : digits) {
    const std::size_t value = hexadecimal_digits.find(c);
    address = address << 4 | static_cast<std::uint32_t>(value < 16 ? value : value - 6);
    if (address >= image::byte_memory_size) {
      throw Failure(ExitCode::usage,
                    fmt::format("{}: found {}, expected an address after @, 0 to FFFF", option, digits));
    }
  }
  return {text.substr(0, at), static_cast<std::uint16_t>(address)};
}

image::ByteImage load_byte_image(const ByteImageArgument& argument, std::optional<ByteFormat> format,
                                 ByteFormat raw) {
  const auto bytes = read_input(argument.path);
  const std::string name = shown_name(argument.path);
  const ByteFormat found = format ? *format : format_of(bytes, argument.path);
  const ByteFormat kind = !format && found == ByteFormat::bin ? raw : found;
  if (kind != ByteFormat::bin && argument.address &&
      !(kind == ByteFormat::com && *argument.address == image::com_origin)) {
    throw Failure(ExitCode::usage, fmt::format("{}: found an address, expected none: {}", name,
                                               kind == ByteFormat::com ? "a .com file goes to 0100"
                                                                       : "Intel HEX has its own"));
  }
  const auto read =
      kind == ByteFormat::hex
          ? image::read_intel_hex({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name)
      : kind == ByteFormat::com ? image::read_com(bytes, name)
                                : image::read_binary(bytes, name, argument.address.value_or(0));
  if (!read) throw Failure(ExitCode::bad_input, read.error().message(base::MessageStyle::compiler));
  return read.value();
}

}  // namespace sightline::app
