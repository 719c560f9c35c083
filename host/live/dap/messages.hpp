// Reads and writes the messages of the Debug Adapter Protocol.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/base/value_of.hpp"

namespace sightline::live::dap {

// Splits the input into messages: Content-Length: N, an empty line, N bytes of JSON.
class Framing {
 public:
  void take(std::string_view bytes) { buffer_ += bytes; }
  // The next complete message, an object; nullopt: more input is needed. An error: the input violates the protocol.
  [[nodiscard]] base::Result<std::optional<base::Json>> next();

 private:
  std::string buffer_;
};

// The bytes of a message, with its header.
[[nodiscard]] std::string framed(const base::Json& message);

// Members of an object. If a member is absent or has another type, they return null, an empty text, `otherwise`, or false. Integers
// are limited to 2^53 in magnitude, so that additions cannot overflow.
[[nodiscard]] const base::Json& member(const base::Json& object, std::string_view name);
[[nodiscard]] std::string text_in(const base::Json& object, std::string_view name);
[[nodiscard]] std::int64_t integer_in(const base::Json& object, std::string_view name, std::int64_t otherwise);
[[nodiscard]] bool flag_in(const base::Json& object, std::string_view name);

// RFC 4648, section 4.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);
// nullopt: not base64.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> bytes_of_base64(std::string_view text);

}  // namespace sightline::live::dap
