#include "host/programs/jones/encode.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "host/base/result.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/read/octal.hpp"

namespace sightline::programs::jones {
namespace {

using geometry::Box;
using geometry::Point;

constexpr std::uint32_t word_mask = 0777777;
constexpr std::uint32_t flag = 0400000;  // F, L and N alike: bit 0
constexpr std::uint32_t magnitude_mask = 0077777;
constexpr std::int32_t longest_vector = 16383;
constexpr std::size_t record_words = 5;  // of the program's, before each opening of a tape for the walk

std::uint32_t twos_complement(std::int32_t number) {
  return static_cast<std::uint32_t>(number) & word_mask;
}

// Number of vector words for a move of `distance` along one axis.
std::size_t vectors_for(std::int32_t distance) {
  return static_cast<std::size_t>((std::abs(distance) + longest_vector - 1) / longest_vector);
}

class Encoder {
 public:
  Encoder(const scene::CellScene& scene, std::uint32_t base, Tape tape)
      : scene_(scene), openings_of_(scene.cells.size()) {
    result_.base = base;
    result_.tape = tape;
    for (std::size_t o = 0; o < scene.openings.size(); ++o) {
      for (const std::size_t cell : scene.openings[o].cells) openings_of_[cell].push_back(o);
    }
  }

  EncodedScene encode(const Viewpoint& view) {
    result_.view = view;
    header();
    if (result_.tape == Tape::walk) {
      tag_ = "ways";
      openings();
    }
    const std::size_t before_cells = result_.words.size();
    for (std::size_t c = 0; c < scene_.cells.size(); ++c) cell(c);
    result_.cell_words = result_.words.size() - before_cells;
    if (result_.tape == Tape::view) openings();
    result_.opening_words = result_.words.size() - scene_header_words - result_.cell_words;
    resolve();
    return std::move(result_);
  }

 private:
  // A word with flags and the address of another element's word, which is known when all elements are placed.
  struct Reference {
    std::size_t word;
    bool to_opening;
    std::size_t number;
    std::uint32_t offset;  // 0 or 1 words into the element
  };

  void header() {
    tag_ = "scene";
    const bool walk = result_.tape == Tape::walk;
    if (walk)
      append(0, scene::octal(0), "initial cell: found by the program");
    else
      reference(0, false, result_.view.cell, 0, "initial cell");
    number(static_cast<std::int32_t>(scene_.cells.size()), "number of cells");
    for (std::size_t a = 0; a < 3; ++a) number(result_.view.eye[a], "eye " + scene::axis_name(a));
    for (std::size_t word = 5; walk && word < scene_header_words; ++word) append(0, scene::octal(0), "box of the eye: set by the program");
    for (std::size_t a = 0; !walk && a < 3; ++a) {
      number(result_.view.limits.low[a], "eye: lowest " + scene::axis_name(a));
      number(result_.view.limits.high[a], "eye: highest " + scene::axis_name(a));
    }
  }

  void openings() {
    for (std::size_t o = 0; o < scene_.openings.size(); ++o) opening(o);
  }

  void cell(std::size_t c) {
    std::vector<scene::Line> left = scene_.cells[c].lines;
    const Point first = left.empty() ? scene_.cells[c].box.low : left.front().from;
    const std::string name = "cell " + std::to_string(c);
    Point pen = first;
    if (result_.tape == Tape::walk) pen = far_planes(scene_.cells[c].box, first, name);
    result_.cell_addresses.push_back(next_address());
    tag_ = "c" + std::to_string(c);
    place(pen, name);
    const std::size_t count = result_.words.size();
    number(0, "");  // replaced below
    move(pen, first, false);
    while (!left.empty()) draw_nearest(left, pen);
    const std::size_t vectors = result_.words.size() - count - 1;
    set_number(result_.words[count], static_cast<std::int32_t>(vectors), "vectors");
    opening_list(c);
  }

  // Places the three planes of the box that are farther from the point, and returns the corner on the three nearer ones.
  Point far_planes(const Box& box, const Point& point, const std::string& name) {
    Point near = box.low;
    for (std::size_t a = 0; a < 3; ++a) {
      std::int32_t far = box.high[a];
      if (far - point[a] < point[a] - near[a]) std::swap(near[a], far);
      number(far, name + ": far plane " + scene::axis_name(a));
    }
    return near;
  }

