#include "host/guests/pdp7/machine.hpp"

#include <algorithm>

namespace sightline::guests {

void GuestSink::grow(std::size_t count) { strokes_.resize(std::max({std::size_t{4096}, 2 * strokes_.size(), kept_ + count})); }

void GuestWatch::tell() {
  for (std::size_t n = 0; n < kept_count_; ++n) told(kept_[n]);
  kept_count_ = 0;
}

GuestPdp7::GuestPdp7(const machines::Pdp7Options& options, GuestSink& sink, GuestWatch& watch)
    : Pdp7(options, sink, watch), watch_(watch) {}
GuestPdp7::~GuestPdp7() = default;

void GuestPdp7::start(pdp7::Address address) { Pdp7::start(address); }

machines::StopReason GuestPdp7::run(const machines::Limits& limits) {
  const machines::StopReason reason = Pdp7::run(limits);
  watch_.tell();
  return reason;
}

}  // namespace sightline::guests
