// The RB09 fixed-head disk on the PDP-7: IOT device 71.
//
// 200 tracks of 80 sectors of 64 words turn under one head per track. A transfer begins when the addressed word next passes
// the head and continues word by word, across sectors and tracks, until the word count is 0. Each word requests a data
// break when it passes; the controller buffers one word, so a break that comes later than the next word is a timing error.
//
// What the program writes is stored beside the image, sector by sector: the image is never changed, and a snapshot holds
// only the differences.
//
// No manual of the RB09 is available. Registers, codes and the status word follow an open simulator of the PDP-7 and the
// use by a kernel of 1970; what neither tells is in Timing.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../core/iot_device.hpp"
#include "../core/state_visitor.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"
#include "device_setup.hpp"
#include "state.hpp"

namespace sightline::pdp7 {

namespace rb09 {

inline constexpr std::uint32_t tracks = 200, sectors = 80, words = 64;
inline constexpr std::uint32_t words_per_track = sectors * words;
inline constexpr std::uint32_t words_of_disk = tracks * words_per_track;
inline constexpr std::uint32_t tracks_per_lock = 10;  // twenty write-lock switches
inline constexpr std::uint32_t all_locked = (1U << (tracks / tracks_per_lock)) - 1;

// Bits of the status word.
namespace status {
inline constexpr std::uint32_t error = 0400000,  // any of the next four
    parity = 0200000, illegal = 0100000,         // an address that does not exist, or a locked track
    timing = 0040000, not_ready = 0020000, done = 0010000, interrupts = 0004000, busy = 0002000, write = 0001000;
inline constexpr std::uint32_t errors = parity | illegal | timing | not_ready;
inline constexpr std::uint32_t toggled = interrupts | busy | write;
}  // namespace status

// The pulse and bits 060 select the operation.
namespace operation {
inline constexpr std::uint32_t clear_flags = 001, skip = 021, clear_status = 041, read_address = 002, read_status = 022,
                               load_core = 042, load_address = 004, load_count = 024, load_status = 044;
}

// The choices where neither source tells, as explained in Timing.
struct Choices {
  core::Duration word{};         // the time of a word under the head
  bool clear_stops = true;       // DBCS stops a transfer
  bool late_stops = true;        // a timing error stops a transfer
  std::uint32_t after_last = 0;  // the address after the last word of the disk
};

struct Counters {
  std::uint64_t transfers = 0;  // begun
  std::uint64_t words_read = 0;
  std::uint64_t words_written = 0;  // on the disk
  std::uint64_t timing_errors = 0;
};

// Track and sector in BCD: the track's three digits above the low eight bits, of which the hundreds digit is 0 or 1, and
// the sector's two. nullopt: a digit above 9, or a sector above 79.
[[nodiscard]] constexpr std::optional<std::uint32_t> address_of_bcd(std::uint32_t ac) {
  const auto digit = [ac](unsigned shift, std::uint32_t mask) { return (ac >> shift) & mask; };
  const std::uint32_t hundreds = digit(16, 1), tens = digit(12, 017), units = digit(8, 017);
  const std::uint32_t sector_tens = digit(4, 017), sector_units = digit(0, 017);
  if (tens > 9 || units > 9 || sector_tens > 7 || sector_units > 9) return std::nullopt;
  return ((hundreds * 100 + tens * 10 + units) * sectors + sector_tens * 10 + sector_units) * words;
}
[[nodiscard]] constexpr std::uint32_t bcd_of_address(std::uint32_t address) {
  const std::uint32_t track = address / words_per_track, sector = address / words % sectors;
  return (track / 100) << 16 | (track / 10 % 10) << 12 | (track % 10) << 8 | (sector / 10) << 4 | sector % 10;
}

}  // namespace rb09

class Rb09 final : public core::IotDevice {
 public:
  using Word = core::Word18;
  static constexpr std::array<std::uint8_t, 1> codes{071};
  static constexpr core::IotDeviceInfo info{.name = "rb09", .help = "the RB09 fixed-head disk", .codes = codes};

  // `core_mask`: core addresses wrap at it.
  explicit Rb09(const rb09::Choices& choices, Address core_mask = in_bank_mask) : choices_(choices), core_mask_(core_mask) {}
  explicit Rb09(const DeviceSetup& setup)
      : Rb09({.word = setup.timing.disk_word,
              .clear_stops = setup.timing.disk_clear_stops,
              .late_stops = setup.timing.disk_late_stops,
              .after_last = setup.timing.disk_after_last},
             setup.address_mask) {}

  // Inserts a disk of words_of_disk words in address order. Locked tracks cannot be written.
  void attach(std::vector<Word> image, std::uint32_t locks) {
    image_ = std::move(image);
    image_.resize(rb09::words_of_disk);
    sum_ = 0;
    for (std::uint32_t address = 0; address < rb09::words_of_disk; ++address) sum_ += checksum(address, image_[address]);
    locks_ = locks;
    changed_.clear();
  }
  void detach() {
    stop();
    image_.clear();
    changed_.clear();
    sum_ = 0;
  }
  [[nodiscard]] bool attached() const { return !image_.empty(); }
  [[nodiscard]] bool changed() const { return !changed_.empty(); }
  [[nodiscard]] Word word(std::uint32_t address) const {
    const auto sector = sector_of(address);
    return sector != changed_.end() && sector->number == address / rb09::words ? sector->words[address % rb09::words]
                                                                               : image_[address];
  }

