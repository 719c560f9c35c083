// The state of a machine as named sections of bytes, and the visitors (emulators/core/state_visitor.hpp) that write and
// read them. The fields of a section follow each other without gaps, in the order of visit_state:
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
// All numbers are little-endian. host/live/snapshot.hpp makes a file of the sections.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/state_visitor.hpp"
#include "emulators/core/word.hpp"
#include "host/base/file.hpp"
#include "host/base/result.hpp"

namespace sightline::machines {

struct StateSection {
  std::string name;
  base::Bytes bytes;
  friend bool operator==(const StateSection&, const StateSection&) = default;
};
using MachineState = std::vector<StateSection>;

// The first bytes of a snapshot file. No program begins like this.
inline constexpr std::array<std::uint8_t, 8> snapshot_signature{0x89, 'S', 'L', 'S', 'N', 'A', 'P', 0x0A};

class StateWriter final : public core::StateVisitor {
 public:
  void words(std::string_view name, std::span<core::Word18> words) override;
  void bytes(std::string_view name, std::span<std::uint8_t> bytes, std::uint8_t most) override;
  void input(std::string_view name, std::span<const std::uint8_t> bytes) override;
  void require(bool, std::string_view, std::string_view) override {}

  [[nodiscard]] MachineState take() { return std::move(sections_); }

 private:
  void number(std::string_view name, core::StoredNumber& number) override;
  std::size_t begin(Group group, std::string_view name, std::size_t elements) override;
  void end() override {}

  std::uint8_t* grow(std::size_t by);
  void put(std::uint64_t number, unsigned bytes);

  MachineState sections_;
  base::Bytes* bytes_ = nullptr;  // of the last section
};

// After the first error it assigns nothing more.
class StateReader final : public core::StateVisitor {
 public:
  // What happens to outputs: a trial leaves them unchanged.
  enum class Outputs : std::uint8_t { keep, cut };

  StateReader(const MachineState& state, Outputs outputs)
      : state_(&state), used_(state.size()), outputs_(outputs) {}

  void words(std::string_view name, std::span<core::Word18> words) override;
  void bytes(std::string_view name, std::span<std::uint8_t> bytes, std::uint8_t most) override;
  void input(std::string_view name, std::span<const std::uint8_t> bytes) override;
  void require(bool holds, std::string_view name, std::string_view expected) override;
  void require_medium(bool holds, std::string_view name, std::string_view expected) override;
  [[nodiscard]] bool restores() const override { return true; }
  [[nodiscard]] bool cuts_outputs() const override { return outputs_ == Outputs::cut && !error_; }

  // The first error, if any; a section that was not read is one.
  [[nodiscard]] std::optional<base::Error> finish();

 private:
  void number(std::string_view name, core::StoredNumber& number) override;
  std::size_t begin(Group group, std::string_view name, std::size_t elements) override;
  void end() override;

  // The next `bytes` bytes of the section, low one first; nullopt after an error, which is recorded.
  std::optional<std::uint64_t> take(std::string_view name, unsigned bytes, std::uint64_t most, bool may_be_never = false);
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  bool open(std::string_view name);
  void close();
  [[nodiscard]] std::string place(std::string_view field) const;
  void too_short(std::string_view name, unsigned bytes);
  void out_of_range(std::string_view name, std::uint64_t number, std::uint64_t most);

  struct Open {
    Group group;
    std::string_view name;
  };
  const MachineState* state_;
  std::vector<bool> used_;
  Outputs outputs_;
  std::string_view section_;
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::vector<Open> groups_;  // groups that have begun and not ended
  std::optional<base::Error> error_;
};

// `visit_all` applies a visitor to the state of a machine. An error leaves the machine unchanged.
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

}  // namespace sightline::machines
