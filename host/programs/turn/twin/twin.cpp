#include "host/programs/turn/twin/twin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace sightline::programs::turn {

namespace {

constexpr std::uint32_t word_mask = 0777777;
constexpr std::uint32_t turn_half = 1U << 17U;

std::int32_t as_signed(std::uint32_t word) {
  return static_cast<std::int32_t>(word) - ((word & turn_half) != 0 ? 1 << 18 : 0);
}

// Words of the header after the first (SPECIFICATION.md section 2).
enum Header : std::uint32_t {
  h_vertices = 1, h_slots, h_edges, h_forms, h_places, h_slot_base, h_first_event, h_events_end, h_event, h_angle, h_file_words
};

const std::array<std::uint32_t, 130>& sine_table() {
  static const std::array<std::uint32_t, 130> table = [] {
    std::array<std::uint32_t, 130> t{};
    for (std::size_t i = 0; i < t.size(); ++i) {
      const double angle = static_cast<double>(std::min<std::size_t>(i, 128)) * std::numbers::pi / 256;
      t[i] = std::min(131071U, static_cast<std::uint32_t>(std::lround(131072 * std::sin(angle))));
    }
    return t;
  }();
  return table;
}

}  // namespace

// A display file under construction (section 7).
class Twin::File {
 public:
  explicit File(std::uint32_t room) : room_(room) { words_.push_back(0410117); }

  // Whether there is space for a piece of the greatest length and the stop.
  [[nodiscard]] bool has_room() const { return words_.size() + 13 <= room_; }

  void begin(const Place& at, TwinPicture& picture) {
    ++picture.beginnings;
    words_.back() ^= 0400000U;
    words_.push_back(020000);
    words_.push_back(static_cast<std::uint32_t>(at.y));
    words_.push_back(static_cast<std::uint32_t>(at.x) ^ 0102000U);
    beam_ = at;
  }

  void line(const Place& to, TwinPicture& picture) {
    ++picture.lines;
    const std::int32_t dy = to.y - beam_.y;
    const std::int32_t dx = to.x - beam_.x;
    beam_ = to;
    const std::uint32_t sign = (dy > 0 ? 0200000U : 0300000U) | (dx > 0 ? 0U : 0200U);
    const std::int32_t ax = std::abs(dx);
    const std::int32_t ay = std::abs(dy);
    const bool along_x = ax >= ay;
    std::int32_t major = std::max(ax, ay);
    std::int32_t minor = std::min(ax, ay);
    if (major > 127) {
      ++picture.long_lines;
      const std::int32_t whole = major;
      const std::int32_t share = 127 * minor;
      std::int32_t error = whole / 2 - whole;
      while (major > 127) {
        std::int32_t step = share / whole;
        error += share % whole;
        if (error >= 0) {
          error -= whole;
          ++step;
        }
        push(sign, along_x, 127, step);
        ++picture.long_words;
        major -= 127;
        minor -= step;
      }
    }
    push(sign, along_x, major, minor);
  }

  std::vector<core::Word18> finished() {
    words_.back() ^= 0400000U;
    words_.push_back(03000);
    std::vector<core::Word18> words;
    words.reserve(words_.size());
    for (const std::uint32_t word : words_) words.emplace_back(word);
    return words;
  }

 private:
  void push(std::uint32_t sign, bool along_x, std::int32_t major, std::int32_t minor) {
    const auto dx = static_cast<std::uint32_t>(along_x ? major : minor);
    const auto dy = static_cast<std::uint32_t>(along_x ? minor : major);
    words_.push_back(sign | (dy << 8U) | dx);
  }

  std::uint32_t room_;
  std::vector<std::uint32_t> words_;
  Place beam_;
};

