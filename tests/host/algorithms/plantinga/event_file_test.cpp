// Event files: round trips, and an error for every kind of damage.
#include "host/algorithms/plantinga/event_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/table_1.hpp"
#include "host/base/file.hpp"
#include "tests/host/algorithms/plantinga/turning_scenes.hpp"

namespace sightline::algorithms::plantinga {
namespace {

using base::Bytes;

struct Made {
  RotationModel model{three_boxes()};
  EventList list = *build_event_list(model);
  Bytes bytes = encode_events(list);
};

const Made& shared_event_list() {
  static const Made one;
  return one;
}

std::string error_of(const Bytes& bytes) {
  const auto read = decode_events(bytes, "x.events", shared_event_list().model);
  return read ? "" : read.error().message();
}

// Corrects the checksum, so that the contents are read.
Bytes signed_again(Bytes bytes) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (std::size_t i = 0; i + 8 < bytes.size(); ++i) hash = (hash ^ bytes[i]) * 1099511628211ULL;
  for (std::size_t i = 0; i < 8; ++i)
    bytes[bytes.size() - 8 + i] = static_cast<std::uint8_t>(hash >> (8 * i));
  return bytes;
}

TEST(EventFile, ThereAndBack) {
  const auto read = decode_events(shared_event_list().bytes, "x.events", shared_event_list().model);
  ASSERT_TRUE(read) << read.error().message();
  const EventList& list = shared_event_list().list;
  EXPECT_EQ(read->first, list.first);
  EXPECT_EQ(read->pieces, list.pieces);
  ASSERT_EQ(read->events.size(), list.events.size());
  for (std::size_t i = 0; i < list.events.size(); ++i) {
    EXPECT_EQ(read->events[i].direction, list.events[i].direction);
    EXPECT_EQ(read->events[i].direction.angle, list.events[i].direction.angle);
  }
  EXPECT_EQ(encode_events(*read), shared_event_list().bytes);
}

TEST(EventFile, TruncatedFilesAreErrors) {
  for (std::size_t size = 0; size < shared_event_list().bytes.size(); size += size < 60 ? 1 : 37) {
    const Bytes part(shared_event_list().bytes.begin(), shared_event_list().bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_NE(error_of(part), "") << size;
    // Also with a checksum of the truncated contents.
    EXPECT_TRUE(size <= 60 || !error_of(signed_again(part)).empty()) << size;
  }
  EXPECT_EQ(error_of({}),
            "x.events: byte 0: an empty file, expected SIGHTLINE EVENTS");
}

TEST(EventFile, ForeignFilesAreErrors) {
  Bytes bytes = shared_event_list().bytes;
  bytes[17] = 9;
  EXPECT_EQ(error_of(bytes), "x.events: byte 17: version 9, expected version 1");
  bytes = shared_event_list().bytes;
  bytes[200] ^= 1;
  EXPECT_NE(error_of(bytes).find("checksum"), std::string::npos);
  const RotationModel other(two_boxes());
  const auto read = decode_events(shared_event_list().bytes, "x.events", other);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message().find("events of another model"), std::string::npos);
}

TEST(EventFile, EveryDamagedByteIsAnErrorOrHarmless) {
  for (std::size_t i = 34; i + 8 < shared_event_list().bytes.size(); i += 3) {
    for (const int flip : {1, 4, 128}) {
      Bytes bytes = shared_event_list().bytes;
      bytes[i] = static_cast<std::uint8_t>(bytes[i] ^ flip);
      const auto read = decode_events(signed_again(bytes), "x.events", shared_event_list().model);
      if (!read) continue;
      EdgeStructureGraph graph(*read);  // then it can be used for a rotation
      for (std::size_t k = 0; k < read->events.size(); ++k) ASSERT_TRUE(graph.step_forward());
    }
  }
}

TEST(EventFile, OnDisk) {
  const std::string path = testing::TempDir() + "three_boxes.events";
  ASSERT_TRUE(write_events(path, shared_event_list().list));
  const auto read = read_events(path, shared_event_list().model);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->pieces, shared_event_list().list.pieces);
  std::filesystem::remove(path);
  const auto missing = read_events(path, shared_event_list().model);
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message().find(path), std::string::npos);
}

TEST(Table1, CountsChangesOfEdges) {
  const Table1Row row = table_1_row("three boxes", shared_event_list().model, shared_event_list().list, 0.5);
  EXPECT_EQ(row.edges, 36U);
  // The study used to check the specification finds 248 for the same three boxes, with the range cut at pi and with back edges of
  // a
  // solid counted by what its faces hide.
  EXPECT_EQ(row.events, shared_event_list().list.changes.size());
  EXPECT_GT(row.events, 200U) << row.events;
  EXPECT_LT(row.events, 300U);
  EXPECT_GE(row.most_events_per_edge, row.events / 36);
}

}  // namespace
}  // namespace sightline::algorithms::plantinga
