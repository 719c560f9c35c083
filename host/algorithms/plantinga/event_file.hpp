// A list of events as a file, so that preprocessing is done once.
//
// Layout, numbers least significant byte first: "SIGHTLINE EVENTS\n", a version byte, the fingerprint of the
// model (8 bytes), the tolerance (8, IEEE double); then, as variable-length numbers of 7 bits a byte: the
// structures of all edges before the first event; the events, each with its direction and, for every edge
// that changes, the pieces that come. Those that go are what the edge had, and are found by going through the
// turn once. Last a checksum (FNV-1a, 8 bytes) of all before it. The same list gives the same bytes.
//
// A reader believes nothing: events must ascend, every number must name something of the model, and the turn
// must end where it began.
#pragma once

#include <string>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/base/file.hpp"
#include "host/base/result.hpp"

namespace sightline::algorithms::plantinga {

[[nodiscard]] base::Bytes encode_events(const EventList& list);
// `name` names the file in errors, which say where, what was found and what was expected.
[[nodiscard]] base::Result<EventList> decode_events(const base::Bytes& bytes, const std::string& name,
                                                    const RotationModel& model);

// Complete or not at all: written beside, then renamed.
[[nodiscard]] base::Result<base::Done> write_events(const std::string& path, const EventList& list);
[[nodiscard]] base::Result<EventList> read_events(const std::string& path, const RotationModel& model);

}  // namespace sightline::algorithms::plantinga
