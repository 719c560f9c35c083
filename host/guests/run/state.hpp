// The state of a machine as named sections of bytes, and the visitors (emulators/core/visit_state.hpp) that
// write and read them. A section's fields follow each other without gaps, in the order in which visit_state
// names them:
//
//   bool, std::uint8_t, enumerators   1 byte          core::Word                 4 bytes
//   std::uint16_t                     2 bytes         TickCount, TickInstant     8 bytes, signed
//   std::uint32_t, int                4 bytes         std::size_t (`count`)      8 bytes
//   std::uint64_t, std::int64_t       8 bytes
//   list      4 bytes, the number of elements, then these
//   present   1 byte, 0 or 1, then as many elements
//   input     8 bytes, the length, then 4 bytes, its CRC-32
//   output    8 bytes, the number of elements produced since the first start
//
// All are little-endian. host/live/snapshot.hpp makes a file of the sections.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "emulators/core/time.hpp"
#include "emulators/core/tstates.hpp"
#include "emulators/core/word.hpp"
#include "host/base/crc32.hpp"
#include "host/base/file.hpp"
#include "host/base/result.hpp"

namespace sightline::guests::run {

struct StateSection {
  std::string name;
  base::Bytes bytes;
  friend bool operator==(const StateSection&, const StateSection&) = default;
};
using MachineState = std::vector<StateSection>;

// The first bytes of a file with a state. No program begins like this.
inline constexpr std::array<std::uint8_t, 8> snapshot_signature{0x89, 'S', 'L', 'S', 'N', 'A', 'P', 0x0A};

// How a member is stored: as an unsigned integer of `bytes` bytes, whose value is 0 to `most`.
template <class T>
struct StoredAs;

template <>
struct StoredAs<bool> {
  static constexpr unsigned bytes = 1;
  static constexpr std::uint64_t most = 1;
  static std::uint64_t number(bool value) { return value ? 1 : 0; }
  static bool member(std::uint64_t number) { return number != 0; }
};

template <class Integer>
requires std::is_integral_v<Integer>
struct StoredAs<Integer> {
  static constexpr unsigned bytes = sizeof(Integer);
  static constexpr std::uint64_t most = std::numeric_limits<std::make_unsigned_t<Integer>>::max();
  static std::uint64_t number(Integer value) { return static_cast<std::make_unsigned_t<Integer>>(value); }
  static Integer member(std::uint64_t number) { return static_cast<Integer>(number); }
};

template <class Enumeration>
requires std::is_enum_v<Enumeration>
struct StoredAs<Enumeration> {
  static constexpr unsigned bytes = 1;
  static constexpr std::uint64_t most = 255;
  static_assert(sizeof(Enumeration) == 1);
  static std::uint64_t number(Enumeration value) { return static_cast<std::uint8_t>(value); }
  static Enumeration member(std::uint64_t number) { return static_cast<Enumeration>(number); }
};

template <unsigned Bits>
struct StoredAs<core::Word<Bits>> {
  static constexpr unsigned bytes = 4;
  static constexpr std::uint64_t most = core::Word<Bits>::mask;
  static std::uint64_t number(core::Word<Bits> value) { return value.value(); }
  static core::Word<Bits> member(std::uint64_t number) {
    return core::Word<Bits>(static_cast<std::uint32_t>(number));
  }
};

// The longest times that machines can count on from without an overflow; `never` is stored as the largest
// number.
template <class Tick>
inline constexpr std::uint64_t longest_time = std::uint64_t{1} << 62;
template <>
inline constexpr std::uint64_t longest_time<core::Nanosecond> = 9'100'000'000'000'000'000;

template <class Tick>
struct StoredAs<core::TickCount<Tick>> {
  static constexpr unsigned bytes = 8;
  static constexpr std::uint64_t most = longest_time<Tick>;
  static std::uint64_t number(core::TickCount<Tick> value) {
    return static_cast<std::uint64_t>(value.count());
  }
  static core::TickCount<Tick> member(std::uint64_t number) {
    return core::TickCount<Tick>(static_cast<std::int64_t>(number));
  }
};

template <class Tick>
struct StoredAs<core::TickInstant<Tick>> {
  static constexpr unsigned bytes = 8;
  static constexpr std::uint64_t most = longest_time<Tick>;
  static constexpr std::uint64_t never = std::numeric_limits<std::int64_t>::max();
  static std::uint64_t number(core::TickInstant<Tick> value) {
    return static_cast<std::uint64_t>(value.time_since_epoch().count());
  }
  static core::TickInstant<Tick> member(std::uint64_t number) {
    return core::TickInstant<Tick>(core::TickCount<Tick>(static_cast<std::int64_t>(number)));
  }
};

// Calls what a part or section is: a class with visit_state, or a function of the visitor.
template <class Visitor, class What>
void visit_what(Visitor& visit, What&& what) {
  if constexpr (requires { what.visit_state(visit); }) {
    what.visit_state(visit);
  } else {
    what(visit);
  }
}

class StateWriter {
 public:
  static constexpr bool restores = false;

