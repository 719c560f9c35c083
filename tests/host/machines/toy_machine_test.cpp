// A machine described by this test: 16 words of 8 bits and six instructions. Everything that the engine offers for machines works
// for
// it, so another machine needs no more than this.
#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "tests/host/machines/machine_run.hpp"

namespace sightline::test {
namespace {

using machines::OptionKind;

// The high digit of a word is the instruction, the low four bits are an address. Every instruction takes 1 us.
class Toy final : public machines::Machine {
 public:
  explicit Toy(std::string device) : device_(std::move(device)) {}

  [[nodiscard]] std::uint32_t words() const override { return static_cast<std::uint32_t>(memory_.size()); }
  [[nodiscard]] std::uint32_t word(std::uint32_t address) const override { return memory_[address]; }
  void put(std::uint32_t address, std::uint32_t word) override {
    memory_[address] = static_cast<std::uint8_t>(word);
  }
  [[nodiscard]] std::uint32_t get(std::size_t number) const override {
    return number == 0 ? pc_ : accumulator_;
  }
  void set(std::size_t number, std::uint32_t value) override { (number == 0 ? pc_ : accumulator_) = value; }
  void start(std::uint32_t address) override { pc_ = address; }
  void take(std::string_view, machines::TextTaker taker) override { printer_ = std::move(taker); }

