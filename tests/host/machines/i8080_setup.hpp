// Devices of an 8080 for tests; an error in them ends the test program.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/machines/i8080.hpp"

namespace sightline::test {

inline void require_empty(const std::string& error) {
  if (error.empty()) return;
  std::fputs(error.c_str(), stderr);
  std::abort();
}

inline void attach(machines::I8080Setup& setup, std::string_view device, const std::vector<core::Setting>& settings = {}) {
  require_empty(setup.machine->attach(device, settings));
}
inline void wire(machines::I8080Setup& setup, std::string_view line, std::uint8_t restart) {
  require_empty(setup.machine->wire(line, restart));
}
// Attaches a link through which the host sends these bytes.
inline void attach_link(machines::I8080Setup& setup, std::string_view link, machines::Bytes bytes) {
  attach(setup, link);
  const machines::Bytes& kept = setup.sent[link] = std::move(bytes);
  setup.machine->device(link)->link_host()->send(kept);
}

}  // namespace sightline::test
