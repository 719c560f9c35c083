#include "host/live/dap/places.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <optional>

#include "host/base/number.hpp"
#include "host/live/dap/messages.hpp"

namespace sightline::live::dap {

std::string reference(std::uint32_t at) {
  return fmt::format("0x{:X}", at);
}

std::uint32_t bytes_a_word(const Debugger& debugger) {
  return debugger.description().word_bits > 8 ? 4 : 1;
}

std::uint32_t place_of(const Debugger& debugger, std::string_view text, std::int64_t offset) {
  std::optional<std::uint64_t> at;
  if (text.starts_with("0x") || text.starts_with("0X")) at = base::unsigned_number(text.substr(2), 16);
  if (!at) at = base::count_number(text);
  const std::int64_t words = debugger.machine().words();
  const std::int64_t place = at && *at < (std::uint64_t{1} << 32)
                                 ? static_cast<std::int64_t>(*at) + offset / static_cast<std::int64_t>(bytes_a_word(debugger))
                                 : -1;
  if (place < 0 || place >= words) {
    throw base::usage_error(fmt::format("found {} and {} bytes, expected an address in {}, 0x0 to 0x{:X}", text, offset,
                              debugger.description().memory_name, words - 1));
  }
  return static_cast<std::uint32_t>(place);
}

base::Json source_of(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path path = std::filesystem::absolute(file, ignored);
  return base::Json{{"name", path.filename().string()}, {"path", path.string()}};
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return a == b || std::filesystem::weakly_canonical(a, ignored) == std::filesystem::weakly_canonical(b, ignored);
}

}  // namespace sightline::live::dap
