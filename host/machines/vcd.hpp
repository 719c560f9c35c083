// Value change dumps (IEEE 1364-2005, section 18): the signals of a machine, for GTKWave and similar viewers.
//
// A machine describes its signals in a table; help, the choice of signals and the file are made from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/machines/machine.hpp"

namespace sightline::machines {

struct VcdSignal {
  std::string_view group;  // selected together, and a scope of the file
  std::string_view name;
  unsigned bits;
  std::string_view meaning;
};

// FILE[:SIGNALS]: the last colon that is followed by a name begins the signals.
struct VcdTarget {
  std::string file;
  std::string signals;  // names of signals and groups between commas; empty: all
};
[[nodiscard]] VcdTarget vcd_target(std::string_view text);
// For help: the groups with their signals.
[[nodiscard]] std::string vcd_help(std::span<const VcdSignal> signals);

class VcdWriter {
 public:
  // The value of a wire that nobody drives.
  static constexpr std::uint32_t floating = ~std::uint32_t{0};

  // The table must outlive the writer. Error usage: a name that no row has.
  [[nodiscard]] static Result<VcdWriter> make(std::string_view machine, std::span<const VcdSignal> signals,
                                              std::string_view chosen);

  void take(TextTaker taker) { text_.take(std::move(taker)); }
  // Extends the last values to that time.
  void finish(std::int64_t nanoseconds);

  // Sets a signal, by its row, from `nanoseconds` on, which must not decrease. Unchanged values are skipped.
  void show(std::int64_t nanoseconds, std::size_t signal, std::uint32_t value) {
    if (!wires_[signal].chosen || (wires_[signal].known && wires_[signal].value == value)) return;
    write(nanoseconds, signal, value);
  }

 private:
  struct Wire {
    bool chosen = false;
    bool known = false;
    std::uint32_t value = 0;
    std::string identifier;
  };
  explicit VcdWriter(std::string_view machine, std::span<const VcdSignal> signals) : machine_(machine), signals_(signals) {}

  void write(std::int64_t nanoseconds, std::size_t signal, std::uint32_t value);
  void begin(std::string& text) const;

  std::string_view machine_;
  std::span<const VcdSignal> signals_;
  std::vector<Wire> wires_;
  TextBlocks text_;
  std::int64_t time_ = -1;  // of the last line; -1: nothing is written
};

}  // namespace sightline::machines
