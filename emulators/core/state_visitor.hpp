// How a machine exposes its state to a snapshot. Each class with state has one member
//
//   void visit_state(core::StateVisitor& visit);
//
// that names its members in a fixed order. The same function serves to save, restore and describe, so that the three cannot
// differ; host/machines/state.hpp has the visitors.
//
//   visit(name, member)                   a bool, integer, core::Word, TickCount or TickInstant
//   visit(name, member, most)             an integer or enumerator from 0 to `most`
//   visit.count(name, member, most)       the same for a size_t, whose width depends on the host
//   visit.words(name, span)               core memory; its size is a part of the configuration
//   visit.bytes(name, span, most)         the same for bytes of 0 to `most`
//   visit.part(name, what)                what.visit_state(visit), or what(visit) for a callable
//   visit.section(name, what)             the same; a section has a name and a length in the snapshot
//   visit.list(name, vector, each)        each(element) visits an element; elements are default-constructed
//   visit.present(name, optional, each)   likewise, for none or one
//   visit.input(name, span)               bytes from the configuration: only length and checksum are stored
//   visit.output(name, vector, before)    what the machine has produced: only its count is stored. `before` counts
//                                         what was produced before the machine was restored, which the vector lacks
//   visit.require(holds, name, expected)  a relation of members; on restoring, the snapshot is rejected if it is false
//   visit.require_medium(holds, name, expected)  the same for the medium in a device, which the user can exchange
//   visit.restores()                      members are being assigned: recompute what depends on them
//   visit.cuts_outputs()                  the same, and drop outputs later than the snapshot
//
// A member that a constructor sets and nothing changes is configuration, not state, and is not visited. A restored
// member is within its bounds, but relations hold only after `require`: until then no member may be used as an index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "time.hpp"
#include "word.hpp"

namespace sightline::core {

// How a member is stored: as an unsigned integer of `bytes` bytes with a value of 0 to `most`.
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
struct StoredAs<Word<Bits>> {
  static constexpr unsigned bytes = 4;
  static constexpr std::uint64_t most = Word<Bits>::mask;
  static std::uint64_t number(Word<Bits> value) { return value.value(); }
  static Word<Bits> member(std::uint64_t number) { return Word<Bits>(static_cast<std::uint32_t>(number)); }
};

// The longest times from which machines can continue without overflow; `never` is stored as the largest number.
template <class Tick>
inline constexpr std::uint64_t longest_time = std::uint64_t{1} << 62;
template <>
inline constexpr std::uint64_t longest_time<Nanosecond> = 9'100'000'000'000'000'000;

template <class Tick>
struct StoredAs<TickCount<Tick>> {
  static constexpr unsigned bytes = 8;
  static constexpr std::uint64_t most = longest_time<Tick>;
  static std::uint64_t number(TickCount<Tick> value) { return static_cast<std::uint64_t>(value.count()); }
  static TickCount<Tick> member(std::uint64_t number) { return TickCount<Tick>(static_cast<std::int64_t>(number)); }
};

template <class Tick>
struct StoredAs<TickInstant<Tick>> {
  static constexpr unsigned bytes = 8;
  static constexpr std::uint64_t most = longest_time<Tick>;
  static constexpr std::uint64_t never = std::numeric_limits<std::int64_t>::max();
  static std::uint64_t number(TickInstant<Tick> value) {
    return static_cast<std::uint64_t>(value.time_since_epoch().count());
  }
  static TickInstant<Tick> member(std::uint64_t number) {
    return TickInstant<Tick>(TickCount<Tick>(static_cast<std::int64_t>(number)));
  }
};

// A number as a visitor sees it.
struct StoredNumber {
  enum class Kind : std::uint8_t { flag, number, signed_number, word, time, output };
  Kind kind;
  std::uint64_t value;
  unsigned bytes;             // in the snapshot
  std::uint64_t most;         // largest value
  bool bounded = false;       // `most` is less than the type's
  bool may_be_never = false;  // beside 0 to `most` it can be the largest signed number
};

class StateVisitor {
 public:
  StateVisitor(const StateVisitor&) = delete;
  StateVisitor& operator=(const StateVisitor&) = delete;

