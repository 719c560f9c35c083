// The page of live machines (host/live/web), packed by gzip; empty where it could not be made when the program was built.
#pragma once

#include <cstdint>
#include <span>

namespace sightline::app {

[[nodiscard]] std::span<const std::uint8_t> packed_page();

}  // namespace sightline::app
