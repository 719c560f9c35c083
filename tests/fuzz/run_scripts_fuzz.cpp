// Any bytes as each of the scripts that `sightline run pdp7` takes: what is no script is a Failure of bad
// input that names the file.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "host/app/command.hpp"
#include "host/app/commands/run_scripts.hpp"

namespace {

using sightline::app::ExitCode;
using sightline::app::Failure;

template <class Read>
void read_script(Read read, std::string_view text) {
  try {
    static_cast<void>(read(text, "fuzz"));
  } catch (const Failure& failure) {
    if (failure.code() != ExitCode::bad_input || !std::string_view(failure.what()).starts_with("fuzz"))
      std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  read_script(sightline::app::read_switch_script, text);
  read_script(sightline::app::read_keyboard_script, text);
  read_script(sightline::app::read_light_pen_script, text);
  return 0;
}
