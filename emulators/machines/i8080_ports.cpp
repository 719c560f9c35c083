// See i8080_ports.hpp.
#include "i8080_ports.hpp"

#include <algorithm>

#include "../core/device_errors.hpp"
#include "i8080_devices.hpp"

namespace sightline::i8080 {

namespace {

std::string quoted(std::string_view name) { return std::string("\"").append(name).append("\""); }

std::string port_name(unsigned port) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  return {digits[port >> 4U], digits[port & 15U]};
}

// The position in the list of devices; devices that are not in it come last.
std::size_t place_of(const core::PortDeviceInfo& info) {
  const auto* const found = std::find_if(known_devices.begin(), known_devices.end(),
                                         [&info](const KnownDevice& known) { return known.info == &info; });
  return static_cast<std::size_t>(found - known_devices.begin());
}

}  // namespace

std::string Ports::attach(const core::PortDeviceInfo& info, std::unique_ptr<core::PortDevice> device) {
  if (device == nullptr) return "found a null device to attach as " + std::string(info.name);
  for (const AttachedDevice& other : devices_) {
    if (other.info->name == info.name) return quoted(info.name) + " is already attached";
  }
  if (std::string error = find_conflict(readers_, info.reads, info.name, "read"); !error.empty()) return error;
  if (std::string error = find_conflict(writers_, info.writes, info.name, "written"); !error.empty()) return error;
  core::PortDevice* const it = device.get();
  if (it->drives_interrupt() && interrupter_ != nullptr) return quoted(info.name) + " drives INT, and so does another device";

  const auto enter = [it](Table& table, std::span<const core::PortRange> ranges) {
    for (const core::PortRange range : ranges) {
      for (unsigned port = range.first; port <= range.last; ++port) table[port].device = it;
    }
  };
  enter(readers_, info.reads);
  enter(writers_, info.writes);
  const auto behind = std::find_if(devices_.begin(), devices_.end(),
                                   [&info](const AttachedDevice& other) { return place_of(*other.info) > place_of(info); });
  const auto place = behind - devices_.begin();
  devices_.insert(behind, {&info, std::move(device)});
  connections_.insert(connections_.begin() + place, nullptr);

  if (it->drives_ready()) waiters_.push_back(it);
  if (it->drives_hold()) holders_.push_back(it);
  if (it->drives_interrupt()) interrupter_ = it;
  if (it->drives_hold() || it->drives_interrupt()) {
    Connection& connection = connect(static_cast<std::size_t>(place));
    if (it->drives_interrupt()) connection.wires[0] |= own_instruction;
    poll(connection);
  }
  return {};
}

std::string Ports::find_conflict(const Table& table, std::span<const core::PortRange> ranges, std::string_view name,
                              std::string_view direction) const {
  for (const core::PortRange range : ranges) {
    for (unsigned port = range.first; port <= range.last; ++port) {
      if (table[port].device == nullptr) continue;
      const auto other = std::find_if(devices_.begin(), devices_.end(), [&](const AttachedDevice& attached) {
        return attached.device.get() == table[port].device;
      });
      return "port " + port_name(port) + " is " + std::string(direction) + " by " + quoted(other->info->name) + " and by " + quoted(name);
    }
  }
  return {};
}

std::string Ports::wire(std::string_view line, std::uint8_t restart) {
  std::vector<std::string_view> lines;
  for (std::size_t place = 0; place < devices_.size(); ++place) {
    const auto& info = *devices_[place].info;
    for (std::size_t n = 0; n < info.lines.size(); ++n) {
      lines.push_back(info.lines[n]);
      if (info.lines[n] != line) continue;
      if (restart > 7) return "interrupt line " + quoted(line) + ": found RST " + std::to_string(restart) + ", expected 0 to 7";
      Connection& connection = connect(place);
      connection.wires[n] = (connection.wires[n] & own_instruction) | 1U << restart;
      poll(connection);
      return {};
    }
  }
  for (const KnownDevice& known : known_devices) {
    if (std::find(known.info->lines.begin(), known.info->lines.end(), line) == known.info->lines.end()) continue;
    return "interrupt line " + quoted(line) + ": " + quoted(known.info->name) + " is not attached";
  }
  return core::unknown_name("interrupt line", line, lines);
}