Twin::Twin(std::span<const core::Word18> words, std::uint32_t base) : base_(base) {
  words_.reserve(words.size());
  for (const core::Word18 w : words) words_.push_back(w.value());
  const auto header = [this](Header at) { return words_[at]; };
  const auto count = [&header](Header at) { return static_cast<std::uint32_t>(-as_signed(header(at))); };
  vertices_ = count(h_vertices);
  slot_count_ = count(h_slots);
  edge_count_ = count(h_edges);
  forms_ = header(h_forms) + 1;
  places_ = header(h_places) + 1;
  slots_ = header(h_slot_base);
  first_event_ = header(h_first_event);
  events_end_ = header(h_events_end);
  event_ = header(h_event);
  angle_ = at_ = header(h_angle);
  file_words_ = header(h_file_words);
}

std::uint32_t Twin::sine(std::uint32_t angle) {
  const auto& table = sine_table();
  const std::uint32_t low = table[angle >> 9U];
  const std::uint32_t high = table[(angle >> 9U) + 1];
  const std::uint32_t value = low + (((high - low) * (angle & 0777U)) >> 9U);
  return std::min((value + 4) >> 3U, 16383U);
}

void Twin::set_angle() {
  const std::uint32_t part = angle_ & 0177777U;
  const std::uint32_t s = sine(part);
  const std::uint32_t c = sine((1U << 16U) - part);
  const std::uint32_t quadrant = angle_ >> 16U;
  const bool odd = (quadrant & 1U) != 0;
  first_multiplier_ = odd ? s : c;
  second_multiplier_ = odd ? c : s;
  first_mask_ = quadrant == 1 || quadrant == 2 ? 0377777U : 0U;
  second_mask_ = quadrant >= 2 ? 0377777U : 0U;
  constant_ = 2 - 4 * static_cast<std::int32_t>(c + s);
}

std::int32_t Twin::form(std::uint32_t address) const {
  const std::uint64_t a = (word(address) ^ first_mask_);
  const std::uint64_t b = (word(address + 1) ^ second_mask_);
  return static_cast<std::int32_t>((a * first_multiplier_) >> 14U) +
         static_cast<std::int32_t>((b * second_multiplier_) >> 14U) + constant_;
}

Twin::Place Twin::place(std::uint32_t before) const {
  return {static_cast<std::int32_t>(word(before + 1)), static_cast<std::int32_t>(word(before + 2))};
}

// The position on the slot's edge in 4096ths.
std::int32_t Twin::junction(std::uint32_t slot, std::uint32_t code) const {
  const std::uint32_t forms = word(slot + 3) + 4 * code + 1;
  std::int32_t n = form(forms);
  std::int32_t d = form(forms + 2);
  if (d < 0) {
    n = ~n;
    d = ~d;
  }
  n = std::max(n, 0);
  return n >= d ? 4095 : static_cast<std::int32_t>((std::int64_t{n} << 12) / d);
}

Twin::Place Twin::junction_place(std::uint32_t slot, std::int32_t s) const {
  const Place p = place(word(slot + 1));
  const Place q = place(word(slot + 2));
  const auto part = [s](std::int32_t from, std::int32_t to) {
    const std::int32_t d = std::abs(to - from);
    const std::int32_t moved = (d * (2 * s + 1) + 4096) >> 13;
    return to < from ? from - moved : from + moved;
  };
  return {part(p.y, q.y), part(p.x, q.x)};
}

std::uint32_t Twin::before(std::uint32_t event) const {
  std::uint32_t at = event == first_event_ ? events_end_ : event;
  do --at;
  while ((word(at) & 2U) == 0);
  return at - 1;
}

void Twin::change(std::uint32_t event, TwinPicture& picture) {
  ++picture.events;
  for (std::uint32_t at = event + 1;; ++at) {
    ++picture.changes;
    const std::uint32_t w = word(at);
    const std::uint32_t slot = slots_ + (w & 03774U);
    const std::uint32_t mask = w & 0770000U;
    put(slot, word(slot) ^ ((w & 04000U) != 0 ? mask >> 6U : mask));
    if ((w & 1U) != 0) return;
  }
}

