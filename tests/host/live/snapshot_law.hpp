// The law of snapshots: run N, save, run M equals restore, run M, in everything that a machine shows.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/machines/machine.hpp"
#include "host/live/snapshot.hpp"

namespace sightline::test {


// A machine with a started program, and its outputs.
struct LawProgram {
  std::string_view machine;  // "pdp7"
  std::function<std::unique_ptr<machines::Machine>()> make;
  std::vector<std::string> streams;   // "--trace"
  std::vector<std::string> appended;  // outputs that grow: "--punch"
  std::vector<std::string> whole;     // outputs of the state: "--png" of a raster
  std::vector<std::string> again;     // outputs that a machine that went back writes again: "--svg"
};

class LawRun {
 public:
  // The program must outlive the run.
  explicit LawRun(const LawProgram& program) : program_(&program), machine_(program.make()) {
    for (const std::string& stream : program.streams)
      machine_->take(stream, [&text = streams_[stream]](std::string_view more) { text += more; });
  }
  LawRun(const LawRun&) = delete;
  LawRun& operator=(const LawRun&) = delete;

  // Runs at most `instructions` more; returns the name of the stop.
  std::string_view go(std::uint64_t instructions) {
    const machines::Limits limits{machine_->instructions() + instructions};
    std::optional<machines::Stop> stop;
    while (!stop) stop = machine_->run(limits, false);
    machine_->finish();
    return stop->name;
  }
  [[nodiscard]] machines::Bytes save() { return live::save_snapshot(program_->machine, *machine_); }
  void restore(const machines::Bytes& snapshot) {
    const auto done = live::restore_snapshot(program_->machine, *machine_, snapshot, "test.snap");
    EXPECT_TRUE(done.has_value()) << (done ? "" : done.error().message());
  }
  [[nodiscard]] machines::Machine& machine() { return *machine_; }
  [[nodiscard]] std::map<std::string, std::string>& streams() { return streams_; }
  [[nodiscard]] machines::Bytes output(const std::string& option) { return machine_->output(option); }

 private:
  const LawProgram* program_;
  std::map<std::string, std::string> streams_;
  std::unique_ptr<machines::Machine> machine_;
};

// The first section and byte in which two snapshots differ. `except`: a section that may differ.
inline std::string difference(const machines::Bytes& a, const machines::Bytes& b, std::string_view except = {}) {
  const auto first = live::decode_snapshot(a, "a");
  const auto second = live::decode_snapshot(b, "b");
  if (!first || !second) return "not a snapshot";
  for (std::size_t n = 0; n < std::min(first->state.size(), second->state.size()); ++n) {
    const auto& x = first->state[n];
    const auto& y = second->state[n];
    if (x == y || (x.name == except && y.name == except)) continue;
    const std::size_t most = std::min(x.bytes.size(), y.bytes.size());
    std::size_t at = 0;
    while (at < most && x.bytes[at] == y.bytes[at]) ++at;
    return x.name + " byte " + std::to_string(at) + " of " + std::to_string(x.bytes.size()) + " and " +
           std::to_string(y.bytes.size());
  }
  return a == b || !except.empty() ? "" : "elsewhere";
}

// False if the program stopped before `first` instructions.
inline bool expect_law(const LawProgram& program, std::uint64_t first, std::uint64_t then) {
  LawRun whole(program);
  LawRun parts(program);
  const std::string_view stopped = parts.go(first);
  const machines::Bytes snapshot = parts.save();
  const std::map<std::string, std::string> written = parts.streams();
  std::map<std::string, machines::Bytes> produced;
  for (const std::string& option : program.appended) produced[option] = parts.output(option);

  whole.go(first + then);
  parts.go(then);
  EXPECT_EQ(difference(whole.save(), parts.save()), "") << "run in two parts";

  LawRun fresh(program);
  fresh.restore(snapshot);
  // A machine that has not drawn begins its drawing at the snapshot.
  EXPECT_EQ(difference(fresh.save(), snapshot, "drawing"), "") << "restored";
  fresh.go(then);
  EXPECT_EQ(difference(whole.save(), fresh.save(), "drawing"), "") << "restored into another machine";
  for (const auto& [option, text] : written)
    EXPECT_TRUE(whole.streams()[option] == text + fresh.streams()[option]) << option;
  for (auto& [option, bytes] : produced) {
    const machines::Bytes more = fresh.output(option);
    bytes.insert(bytes.end(), more.begin(), more.end());
    EXPECT_TRUE(whole.output(option) == bytes) << option;
  }
  for (const std::string& option : program.whole)
    EXPECT_TRUE(whole.output(option) == fresh.output(option)) << option;

  // Back in a machine that has continued.
  const std::map<std::string, std::string> before = parts.streams();
  parts.restore(snapshot);
  EXPECT_EQ(difference(parts.save(), snapshot), "") << "gone back";
  parts.go(then);
  EXPECT_EQ(difference(whole.save(), parts.save()), "") << "gone back and run on";
  for (const auto& [option, text] : before)
    EXPECT_TRUE(parts.streams()[option] == text + fresh.streams()[option]) << option << " of the second way";
  for (const auto* options : {&program.appended, &program.whole, &program.again}) {
    for (const std::string& option : *options)
      EXPECT_TRUE(whole.output(option) == parts.output(option)) << option << " after going back";
  }
  return stopped == "instruction_limit";
}

}  // namespace sightline::test
