// A reminder for the author of a new member: the size of a class with state has changed. If the member is state, visit it in
// visit_state,
// document it in host/manual/formats.md and increment live::snapshot_version. Then correct the size here.
//
// The sizes are those of one implementation of the library; the law of snapshots (snapshot_law.hpp) is tested on all.
#include <gtest/gtest.h>

#include <cstddef>

#include "emulators/machines/i8080_devices.hpp"
#include "emulators/machines/i8080_parts.hpp"
#include "emulators/machines/pdp7_devices.hpp"
#include "emulators/machines/pdp7.hpp"
#include "host/machines/pdp7_scripts.hpp"

namespace sightline::test {
namespace {

using machines::PenMove;

template <class State>
void expect_size(std::size_t expected, const char* name) {
  EXPECT_EQ(sizeof(State), expected) << name << " has a new member: see this file's beginning";
}

#if defined(__GLIBCXX__) && defined(__x86_64__)
TEST(StateMembers, AreVisited) {
  expect_size<pdp7::State>(24, "pdp7::State");
  expect_size<pdp7::Console>(40, "pdp7::Console");
  expect_size<pdp7::CoreMemory>(32, "pdp7::CoreMemory");
  expect_size<pdp7::Clock>(48, "pdp7::Clock");
  expect_size<pdp7::Reader>(88, "pdp7::Reader");
  expect_size<pdp7::Punch>(64, "pdp7::Punch");
  expect_size<pdp7::Keyboard>(72, "pdp7::Keyboard");
  expect_size<pdp7::Printer>(64, "pdp7::Printer");
  expect_size<pdp7::Rb09>(168, "pdp7::Rb09");
  expect_size<pdp7::rb09::Counters>(32, "pdp7::rb09::Counters");
  expect_size<type340::Registers>(32, "type340::Registers");
  expect_size<type340::Delays>(88, "type340::Delays");
  expect_size<type340::CharacterPath>(656, "type340::CharacterPath");
  expect_size<type340::LightPen>(16, "type340::LightPen");
  expect_size<type340::Counters>(88, "type340::Counters");
  expect_size<core::DataBreak>(12, "core::DataBreak");
  expect_size<type340::Display>(984, "type340::Display");
  expect_size<pdp7::Counts>(24, "pdp7::Counts");
  expect_size<pdp7::Unanswered>(24, "pdp7::Unanswered");
  expect_size<pdp7::Machine>(1024, "pdp7::Machine");
  expect_size<core::Raster>(65536, "core::Raster");
  expect_size<i8080::State>(16, "i8080::State");
  expect_size<devices::Alt256>(65600, "devices::Alt256");
  expect_size<devices::Alt256Counts>(32, "devices::Alt256Counts");
  expect_size<devices::AltairSerial>(240, "devices::AltairSerial");
  expect_size<devices::AltairSerialCounts>(24, "devices::AltairSerialCounts");
  expect_size<devices::CalComp565>(136, "devices::CalComp565");
  expect_size<devices::CalComp565Counts>(72, "devices::CalComp565Counts");
  expect_size<devices::Minigraf0507>(152, "devices::Minigraf0507");
  expect_size<devices::MinigrafCounts>(56, "devices::MinigrafCounts");
  expect_size<devices::ef9365::Drawing>(65560, "devices::ef9365::Drawing");
  expect_size<devices::Ef9365>(65688, "devices::Ef9365");
  expect_size<devices::Ef9365Counts>(48, "devices::Ef9365Counts");
  expect_size<devices::KeptBytes>(48, "devices::KeptBytes");
  expect_size<devices::I8255>(27, "devices::I8255");
  expect_size<devices::ParallelLink>(248, "devices::ParallelLink");
  expect_size<devices::SerialFrame>(16, "devices::SerialFrame");
  expect_size<devices::SerialFormat>(12, "devices::SerialFormat");
  expect_size<devices::I8251>(176, "devices::I8251");
  expect_size<devices::I8251Counts>(64, "devices::I8251Counts");
  expect_size<devices::SerialLink>(328, "devices::SerialLink");
  expect_size<i8080::UnansweredPort>(16, "i8080::UnansweredPort");
  expect_size<i8080::UndefinedOpcode>(16, "i8080::UndefinedOpcode");
  expect_size<i8080::UndefinedOpcodes>(32, "i8080::UndefinedOpcodes");
  expect_size<i8080::PinLatches>(9, "i8080::PinLatches");
  expect_size<i8080::MachineParts>(96552, "i8080::MachineParts");
  expect_size<PenMove>(32, "PenMove");
}
#endif

}  // namespace
}  // namespace sightline::test
