// A reminder for the author of a new member: a class with state has another size now. Visit the member in visit_state, if
// it is state, document it in host/manual/formats.md, count up live::snapshot_version, and correct the size here.
//
// The sizes are those of one implementation of the library; the law of snapshots (snapshot_law.hpp) is tested on all.
#include <gtest/gtest.h>

#include <cstddef>

#include "emulators/machines/i8080_machine.hpp"
#include "emulators/machines/pdp7.hpp"
#include "emulators/machines/skala_ports.hpp"
#include "host/guests/run/pdp7_scripts.hpp"

namespace sightline::test {
namespace {

using Ports = machines::SkalaPorts<>;
using Machine8080 = machines::I8080Machine<Ports>;
using guests::run::PenMove;

template <class State>
void expect_size(std::size_t expected, const char* name) {
  EXPECT_EQ(sizeof(State), expected) << name << " has a new member: see this file's beginning";
}

#if defined(__GLIBCXX__) && defined(__x86_64__)
TEST(StateMembers, AreVisited) {
  expect_size<pdp7::State>(0, "pdp7::State");
  expect_size<pdp7::Console>(0, "pdp7::Console");
  expect_size<pdp7::CoreMemory>(0, "pdp7::CoreMemory");
  expect_size<pdp7::Clock>(0, "pdp7::Clock");
  expect_size<pdp7::Reader>(0, "pdp7::Reader");
  expect_size<pdp7::Punch>(0, "pdp7::Punch");
  expect_size<pdp7::Keyboard>(0, "pdp7::Keyboard");
  expect_size<pdp7::Printer>(0, "pdp7::Printer");
  expect_size<pdp7::Peripherals>(0, "pdp7::Peripherals");
  expect_size<type340::Registers>(0, "type340::Registers");
  expect_size<type340::Delays>(0, "type340::Delays");
  expect_size<type340::CharacterPath>(0, "type340::CharacterPath");
  expect_size<type340::LightPen>(0, "type340::LightPen");
  expect_size<type340::Counters>(0, "type340::Counters");
  expect_size<type340::BreakRequest>(0, "type340::BreakRequest");
  expect_size<type340::Display<>>(0, "type340::Display<>");
  expect_size<machines::Counts>(0, "machines::Counts");
  expect_size<machines::Unanswered>(0, "machines::Unanswered");
  expect_size<machines::Pdp7<>>(0, "machines::Pdp7<>");
  expect_size<core::Raster>(0, "core::Raster");
  expect_size<i8080::State>(0, "i8080::State");
  expect_size<devices::Alt256>(0, "devices::Alt256");
  expect_size<devices::Alt256Counts>(0, "devices::Alt256Counts");
  expect_size<devices::CalComp565<core::NoStrokes>>(0, "devices::CalComp565<core::NoStrokes>");
  expect_size<devices::CalComp565Counts>(0, "devices::CalComp565Counts");
  expect_size<devices::Minigraf0507<core::NoStrokes>>(0, "devices::Minigraf0507<core::NoStrokes>");
  expect_size<devices::MinigrafCounts>(0, "devices::MinigrafCounts");
  expect_size<devices::ef9365::Drawing>(0, "devices::ef9365::Drawing");
  expect_size<devices::Ef9365>(0, "devices::Ef9365");
  expect_size<devices::Ef9365Counts>(0, "devices::Ef9365Counts");
  expect_size<devices::KeptBytes>(0, "devices::KeptBytes");
  expect_size<devices::I8255>(0, "devices::I8255");
  expect_size<devices::ParallelLink>(0, "devices::ParallelLink");
  expect_size<devices::SerialFrame>(0, "devices::SerialFrame");
  expect_size<devices::SerialFormat>(0, "devices::SerialFormat");
  expect_size<devices::I8251>(0, "devices::I8251");
  expect_size<devices::I8251Counts>(0, "devices::I8251Counts");
  expect_size<devices::SerialLink>(0, "devices::SerialLink");
  expect_size<machines::UnansweredPort>(0, "machines::UnansweredPort");
  expect_size<Ports>(0, "Ports");
  expect_size<Machine8080>(0, "Machine8080");
  expect_size<PenMove>(0, "PenMove");
}
#endif

}  // namespace
}  // namespace sightline::test
