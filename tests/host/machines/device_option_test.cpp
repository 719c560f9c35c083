// --device: its syntax, its description in the help, and a device's counts in a report.
#include "host/machines/device_option.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace sightline::test {
namespace {


constexpr std::array settings{core::DeviceOption{"units", "drives on the controller", 1, 1, 4},
                              core::DeviceOption{"late", "a word that comes late stops it", 0, 0, 1}};
constexpr std::array devices{machines::ListedDevice{"drum", "the Type 24 serial drum", settings},
                             machines::ListedDevice{"lights", "sixteen lamps", {}}};

std::string refusal(const std::string& text) {
  const auto read = machines::read_devices(std::array{text}, devices);
  return read ? "read" : read.error().message();
}

TEST(DeviceOption, ExistsOnlyIfThereAreDevices) {
  EXPECT_FALSE(machines::device_option({}).has_value());
  EXPECT_EQ(machines::device_help({}), "");
  const auto option = machines::device_option(devices);
  ASSERT_TRUE(option.has_value());
  EXPECT_EQ(option->name, "--device");
  EXPECT_EQ(machines::device_help(devices),
            "\nDevices that --device attaches, and their settings (default, bounds):\n"
            "  drum                 the Type 24 serial drum\n"
            "    units              drives on the controller: 1 (1 to 4)\n"
            "    late               a word that comes late stops it: 0 (0 to 1)\n"
            "  lights               sixteen lamps\n");
}

TEST(DeviceOption, ReadsNamesAndSettings) {
  const auto read = machines::read_devices(std::array<std::string, 2>{"drum,units=2,late=1", "lights"}, devices);
  ASSERT_TRUE(read.has_value());
  ASSERT_EQ(read->size(), 2U);
  const machines::DeviceChoice& drum = read->front();
  EXPECT_EQ(machines::device_text(drum), "drum,units=2,late=1");
  EXPECT_EQ(drum.name, "drum");
  const auto& values = drum.settings;
  ASSERT_EQ(values.size(), 2U);
  EXPECT_EQ(values[0].name, "units");
  EXPECT_EQ(values[0].value, 2);
  EXPECT_EQ(values[1].name, "late");
  EXPECT_EQ(values[1].value, 1);
  EXPECT_EQ(read->back().name, "lights");
  EXPECT_TRUE(read->back().settings.empty());
}

TEST(DeviceOption, RejectsUnknownDevicesAndSettings) {
  EXPECT_EQ(refusal("drums"), "--device: found \"drums\", expected one of drum, lights");
  EXPECT_EQ(refusal("drum,units"), "--device drum: found \"units\", expected SETTING=N with one of units, late");
  EXPECT_EQ(refusal("drum,"), "--device drum: found \"\", expected SETTING=N with one of units, late");
  EXPECT_EQ(refusal("drum,,units=1"), "--device drum: found \"\", expected SETTING=N with one of units, late");
  EXPECT_EQ(refusal("lights,units=1"), "--device lights: found \"units=1\", expected no setting");
  EXPECT_EQ(refusal("drum,units=1,units=1"), "--device drum: found units twice, expected it once");
  EXPECT_EQ(refusal("drum,units="), "--device drum,units: found \"\", expected a whole decimal number, 1 to 4");
  EXPECT_EQ(refusal("drum,units=1x"), "--device drum,units: found \"1x\", expected a whole decimal number, 1 to 4");
  EXPECT_EQ(refusal("drum,units=5"), "--device drum,units: found \"5\", expected a whole decimal number, 1 to 4");
  EXPECT_EQ(refusal("drum,units=99999999999999999999"),
            "--device drum,units: found \"99999999999999999999\", expected a whole decimal number, 1 to 4");
}

TEST(DeviceOption, CountsInAReport) {
  const std::vector<core::Count> counts{{"words_read", 12}, {"errors", 0}, {"transfers", 1}};
  EXPECT_EQ(machines::counts_text(counts), "words read 12, transfers 1");
  EXPECT_EQ(machines::counts_json(counts).dump(), R"({"words_read":12,"errors":0,"transfers":1})");
  EXPECT_EQ(machines::counts_text({}), "nothing");
}

}  // namespace
}  // namespace sightline::test
