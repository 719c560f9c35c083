#include "snapshot_facts.hpp"

#include <fmt/core.h>

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "emulators/machines/i8080_machine.hpp"
#include "emulators/machines/pdp7.hpp"
#include "emulators/machines/skala_ports.hpp"
#include "host/guests/run/state.hpp"
#include "table.hpp"

namespace sightline::manual {
namespace {

template <class Member>
inline constexpr bool is_time = false;
template <class Tick>
inline constexpr bool is_time<core::TickCount<Tick>> = true;
template <class Tick>
inline constexpr bool is_time<core::TickInstant<Tick>> = true;

// Fields that come again and again, as those of 256 ports, are written once.
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

// A visitor (emulators/core/visit_state.hpp) that writes names and types, one row for each section.
class Describer {
 public:
  static constexpr bool restores = false;

  explicit Describer(Table& table) : table_(&table) {}

  template <class Member>
  void operator()(std::string_view name, const Member&) {
    using Stored = guests::run::StoredAs<Member>;
    if constexpr (std::is_same_v<Member, bool>) {
      add(name, "flag");
    } else if constexpr (is_time<Member>) {
      add(name, "time");
    } else if constexpr (std::is_class_v<Member>) {
      add(name, fmt::format("4, to {:o} octal", Stored::most));
    } else {
      add(name, fmt::format("{}{}", std::is_signed_v<Member> ? "signed " : "", Stored::bytes));
    }
  }
  template <class Member, class Most>
  void operator()(std::string_view name, const Member&, Most most) {
    using Stored = guests::run::StoredAs<Member>;
    add(name, fmt::format("{}, to {}", Stored::bytes, Stored::number(static_cast<Member>(most))));
  }
  void count(std::string_view name, std::size_t, std::size_t) { add(name, "8"); }
  template <class Words>
  void words(std::string_view name, Words) {
    add(name, "4 each");
  }
  void bytes(std::string_view name, std::span<std::uint8_t> bytes, std::uint8_t most = 0xFF) {
    add(name, fmt::format("{} of 1, to {}", bytes.size(), most));
  }
  template <class What>
  void part(std::string_view name, What&& what) {
    const std::string before = prefix_;
    prefix_ += std::string(name) + ".";
    guests::run::visit_what(*this, what);
    prefix_ = before;
  }
  template <class What>
  void section(std::string_view name, What&& what) {
    fields_.clear();
    guests::run::visit_what(*this, what);
    table_->row({code(name), once(fields_)});
  }
  template <class Element, class Each>
  void list(std::string_view name, std::vector<Element>&, Each each) {
    inner(name, "list of", [&each] {
      Element element{};
      each(element);
    });
  }
  template <class Element, class Each>
  void present(std::string_view name, std::optional<Element>&, Each each) {
    inner(name, "if present", [&each] {
      Element element{};
      each(element);
    });
  }
  void input(std::string_view name, std::span<const std::uint8_t>) { add(name, "input"); }
  template <class Elements>
  void output(std::string_view name, const Elements&, std::uint64_t) {
    add(name, "output");
  }
  void require(bool, std::string_view, std::string_view) {}

 private:
  void add(std::string_view name, std::string_view type) {
    fields_ += fmt::format("{}{} {}", fields_.empty() ? "" : "; ", code(prefix_ + std::string(name)), type);
  }
  template <class Visit>
  void inner(std::string_view name, std::string_view what, Visit visit) {
    const std::string before = std::exchange(fields_, {});
    visit();
    const std::string fields = std::exchange(fields_, before);
    add(name, fmt::format("{} ({})", what, fields));
  }

  Table* table_;
  std::string prefix_;
  std::string fields_;
};

}  // namespace

std::string snapshot_pdp7() {
  core::NoStrokes sink;
  machines::NoObserver observer;
  machines::Pdp7Options options{{}, type340::Options{}};
  options.configuration.devices.disk = true;
  machines::Pdp7<> machine(options, sink, observer);
  Table table{"section", "fields"};
  Describer describer(table);
  machine.visit_state(describer);
  return table.text();
}

std::string snapshot_i8080() {
  machines::SkalaConfiguration configuration;
  configuration.ef9365 = configuration.alt256 = configuration.calcomp565 = configuration.minigraf0507 = true;
  configuration.sio = configuration.two_sio = true;
  configuration.parallel.emplace();
  configuration.serial.emplace();
  core::NoStrokes sink;
  machines::NoI8080Observer observer;
  using Ports = machines::SkalaPorts<>;
  const auto ports = std::make_unique<Ports>(configuration, sink);
  machines::I8080Machine<Ports> machine(*ports, observer);
  Table table{"section", "fields"};
  Describer describer(table);
  machine.visit_state(describer);
  ports->visit_state(describer);
  return table.text();
}

}  // namespace sightline::manual