  template <class Member>
  void operator()(std::string_view, const Member& member) {
    put(StoredAs<Member>::number(member), StoredAs<Member>::bytes);
  }
  template <class Member, class Most>
  void operator()(std::string_view name, const Member& member, Most) {
    (*this)(name, member);
  }
  void count(std::string_view, std::size_t member, std::size_t) { put(member, 8); }
  template <unsigned Bits>
  void words(std::string_view, std::span<core::Word<Bits>> words) {
    std::uint8_t* at = grow(4 * words.size());
    for (const core::Word<Bits> word : words) {
      for (unsigned i = 0; i < 4; ++i) *at++ = static_cast<std::uint8_t>(word.value() >> (8 * i));
    }
  }
  void bytes(std::string_view, std::span<std::uint8_t> bytes, std::uint8_t = 0xFF) {
    bytes_->insert(bytes_->end(), bytes.begin(), bytes.end());
  }
  template <class What>
  void part(std::string_view, What&& what) {
    visit_what(*this, what);
  }
  template <class What>
  void section(std::string_view name, What&& what) {
    sections_.push_back({std::string(name), {}});
    bytes_ = &sections_.back().bytes;
    visit_what(*this, what);
  }
  template <class Element, class Each>
  void list(std::string_view, std::vector<Element>& elements, Each each) {
    put(elements.size(), 4);
    for (Element& element : elements) each(element);
  }
  template <class Element, class Each>
  void present(std::string_view, std::optional<Element>& element, Each each) {
    put(element ? 1 : 0, 1);
    if (element) each(*element);
  }
  void input(std::string_view, std::span<const std::uint8_t> bytes) {
    put(bytes.size(), 8);
    put(base::crc32(bytes), 4);
  }
  template <class Elements>
  void output(std::string_view, const Elements& elements, std::uint64_t before) {
    put(before + elements.size(), 8);
  }
  void require(bool, std::string_view, std::string_view) {}

  [[nodiscard]] MachineState take() { return std::move(sections_); }

 private:
  std::uint8_t* grow(std::size_t by) {
    bytes_->resize(bytes_->size() + by);
    return bytes_->data() + (bytes_->size() - by);
  }
  void put(std::uint64_t number, unsigned bytes) {
    for (; bytes > 0; --bytes, number >>= 8) bytes_->push_back(static_cast<std::uint8_t>(number));
  }

  MachineState sections_;
  base::Bytes* bytes_ = nullptr;  // of the last section
};

// After the first error nothing more is assigned.
class StateReader {
 public:
  static constexpr bool restores = true;

  // What is done to outputs: a trial leaves them alone.
  enum class Outputs : std::uint8_t { keep, cut };

  StateReader(const MachineState& state, Outputs outputs)
      : state_(&state), used_(state.size()), outputs_(outputs) {}

