// 6688 single instructions with their results on another simulator.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/emulators/pdp7/array_bus.hpp"

namespace sightline {
namespace {

TEST(Pdp7Vectors, AllResultsOfAnotherSimulatorAreReproduced) {
  std::ifstream in(SIGHTLINE_TEST_DATA "/pdp7/instruction-vectors.csv");
  ASSERT_TRUE(in);
  int cases = 0;
  tests::ArrayMachine machine;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    std::string name;
    std::getline(fields, name, ',');
    std::vector<std::uint32_t> v;
    for (std::string field; std::getline(fields, field, ',');) {
      v.push_back(static_cast<std::uint32_t>(std::stoul(field, nullptr, 8)));
    }
    ASSERT_EQ(v.size(), 10U) << line;
    machine.switches = core::Word18(0707070);
    machine.core[0100] = core::Word18(v[0]);
    machine.core[0101] = core::Word18(v[4]);
    pdp7::State state;
    state.pc = 0100;
    state.sc = core::Word<6>(025);
    state.ac = core::Word18(v[1]);
    state.mq = core::Word18(v[2]);
    state.link = v[3] != 0;
    const pdp7::State after = tests::run_on_array(machine, state);
    const std::vector<std::uint32_t> got{after.ac.value(), after.mq.value(), after.link ? 1U : 0U,
                                         after.sc.value(), after.pc};
    ASSERT_EQ(got, (std::vector<std::uint32_t>(v.begin() + 5, v.end()))) << line;
    ++cases;
  }
  EXPECT_EQ(cases, 6688);
}

}  // namespace
}  // namespace sightline