  // A word that has passed is moved, or is late, at the next instruction boundary: never before this IOT.
  void iot(core::Instant now, std::uint32_t word, core::IotReply& reply) override {
    const std::uint32_t subdevice = word & 060U;
    for (const std::uint32_t pulse : {1U, 2U, 4U}) {
      if ((word & pulse) != 0 && subdevice != 060U) {
        operate(now, subdevice | pulse, reply);
        reply.answered |= pulse;
      }
    }
  }

  // When the next word of a transfer passes.
  [[nodiscard]] core::Instant deadline() const override { return next_; }
  void advance(core::Instant now) override {
    passed_ = false;
    if (now < next_) return;
    const bool late = now > next_ + choices_.word;
    if (late && choices_.late_stops) {
      note_late();
      return stop();
    }
    const bool writes = (status_ & rb09::status::write) != 0;
    if (writes && (locks_ >> (address_ / rb09::words_per_track / rb09::tracks_per_lock) & 1U) != 0) {
      if (late) note_late();
      fail(rb09::status::illegal);
      status_ |= rb09::status::done;
      return;
    }
    using Direction = core::DataBreak::Direction;
    passed_ = true;
    break_ = {.direction = writes ? Direction::from_core : Direction::to_core,
              .address = static_cast<std::uint16_t>(core_),
              .word = writes ? Word(0) : word(address_)};
  }
  [[nodiscard]] const core::DataBreak* data_break() const override { return passed_ ? &break_ : nullptr; }
  void end_break(core::Instant end, Word moved) override {
    passed_ = false;
    if (end - machine_cycle > next_ + choices_.word) note_late();
    if ((status_ & rb09::status::write) != 0) {
      put(address_, moved);
      ++counters_.words_written;
    } else {
      ++counters_.words_read;
    }
    address_ = address_ + 1 == rb09::words_of_disk ? choices_.after_last : address_ + 1;
    core_ = (core_ + 1) & core_mask_;
    count_ = (count_ + 1) & count_mask;
    next_ += choices_.word;
    if (count_ != 0) return;
    stop();
    status_ |= rb09::status::done;
  }

  [[nodiscard]] bool interrupt_request() const override {
    return (status_ & rb09::status::interrupts) != 0 && (status_ & (rb09::status::errors | rb09::status::done)) != 0;
  }
  // CAF and START: flags down, a transfer is abandoned.
  void clear_flags(core::Instant) override {
    stop();
    status_ = 0;
  }

  [[nodiscard]] const rb09::Counters& counters() const { return counters_; }
  [[nodiscard]] std::vector<core::Count> counts() const override {
    return {{"transfers", counters_.transfers},
            {"words_read", counters_.words_read},
            {"words_written", counters_.words_written},
            {"timing_errors", counters_.timing_errors}};
  }
  // The status word including the bit for any error.
  [[nodiscard]] std::uint32_t status_word() const {
    return status_ | ((status_ & rb09::status::errors) != 0 ? rb09::status::error : 0U);
  }
  [[nodiscard]] std::uint32_t address() const { return address_; }
  [[nodiscard]] Address core_address() const { return core_; }
  [[nodiscard]] std::uint32_t word_count() const { return count_; }

  void visit_state(core::StateVisitor& visit) override {
    std::uint64_t others = sum_of_other_sectors();
    visit("image", others);
    visit("status", status_, Word::mask);
    visit("address", address_, rb09::words_of_disk - 1);
    visit("core", core_, address_mask);
    visit("count", count_, count_mask);
    visit("next", next_);
    visit("transfers", counters_.transfers);
    visit("words_read", counters_.words_read);
    visit("words_written", counters_.words_written);
    visit("timing_errors", counters_.timing_errors);
    visit.list("changed", changed_, [&visit](Sector& sector) {
      visit("number", sector.number, rb09::words_of_disk / rb09::words - 1);
      visit.words("words", std::span<Word>(sector.words));
    });
    const bool busy = (status_ & rb09::status::busy) != 0;
    visit.require(busy == (next_ != core::never) && (!busy || attached()), "status", "busy while words pass, and only then");
    visit.require(std::is_sorted(changed_.begin(), changed_.end(),
                                 [](const Sector& a, const Sector& b) { return a.number <= b.number; }),
                  "changed", "sectors in ascending order");
    visit.require(attached() || changed_.empty(), "changed", "no sectors while no disk is in the drive");
    visit.require_medium(others == sum_of_other_sectors(), "image",
                         "the disk image of the run that made the snapshot, as it was before that run or as the run has written it back");
  }

