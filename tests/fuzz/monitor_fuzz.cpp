// Any bytes as monitor commands for a small PDP-7: each answer consists of whole lines, and inspecting the past afterwards
// does not change the machine in any bit.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "host/machines/engine.hpp"
#include "host/live/console.hpp"
#include "host/live/monitor/monitor.hpp"
#include "host/live/snapshot.hpp"
#include "tests/host/live/small_pdp7.hpp"

namespace {

using namespace sightline;

void require(bool holds) {
  if (!holds) std::abort();
}

// Files are empty, and output is discarded.
live::MonitorHost host(int& patience) {
  live::MonitorHost host;
  host.running.run = [&patience](machines::Machine& machine, const machines::Limits& limits, const auto& heard) {
    std::optional<machines::Stop> stop;
    while (!stop) {
      stop = machine.run(limits, false);
      heard(live::shown_text(machine.take_printed()));
      if (!stop && --patience < 0) stop = machines::Stop{machines::interrupted, {}};
    }
    return *stop;
  };
  host.running.interrupted = [&patience] { return --patience < 0; };
  host.running.print = [](std::string_view) {};
  host.read = [](const std::string& path) -> base::Result<machines::Input> { return machines::Input{path, {}}; };
  host.write = [](const std::string&, std::span<const std::uint8_t>) -> base::Result<base::Done> { return base::Done{}; };
  host.speed = [](const std::string&) -> base::Result<base::Done> { return base::usage_error("there is no console"); };
  return host;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto machine = test::small_pdp7(true);
  int patience = 50;
  machines::Limits limits;
  limits.instructions = 3000;
  live::Monitor monitor(machines::pdp7(), *machine, limits, live::Symbols(8), host(patience));
  const std::string text(data, data + size);
  std::string_view rest = text;
  for (int lines = 0; !rest.empty() && lines < 20; ++lines) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const live::Answer answer = monitor.execute(line);
    require(answer.text.empty() || answer.text.back() == '\n');
    if (answer.kind == live::Answer::Kind::quit) break;
    static_cast<void>(monitor.completions(line, line.substr(line.size() / 2)));
  }
  const machines::Bytes before = live::save_snapshot("pdp7", *machine);
  for (const char* const look : {"history 100", "who 7", "show stack", "show display", "list"})
    require(monitor.execute(look).kind == live::Answer::Kind::done);
  require(live::save_snapshot("pdp7", *machine) == before);
  return 0;
}
