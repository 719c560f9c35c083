// The native twin of firmware/pdp7/turn, written from its SPECIFICATION.md: from the words of a model's tape and the
// switches to the display words of every picture, bit for bit. It does not model time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "emulators/core/word.hpp"
#include "host/programs/turn/specification.hpp"

namespace sightline::programs::turn {

struct TwinPicture {
  std::uint32_t angle = 0;  // 2^18 to a turn
  bool wire = false;
  Status status = Status::right;
  std::vector<core::Word18> display_file;  // to its stop word
  // Counted for the cost model of NOTES.md.
  std::uint32_t vertices = 0;
  std::uint32_t slots_empty = 0;
  std::uint32_t whole_edges = 0;
  std::uint32_t cut_edges = 0;      // with a junction, drawn or not
  std::uint32_t junctions = 0;      // ends at a junction
  std::uint32_t junctions_drawn = 0;
  std::uint32_t beginnings = 0;     // beginnings of chains of lines
  std::uint32_t lines = 0;          // drawn
  std::uint32_t long_lines = 0;     // of more than 127 points
  std::uint32_t long_words = 0;     // of 127 points
  std::uint32_t events = 0;         // passed
  std::uint32_t changes = 0;
};

class Twin {
 public:
  // `words`: of a tape, from address `base` on.
  Twin(std::span<const core::Word18> words, std::uint32_t base);

  // Computes the program's next picture; false if these switches make none. The first one is at the tape's angle whatever
  // speed the switches set.
  [[nodiscard]] bool next(std::uint32_t switches, TwinPicture& picture);

  [[nodiscard]] std::uint32_t angle() const { return angle_; }
  // The state word of a slot.
  [[nodiscard]] std::uint32_t state(std::uint32_t slot) const { return word(slots_ + 4 * slot); }

  // 2^14 times the sine of an angle from 0 to 2^16, a quarter turn.
  [[nodiscard]] static std::uint32_t sine(std::uint32_t angle);

 private:
  struct Place {
    std::int32_t y = 0;  // word of the display
    std::int32_t x = 0;
  };
  struct Range {
    bool from_junction = false;
    bool to_junction = false;
    std::int32_t from = 0;
    std::int32_t to = 0;
  };
  class File;

  [[nodiscard]] std::uint32_t word(std::uint32_t address) const { return words_[address - base_]; }
  void put(std::uint32_t address, std::uint32_t value) { words_[address - base_] = value; }
  void turn(TwinPicture& picture);
  void change(std::uint32_t event, TwinPicture& picture);
  [[nodiscard]] std::uint32_t before(std::uint32_t event) const;
  [[nodiscard]] std::int32_t form(std::uint32_t address) const;
  [[nodiscard]] Place place(std::uint32_t before) const;
  [[nodiscard]] std::int32_t junction(std::uint32_t slot, std::uint32_t code) const;
  [[nodiscard]] Place junction_place(std::uint32_t slot, std::int32_t s) const;
  void set_angle();
  void draw(TwinPicture& picture);
  bool range_of(std::uint32_t slot, Range& range, TwinPicture& picture) const;

  std::uint32_t base_;
  std::vector<std::uint32_t> words_;
  std::uint32_t vertices_, slot_count_, edge_count_, forms_, places_, slots_, first_event_, events_end_, event_;
  std::uint32_t file_words_;
  std::uint32_t angle_ = 0, at_ = 0;
  std::uint32_t last_switches_ = 0;
  bool begun_ = false;
  // For the current angle.
  std::uint32_t first_multiplier_ = 0, second_multiplier_ = 0, first_mask_ = 0, second_mask_ = 0;
  std::int32_t constant_ = 0;
};

}  // namespace sightline::programs::turn
