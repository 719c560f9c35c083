#include "snapshot_facts.hpp"

#include <fmt/core.h>

#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/state_visitor.hpp"
#include "emulators/machines/i8080.hpp"
#include "emulators/machines/i8080_devices.hpp"
#include "emulators/machines/pdp7.hpp"
#include "emulators/machines/pdp7_devices.hpp"
#include "table.hpp"

namespace sightline::manual {
namespace {

// Repeated fields, such as those of 256 ports, are written once.
std::string once(const std::string& fields) {
  constexpr std::string_view between = "; ";
  constexpr std::size_t often = 8;
  const std::string first = fields.substr(0, fields.find(between));
  const std::size_t again = fields.find(std::string(between) + first + std::string(between));
  if (again == std::string::npos) return fields;
  const std::string unit = fields.substr(0, again);
  std::string all = unit;
  std::size_t times = 1;
  for (; all.size() < fields.size(); ++times) all += std::string(between) + unit;
  return all == fields && times >= often ? fmt::format("{} times ({})", times, unit) : fields;
}

// A visitor that writes names and types, one row per section. A list gets one element for the description.
class Describer final : public core::StateVisitor {
 public:
  explicit Describer(Table& table) : table_(&table) {}

  void words(std::string_view name, std::span<core::Word18>) override { add(name, "4 each"); }
  void bytes(std::string_view name, std::span<std::uint8_t> bytes, std::uint8_t most) override {
    add(name, fmt::format("{} of 1, to {}", bytes.size(), most));
  }
  void input(std::string_view name, std::span<const std::uint8_t>) override { add(name, "input"); }
  void require(bool, std::string_view, std::string_view) override {}

 private:
  void add(std::string_view name, std::string_view type) {
    fields_ += fmt::format("{}{} {}", fields_.empty() ? "" : "; ", code(prefix_ + std::string(name)), type);
  }
  void number(std::string_view name, core::StoredNumber& number) override { add(name, type_of(number)); }
  static std::string type_of(const core::StoredNumber& number) {
    using Kind = core::StoredNumber::Kind;
    if (number.bounded) return fmt::format("{}, to {}", number.bytes, number.most);
    switch (number.kind) {
      case Kind::flag: return "flag";
      case Kind::time: return "time";
      case Kind::word: return fmt::format("4, to {:o} octal", number.most);
      case Kind::signed_number: return fmt::format("signed {}", number.bytes);
      case Kind::output: return "output";
      case Kind::number: break;
    }
    return fmt::format("{}", number.bytes);
  }
  std::size_t begin(Group group, std::string_view name, std::size_t) override {
    open_.push_back({group, name, {}, prefix_});
    if (group == Group::part) prefix_ += std::string(name) + ".";
    else open_.back().fields = std::exchange(fields_, {});
    return 1;
  }
  void end() override {
    const Open ended = open_.back();
    open_.pop_back();
    prefix_ = ended.prefix;
    if (ended.group == Group::part) return;
    const std::string fields = std::exchange(fields_, ended.fields);
    if (ended.group == Group::section) table_->row({code(ended.name), once(fields)});
    else add(ended.name, fmt::format("{} ({})", ended.group == Group::list ? "list of" : "if present", fields));
  }

  struct Open {
    Group group;
    std::string_view name;
    std::string fields;  // described before it
    std::string prefix;
  };
  std::vector<Open> open_;
  Table* table_;
  std::string prefix_;
  std::string fields_;
};

}  // namespace

std::string snapshot_pdp7() {
  pdp7::Machine machine;
  for (const core::IotDeviceInfo& info : pdp7::device_infos)
    if (machine.device(info.name) == nullptr) static_cast<void>(machine.attach(info.name));
  Table table{"section", "fields"};
  Describer describer(table);
  machine.visit_state(describer);
  return table.text();
}

std::string snapshot_i8080() {
  i8080::Machine machine;
  for (const i8080::KnownDevice& known : i8080::known_devices) {
    if (known.info->has_state) static_cast<void>(machine.attach(known.info->name));
  }
  Table table{"section", "fields"};
  Describer describer(table);
  machine.visit_state(describer);
  return table.text();
}

}  // namespace sightline::manual
