// The machine without its processor: its devices, the dispatch of IOTs, and the work at instruction boundaries.
#include "pdp7.hpp"

#include <algorithm>
#include <utility>

#include "../core/device_errors.hpp"
#include "../core/inline.hpp"
#include "../pdp7/absent_devices.hpp"
#include "../pdp7/cpu.hpp"
#include "../pdp7/registers.hpp"
#include "pdp7_devices.hpp"
#include "pdp7_observer_calls.hpp"

namespace sightline::pdp7 {
namespace {

constexpr std::uint8_t no_device = 0xFF;
constexpr std::uint8_t control_code = 033, extension_code = 077;  // of the processor itself

Options with_implied_options(Options options) {
  if (options.core_words > 8192) options.model.extend = true;
  return options;
}

const KnownDevice* find_known(std::string_view name) {
  const auto found = std::find_if(known_devices.begin(), known_devices.end(),
                                  [name](const KnownDevice& each) { return each.info.name == name; });
  return found == known_devices.end() ? nullptr : &*found;
}

std::size_t priority_of(std::string_view name) {
  const KnownDevice* const known = find_known(name);
  return known == nullptr ? known_devices.size() : static_cast<std::size_t>(known - known_devices.data());
}

std::string unknown_device(std::string_view name) {
  std::array<std::string_view, known_devices.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = known_devices[i].info.name;
  return core::unknown_name("device", name, names);
}

// The settings, with the names taken from the options, which live as long as the program.
std::vector<core::Setting> with_lasting_names(std::span<const core::DeviceOption> options, std::span<const core::Setting> settings) {
  std::vector<core::Setting> kept;
  for (const core::Setting& setting : settings) {
    for (const core::DeviceOption& option : options) {
      if (option.name == setting.name) kept.push_back({option.name, setting.value});
    }
  }
  return kept;
}

std::string octal(unsigned code) {
  return {static_cast<char>('0' + code / 8), static_cast<char>('0' + code % 8)};
}

std::unique_ptr<core::IotDevice> make(const KnownDevice& known, std::span<const core::Setting> settings, const Options& options,
                                      core::StrokeBuffer& strokes) {
  const auto mask = static_cast<std::uint16_t>(options.model.extend ? address_mask : in_bank_mask);
  return known.make(DeviceSetup{{settings, strokes, mask}, options.timing});
}

}  // namespace

Machine::Machine(const Options& options) : options_(with_implied_options(options)), core_(options_.core_words) {
  wire();
  for (const std::string_view name : options_.devices) {
    if (error_.empty()) error_ = attach(name);
  }
}

Machine::~Machine() = default;

// --- Devices ---

std::string Machine::attach(std::string_view name, std::span<const core::Setting> settings) {
  const KnownDevice* const known = find_known(name);
  if (known == nullptr) return unknown_device(name);
  std::string error = core::wrong_setting(name, known->info.options, settings);
  if (error.empty()) error = attach(known->info, make(*known, settings, options_, *strokes_));
  return error;
}

std::string Machine::attach(const core::IotDeviceInfo& info, std::unique_ptr<core::IotDevice> device) {
  if (device == nullptr) return "found a null device to attach as " + std::string(info.name);
  if (std::string error = find_code_conflict(info); !error.empty()) return error;
  devices_.push_back(std::make_unique<Attached>(Attached{info, std::move(device), priority_of(info.name)}));
  wire();
  return {};
}

// Why such a device cannot be attached: its name is taken, or a device code belongs to another device, even to one that
// waits for its first IOT. Empty if it can.
std::string Machine::find_code_conflict(const core::IotDeviceInfo& info) const {
  const std::string name(info.name);
  if (find_attached(info.name) != nullptr) return "the device " + name + " is already attached";
  for (const std::uint8_t code : info.codes) {
    if (code >= by_code_.size()) return "the device " + name + " has the code " + std::to_string(code) + ", expected 0 to 63";
    std::string other;
    if (code == control_code || code == extension_code) other = "the processor";
    else if (by_code_[code] != no_device) other = "the device " + std::string(by_priority_[by_code_[code]]->info.name);
    for (const Spare& spare : spares_) {
      const auto codes = spare.known->info.codes;
      const bool has_it = spare.known->info.name != info.name && std::find(codes.begin(), codes.end(), code) != codes.end();
      if (other.empty() && has_it) other = "the device " + std::string(spare.known->info.name);
    }
    if (!other.empty()) return "the device " + name + " has the device code " + octal(code) + ", which " + other + " already has";
  }
  return {};
}

// Rebuilds the tables that depend on the attached devices.
void Machine::wire() {
  by_priority_.clear();
  for (const auto& each : devices_) by_priority_.push_back(each.get());
  std::stable_sort(by_priority_.begin(), by_priority_.end(),
                   [](const Attached* a, const Attached* b) { return a->priority < b->priority; });
  by_code_.fill(no_device);
  requesting_ = 0;
  for (std::size_t i = 0; i < by_priority_.size(); ++i) {
    for (const std::uint8_t code : by_priority_[i]->info.codes) by_code_[code] = static_cast<std::uint8_t>(i);
    requesting_ += by_priority_[i]->requests ? 1 : 0;
  }
  due_.assign(by_priority_.size(), core::Instant::min());
}

std::string Machine::attach_when_used(std::string_view name, std::span<const core::Setting> settings) {
  const KnownDevice* const known = find_known(name);
  if (known == nullptr) return unknown_device(name);
  std::string error = core::wrong_setting(name, known->info.options, settings);
  if (error.empty()) error = find_code_conflict(known->info);
  if (error.empty()) spares_.push_back({known, with_lasting_names(known->info.options, settings)});
  return error;
}

void Machine::plug_in(std::string_view name, bool in) {
  const auto spare = std::find_if(spares_.begin(), spares_.end(), [name](const Spare& each) { return each.known->info.name == name; });
  if (spare == spares_.end()) return;
  std::erase_if(devices_, [name](const auto& each) { return each->info.name == name; });
  wire();
  if (in) static_cast<void>(attach(spare->known->info, make(*spare->known, spare->settings, options_, *strokes_)));
}

void Machine::plug_in_used(std::uint32_t word) {
  const auto code = static_cast<std::uint8_t>((word >> 6) & 077U);
  if (by_code_[code] != no_device || belongs_to_absent_device(word)) return;
  for (const Spare& spare : spares_) {
    const auto codes = spare.known->info.codes;
    if (std::find(codes.begin(), codes.end(), code) != codes.end()) return plug_in(spare.known->info.name, true);
  }
}

Machine::Attached* Machine::find_attached(std::string_view name) const {
  const auto found =
      std::find_if(devices_.begin(), devices_.end(), [name](const auto& each) { return each->info.name == name; });
  return found == devices_.end() ? nullptr : found->get();
}

core::IotDevice* Machine::device(std::string_view name) const {
  const Attached* const attached = find_attached(name);
  return attached == nullptr ? nullptr : attached->device.get();
}

// --- Between runs ---

void Machine::load(Address address, std::span<const core::Word18> words) {
  for (const core::Word18 word : words) deposit(address++, word);
}

void Machine::load(Address address, std::initializer_list<std::uint32_t> words) {
  for (const std::uint32_t word : words) deposit(address++, core::Word18(word));
}

core::Instant Machine::deadline() const {
  core::Instant next = console_.deadline();
  for (const auto& each : devices_) next = std::min(next, each->device->deadline());
  return next;
}

Counts Machine::counts() const {
  const std::int64_t machine_cycles = (now_.time_since_epoch() - asynchronous_) / machine_cycle;
  return {counts_.instructions, static_cast<std::uint64_t>(machine_cycles), counts_.stolen_cycles};
}

void Machine::start(Address address) {
  for (const auto& each : devices_) each->device->power_clear(now_);
  state_ = {.ac = state_.ac, .mq = state_.mq, .sc = state_.sc, .pc = address & address_mask, .link = state_.link};
}

void Machine::visit_state(core::StateVisitor& visit) {
  visit.section("processor", state_);
  visit.section("time", [this](core::StateVisitor& fields) {
    fields("now", now_);
    fields("asynchronous", asynchronous_);
    fields("instructions", counts_.instructions);
    fields("stolen_cycles", counts_.stolen_cycles);
    fields.require(asynchronous_ <= now_.time_since_epoch(), "asynchronous", "no more than the time");
  });
  visit.section("core", core_);
  visit.section("console", console_);
  for (const auto& each : devices_) {
    visit.section(each->info.name, *each->device);
    each->device->require_time(visit, now_);
  }
  if (visit.restores()) stop_requested_ = false;
  visit.section("unanswered", [this](core::StateVisitor& fields) {
    fields.list("words", unanswered_, [&fields](Unanswered& entry) {
      fields("word", entry.word, core::Word18::mask);
      fields("count", entry.count);
      fields("first_pc", entry.first_pc, address_mask);
    });
  });
}

// --- Inside a run ---

// The host may have accessed any device since the last run.
void Machine::begin_run() {
  std::fill(due_.begin(), due_.end(), core::Instant::min());
}

void Machine::end_run() {
  for (const auto& each : devices_) each->device->finish_strokes(now_);
  strokes_->flush();
}

// Returns the time after the data break. The request is copied, because the device drops its own when it is granted.
SIGHTLINE_INLINE inline core::Instant Machine::grant(core::IotDevice& device, core::DataBreak request, core::Instant now,
                                                     ObserverCalls* calls) {
  using Direction = core::DataBreak::Direction;
  core::Word18 word = request.direction == Direction::to_core ? request.word : core_.read(request.address);
  Verb verb = Verb::break_read;
  std::uint8_t access = mark::read;
  if (request.direction != Direction::from_core) [[unlikely]] {
    const bool counts = request.direction == Direction::count;
    if (counts) word = word + core::Word18(1);
    verb = counts ? Verb::break_modify : Verb::break_write;
    access = counts ? mark::read | mark::written : mark::written;
    core_.write(request.address, word);
  }
  const core::Duration length = machine_cycle * request.cycles;
  if (calls != nullptr) calls->access(access, {now, length, verb, request.address, word});
  counts_.stolen_cycles += static_cast<std::uint64_t>(request.cycles);
  device.end_break(now + length, word);
  return now + length;
}

// A boundary at which something may be due: advances the devices that are due, and grants their data breaks.
Machine::Boundary Machine::serve_boundary(core::Instant now, Registers& registers, ObserverCalls* calls) {
  const bool deferred = registers.is(mode::interrupts_deferred);
  const bool open = registers.is(mode::interrupts_on) && !deferred;
  registers.modes &= ~mode::interrupts_deferred;
  const std::size_t count = due_.size();
  core::Instant due = core::never;
  for (std::size_t i = 0; i < count;) {
    if (const core::Instant of_device = due_[i]; now < of_device) {
      due = of_device < due ? of_device : due;
      ++i;
      continue;
    }
    Attached& attached = *by_priority_[i];
    core::IotDevice& device = *attached.device;
    device.advance(now);
    const core::DataBreak* const request = device.data_break();
    if (request != nullptr) {
      now = grant(device, *request, now, calls);
      due = core::never;
    }
    due_[i] = device.deadline();
    const bool requests = device.interrupt_request();
    requesting_ += static_cast<std::size_t>(requests) - static_cast<std::size_t>(attached.requests);
    attached.requests = requests;
    if (request != nullptr) {
      i = 0;  // one before it may be due by now
    } else {
      due = std::min(due, due_[i++]);
    }
  }
  due = deferred || stop_requested_ ? now : std::max(now, due);
  return {now, due, open && requesting_ != 0};
}

// The pulses of an IOT whose Fetch cycle ends at `now`.
Machine::IotEffect Machine::input_output(core::Instant now, std::uint32_t word, core::Word18 ac) {
  if (!spares_.empty()) plug_in_used(word);
  core::IotReply reply{ac};
  const unsigned code = (word >> 6) & 077U;
  const bool acts = (word & 06U) != 0;
  if (const std::size_t i = by_code_[code]; i != no_device) {
    by_priority_[i]->device->iot(now, word, reply);
    if (acts) due_[i] = core::Instant::min();
  }
  if (reads_status(word)) {
    for (const auto& each : devices_) reply.collect(core::Word18(each->device->status(now)));
    reply.answered |= 04U;
  }
  if (code == control_code) control_pulses(now, word, reply);
  return {reply, options_.timing.iot_stretch[code], acts || stop_requested_};
}

// TTS 703301 (skips if there is a teletype), CAF 703302. SKP7 is the processor's.
void Machine::control_pulses(core::Instant now, std::uint32_t word, core::IotReply& reply) {
  const std::uint32_t pulses = word & 07U;
  if (!options_.timing.device_33_each_pulse && (pulses & (pulses - 1)) != 0) return;
  if ((word & 040U) == 0) reply.test(word, find_attached("keyboard") != nullptr);
  if ((word & 02U) == 0) return;
  reply.answered |= 02U;
  for (const auto& each : devices_) each->device->clear_flags(now);
  std::fill(due_.begin(), due_.end(), core::Instant::min());
}

void Machine::count_unanswered(std::uint32_t word, Address at) {
  for (Unanswered& entry : unanswered_) {
    if (entry.word == word) {
      ++entry.count;
      return;
    }
  }
  unanswered_.push_back({word, 1, at});
}

// The reason of a run that an instruction ends.
StopReason Machine::reason_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::halted: return StopReason::halt;
    case Outcome::xct_chain: return StopReason::xct_chain;
    default: return StopReason::unanswered;
  }
}

}  // namespace sightline::pdp7