 private:
  struct Sector {
    std::uint32_t number = 0;
    std::array<Word, rb09::words> words{};
  };
  static constexpr std::uint32_t count_mask = 0177777;

  // A sum over words, so that it is known without any of the sectors. The mixing is that of SplitMix64.
  [[nodiscard]] static constexpr std::uint64_t checksum(std::uint32_t address, Word word) {
    std::uint64_t mixed = (std::uint64_t{address} << 18U | word.value()) + 0x9E3779B97F4A7C15U;
    mixed = (mixed ^ mixed >> 30U) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ mixed >> 27U) * 0x94D049BB133111EBU;
    return mixed ^ mixed >> 31U;
  }
  // Over the sectors of the image that the run has not written: a snapshot needs those, and holds the others.
  [[nodiscard]] std::uint64_t sum_of_other_sectors() const {
    std::uint64_t sum = sum_;
    if (!attached()) return sum;
    for (const Sector& sector : changed_) {
      for (std::uint32_t n = 0; n < rb09::words; ++n) {
        const std::uint32_t address = sector.number * rb09::words + n;
        sum -= checksum(address, image_[address]);
      }
    }
    return sum;
  }
  [[nodiscard]] std::vector<Sector>::const_iterator sector_of(std::uint32_t address) const {
    return std::lower_bound(changed_.begin(), changed_.end(), address / rb09::words,
                            [](const Sector& sector, std::uint32_t number) { return sector.number < number; });
  }
  void put(std::uint32_t address, Word word) {
    const std::uint32_t number = address / rb09::words;
    auto sector = changed_.begin() + (sector_of(address) - changed_.cbegin());
    if (sector == changed_.end() || sector->number != number) {
      sector = changed_.insert(sector, Sector{number, {}});
      std::copy_n(image_.begin() + static_cast<std::ptrdiff_t>(number * rb09::words), rb09::words, sector->words.begin());
    }
    sector->words[address % rb09::words] = word;
  }

  void operate(core::Instant now, std::uint32_t operation, core::IotReply& reply) {
    namespace status = rb09::status;
    const std::uint32_t ac = reply.ac.value();
    switch (operation) {
      case rb09::operation::clear_flags: status_ &= ~(status::errors | status::done); break;
      case rb09::operation::skip:
        if ((status_ & (status::errors | status::done)) != 0) reply.skip = true;
        break;
      case rb09::operation::clear_status:
        if (choices_.clear_stops) stop();
        status_ = 0;
        break;
      case rb09::operation::read_address: reply.collect(Word(rb09::bcd_of_address(address_))); break;
      case rb09::operation::read_status: reply.collect(Word(status_word())); break;
      case rb09::operation::load_core: core_ = ac & core_mask_; break;
      case rb09::operation::load_address: {
        const auto address = rb09::address_of_bcd(ac);
        if (address) {
          address_ = *address;
        } else {
          status_ |= status::illegal;
        }
        break;
      }
      case rb09::operation::load_count: count_ = ac & count_mask; break;
      default: load_status(now, ac); break;
    }
  }

  void load_status(core::Instant now, std::uint32_t ac) {
    namespace status = rb09::status;
    const bool was_busy = (status_ & status::busy) != 0;
    status_ = (status_ & status::toggled) ^ (ac & (status::toggled | status::errors | status::done));
    const bool is_busy = (status_ & status::busy) != 0;
    if (!is_busy) next_ = core::never;
    if (is_busy && !was_busy) begin(now);
  }

  void begin(core::Instant now) {
    ++counters_.transfers;
    if (!attached()) {
      fail(rb09::status::not_ready);
      status_ |= rb09::status::done;
      return;
    }
    // Each word passes once per turn; the disk turns from instant zero.
    const std::int64_t turn = choices_.word.count() * rb09::words_per_track;
    const std::int64_t place = choices_.word.count() * (address_ % rb09::words_per_track);
    const std::int64_t since = now.time_since_epoch().count() - place;
    next_ = core::Instant(core::Duration(place + (since < 0 ? 0 : since / turn + 1) * turn));
  }
  // Records a break that comes later than the next word.
  void note_late() {
    ++counters_.timing_errors;
    status_ |= rb09::status::timing;
  }
  void fail(std::uint32_t error) {
    status_ |= error;
    stop();
  }
  void stop() {
    status_ &= ~rb09::status::busy;
    next_ = core::never;
    passed_ = false;
  }

  rb09::Choices choices_;
  Address core_mask_;
  std::vector<Word> image_;  // empty: no disk in the drive
  std::uint64_t sum_ = 0;  // of all words of the image
  std::uint32_t locks_ = 0;  // one bit per ten tracks, the first lowest
  std::vector<Sector> changed_;
  std::uint32_t status_ = 0;  // without the error bit
  std::uint32_t address_ = 0;
  Address core_ = 0;
  std::uint32_t count_ = 0;
  core::Instant next_ = core::never;
  bool passed_ = false;  // a word waits for its data break
  core::DataBreak break_;
  rb09::Counters counters_;
};

}  // namespace sightline::pdp7
