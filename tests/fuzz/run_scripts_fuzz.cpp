// Any bytes as each of the scripts that `sightline run pdp7` takes: an invalid script is rejected as bad input with the file
// name.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "host/machines/machine.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  const machines::MachineDescription& pdp7 = machines::pdp7();
  for (const char* const option : {"--switches", "--keyboard", "--light-pen"}) {
    machines::Arguments arguments(pdp7.options);
    arguments.value(option).text = "fuzz";
    const auto machine = pdp7.make(arguments, [data, size](const std::string& path) {
      return machines::Input{path, {data, data + size}};
    });
    if (machine) continue;
    const base::Error& refusal = machine.error();
    if (refusal.kind != base::ErrorKind::bad_input || !refusal.message().starts_with("fuzz:")) std::abort();
  }
  return 0;
}