  template <class Member>
  void operator()(std::string_view name, Member& member) {
    visit_number(name, member, StoredAs<Member>::most, false);
  }
  template <class Member, class Most>
  void operator()(std::string_view name, Member& member, Most most) {
    visit_number(name, member, StoredAs<Member>::number(static_cast<Member>(most)), true);
  }
  void count(std::string_view name, std::size_t& member, std::size_t most) {
    StoredNumber stored{StoredNumber::Kind::number, member, 8, most};
    number(name, stored);
    member = static_cast<std::size_t>(stored.value);
  }

  template <class What>
  void part(std::string_view name, What&& what) {
    begin(Group::part, name, 1);
    visit_what(what);
    end();
  }
  template <class What>
  void section(std::string_view name, What&& what) {
    if (begin(Group::section, name, 1) == 0) return;
    visit_what(what);
    end();
  }
  template <class Element, class Each>
  void list(std::string_view name, std::vector<Element>& elements, Each each) {
    const std::size_t count = begin(Group::list, name, elements.size());
    if (restores()) elements.clear();
    elements.resize(count);
    for (Element& element : elements) each(element);
    end();
  }
  template <class Element, class Each>
  void present(std::string_view name, std::optional<Element>& element, Each each) {
    const bool there = begin(Group::optional, name, element ? 1 : 0) != 0;
    if (restores() || !there) element.reset();
    if (there && !element) element.emplace();
    if (element) each(*element);
    end();
  }
  template <class Elements>
  void output(std::string_view name, Elements& elements, std::uint64_t& before) {
    StoredNumber stored{StoredNumber::Kind::output, before + elements.size(), 8, ~std::uint64_t{0}};
    number(name, stored);
    if (!cuts_outputs()) return;
    // Drops what was produced after the snapshot. Output from before it that another run produced is not available.
    if (stored.value >= before && stored.value - before <= elements.size()) {
      elements.resize(static_cast<std::size_t>(stored.value - before));
    } else {
      elements.clear();
      before = stored.value;
    }
  }

  virtual void words(std::string_view name, std::span<Word18> words) = 0;
  virtual void bytes(std::string_view name, std::span<std::uint8_t> bytes, std::uint8_t most = 0xFF) = 0;
  virtual void input(std::string_view name, std::span<const std::uint8_t> bytes) = 0;
  virtual void require(bool holds, std::string_view name, std::string_view expected) = 0;
  virtual void require_medium(bool holds, std::string_view name, std::string_view expected) { require(holds, name, expected); }
  [[nodiscard]] virtual bool restores() const { return false; }
  [[nodiscard]] virtual bool cuts_outputs() const { return false; }

 protected:
  StateVisitor() = default;
  ~StateVisitor() = default;

  // Reads the number, or assigns it.
  virtual void number(std::string_view name, StoredNumber& number) = 0;

  enum class Group : std::uint8_t { part, section, list, optional };
  // Begins a group that has `elements` elements; returns how many it shall have. For a section, 0 means: do not visit it.
  virtual std::size_t begin(Group group, std::string_view name, std::size_t elements) = 0;
  virtual void end() = 0;

 private:
  template <class Member>
  void visit_number(std::string_view name, Member& member, std::uint64_t most, bool bounded) {
    using Stored = StoredAs<Member>;
    StoredNumber stored{kind_of<Member>(), Stored::number(member), Stored::bytes, most, bounded, requires { Stored::never; }};
    number(name, stored);
    if (restores()) member = Stored::member(stored.value);
  }
  template <class Member>
  static constexpr StoredNumber::Kind kind_of() {
    if constexpr (std::is_same_v<Member, bool>) return StoredNumber::Kind::flag;
    else if constexpr (requires { Member{}.time_since_epoch(); } || requires { Member{}.count(); }) return StoredNumber::Kind::time;
    else if constexpr (std::is_class_v<Member>) return StoredNumber::Kind::word;
    else if constexpr (std::is_signed_v<Member>) return StoredNumber::Kind::signed_number;
    else return StoredNumber::Kind::number;
  }
  template <class What>
  void visit_what(What&& what) {
    if constexpr (requires { what.visit_state(*this); }) what.visit_state(*this);
    else what(*this);
  }
};

}  // namespace sightline::core
