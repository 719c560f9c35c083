// See eae_option.hpp.
#include "host/app/eae_option.hpp"

#include <CLI/CLI.hpp>

namespace sightline::app {

void add_eae_options(CLI::App& command, bool& no_eae) {
  CLI::Option* const with = command.add_flag("--eae")->description(
      "The PDP-7 with the Type 177 extended arithmetic element, the default");
  command.add_flag("--no-eae", no_eae, "The PDP-7 without it, where 64xxxx does nothing")->excludes(with);
}

void add_eae_options(const Command& command, bool& no_eae) {
  const Option with =
      command.flag("--eae", "The PDP-7 with the Type 177 extended arithmetic element, the default");
  command.flag("--no-eae", no_eae, "The PDP-7 without it, where 64xxxx does nothing").excludes(with);
}

}  // namespace sightline::app
