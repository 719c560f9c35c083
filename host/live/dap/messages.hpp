// Messages of the Debug Adapter Protocol as bytes, and what is read from them.
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

// The messages in the bytes that come in: Content-Length: N, an empty line, N bytes of JSON.
class Framing {
 public:
  void take(std::string_view bytes) { buffer_ += bytes; }
  // The next whole message, an object; nullopt: more is needed. An error: what came is not the protocol.
  [[nodiscard]] base::Result<std::optional<base::Json>> next();

 private:
  std::string buffer_;
};

// A message as it is sent.
[[nodiscard]] std::string framed(const base::Json& message);

// Members of an object. One that is absent or of another type is null, an empty text, `otherwise`, false. An integer beyond 2^53 in
// magnitude is taken as 2^53, so that adding to it cannot overflow.
[[nodiscard]] const base::Json& member(const base::Json& object, std::string_view name);
[[nodiscard]] std::string text_in(const base::Json& object, std::string_view name);
[[nodiscard]] std::int64_t integer_in(const base::Json& object, std::string_view name, std::int64_t otherwise);
[[nodiscard]] bool flag_in(const base::Json& object, std::string_view name);

// RFC 4648, section 4.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);
// nullopt: not base64.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> bytes_of_base64(std::string_view text);

}  // namespace sightline::live::dap
