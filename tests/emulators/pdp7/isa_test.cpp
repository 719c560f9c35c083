// The instruction table as a check on the processor: its cycle counts compared with the bus cycles that an instruction uses.
#include "emulators/pdp7/isa.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "emulators/machines/pdp7_devices.hpp"
#include "tests/emulators/pdp7/array_bus.hpp"

namespace sightline {
namespace {

// Runs one word at 100, with every address it can reference leading to a NOP at 200, and returns its cycles.
int cycles_of(std::uint32_t word) {
  tests::ArrayMachine machine;
  machine.core[0100] = core::Word18(word);
  machine.core[0200] = core::Word18(0740000);
  machine.core[0300] = core::Word18(0200);
  machine.core[0010] = core::Word18(0177);
  pdp7::State state;
  state.pc = 0100;
  tests::run_on_array(machine, state);
  return machine.cycles;
}

TEST(Pdp7Isa, TableCyclesAreTheBusVerbsOfTheDirectForm) {
  for (const auto& row : pdp7::instructions) {
    const bool memory = row.operands == pdp7::Operands::address;
    const bool execute = row.operation == pdp7::Operation::xct;
    EXPECT_EQ(cycles_of(row.value | (memory ? 0200U : 0U)), row.cycles + (execute ? 1 : 0)) << row.mnemonic;
  }
}

TEST(Pdp7Isa, AnIndirectReferenceTakesOneCycleMore) {
  for (const auto& row : pdp7::instructions) {
    if (row.operands != pdp7::Operands::address) continue;
    const int direct = cycles_of(row.value | 0200U);
    EXPECT_EQ(cycles_of(row.value | pdp7::indirect_bit | 0300U), direct + 1) << row.mnemonic;
    EXPECT_EQ(cycles_of(row.value | pdp7::indirect_bit | 0010U), direct + 1) << row.mnemonic << " auto-index";
  }
}

TEST(Pdp7Isa, EveryWordHasOneRowAndEveryMnemonicOneRow) {
  std::set<std::string_view> names;
  for (const auto& row : pdp7::instructions) EXPECT_TRUE(names.insert(row.mnemonic).second) << row.mnemonic;
  for (std::uint32_t word = 0; word <= 0777777; ++word) {
    const auto& row = pdp7::instruction_of(word);
    ASSERT_EQ(word & row.mask, row.value) << std::oct << word;
  }
}

TEST(Pdp7Isa, MicroinstructionsStandInTheClassTheirNameSays) {
  std::set<std::string_view> names;
  for (const auto& micro : pdp7::microinstructions) {
    const auto& row = pdp7::instruction_of(micro.value);
    EXPECT_TRUE(names.insert(micro.name).second) << micro.name;
    EXPECT_NE(row.instruction_class, pdp7::Class::memory) << micro.name;
  }
  for (const auto& device : pdp7::device_infos) {
    for (const core::IotName& iot : device.iots) {
      EXPECT_TRUE(names.insert(iot.mnemonic).second) << iot.mnemonic;
      EXPECT_EQ(pdp7::instruction_of(iot.word).instruction_class, pdp7::Class::iot) << iot.mnemonic;
      const auto code = static_cast<std::uint8_t>(iot.word >> 6 & 077U);
      EXPECT_NE(std::find(device.codes.begin(), device.codes.end(), code), device.codes.end()) << iot.mnemonic;
    }
  }
}

// XCT XCT ... LAC: sixteen XCTs are followed, the seventeenth stops.
TEST(Pdp7Cpu, AnXctChainOfSixteenIsFollowedAndOneOfSeventeenStops) {
  for (const std::uint32_t length : {16U, 17U}) {
    tests::ArrayMachine machine;
    for (std::uint32_t i = 0; i < length; ++i) machine.core[0100 + i] = core::Word18(0400101 + i);
    machine.core[0100 + length] = core::Word18(0750001);
    pdp7::State state;
    state.pc = 0100;
    const pdp7::Timing timing;
    const pdp7::Model model;
    pdp7::Cpu<tests::ArrayBus> cpu(tests::ArrayBus(machine), model, timing, state);
    EXPECT_EQ(cpu.step(), length == 16 ? pdp7::Outcome::completed : pdp7::Outcome::xct_chain);
    EXPECT_EQ(cpu.state().ac.value(), length == 16 ? 0777777U : 0U);
  }
}

TEST(Pdp7Cpu, AnXctOfItselfStops) {
  tests::ArrayMachine machine;
  machine.core[0100] = core::Word18(0400100);
  pdp7::State state;
  state.pc = 0100;
  const pdp7::Timing timing;
  const pdp7::Model model;
  pdp7::Cpu<tests::ArrayBus> cpu(tests::ArrayBus(machine), model, timing, state);
  EXPECT_EQ(cpu.step(), pdp7::Outcome::xct_chain);
}

TEST(Pdp7Cpu, WithoutTheEaeItsClassIsACountedNoOperation) {
  tests::ArrayMachine machine;
  machine.core[0100] = core::Word18(0653122);
  pdp7::State state;
  state.pc = 0100;
  state.ac = core::Word18(05);
  pdp7::Model model;
  model.eae = false;
  pdp7::State expected = state;
  expected.pc = 0101;
  EXPECT_EQ(tests::run_on_array(machine, state, 1, model), expected);
  EXPECT_EQ(machine.unanswered, 1);
  EXPECT_EQ(machine.cycles, 1);
}

// JMS 200 at 100 saves the word: the PC in it is that of the next instruction.
TEST(Pdp7Cpu, SavedWordHasLinkExtendAndTrapAboveThePc) {
  tests::ArrayMachine machine;
  machine.core[0100] = core::Word18(0100200);
  pdp7::State state;
  state.pc = 0100;
  const auto saved = [&] {
    static_cast<void>(tests::run_on_array(machine, state));
    return machine.core[0200].value();
  };
  EXPECT_EQ(saved(), 0000101U);
  state.link = true;
  EXPECT_EQ(saved(), 0400101U);
  state.extend = state.trap_mode = true;
  EXPECT_EQ(saved(), 0700101U);
}

}  // namespace
}  // namespace sightline