  template <class Member>
  void operator()(std::string_view name, Member& member) {
    assign(name, member, StoredAs<Member>::most);
  }
  template <class Member, class Most>
  void operator()(std::string_view name, Member& member, Most most) {
    assign(name, member, StoredAs<Member>::number(static_cast<Member>(most)));
  }
  void count(std::string_view name, std::size_t& member, std::size_t most) {
    std::uint64_t wide = member;
    assign(name, wide, most);
    member = static_cast<std::size_t>(wide);
  }
  template <unsigned Bits>
  void words(std::string_view name, std::span<core::Word<Bits>> words) {
    for (core::Word<Bits>& word : words) (*this)(name, word);
  }
  void bytes(std::string_view name, std::span<std::uint8_t> bytes, std::uint8_t most = 0xFF) {
    for (std::uint8_t& byte : bytes) (*this)(name, byte, most);
  }
  template <class What>
  void part(std::string_view name, What&& what) {
    parts_.push_back(name);
    visit_what(*this, what);
    parts_.pop_back();
  }
  template <class What>
  void section(std::string_view name, What&& what) {
    if (!open(name)) return;
    visit_what(*this, what);
    close();
  }
  template <class Element, class Each>
  void list(std::string_view name, std::vector<Element>& elements, Each each) {
    parts_.push_back(name);
    std::uint32_t count = 0;
    // An element has a byte at least.
    assign("number", count, left());
    if (!error_) {
      elements.clear();
      elements.resize(count);
      for (Element& element : elements) each(element);
    }
    parts_.pop_back();
  }
  template <class Element, class Each>
  void present(std::string_view name, std::optional<Element>& element, Each each) {
    bool there = element.has_value();
    (*this)(name, there);
    if (error_) return;
    element.reset();
    if (there) each(element.emplace());
  }
  void input(std::string_view name, std::span<const std::uint8_t> bytes);
  // What was produced later than the snapshot is dropped; of what another run produced before it nothing is
  // there.
  template <class Elements>
  void output(std::string_view name, Elements& elements, std::uint64_t& before) {
    std::uint64_t count = 0;
    assign(name, count, std::numeric_limits<std::uint64_t>::max());
    if (error_ || !cuts_outputs()) return;
    if (count >= before && count - before <= elements.size()) {
      elements.resize(static_cast<std::size_t>(count - before));
    } else {
      elements.clear();
      before = count;
    }
  }
  void require(bool holds, std::string_view name, std::string_view expected);

  [[nodiscard]] bool cuts_outputs() const { return outputs_ == Outputs::cut; }
  // The error if there was one, also that of a section that nothing has read.
  [[nodiscard]] std::optional<base::Error> finish();

 private:
  template <class Member>
  void assign(std::string_view name, Member& member, std::uint64_t most) {
    using Stored = StoredAs<Member>;
    if (error_) return;
    if (left() < Stored::bytes) return too_short(name, Stored::bytes);
    std::uint64_t number = 0;
    for (unsigned i = 0; i < Stored::bytes; ++i) number |= std::uint64_t{bytes_[at_ + i]} << (8 * i);
    bool good = number <= most;
    if constexpr (requires { Stored::never; }) good = good || number == Stored::never;
    if (!good) return out_of_range(name, number, most);
    at_ += Stored::bytes;
    member = Stored::member(number);
  }

  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  bool open(std::string_view name);
  void close();
  [[nodiscard]] std::string place(std::string_view field) const;
  void too_short(std::string_view name, unsigned bytes);
  void out_of_range(std::string_view name, std::uint64_t number, std::uint64_t most);

  const MachineState* state_;
  std::vector<bool> used_;
  Outputs outputs_;
  std::string_view section_;
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::vector<std::string_view> parts_;
  std::optional<base::Error> error_;
};

// `visit_all` shows the state of a machine to a visitor. A state that is refused leaves the machine as it
// was.
template <class VisitAll>
[[nodiscard]] base::Result<base::Done> restore_state(const MachineState& state, VisitAll visit_all) {
  StateWriter before;
  visit_all(before);
  StateReader trial(state, StateReader::Outputs::keep);
  visit_all(trial);
  if (auto error = trial.finish()) {
    const MachineState kept = before.take();
    StateReader back(kept, StateReader::Outputs::keep);
    visit_all(back);
    return *error;
  }
  StateReader last(state, StateReader::Outputs::cut);
  visit_all(last);
  return base::Done{};
}

}  // namespace sightline::guests::run
