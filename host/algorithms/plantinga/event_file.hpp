// Stores a list of events as a file, so that preprocessing is done only once.
//
// Layout, numbers least significant byte first: "SIGHTLINE EVENTS
// ", a version byte, the fingerprint of the model (8 bytes), the tolerance (8 bytes, IEEE double). Then, as
// variable-length numbers of 7 bits per byte: the structures of all edges before the first event, and the events, each
// with its direction and, for every edge that changes, the pieces added. The pieces removed are those the edge had; the
// reader finds them by going through the turn once. Last a checksum (FNV-1a, 8 bytes) of everything before it. The same
// list gives the same bytes.
//
// A reader checks everything: events must ascend, every number must refer to a part of the model, and the turn must end
// with the structures that it starts with.
#pragma once

#include <string>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/base/file.hpp"
#include "host/base/result.hpp"

namespace sightline::algorithms::plantinga {

[[nodiscard]] base::Bytes encode_events(const EventList& list);
// `name` is the name of the file in errors, which give the place, what was found and what was expected.
[[nodiscard]] base::Result<EventList> decode_events(const base::Bytes& bytes, const std::string& name,
                                                    const RotationModel& model);

// Writes a temporary file and renames it, so the file is complete or absent.
[[nodiscard]] base::Result<base::Done> write_events(const std::string& path, const EventList& list);
[[nodiscard]] base::Result<EventList> read_events(const std::string& path, const RotationModel& model);

}  // namespace sightline::algorithms::plantinga
