// Damaged streams on the machine: the program reports them and draws nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/programs/stripes/stripes.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/programs/stripes/views.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::stripes {
namespace {

using jones::Dice;
using Bytes = std::vector<std::uint8_t>;

// A triangle over a square.
ProjectedScene two_faces() {
  ProjectedScene scene;
  scene.faces.resize(2);
  scene.faces[0].rings = {{{0x1000, 0x1000, 0x100}, {0x9000, 0x1800, 0x100}, {0x4000, 0xA000, 0x100}}};
  scene.faces[0].level = 7;
  scene.faces[0].d = 0x100;
  scene.faces[1].rings = {{{0x2000, 0x2000, 0x800}, {0xA000, 0x2000, 0x800}, {0xA000, 0xA000, 0x800}, {0x2000, 0xA000, 0x800}}};
  scene.faces[1].level = 3;
  scene.faces[1].d = 0x800;
  return scene;
}

Bytes stream_of(const StreamOptions& options) { return encode(two_faces(), options)->bytes; }

void expect_refused(const Bytes& stream, Status status, const std::string& name, std::uint8_t fault = 0) {
  const CheckedPicture picture = run_both(stream);
  EXPECT_EQ(picture.difference, "") << name;
  EXPECT_TRUE(picture.machine.ended) << name;
  EXPECT_EQ(picture.machine.status, status) << name << ": " << text_of(picture.machine.status);
  EXPECT_EQ(picture.machine.fault, fault) << name;
  EXPECT_EQ(picture.machine.raster, core::Raster()) << name;
  EXPECT_TRUE(picture.machine.commands.empty()) << name;
}

TEST(StripesDamage, TheStreamsAreCorrect) {
  for (const Output output : outputs)
    for (const Computer stripes : both)
      for (const Computer priority : both) {
        const CheckedPicture picture = run_both(stream_of({output, stripes, priority}));
        EXPECT_EQ(picture.machine.status, Status::complete);
        EXPECT_EQ(picture.machine.order, (std::vector<std::uint8_t>{0, 1}));
      }
}

// Of every byte one bit, and all bits.
TEST(StripesDamage, AChangedByteIsFound) {
  const Bytes right = stream_of({Output::raster, Computer::i8080, Computer::i8080});
  for (std::size_t at = 0; at < right.size(); ++at) {
    for (const std::uint8_t change : {std::uint8_t(1U << at % 8), std::uint8_t{0xFF}}) {
      Bytes bytes = right;
      bytes[at] ^= change;
      const CheckedPicture picture = run_both(bytes);
      EXPECT_EQ(picture.difference, "");
      EXPECT_NE(picture.machine.status, Status::complete) << "byte " << at;
      EXPECT_NE(picture.machine.status, Status::running) << "byte " << at;
      EXPECT_EQ(picture.machine.raster, core::Raster()) << "byte " << at;
    }
  }
}

TEST(StripesDamage, ExchangedBytesAreFound) {
  const Bytes right = stream_of({Output::raster, Computer::i8080, Computer::i8080});
  for (std::size_t at = header_bytes; at + 3 < right.size(); ++at) {
    if (right[at] == right[at + 1]) continue;
    Bytes bytes = right;
    std::swap(bytes[at], bytes[at + 1]);
    expect_refused(bytes, Status::checksum, "byte " + std::to_string(at));
  }
}

TEST(StripesDamage, AStreamThatEndsEarlyIsFound) {
  const Bytes right = stream_of({Output::vector, Computer::host, Computer::i8080});
  for (std::size_t length = 0; length < right.size(); length += tests::effort(std::size_t{97}, std::size_t{307}))
    expect_refused(Bytes(right.begin(), right.begin() + static_cast<std::ptrdiff_t>(length)), Status::link_silent,
                   std::to_string(length) + " bytes");
  expect_refused(Bytes(right.begin(), right.end() - 1), Status::link_silent, "all but one");
}

// Headers with correct check sums.
TEST(StripesDamage, HeadersAreChecked) {
  const auto with = [](std::size_t at, std::uint8_t value) {
    Bytes bytes = stream_of({Output::raster, Computer::i8080, Computer::i8080});
    bytes[at] = value;
    return bytes;
  };
  expect_refused(with(0, 0x54), Status::not_a_stream, "first byte");
  expect_refused(with(1, 2), Status::not_a_stream, "version");
  expect_refused(with(4, 8), Status::not_a_stream, "mode");
  expect_refused(framed(0, 65, {}), Status::too_large, "65 faces");
  expect_refused(framed(0, 1, Bytes(0x6801)), Status::too_large, "a body of 6801h bytes");
}

// Bodies with correct check sums, each with one error.
TEST(StripesDamage, RecordsAreChecked) {
  struct Change {
    const char* name;
    std::size_t at;  // in the record of the second face
    std::uint8_t value;
  };
  const auto body_of = [](const StreamOptions& options) {
    const Bytes bytes = stream_of(options);
    return Bytes(bytes.begin() + header_bytes, bytes.end() - 2);
  };
  const auto second = [](const Bytes& body) { return std::size_t{body[0]} + 256U * body[1]; };
  const Bytes polygons = body_of({Output::raster, Computer::i8080, Computer::i8080});
  const std::size_t record = second(polygons);
  for (const Change& change : {Change{"length + 1", 0, static_cast<std::uint8_t>(polygons[record] + 1)},
                               Change{"length - 1", 0, static_cast<std::uint8_t>(polygons[record] - 1)},
                               Change{"length 0", 0, 0}, Change{"a long record", 1, 0x7F}, Change{"length beyond memory", 1, 0xFF},
                               Change{"level 0", 2, 0}, Change{"level 8", 2, 8}, Change{"c of 0", 7, 0}, Change{"c below 0", 8, 0x80},
                               Change{"no ring", 13, 0}, Change{"one ring more", 13, 2}, Change{"a ring of 2", 14, 2},
                               Change{"a ring of 5", 14, 5}, Change{"X above FF00", 16, 0xFF}, Change{"Y above FF00", 18, 0xFF},
                               Change{"Z above FF00", 20, 0xFF}}) {
    Bytes body = polygons;
    body[record + change.at] = change.value;
    // X, Y or Z of FF00 is allowed.
    if (change.value == 0xFF && change.at >= 16) body[record + change.at - 1] = 1;
    if (std::string(change.name) == "c of 0") body[record + 8] = 0;
    expect_refused(framed(find_priority, 2, body), Status::bad_record, change.name, 1);
  }
  Bytes longer = polygons;
  longer.push_back(0);
  expect_refused(framed(find_priority, 2, longer), Status::bad_record, "a byte behind the last record", 2);
  expect_refused(framed(find_priority, 3, polygons), Status::bad_record, "a face more than there is", 2);
  const Bytes lists = body_of({Output::raster, Computer::host, Computer::host});
  const std::size_t stripes = second(lists);
  for (const Change& change : {Change{"lines above the picture", 3, 250}, Change{"a line too many", 4, 129}, Change{"a line less", 4, 127},
                               Change{"toggles that descend", 5, 0xA1}, Change{"equal toggles", 6, lists[stripes + 5]},
                               Change{"a line without an end", 7, 254}}) {
    Bytes body = lists;
    body[stripes + change.at] = change.value;
    expect_refused(framed(faces_are_stripes, 2, body), Status::bad_record, change.name, 1);
  }
  const auto line_of = [](int toggles) {
    Bytes body{0, 0, 1, 10, 1};
    for (int k = 0; k < toggles; ++k) body.push_back(static_cast<std::uint8_t>(2 * k));
    body.push_back(255);
    body[0] = static_cast<std::uint8_t>(body.size());
    return body;
  };
  expect_refused(framed(faces_are_stripes, 1, line_of(16)), Status::bad_record, "16 toggles");
  EXPECT_EQ(run_both(framed(faces_are_stripes, 1, line_of(15))).machine.status, Status::complete);
}

// Random bytes in a correct frame: the program ends as its twin does.
TEST(StripesDamage, AnyRecordsEnd) {
  constexpr std::uint32_t seed = 1985;
  Dice dice(seed);
  const int streams = tests::effort(600, 100);
  const Bytes right = stream_of({Output::raster, Computer::host, Computer::i8080});
  for (int n = 0; n < streams; ++n) {
    Bytes body(right.begin() + header_bytes, right.end() - 2);
    for (int changes = dice(1, 3); changes > 0; --changes)
      body[static_cast<std::size_t>(dice(0, static_cast<int>(body.size()) - 1))] = static_cast<std::uint8_t>(dice(0, 255));
    const std::uint8_t mode = dice(0, 3) == 0 ? static_cast<std::uint8_t>(dice(0, 7)) : right[4] | static_cast<std::uint8_t>(dice(0, 1));
    const CheckedPicture picture = run_both(framed(mode, 2, body));
    ASSERT_EQ(picture.difference, "") << "stream " << n << " of seed " << seed;
    ASSERT_TRUE(picture.machine.ended) << "stream " << n << " of seed " << seed;
  }
}

TEST(StripesDamage, ADeviceMustAnswer) {
  for (const Output output : outputs) {
    MachineOptions options;
    options.device = Device::none;
    const MachinePicture picture = run_machine(resident_program(), stream_of({output, Computer::i8080, Computer::i8080}), options);
    EXPECT_TRUE(picture.ended);
    EXPECT_EQ(picture.status, Status::no_device);
  }
}

// Combs with adjacent teeth: the silhouette has more ends in a line than fit.
ProjectedScene combs(int count) {
  ProjectedScene scene;
  for (int f = 0; f < count; ++f) {
    SceneFace& face = scene.faces.emplace_back();
    face.body = static_cast<std::uint32_t>(f);
    for (int tooth = 0; tooth < 7; ++tooth) {
      const auto west = static_cast<std::uint16_t>(256 * (f * 80 + tooth * 10));
      const auto east = static_cast<std::uint16_t>(west + 256 * 5);
      face.rings.push_back({{west, 0x1000, 0}, {east, 0x1000, 0}, {east, 0x8000, 0}, {west, 0x8000, 0}});
    }
  }
  return scene;
}

TEST(StripesDamage, ALineThatIsTooFullIsFound) {
  const auto run = [](int count) {
    return run_both(encode(combs(count), {Output::raster, Computer::i8080, Computer::host})->bytes);
  };
  EXPECT_EQ(run(2).machine.status, Status::complete);  // 28 ends
  const CheckedPicture picture = run(3);
  EXPECT_EQ(picture.difference, "");
  EXPECT_EQ(picture.machine.status, Status::full);
  EXPECT_EQ(picture.machine.fault, 2);
}

std::string message_of(const ProjectedScene& scene, const StreamOptions& options) {
  const auto stream = encode(scene, options);
  return stream ? "" : stream.error().message();
}

// Data that do not fit are reported before anything is sent: the part, and the excess.
TEST(StripesDamage, WhatDoesNotFitIsReported) {
  ProjectedScene many;
  many.faces.resize(67, two_faces().faces[0]);
  EXPECT_EQ(message_of(many, {}), "faces: 67 faces are turned to the eye, 3 too many, expected at most 64 for the 8080");
  ProjectedScene large;
  large.faces.resize(64);
  for (SceneFace& face : large.faces) face.rings = {{{0, 0, 0}, {0xF000, 0, 0}, {0xF000, 0xFF00, 0}, {0, 0xFF00, 0}}};
  // 64 faces of 255 lines of 3 bytes, 2 bytes and a head of 3; 26,624 bytes are free.
  EXPECT_EQ(message_of(large, {Output::raster, Computer::host, Computer::host}),
            "scene: 49280 bytes (49088 of stripes, 0 of polygons, 3 a face), 22656 too many, expected at most 26624 in the 8080's "
            "memory; let the 8080 make the stripes");
  EXPECT_EQ(message_of(large, {Output::raster, Computer::i8080, Computer::i8080}), "");
  ProjectedScene jagged;
  auto& ring = jagged.faces.emplace_back().rings.emplace_back();
  for (int k = 0; k < 9; ++k) {
    ring.push_back({static_cast<std::uint16_t>(k * 4096), 0x1000, 0});
    ring.push_back({static_cast<std::uint16_t>(k * 4096 + 2048), 0x9000, 0});
  }
  EXPECT_EQ(message_of(jagged, {}), "face 0 of body 0: 18 sides in a line, 3 too many, expected at most 15 for the 8080");
}

// Programs with one wrong byte: a checked run either fails or has the picture of the right program.
TEST(StripesDamage, ACheckedRunOfAWrongProgramFails) {
  NEEDS_OPTIMISED_CODE();  // some of these programs run to the limit of time
  const scene::PolyScene scene = scene::generate_boxes(2);
  const Order order{.scene = scene, .view = view_of(scene, scene.camera), .check = true};
  const auto right = run(order);
  ASSERT_TRUE(right) << right.error().message();
  Program program = resident_program();
  int differences = 0;
  for (std::size_t at = 100; at < program.memory.size(); at += 701) {
    program.memory[at] ^= 1U;
    const auto wrong = run(order, program);
    program.memory[at] ^= 1U;
    if (wrong) EXPECT_EQ(wrong->picture.raster, right->picture.raster) << "byte " << at;
    else differences += wrong.error().kind == base::ErrorKind::differs ? 1 : 0;
  }
  EXPECT_GT(differences, 0);
}

}  // namespace
}  // namespace sightline::programs::stripes
