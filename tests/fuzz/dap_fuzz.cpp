// Any bytes from the client of a debug adapter that launches a small PDP-7: the session ends, with or without an error, and
// every reply is framed. The input is sent as it is, and then each line of it as a message.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "host/live/dap/dap.hpp"
#include "tests/host/live/small_pdp7.hpp"

namespace {

using namespace sightline;

void run_session(std::string_view bytes) {
  int patience = 60;
  live::DapHost host;
  host.read = [&bytes, &patience](int milliseconds) -> std::optional<std::string> {
    // While the machine runs some polls find no message.
    if (milliseconds == 0 && --patience > 0 && patience % 4 != 0) return std::string();
    if (bytes.empty()) return std::nullopt;
    const std::string piece(bytes.substr(0, 50));
    bytes.remove_prefix(piece.size());
    return piece;
  };
  host.write = [](std::string_view text) {
    if (!text.starts_with("Content-Length: ")) std::abort();
    return true;
  };
  host.launch = [](const base::Json&) -> base::Result<live::Launched> {
    machines::Limits limits;
    limits.instructions = 3000;
    return live::Launched{&machines::pdp7(), {test::small_pdp7(true), limits}, live::Symbols(8), {}};
  };
  static_cast<void>(live::serve_debug_adapter(host));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  run_session(text);
  std::string framed;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    framed += "Content-Length: " + std::to_string(line.size()) + "\r\n\r\n" + std::string(line);
  }
  run_session(framed);
  return 0;
}