void Twin::turn(TwinPicture& picture) {
  const std::int32_t way = as_signed((angle_ - at_) & word_mask);
  if (way > 0) {
    for (;;) {
      if (event_ == events_end_) event_ = first_event_;
      const std::uint32_t to = (word(event_) - at_ - 1) & word_mask;  // the distance to it, minus 1
      if (to >= ((angle_ - at_) & word_mask)) break;
      at_ = word(event_);
      change(event_, picture);
      do ++event_;
      while ((word(event_) & 1U) == 0);
      ++event_;
    }
  } else if (way < 0) {
    for (;;) {
      const std::uint32_t event = before(event_);
      const std::uint32_t to = (at_ - word(event)) & word_mask;
      if (to >= ((at_ - angle_) & word_mask)) break;
      at_ = (word(event) - 1) & word_mask;
      event_ = event;
      change(event_, picture);
    }
  }
  at_ = angle_;
}

// The visible part of a cut edge, in 4096ths; false if it is empty.
bool Twin::range_of(std::uint32_t slot, Range& range, TwinPicture& picture) const {
  ++picture.cut_edges;
  const std::uint32_t first = word(slot) >> 12U;
  const std::uint32_t second = (word(slot) >> 6U) & 077U;
  range = {first != 1, second != 1, 0, 0};
  if (range.from_junction) range.from = junction(slot, first);
  if (range.to_junction) range.to = junction(slot, second);
  picture.junctions += (range.from_junction ? 1U : 0U) + (range.to_junction ? 1U : 0U);
  return !range.to_junction || range.to > range.from;
}

void Twin::draw(TwinPicture& picture) {
  set_angle();
  for (std::uint32_t v = 0; v < vertices_; ++v) {
    const std::int32_t u = form(forms_ + 2 * v) + 0200100;
    put(places_ + 2 * v + 1, static_cast<std::uint32_t>(u >> 7));
  }
  picture.vertices = vertices_;
  File file(file_words_);
  std::uint32_t last = 0;
  const auto go_on = [&](std::uint32_t vertex) {
    if (vertex != last) file.begin(place(vertex), picture);
  };
  for (std::uint32_t k = 0; k < (picture.wire ? edge_count_ : slot_count_); ++k) {
    const std::uint32_t slot = slots_ + 4 * k;
    const std::uint32_t state = word(slot);
    if (!picture.wire && state == 0) {
      ++picture.slots_empty;
      continue;
    }
    if (!file.has_room()) {
      picture.status = Status::file_full;
      break;
    }
    const std::uint32_t p = word(slot + 1);
    const std::uint32_t q = word(slot + 2);
    if (picture.wire || state == 010100) {
      ++picture.whole_edges;
      go_on(p);
      file.line(place(q), picture);
      last = q;
      continue;
    }
    Range range;
    if (!range_of(slot, range, picture)) continue;
    picture.junctions_drawn += (range.from_junction ? 1U : 0U) + (range.to_junction ? 1U : 0U);
    if (range.from_junction) {
      file.begin(junction_place(slot, range.from), picture);
    } else {
      go_on(p);
    }
    file.line(range.to_junction ? junction_place(slot, range.to) : place(q), picture);
    last = range.to_junction ? 0 : q;
  }
  picture.display_file = file.finished();
}

bool Twin::next(std::uint32_t switches, TwinPicture& picture) {
  picture = TwinPicture{};
  const bool first = !begun_;
  begun_ = true;
  const std::uint32_t before_this = last_switches_;
  last_switches_ = switches;
  if (!first) {
    const bool backward = (switches & backward_switch) != 0;
    if ((switches & single_switch) != 0) {
      if ((before_this & single_switch) != 0) return false;
      turn(picture);
      if (backward) {
        angle_ = (word(before(event_)) - 1) & word_mask;
      } else {
        angle_ = word(event_ == events_end_ ? first_event_ : event_);
      }
    } else {
      const std::uint32_t step = switches & speed_mask;
      if (step == 0 && switches == before_this) return false;
      angle_ = (backward ? angle_ - step : angle_ + step) & word_mask;
    }
  }
  picture.wire = (switches & wire_switch) != 0;
  picture.angle = angle_;
  if (!picture.wire) turn(picture);
  draw(picture);
  return true;
}

}  // namespace sightline::programs::turn
