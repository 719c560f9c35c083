// The priority display of the Sussex project: a colour raster display for flight simulators that is given
// surfaces with a priority number each, and at each scan point shows the surface with the highest priority of
// those that cover it. Nothing is ever erased or drawn over; hidden surfaces are inhibited as the beam goes.
//
// Documented are the rule, that the display is a raster one in full colour as television receivers are, and
// the 25 frames a second it is meant for. Chosen here: 512 lines of 512 points out of 625 lines of 64 us (a
// frame of 40 ms, not interlaced); two lists of surfaces, one shown and one being written, exchanged at the
// beginning of a frame; registers of 32 bits:
//   0 write CONTROL   bit 0: show the written list from the next frame on; bit 1: empty it now
//     read  STATUS    bit 0: vertical blanking; bit 1: an exchange is waiting; bit 2: the list is full
//   1 PRIORITY        of surfaces begun from now on
//   2 COLOUR          of the same, red 23-16, green 15-8, blue 7-0
//   3 LINE            begins a surface on this line, from the top; read: the line being scanned
//   4 SPAN            what it covers of its next line: first column in 15-0, the one after the last in 31-16
// A surface without a colour is black; a point without a surface has the background's colour, 0. Of surfaces
// with the same priority the one that was begun first is shown. While an exchange is waiting the list cannot be
// written; such writes are lost and counted, and so is what is beyond the list's size or the screen.
// Left out: sound, synchronisation pulses, the host's connection. Sources: Willis 1977 (the rule, and what it
// is for); the display's patent application of 1976 is not at hand.
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
  std::uint64_t points = 0;            // covered by a surface, each as often as it is covered
  std::uint64_t writes_lost = 0;       // while an exchange was waiting
  std::uint64_t writes_no_room = 0;    // beyond the sizes of the list
  std::uint64_t writes_off_screen = 0; // lines and columns that are not there; such a surface or span is left out
  std::uint64_t unanswered = 0;        // registers that are not there, spans without a surface
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

  // At an instant not before any earlier one; the display is scanned up to it first.
  [[nodiscard]] std::uint32_t read(std::uint8_t number, core::Instant at);
  void write(std::uint8_t number, std::uint32_t value, core::Instant at);

  // Scans every line that has begun by then.
  void advance(core::Instant now);

  // What was scanned last of each point, 24 bits of colour, the top line first.
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
  bool open_ = false;  // a surface has been begun that spans belong to
  std::uint32_t priority_ = 0;
  std::uint32_t colour_ = 0;
  core::Instant next_line_{};   // when the scan has something to do
  std::uint32_t next_number_ = 0;
  std::vector<std::uint32_t> by_line_;  // surfaces of the shown list, ascending by their first line
  std::size_t next_surface_ = 0;        // of by_line_, the first not yet reached
  std::vector<std::uint32_t> active_;   // surfaces on the line, in the order of the list
  std::array<std::uint64_t, priority_display::columns> best_{};  // of the line: priority + 1, 0 for none
  std::vector<std::uint32_t> picture_;
  PriorityDisplayCounts counts_;
};

}  // namespace sightline::devices