  [[nodiscard]] std::optional<machines::Stop> run(const machines::Limits& limits, bool asked) override {
    for (int n = 0; !asked || n < 4; ++n) {
      if (instructions_ >= limits.instructions) return machines::Stop{"instruction_limit", {}};
      if (static_cast<std::int64_t>(instructions_) >= limits.until) return machines::Stop{"time_limit", {}};
      if (auto stop = step()) return stop;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::uint64_t instructions() const override { return instructions_; }
  [[nodiscard]] std::int64_t ticks() const override { return core::nanoseconds_of(now()); }
  [[nodiscard]] std::int64_t ticks_per_second() const override { return 1'000'000'000; }
  [[nodiscard]] core::Instant now() const override {
    return core::at_nanoseconds(static_cast<std::int64_t>(instructions_) * 1000);
  }
  [[nodiscard]] std::vector<machines::ReportLine> lines() const override {
    return {{"instructions", std::to_string(instructions_)}};
  }
  void add_times(base::Json& report) const override { report["microseconds"] = instructions_; }
  [[nodiscard]] machines::Bytes output(std::string_view) const override {
    return {device_.begin(), device_.end()};
  }

 private:
  std::optional<machines::Stop> step() {
    const std::uint8_t word = memory_[pc_];
    const std::size_t at = word & 15U;
    pc_ = (pc_ + 1) & 15U;
    ++instructions_;
    switch (word >> 4) {
      case 0: return machines::Stop{"halt", {}};
      case 1: accumulator_ = memory_[at]; break;
      case 2: accumulator_ = (accumulator_ + memory_[at]) & 0xFFU; break;
      case 3: memory_[at] = static_cast<std::uint8_t>(accumulator_); break;
      case 4: pc_ = static_cast<std::uint32_t>(at); break;
      case 5: printer_(std::to_string(accumulator_) + "\n"); break;
      default: return machines::Stop{"undefined", "stopped: an undefined instruction"};
    }
    return std::nullopt;
  }

  std::array<std::uint8_t, 16> memory_{};
  std::uint32_t pc_ = 0;
  std::uint32_t accumulator_ = 0;
  std::uint64_t instructions_ = 0;
  std::string device_;
  machines::TextTaker printer_ = [](std::string_view) {};
};

// "A=W B=W ...", hexadecimal.
base::Result<machines::Program> read_pairs(std::span<const std::uint8_t> bytes, const std::string& file,
                                     std::optional<std::uint32_t> address) {
  if (address) return base::usage_error(file + ": found an address, expected none");
  machines::Program program;
  std::istringstream text(std::string(bytes.begin(), bytes.end()));
  for (std::string pair; text >> pair;) {
    const std::size_t equals = pair.find('=');
    if (equals == std::string::npos) return base::bad_input(file + ": found " + pair + ", expected A=W");
    program.words.emplace_back(std::stoul(pair.substr(0, equals), nullptr, 16),
                               std::stoul(pair.substr(equals + 1), nullptr, 16));
  }
  return program;
}

base::Result<std::int64_t> microseconds(std::string_view option, std::string_view text) {
  const auto count = machines::count_argument(option, text);
  if (!count) return count.error();
  return static_cast<std::int64_t>(*count);
}

base::Result<std::unique_ptr<machines::Machine>> make_toy(const machines::Arguments& arguments,
                                                    const machines::FileReader& read) {
  std::string device;
  if (arguments.given("--device")) {
    const machines::Input input = read(arguments.text("--device"));
    if (input.bytes.empty()) return base::bad_input(input.name + ": found nothing, expected bytes");
    device.assign(input.bytes.begin(), input.bytes.end());
  }
  return std::unique_ptr<machines::Machine>(std::make_unique<Toy>(device));
}

const machines::MachineDescription& toy() {
  static const machines::MachineDescription description = [] {
    machines::MachineDescription toy;
    toy.name = "toy";
    toy.radix = 16;
    toy.address_bits = 4;
    toy.word_bits = 8;
    toy.words_per_line = 4;
    toy.registers = {{"PC", 4, "an address", true}, {"ACC", 8, "a word"}};
    toy.options = {{OptionKind::files, "--load", "FILE", "Programs"},
                   {OptionKind::text, "--start", "ADDRESS", "Where to begin"},
                   {OptionKind::list, "--set", "REGISTER=VALUE", "Set PC or ACC"},
                   {OptionKind::text, "--max-instructions", "N", "Stop after so many"},
                   {OptionKind::text, "--max-time", "N", "Stop after so many microseconds"},
                   {OptionKind::text, "--device", "FILE", "Attach the device"},
                   {OptionKind::stream, "--printer", "FILE", "What is printed"},
                   {.kind = OptionKind::output, .name = "--device-out", .needs = "--device"}};
    toy.formats = {{"pairs", {}, [](std::span<const std::uint8_t>) { return true; }, read_pairs, nullptr}};
    toy.time_limit = "--max-time";
    toy.parse_time = microseconds;
    toy.make = make_toy;
    return toy;
  }();
  return description;
}

// Counts up in word F and prints it, for ever.
constexpr const char* counting = "0=1F 1=2E 2=3F 3=50 4=40 E=1";

MachineRun run_of(const char* program) {
  return MachineRun(toy()).set_file("--load", "program", program);
}

TEST(ToyMachine, RunsToItsHaltAndIsReported) {
  const Left left = run_of("4=1E 5=2F 6=3D 7=50 8=0 E=2 F=3").set("--start", "4").set("--printer").go();
  EXPECT_EQ(left.stop.name, "halt");
  EXPECT_EQ(left.streams.at("--printer"), "5\n");
  EXPECT_EQ(left.report.dump(),
            R"({"schema":"sightline/run-toy/1","stop_reason":"halt","pc":"9","instructions":5,)"
            R"("microseconds":5,"registers":{"pc":"9","acc":"05"}})");
  EXPECT_EQ(table_report(toy(), *left.machine, left.stop),
            "stopped by      halt, PC 9\n"
            "instructions    5\n"
            "registers       ACC 05\n");
  EXPECT_EQ(left.dump, "9 05\n00 00 00 00\n1E 2F 3D 50\n00 00 00 00\n00 05 02 03\n");
}

TEST(ToyMachine, LimitsAndPollsEndRuns) {
  EXPECT_EQ(run_of(counting).set("--max-instructions", "7").go().number("instructions"), 7);
  const Left left = run_of(counting).set("--max-time", "12").set("--printer").go();
  EXPECT_EQ(left.stop.name, "time_limit");
  EXPECT_EQ(left.streams.at("--printer"), "1\n2\n");
  int asked = 0;
  EXPECT_EQ(run_of(counting).ask([&asked](const machines::Progress&) { return ++asked < 5; }).go().stop.name,
            machines::interrupted);
  EXPECT_EQ(asked, 5);
}

TEST(ToyMachine, RegistersAreSet) {
  const Left left = run_of("A=50 B=0").set("--set", "acc=0x7F").set("--set", "PC=A").set("--printer").go();
  EXPECT_EQ(left.streams.at("--printer"), "127\n");
}

TEST(ToyMachine, AProgramThatFailsComplains) {
  const Left left = run_of("0=70").go();
  EXPECT_EQ(left.stop.complaint, "stopped: an undefined instruction");
}

TEST(ToyMachine, DevicesTakeAndGiveFiles) {
  const Left left = run_of("0=0").set_file("--device", "tape", "xyz").set("--device-out", "out").go();
  EXPECT_EQ(left.machine->output("--device-out"), (machines::Bytes{'x', 'y', 'z'}));
}

TEST(ToyMachine, ErrorsAreRejected) {
  EXPECT_EQ(MachineRun(toy()).refusal(),
            "run toy: needs a PROGRAM or --load FILE: without a program there is nothing to run");
  EXPECT_EQ(run_of("0=0").set("--device-out", "out").refusal(), "--device-out: needs --device");
  EXPECT_EQ(run_of("0=0").set_file("--device", "tape", "").refusal(), "tape: found nothing, expected bytes");
  EXPECT_EQ(run_of("0=0 10=1").refusal(),
            "program: error: found a word for address 10, expected one in memory, 0-F");
  EXPECT_EQ(run_of("0=0 1=100").refusal(),
            "program: error: found 100 at address 1, expected a word of 8 bits");
  EXPECT_EQ(run_of("0:0").refusal(), "program: found 0:0, expected A=W");
  EXPECT_EQ(run_of("0=0").set("--start", "1G").refusal(),
            "--start: found \"1G\", expected an address, hexadecimal, 0 to F");
  EXPECT_EQ(run_of("0=0").set("--set", "X=1").refusal(),
            "--set: found \"X=1\", expected REGISTER=VALUE with one of PC ACC");
  EXPECT_EQ(run_of("0=0").set("--set", "ACC=100").refusal(),
            "--set ACC: found \"100\", expected a word, hexadecimal, 0 to FF");
  EXPECT_EQ(run_of("0=0").set("--max-instructions", "x").refusal(),
            "--max-instructions: found \"x\", expected a whole decimal number such as 1000000 or 1e6");
}

TEST(Machines, EveryOneHasWhatTheCommandsNeed) {
  for (const machines::MachineDescription* machine : machines::machines()) {
    EXPECT_FALSE(machine->name.empty());
    EXPECT_NE(machine->make, nullptr) << machine->name;
    EXPECT_FALSE(machine->formats.empty()) << machine->name;
    const machines::Arguments arguments(machine->options);
    EXPECT_FALSE(arguments.given("--load")) << machine->name;
    for (const machines::Option& option : machine->options) {
      EXPECT_TRUE(option.key().starts_with("--")) << option.name;
      EXPECT_FALSE(option.help.empty()) << option.name;
    }
    for (const char* const read_by_the_engine :
         {"--load", "--start", "--set", "--max-instructions", "--dump", "--json"}) {
      EXPECT_TRUE(std::any_of(machine->options.begin(), machine->options.end(),
                              [&](const machines::Option& option) { return option.key() == read_by_the_engine; }))
          << machine->name << read_by_the_engine;
    }
  }
}

}  // namespace
}  // namespace sightline::test
