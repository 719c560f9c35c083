// The page of live machines (host/live/web), compressed by gzip; empty if the page was not built.
#pragma once

#include <cstdint>
#include <span>

namespace sightline::app {

[[nodiscard]] std::span<const std::uint8_t> packed_page();

}  // namespace sightline::app
