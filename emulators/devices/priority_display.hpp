// The priority display of the Sussex project: a colour raster display for flight simulators that receives surfaces, each
// with a priority number, and at each scan point shows the surface with the highest priority among those that cover it.
// Nothing is erased or drawn over; hidden surfaces are suppressed during the scan.
//
// The documents give the rule, that the display is a full-colour raster display like a television receiver, and its frame
// rate of 25 Hz. Chosen here: 512 lines of 512 points out of 625 lines of 64 us (a frame of 40 ms, not interlaced); two
// lists of surfaces, one shown and one being written, exchanged at the beginning of a frame; registers of 32 bits:
//   0 write CONTROL   bit 0: show the written list from the next frame on; bit 1: empty it now
//     read  STATUS    bit 0: vertical blanking; bit 1: an exchange is waiting; bit 2: the list is full
//   1 PRIORITY        of the surfaces begun after it
//   2 COLOUR          of the same, red 23-16, green 15-8, blue 7-0
//   3 LINE            begins a surface on this line, from the top; read: the line being scanned
//   4 SPAN            what it covers of its next line: first column in 15-0, one past the last in 31-16
// The default colour of a surface is black; a point without a surface has the background colour, 0. Of surfaces with the
// same priority the one begun first is shown. While an exchange is waiting the list cannot be written; such writes are lost
// and counted, and so are writes beyond the list's size or the screen.
// Left out: sound, synchronisation pulses, the host's connection. Sources: Willis 1977 (the rule, and the purpose); the
// display's patent application of 1976 is not available.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../core/time.hpp"

namespace sightline::devices {

namespace priority_display {
inline constexpr int columns = 512;
inline constexpr int lines = 512;
inline constexpr core::Duration line{64'000};
inline constexpr core::Duration frame = line * 625;
static_assert(frame.count() * 25 == 1'000'000'000);
}  // namespace priority_display

struct PriorityDisplayCounts {
  std::uint64_t frames = 0;            // begun
  std::uint64_t exchanges = 0;         // of lists
  std::uint64_t surfaces = 0;          // begun in the list
  std::uint64_t spans = 0;             // resolved by the scan
  std::uint64_t points = 0;            // covered by a surface, counted once per surface
  std::uint64_t writes_lost = 0;       // while an exchange was waiting
  std::uint64_t writes_no_room = 0;    // beyond the sizes of the list
  std::uint64_t writes_off_screen = 0; // lines and columns that do not exist; such a surface or span is left out
  std::uint64_t unanswered = 0;        // registers that do not exist, spans without a surface
};

class PriorityDisplay {
 public:
  static constexpr std::size_t usual_surfaces = std::size_t{1} << 16;
  static constexpr std::size_t usual_spans = std::size_t{1} << 21;

  // Sizes of each list.
  explicit PriorityDisplay(std::size_t most_surfaces = usual_surfaces, std::size_t most_spans = usual_spans);

  struct Register {
    static constexpr std::uint8_t control = 0;
    static constexpr std::uint8_t status = 0;
    static constexpr std::uint8_t priority = 1;
    static constexpr std::uint8_t colour = 2;
    static constexpr std::uint8_t line = 3;
    static constexpr std::uint8_t span = 4;
  };
  static constexpr std::uint32_t show = 1;
  static constexpr std::uint32_t empty = 2;
  static constexpr std::uint32_t status_blanking = 1;
  static constexpr std::uint32_t status_waiting = 2;
  static constexpr std::uint32_t status_full = 4;

  // `at` must not be before that of any earlier call; the display is first scanned up to it.
  [[nodiscard]] std::uint32_t read(std::uint8_t number, core::Instant at);
  void write(std::uint8_t number, std::uint32_t value, core::Instant at);

  // Scans every line that has begun by `now`.
  void advance(core::Instant now);

  // The colour last scanned for each point, 24 bits, top line first.
  [[nodiscard]] std::span<const std::uint32_t> picture() const { return picture_; }
  [[nodiscard]] const PriorityDisplayCounts& counts() const { return counts_; }

 private:
  struct Surface {
    std::uint32_t priority = 0;
    std::uint32_t colour = 0;
    std::uint32_t first_line = 0;
    std::uint32_t first_span = 0;
    std::uint32_t line_count = 0;
  };
  struct Span {
    std::uint16_t from = 0;
    std::uint16_t to = 0;
  };
  struct List {
    std::vector<Surface> surfaces;
    std::vector<Span> spans;
    void clear() {
      surfaces.clear();
      spans.clear();
    }
  };

  void control(std::uint32_t value);
  void begin_surface(std::uint32_t line);
  void add_span(std::uint32_t value);
  void begin_frame();
  void scan(std::uint32_t line);
  void resolve(const Surface& surface, const Span& span, std::uint32_t* row);

  std::size_t most_surfaces_;
  std::size_t most_spans_;
  List shown_;
  List written_;
  bool waiting_ = false;
  bool open_ = false;  // a surface has been begun, to which spans belong
  std::uint32_t priority_ = 0;
  std::uint32_t colour_ = 0;
  core::Instant next_line_{};   // when the scan has work to do
  std::uint32_t next_number_ = 0;
  std::vector<std::uint32_t> by_line_;  // surfaces of the shown list, ascending by their first line
  std::size_t next_surface_ = 0;        // of by_line_, the first not yet reached
  std::vector<std::uint32_t> active_;   // surfaces on the line, in the order of the list
  std::array<std::uint64_t, priority_display::columns> best_{};  // of the line: priority + 1, 0 for none
  std::vector<std::uint32_t> picture_;
  PriorityDisplayCounts counts_;
};

}  // namespace sightline::devices