  // Moves to and draws the line that takes the fewest dummy vectors; in a tie the first in the scene's order.
  void draw_nearest(std::vector<scene::Line>& left, Point& pen) {
    std::size_t best = 0;
    bool best_reversed = false;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (std::size_t l = 0; l < left.size(); ++l) {
      for (const bool reversed : {false, true}) {
        const Point& start = reversed ? left[l].to : left[l].from;
        std::size_t dummies = 0;
        for (std::size_t a = 0; a < 3; ++a) dummies += vectors_for(start[a] - pen[a]);
        if (dummies < fewest) {
          fewest = dummies;
          best = l;
          best_reversed = reversed;
        }
      }
    }
    const scene::Line line = left[best];
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    move(pen, best_reversed ? line.to : line.from, false);
    move(pen, best_reversed ? line.from : line.to, true);
  }

  void move(Point& pen, const Point& to, bool actual) {
    for (std::size_t a = 0; a < 3; ++a) {
      while (pen[a] != to[a]) {
        const std::int32_t step = std::clamp(to[a] - pen[a], -longest_vector, longest_vector);
        vector({actual, a, step});
        pen[a] += step;
      }
    }
  }

  void opening_list(std::size_t c) {
    const auto& list = openings_of_[c];
    if (list.empty()) {
      append(flag, scene::octal(flag), "no openings");
      return;
    }
    for (const std::size_t o : list) {
      const bool far_is_high = scene_.openings[o].cells[0] == c;
      const std::size_t far = scene_.openings[o].cells[far_is_high ? 1 : 0];
      reference(o == list.back() ? flag : 0, true, o, far_is_high ? 1 : 0, "to cell " + std::to_string(far));
    }
  }

  void opening(std::size_t o) {
    const scene::Opening& element = scene_.openings[o];
    for (std::size_t word = 0; result_.tape == Tape::walk && word < record_words; ++word)
      append(0, scene::octal(0), "opening " + std::to_string(o) + ": record");
    result_.opening_addresses.push_back(next_address());
    tag_ = "o" + std::to_string(o);
    reference(flag, false, element.cells[0], 0, "opening " + std::to_string(o) + ": cell on the low side");
    reference(0, false, element.cells[1], 0, "cell on the high side");
    place(element.ring[0], "opening " + std::to_string(o));
    number(static_cast<std::int32_t>(element.vectors.size()), "vectors");
    for (const scene::RingVector& v : element.vectors) vector(v);
  }

  void place(const Point& origin, const std::string& of) {
    for (std::size_t a = 0; a < 3; ++a) number(origin[a], of + ": origin " + scene::axis_name(a));
  }

  void vector(const scene::RingVector& v) {
    const std::uint32_t word = (v.actual ? flag : 0) | static_cast<std::uint32_t>(v.axis + 1) << 15 |
                               (static_cast<std::uint32_t>(v.magnitude) & magnitude_mask);
    const std::string sign = v.magnitude > 0 ? "+" : "";
    append(word, scene::octal(word),
           std::string(v.actual ? "real " : "dummy ") + "ijk"[v.axis] + " " + sign +
               std::to_string(v.magnitude));
  }

  void number(std::int32_t value, const std::string& what) {
    append(0, "", "");
    set_number(result_.words.back(), value, what);
  }

  static void set_number(EncodedWord& word, std::int32_t value, const std::string& what) {
    word.value = twos_complement(value);
    word.expression = scene::octal(word.value);
    word.comment = what + " " + std::to_string(value);
  }

  void reference(std::uint32_t flags, bool to_opening, std::size_t number, std::uint32_t offset,
                 const std::string& comment) {
    references_.push_back({result_.words.size(), to_opening, number, offset});
    append(flags,
           (flags ? scene::octal(flags) + "+" : "") + (to_opening ? "o" : "c") + std::to_string(number) +
               (offset ? "+1" : ""),
           comment);
  }

  void append(std::uint32_t value, std::string expression, std::string comment) {
    result_.words.push_back({value, std::move(tag_), std::move(expression), std::move(comment)});
    tag_.clear();
  }

  void resolve() {
    for (const Reference& r : references_) {
      const auto& addresses = r.to_opening ? result_.opening_addresses : result_.cell_addresses;
      result_.words[r.word].value |= addresses[r.number] + r.offset;
    }
  }

  [[nodiscard]] std::uint32_t next_address() const {
    return result_.base + static_cast<std::uint32_t>(result_.words.size());
  }

