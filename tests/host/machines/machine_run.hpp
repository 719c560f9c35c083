// Runs on described machines for tests: options as on the command line, files from a table, and the state that a run leaves.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "host/machines/engine.hpp"

namespace sightline::test {


// The state after a run.
struct Left {
  machines::Stop stop;
  std::unique_ptr<machines::Machine> machine;
  base::Json report;
  std::string dump;
  std::map<std::string, std::string> streams;  // by option

  // The report's number of that name; -1 if there is none.
  [[nodiscard]] std::int64_t number(std::string_view name) const {
    const base::Json* const value = report.find(name);
    return value == nullptr ? -1 : value->integer().value_or(-1);
  }
  [[nodiscard]] std::string text(std::string_view group, std::string_view name) const {
    const base::Json* const members = report.find(group);
    const base::Json* const value = members == nullptr ? nullptr : members->find(name);
    return value == nullptr || value->text() == nullptr ? "" : *value->text();
  }
};

class MachineRun {
 public:
  explicit MachineRun(const machines::MachineDescription& machine)
      : machine_(&machine), arguments_(machine.options) {}

  // A flag has no text; a list option adds an element.
  MachineRun& set(std::string_view option, std::string_view text = {}) {
    machines::Arguments::Value& value = arguments_.value(option);
    const auto found = std::find_if(machine_->options.begin(), machine_->options.end(),
                                    [option](const machines::Option& each) { return each.key() == option; });
    EXPECT_NE(found, machine_->options.end()) << option;
    if (found == machine_->options.end()) return *this;
    switch (found->kind) {
      case machines::OptionKind::step: arguments_.add_step(option, std::string(text)); break;
      case machines::OptionKind::flag: value.flag = true; break;
      case machines::OptionKind::list:
      case machines::OptionKind::files: value.list.emplace_back(text); break;
      case machines::OptionKind::stream:
        streams_[std::string(option)];
        value.text = "kept";
        break;
      default: value.text = text; break;
    }
    return *this;
  }
  // Adds a file of that name, and the option that names it.
  MachineRun& set_file(std::string_view option, const std::string& name, std::string_view text) {
    files_[name] = {text.begin(), text.end()};
    return set(option, name);
  }
  // Gives the machine a monitor.
  MachineRun& monitored() {
    arguments_.value("--monitor").flag = true;
    return *this;
  }
  MachineRun& ask(machines::KeepRunning keep_running) {
    keep_running_ = std::move(keep_running);
    return *this;
  }

  [[nodiscard]] base::Result<machines::Prepared> prepared() const {
    return prepare(*machine_, arguments_, [this](const std::string& path) {
      const auto found = files_.find(path);
      return machines::Input{path, found == files_.end() ? machines::Bytes{} : found->second};
    });
  }
  // The error of the run.
  [[nodiscard]] std::string refusal() const {
    const auto ready = prepared();
    return ready ? "nothing was refused" : ready.error().message();
  }

  [[nodiscard]] Left go() const {
    Left left;
    left.streams = streams_;
    auto ready = prepared();
    EXPECT_TRUE(ready.has_value()) << refusal();
    if (!ready) return left;
    left.machine = std::move(ready->machine);
    for (auto& [option, text] : left.streams)
      left.machine->take(option, [&kept = text](std::string_view more) { kept += more; });
    left.stop = run_to_stop(*left.machine, ready->limits, keep_running_);
    left.report = json_report(*machine_, *left.machine, left.stop);
    left.dump = dump_text(*machine_, *left.machine);
    return left;
  }

 private:
  const machines::MachineDescription* machine_;
  machines::Arguments arguments_;
  std::map<std::string, machines::Bytes> files_;
  std::map<std::string, std::string> streams_;
  machines::KeepRunning keep_running_;
};

inline void expect_same(const Left& a, const Left& b) {
  EXPECT_EQ(a.report.dump(2), b.report.dump(2));
  EXPECT_EQ(a.dump, b.dump);
}

}  // namespace sightline::test
