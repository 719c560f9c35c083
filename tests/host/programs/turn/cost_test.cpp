// The cost model of firmware/pdp7/turn/NOTES.md: the machine's time for every picture, from the twin's counts.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include "host/programs/turn/turn.hpp"
#include "tests/host/programs/turn/turned_model.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::turn {
namespace {

// Item -> microseconds with and without the EAE, from the table in the notes.
std::map<std::string, std::array<double, 2>> cost_table() {
  std::ifstream file(SIGHTLINE_SOURCE_DIR "/firmware/pdp7/turn/NOTES.md");
  std::map<std::string, std::array<double, 2>> table;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("## ", 0) == 0) inside = line == "## Cost model";
    if (!inside || line.rfind("| ", 0) != 0 || line.find("with EAE") != std::string::npos) continue;
    const std::size_t first = line.find(" | ");
    const std::size_t second = line.find(" | ", first + 1);
    table[line.substr(2, first - 2)] = {std::atof(line.c_str() + first + 3), std::atof(line.c_str() + second + 3)};
  }
  return table;
}

TEST(TurnCost, ModelPredictsEveryPicture) {
  NEEDS_OPTIMISED_CODE();
  const auto table = cost_table();
  ASSERT_EQ(table.size(), 12U);
  for (const std::string& name : {cube, block, crossed, lshape, star, std::string("roberts"), std::string("boxes-8"), grid}) {
    const bool large = name == grid;
    const Tape& tape = turned_model(name, large ? Memory::words_32k : Memory::words_8k, !large).tape;
    const Program both[] = {assemble_program(true, tape.memory), assemble_program(false, tape.memory)};
    for (const std::uint32_t wire : {0U, wire_switch}) {
      for (unsigned without = 0; without < 2; ++without) {
        PicturesOrder order;
        // Not the turn to which the table was fitted, and backwards.
        const std::uint32_t switches = backward_switch | wire | 3001;
        order.pictures = pictures_of_turn(3001);
        order.switches = [switches](std::uint32_t) { return switches; };
        order.check = true;
        const auto run = run_pictures(both[without], tape, order);
        ASSERT_TRUE(run) << run.error().message();
        Twin twin(tape.words, model_base(tape.memory));
        TwinPicture p;
        for (std::size_t i = 0; i < run->pictures.size(); ++i) {
          ASSERT_TRUE(twin.next(switches, p));
          EXPECT_EQ(run->pictures[i].lines, p.lines);
          EXPECT_EQ(run->pictures[i].junctions, p.junctions_drawn);
          if (i < 2) continue;
          const auto cost = [&](const char* item) { return table.at(item)[without]; };
          const double predicted =
              cost("picture") + p.vertices * cost("vertex") + p.slots_empty * cost("empty slot") +
              p.whole_edges * cost("whole edge") + p.cut_edges * cost("cut edge") + p.junctions * cost("junction") +
              p.junctions_drawn * cost("junction drawn") + p.beginnings * cost("beginning of lines") +
              p.long_lines * cost("line of more than 127 points") + p.long_words * cost("word of 127 points") +
              p.events * cost("event") + p.changes * cost("change");
          const double measured = static_cast<double>((run->pictures[i].time - run->pictures[i].waiting).count()) / 1e3;
          EXPECT_NEAR(predicted / measured, 1, 0.1) << name << " picture " << i << (without ? " without EAE" : " with EAE");
        }
      }
    }
  }
}

}  // namespace
}  // namespace sightline::programs::turn