core::PortDevice* Ports::device(std::string_view name) const {
  for (const AttachedDevice& attached : devices_) {
    if (attached.info->name == name) return attached.device.get();
  }
  return nullptr;
}

bool Ports::is_connected(const core::PortDevice& device) const {
  return std::any_of(connections_.begin(), connections_.end(),
                     [&device](const auto& each) { return each != nullptr && each->device == &device; });
}

void Ports::put_before(core::PortRange ports, core::PortDevice& front) {
  for (unsigned port = ports.first; port <= ports.last; ++port) fronts_[port] = &front;
}

void Ports::visit_state(core::StateVisitor& visit) {
  for (const AttachedDevice& attached : devices_) {
    if (attached.info->has_state) visit.section(attached.info->name, *attached.device);
  }
  visit.section("ports", [this](core::StateVisitor& fields) {
    for (UnansweredPort& port : unanswered_) {
      fields("reads", port.reads);
      fields("writes", port.writes);
    }
  });
  if (!visit.restores()) return;
  stop_.reset();
  reached_ = {};
  poll_all();
}

Byte Ports::acknowledge(core::TStateInstant at) {
  advance(at);
  if (interrupter_ != nullptr && ((requests_ & own_instruction) != 0 || (requests_ & every_restart) == 0)) {
    const Byte byte = interrupter_->acknowledge(at);
    poll_all();
    return byte;
  }
  unsigned restart = 7;
  while (restart != 0 && requests_ != 0 && (requests_ >> restart & 1U) == 0) --restart;
  return static_cast<Byte>(0xC7U | restart << 3U);
}

void Ports::advance_all(core::TStateInstant now) {
  reached_ = std::max(reached_, now);
  for (const AttachedDevice& attached : devices_) attached.device->advance(reached_);
  poll_all();
}

core::TStateInstant Ports::hold_ends(core::TStateInstant t) const {
  for (bool high = true; high;) {
    high = false;
    for (const core::PortDevice* const holder : holders_) {
      if (holder->next_hold(t) != t) continue;
      t = holder->hold_ends(t);
      high = true;
    }
  }
  return t;
}

int Ports::wait_states(Status status, Address address, core::TStateInstant at) const {
  int longest = 0;
  for (const core::PortDevice* const waiter : waiters_) longest = std::max(longest, waiter->wait_states(status, address, at));
  return longest;
}

Ports::Connection& Ports::connect(std::size_t device) {
  std::unique_ptr<Connection>& connection = connections_[device];
  if (connection != nullptr) return *connection;
  connection = std::make_unique<Connection>();
  connection->device = devices_[device].device.get();
  connection->wires.resize(std::max<std::size_t>(devices_[device].info->lines.size(), 1));
  for (Table* const table : {&readers_, &writers_}) {
    for (Port& port : *table) {
      if (port.device == connection->device) port.connection = connection.get();
    }
  }
  return *connection;
}

void Ports::poll(Connection& connection) {
  const unsigned lines = connection.device->requests();
  connection.requests = 0;
  for (std::size_t n = 0; n < connection.wires.size(); ++n) {
    if ((lines >> n & 1U) != 0) connection.requests |= connection.wires[n];
  }
  connection.deadline = connection.device->deadline();
  unsigned requests = 0;
  core::TStateInstant deadline = core::never_t;
  for (const auto& each : connections_) {
    if (each == nullptr) continue;
    requests |= each->requests;
    deadline = std::min(deadline, each->deadline);
  }
  changed_ = changed_ || requests != requests_ || deadline != deadline_ || connection.device->drives_hold();
  requests_ = requests;
  deadline_ = deadline;
}

void Ports::poll_all() {
  for (const auto& connection : connections_) {
    if (connection != nullptr) poll(*connection);
  }
}

void Ports::advance_connected(core::TStateInstant now) {
  for (const auto& connection : connections_) {
    if (connection == nullptr || connection->deadline > now) continue;
    connection->device->advance(now);
    poll(*connection);
  }
}

core::TStateInstant Ports::next_of_holders(core::TStateInstant t) const {
  core::TStateInstant next = core::never_t;
  for (const core::PortDevice* const holder : holders_) next = std::min(next, holder->next_hold(t));
  return next;
}

}  // namespace sightline::i8080