  const scene::CellScene& scene_;
  std::vector<std::vector<std::size_t>> openings_of_;
  std::vector<Reference> references_;
  std::string tag_;  // for the next word
  EncodedScene result_;
};

// Rejects a scene that cannot fit before building any of it: every line is a word, an opening at least ten.
std::optional<base::Error> too_large(const scene::CellScene& scene, std::uint32_t base) {
  std::uint64_t words = scene_header_words + 10 * std::uint64_t{scene.openings.size()};
  for (const scene::Cell& cell : scene.cells) words += 5 + cell.lines.size();
  if (base <= core_words && words <= core_words - base) return std::nullopt;
  return base::Error{"", "",
                     "needs at least " + std::to_string(words) + " words from address " + scene::octal(base) +
                         "; core ends at " + scene::octal(core_words - 1)};
}

// A walk needs a point inside each cell.
std::optional<base::Error> too_thin(const scene::CellScene& scene) {
  for (std::size_t c = 0; c < scene.cells.size(); ++c)
    for (std::size_t a = 0; a < 3; ++a)
      if (scene.cells[c].box.span(a).length() < 2)
        return base::Error{"", "cell " + std::to_string(c), "is 1 unit thick along " + scene::axis_name(a) + "; a walk needs at least 2: multiply all coordinates of the scene by 2"};
  return std::nullopt;
}

Box limits_in(const Box& cell) {
  Box limits;
  for (std::size_t a = 0; a < 3; ++a) {
    limits.low[a] = cell.low[a] + near_z;
    limits.high[a] = cell.high[a] - near_z;
  }
  return limits;
}

constexpr std::size_t expression_column = 8;
constexpr std::size_t comment_column = 28;

std::string line_of(const EncodedWord& word) {
  std::string line = word.tag.empty() ? "" : word.tag + ",";
  line.resize(std::max(expression_column, line.size() + 1), ' ');
  line += word.expression;
  line.resize(std::max(comment_column, line.size() + 1), ' ');
  return line + "/ " + word.comment + "\n";
}

}  // namespace

base::Result<Viewpoint> viewpoint(const scene::CellScene& scene, const Point& eye) {
  const auto cell = scene::locate(scene, eye);
  if (!cell) return cell.error();
  const Box limits = limits_in(scene.cells[*cell].box);
  if (limits.contains(eye)) return Viewpoint{eye, *cell, limits};
  return base::Error{"", "point " + scene::text_of(eye),
                     "is too close to the faces of cell " + std::to_string(*cell) + ": expected " +
                         scene::text_of(0, limits.span(0)) + ", " + scene::text_of(1, limits.span(1)) + ", " +
                         scene::text_of(2, limits.span(2))};
}

base::Result<EncodedScene> encode(const scene::CellScene& scene, std::optional<Point> eye, std::uint32_t base, Tape tape) {
  if (const auto error = too_large(scene, base)) return *error;
  if (tape == Tape::walk)
    if (const auto error = too_thin(scene)) return *error;
  const auto view = viewpoint(scene, eye.value_or(scene.default_view));
  if (!view) return view.error();
  EncodedScene result = Encoder(scene, base, tape).encode(*view);
  if (base + result.words.size() > core_words) {
    return base::Error{"", "",
                       "needs " + std::to_string(result.words.size()) + " words from address " +
                           scene::octal(base) + "; core ends at " + scene::octal(core_words - 1)};
  }
  return result;
}

std::array<std::uint32_t, scene_header_words> header_words(const EncodedScene& scene, const Viewpoint& view) {
  std::array<std::uint32_t, scene_header_words> words{};
  words[1] = static_cast<std::uint32_t>(scene.cell_addresses.size());
  for (std::size_t a = 0; a < 3; ++a) words[2 + a] = twos_complement(view.eye[a]);
  if (scene.tape == Tape::walk) return words;
  words[0] = scene.cell_addresses[view.cell];
  for (std::size_t a = 0; a < 3; ++a) {
    words[5 + 2 * a] = twos_complement(view.limits.low[a]);
    words[6 + 2 * a] = twos_complement(view.limits.high[a]);
  }
  return words;
}

base::Result<std::string> write_tape(const scene::CellScene& scene, std::optional<Point> eye, Tape tape) {
  const auto encoded = encode(scene, eye, 0, tape);
  if (!encoded) return encoded.error();
  const auto& result = *encoded;
  std::string text = "/ scene " + scene.name + ": " + std::to_string(scene.cells.size()) + " cells in " +
                     std::to_string(result.cell_words) + " words, " + std::to_string(scene.openings.size()) +
                     " openings in " + std::to_string(result.opening_words) + ", header " +
                     std::to_string(scene_header_words) + "\n";
  // The program with another setting would take other words for the planes; tapes of one view have no tag `ways`.
  if (tape == Tape::walk) text += "        IFZERO WALK <           / only for a program with the walk\n        assemble-with-WALK\n        >\n";
  for (const EncodedWord& word : result.words) text += line_of(word);
  return text;
}

}  // namespace sightline::programs::jones
