#include "host/programs/stripes/twin/twin.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <optional>

#include "host/programs/stripes/face_stripes.hpp"

namespace sightline::programs::stripes {

namespace {

constexpr int columns = picture_size;

// --- Section 3: one rule for all operations

template <class Rule>
Toggles combine(const Toggles& a, const Toggles& b, Rule rule) {
  Toggles result;
  bool inside = false;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const int next_a = i < a.size() ? a[i] : columns;
    const int next_b = j < b.size() ? b[j] : columns;
    const int at = std::min(next_a, next_b);
    if (next_a == at) ++i;
    if (next_b == at) ++j;
    const bool now = rule((i & 1U) != 0, (j & 1U) != 0);
    if (now != inside) result.push_back(static_cast<std::uint8_t>(at));
    inside = now;
  }
  return result;
}

Toggles subtract(const Toggles& a, const Toggles& b) {
  return combine(a, b, [](bool in_a, bool in_b) { return in_a && !in_b; });
}
Toggles intersect(const Toggles& a, const Toggles& b) {
  return combine(a, b, [](bool in_a, bool in_b) { return in_a && in_b; });
}
Toggles unite(const Toggles& a, const Toggles& b) {
  return combine(a, b, [](bool in_a, bool in_b) { return in_a || in_b; });
}

bool covers(const Toggles& list, int column) {
  const auto after = std::upper_bound(list.begin(), list.end(), column,
                                      [](int value, std::uint8_t toggle) { return value < toggle; });
  return ((after - list.begin()) & 1) != 0;
}

template <class Action>
void for_substripes(const Toggles& list, Action action) {
  for (std::size_t k = 0; k < list.size(); k += 2) action(int{list[k]}, k + 1 < list.size() ? int{list[k + 1]} : columns);
}

// --- The stream

struct Plane {
  std::int32_t a = 0;
  std::int32_t b = 0;
  std::int32_t c = 0;
  std::int64_t d = 0;
};

struct Extent {
  std::uint16_t low = 0xFFFF;
  std::uint16_t high = 0;
  void take(std::uint16_t value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

struct Face {
  std::uint8_t level = 0;
  Plane plane;
  CornerRings rings;
  std::optional<Stripes> sent;
  Extent x;
  Extent y;
  Extent z;
  int low_line = 0;
  int end_line = 0;
};

// Thrown to end the work at any depth.
struct Stop {
  Status status;
  std::size_t fault = 0;
};

class Bytes {
 public:
  Bytes(std::span<const std::uint8_t> bytes, std::size_t face) : bytes_(bytes), face_(face) {}

  std::uint8_t byte() {
    if (at_ >= bytes_.size()) refuse();
    return bytes_[at_++];
  }
  std::uint16_t word() {
    const unsigned low = byte();
    return static_cast<std::uint16_t>(low | unsigned{byte()} << 8U);
  }
  void limit(std::size_t length) {
    if (length < at_ || length > bytes_.size()) refuse();
    bytes_ = bytes_.first(length);
  }
  [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }
  [[noreturn]] void refuse() const { throw Stop{Status::bad_record, face_}; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::size_t face_;
};

std::int32_t signed_word(std::uint16_t word) { return static_cast<std::int16_t>(word); }

void read_polygon(Bytes& bytes, Face& face) {
  face.plane.a = signed_word(bytes.word());
  face.plane.b = signed_word(bytes.word());
  face.plane.c = signed_word(bytes.word());
  if (face.plane.c <= 0) bytes.refuse();
  const std::uint32_t low = bytes.word();
  face.plane.d = static_cast<std::int32_t>(low | std::uint32_t{bytes.word()} << 16U);
  const int rings = bytes.byte();
  if (rings == 0) bytes.refuse();
  for (int r = 0; r < rings; ++r) {
    std::vector<Corner>& ring = face.rings.emplace_back();
    const int count = bytes.byte();
    if (count < 3) bytes.refuse();
    for (int k = 0; k < count; ++k) {
      Corner corner;
      for (std::uint16_t* part : {&corner.x, &corner.y, &corner.z}) {
        *part = bytes.word();
        if (*part > 0xFF00) bytes.refuse();
      }
      face.x.take(corner.x);
      face.y.take(corner.y);
      face.z.take(corner.z);
      ring.push_back(corner);
    }
  }
  face.low_line = Corner{0, face.y.low, 0}.line();
  face.end_line = Corner{0, face.y.high, 0}.line();
}

void read_stripes(Bytes& bytes, Face& face) {
  Stripes& sent = face.sent.emplace();
  sent.low = bytes.byte();
  const int count = bytes.byte();
  if (sent.low + count > columns) bytes.refuse();
  face.low_line = sent.low;
  face.end_line = sent.low + count;
  for (int k = 0; k < count; ++k) {
    Toggles& line = sent.lines.emplace_back();
    for (int toggle = bytes.byte(); toggle != columns; toggle = bytes.byte()) {
      if (line.size() == most_face_toggles || (!line.empty() && toggle <= line.back())) bytes.refuse();
      line.push_back(static_cast<std::uint8_t>(toggle));
    }
  }
}

struct Scene {
  std::uint8_t mode = 0;
  std::vector<Face> faces;
};

// The bits of the mode that a build does not accept.
std::uint8_t refused_modes(Build build) {
  switch (build) {
    case Build::plain: return 0;
    case Build::coverage: return vector_output | faces_are_stripes;
    case Build::overwrite: return vector_output;
  }
  return 0;
}

Scene read_scene(std::span<const std::uint8_t> stream, Build build) {
  const auto byte = [stream](std::size_t at) {
    if (at >= stream.size()) throw Stop{Status::link_silent};
    return stream[at];
  };
  if (byte(0) != first_byte || byte(1) != version) throw Stop{Status::not_a_stream};
  const std::size_t length = byte(2) + std::size_t{byte(3)} * 256;
  if (length > most_body_bytes_of(build)) throw Stop{Status::too_large};
  Scene scene;
  scene.mode = byte(4);
  if (scene.mode > 7 || (scene.mode & refused_modes(build)) != 0) throw Stop{Status::not_a_stream};
  const std::size_t count = byte(5);
  if (count > most_faces) throw Stop{Status::too_large};
  const std::size_t end = header_bytes + length;
  unsigned one = 0;
  unsigned two = 0;
  for (std::size_t at = 0; at < end; ++at) {
    one = (one + byte(at)) & 0xFFU;
    two = (two + one) & 0xFFU;
  }
  if (byte(end) != one || byte(end + 1) != two) throw Stop{Status::checksum};
  std::size_t at = header_bytes;
  for (std::size_t f = 0; f < count; ++f) {
    Bytes bytes(stream.subspan(at, end - at), f);
    const std::size_t size = bytes.word();
    bytes.limit(size);
    Face& face = scene.faces.emplace_back();
    face.level = bytes.byte();
    if (face.level < 1 || face.level > 7) bytes.refuse();
    if ((scene.mode & (faces_are_stripes | find_priority)) != faces_are_stripes) read_polygon(bytes, face);
    if ((scene.mode & faces_are_stripes) != 0) read_stripes(bytes, face);
    if (!bytes.at_end()) bytes.refuse();
    at += size;
  }
  if (at != end) throw Stop{Status::bad_record, count};
  return scene;
}

// --- Sections 5 and 6

enum class Relation : std::uint8_t { none, unconfirmed, confirmed };

class Work {
 public:
  Work(const Scene& scene, TwinPicture& picture) : scene_(scene), picture_(picture) {}

  Stripes stripes(std::size_t f) {
    const Face& face = scene_.faces[f];
    if (face.sent) return *face.sent;
    std::size_t longest = 0;
    Stripes made = stripes_of(face.rings, longest);
    if (longest > most_face_toggles) throw Stop{Status::full, f};
    return made;
  }

  void rank() {
    const std::size_t n = scene_.faces.size();
    hides_.assign(n, std::vector<Relation>(n, Relation::none));
    std::vector<std::size_t> sorted(n);
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::stable_sort(sorted.begin(), sorted.end(),
                     [this](std::size_t a, std::size_t b) { return scene_.faces[a].x.low < scene_.faces[b].x.low; });
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        if (scene_.faces[sorted[i]].x.high <= scene_.faces[sorted[j]].x.low) {
          picture_.counts.decided_by[1] += static_cast<std::uint32_t>(n - j);
          break;
        }
        relate(sorted[i], sorted[j]);
      }
    }
    list();
  }

 private:
  struct Substripe {
    int west = 0;
    int east = 0;
    int line = 0;
    [[nodiscard]] int width() const { return east - west; }
  };

  void decided(std::size_t test) { ++picture_.counts.decided_by[test]; }
  void hide(std::size_t near, std::size_t far, std::size_t test) {
    decided(test);
    ++picture_.counts.relations;
    hides_[near][far] = test == 6 ? Relation::confirmed : Relation::unconfirmed;
  }

  void relate(std::size_t i, std::size_t j) {
    const Face& f = scene_.faces[i];
    const Face& g = scene_.faces[j];
    if (f.low_line >= g.end_line || g.low_line >= f.end_line) return decided(2);
    if (g.z.high < f.z.low) return hide(j, i, 3);
    if (f.z.high < g.z.low) return hide(i, j, 3);
    const auto [f_near, f_far] = sides(f, g.plane);
    if (f_near && f_far) return decided(4);
    const auto [g_near, g_far] = sides(g, f.plane);
    if (g_near && g_far) return decided(4);
    if (f_near || g_far) return hide(i, j, 4);
    if (f_far || g_near) return hide(j, i, 5);
    const Substripe widest = widest_common(i, j);
    if (widest.width() == 0) return decided(6);
    const auto x = 128 * (widest.west + widest.east);
    const auto y = 256 * widest.line + 128;
    const auto depth_f = depth(f, x, y);
    const auto depth_g = depth(g, x, y);
    if (depth_f == depth_g) return decided(6);
    if (depth_f < depth_g) return hide(i, j, 6);
    hide(j, i, 6);
  }

  // near, far
  static std::pair<bool, bool> sides(const Face& face, const Plane& plane) {
    bool near = true;
    bool far = true;
    for (const auto& ring : face.rings) {
      for (const Corner& corner : ring) {
        const std::int64_t sum = std::int64_t{plane.a} * corner.x + std::int64_t{plane.b} * corner.y +
                                 std::int64_t{plane.c} * corner.z - plane.d;
        const std::int32_t whole = static_cast<std::int32_t>(static_cast<std::uint32_t>(sum)) >> 17;
        near = near && whole <= 0;
        far = far && whole >= -1;
      }
    }
    return {near, far};
  }

  static std::int64_t depth(const Face& face, int x, int y) {
    const std::int64_t sum = face.plane.d - std::int64_t{face.plane.a} * x - std::int64_t{face.plane.b} * y;
    const std::int64_t whole = static_cast<std::int32_t>(static_cast<std::uint32_t>(sum));
    if (whole < 0) return face.z.low;
    return std::clamp<std::int64_t>(whole / face.plane.c, face.z.low, face.z.high);
  }

  Substripe widest_common(std::size_t i, std::size_t j) {
    const Stripes a = stripes(i);
    const Stripes b = stripes(j);
    Substripe widest;
    const int end = std::min(a.low + static_cast<int>(a.lines.size()), b.low + static_cast<int>(b.lines.size()));
    for (int line = std::max(a.low, b.low); line < end; ++line) {
      const auto at = [line](const Stripes& s) -> const Toggles& { return s.lines[static_cast<std::size_t>(line - s.low)]; };
      for_substripes(intersect(at(a), at(b)), [&](int west, int east) {
        if (east - west > widest.width()) widest = {west, east, line};
      });
    }
    return widest;
  }

  [[nodiscard]] bool hides(std::size_t near, std::size_t far) const {
    return left_[near] && left_[far] && hides_[near][far] != Relation::none;
  }
  [[nodiscard]] std::size_t occluder_of(std::size_t f) const {
    for (std::size_t g = 0;; ++g)
      if (hides(g, f)) return g;
  }

  void list() {
    const std::size_t n = scene_.faces.size();
    left_.assign(n, true);
    std::vector<std::uint8_t> front;
    std::vector<std::uint8_t> back;  // its classes, in reverse order
    for (std::size_t count = n; count > 0;) {
      std::vector<std::uint8_t> to_front;
      std::vector<std::uint8_t> to_back;
      for (std::size_t f = 0; f < n; ++f) {
        if (!left_[f]) continue;
        bool hides_one = false;
        bool is_hidden = false;
        for (std::size_t g = 0; g < n; ++g) {
          hides_one = hides_one || hides(f, g);
          is_hidden = is_hidden || hides(g, f);
        }
        if (!hides_one)
          to_back.push_back(static_cast<std::uint8_t>(f));
        else if (!is_hidden)
          to_front.push_back(static_cast<std::uint8_t>(f));
      }
      if (to_front.empty() && to_back.empty()) {
        break_cycle();
        continue;
      }
      for (const auto& leaving : {to_front, to_back})
        for (const std::uint8_t f : leaving) left_[f] = false;
      count -= to_front.size() + to_back.size();
      front.insert(front.end(), to_front.begin(), to_front.end());
      back.insert(back.begin(), to_back.begin(), to_back.end());
    }
    picture_.order = front;
    picture_.order.insert(picture_.order.end(), back.begin(), back.end());
  }

  void break_cycle() {
    std::size_t start = static_cast<std::size_t>(std::find(left_.begin(), left_.end(), true) - left_.begin());
    for (int k = 0; k < 64; ++k) start = occluder_of(start);
    bool deleted = false;
    std::size_t f = start;
    do {
      const std::size_t near = occluder_of(f);
      Relation& relation = hides_[near][f];
      if (relation == Relation::unconfirmed) {
        relation = Relation::confirmed;
        if (widest_common(near, f).width() == 0) {
          relation = Relation::none;
          deleted = true;
          ++picture_.counts.deleted;
        }
      }
      f = near;
    } while (f != start);
    if (deleted) return;
    const std::size_t near = occluder_of(start);
    if (picture_.cuts.size() == most_cuts) throw Stop{Status::full, start};
    picture_.cuts.emplace_back(static_cast<std::uint8_t>(start), static_cast<std::uint8_t>(near));
    ++picture_.counts.cuts;
    hides_[near][start] = Relation::none;
  }

  const Scene& scene_;
  TwinPicture& picture_;
  std::vector<std::vector<Relation>> hides_;
  std::vector<bool> left_;
};

// --- Section 4

class Pen {
 public:
  explicit Pen(TwinPicture& picture) : picture_(picture) {}

  void link(int x, int y, int direction) {
    ++picture_.counts.links;
    if (!chain_) {
      chain_ = true;
      travel(x, y);
    }
    if (pending_ && ((*pending_ ^ direction) & 1) != 0) {
      const int sum = *pending_ + direction;
      const bool up_and_left = sum == 3 && (*pending_ == 0 || direction == 0);
      pending_.reset();
      step(up_and_left ? 7 : sum);
      return;
    }
    if (pending_) step(2 * *pending_);
    pending_ = direction;
  }
  void end_chain() {
    if (pending_) step(2 * *pending_);
    pending_.reset();
    chain_ = false;
  }
  void lift() {
    if (down_) command(8);
    down_ = false;
  }

 private:
  static constexpr std::array<std::array<int, 2>, 8> moves{
      {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};

  void command(int code) { picture_.commands.push_back(static_cast<std::uint8_t>(code)); }
  void step(int code) {
    x_ += moves[static_cast<std::size_t>(code)][0];
    y_ += moves[static_cast<std::size_t>(code)][1];
    command(code);
  }
  void travel(int x, int y) {
    if (x == x_ && y == y_ && down_) return;
    if (x != x_ || y != y_) lift();
    while (x != x_ || y != y_) {
      const std::array<int, 2> move{(x > x_) - (x < x_), (y > y_) - (y < y_)};
      step(static_cast<int>(std::find(moves.begin(), moves.end(), move) - moves.begin()));
    }
    command(9);
    down_ = true;
  }

  TwinPicture& picture_;
  int x_ = 0;
  int y_ = 0;
  bool down_ = false;
  bool chain_ = false;
  std::optional<int> pending_;
};

class Drawing {
 public:
  // `overwrite`: section 9.
  Drawing(const Scene& scene, TwinPicture& picture, bool overwrite)
      : scene_(scene), picture_(picture), overwrite_(overwrite), silhouette_(static_cast<std::size_t>(columns)), pen_(picture) {}

  void run(Work& work) {
    std::vector<std::uint8_t> order = picture_.order;
    if (overwrite_) std::reverse(order.begin(), order.end());
    for (const std::uint8_t f : order) draw(work, f);
    pen_.lift();
    if (overwrite_)
      picture_.counts.dots = static_cast<std::uint32_t>(
          std::count_if(picture_.items.begin(), picture_.items.end(), [](std::uint8_t item) { return item != 0; }));
  }

 private:
  [[nodiscard]] bool vector() const { return (scene_.mode & vector_output) != 0; }

  void draw(Work& work, std::uint8_t f) {
    Stripes seen = work.stripes(f);
    for (const auto& [face, by] : picture_.cuts) {
      if (face != f) continue;
      const Stripes other = work.stripes(by);
      for (std::size_t k = 0; k < seen.lines.size(); ++k) {
        const int there = seen.low + static_cast<int>(k) - other.low;
        if (there < 0 || there >= static_cast<int>(other.lines.size())) continue;
        seen.lines[k] = subtract(seen.lines[k], other.lines[static_cast<std::size_t>(there)]);
        if (seen.lines[k].size() > most_face_toggles) throw Stop{Status::full, f};
      }
    }
    const auto most = [](std::uint32_t& value, std::size_t size) { value = std::max(value, static_cast<std::uint32_t>(size)); };
    for (std::size_t k = 0; k < seen.lines.size(); ++k) {
      Toggles& line = seen.lines[k];
      Toggles& shadow = silhouette_[static_cast<std::size_t>(seen.low) + k];
      most(picture_.counts.face_most, line.size());
      if (overwrite_) {
        fill(line, seen.low + static_cast<int>(k), f);
        continue;
      }
      const Toggles face = line;
      line = subtract(face, shadow);
      shadow = unite(shadow, face);
      most(picture_.counts.silhouette_most, shadow.size());
      most(picture_.seen_most, line.size());
      if (shadow.size() > most_silhouette_toggles) throw Stop{Status::full, f};
      if (vector() && line.size() > most_seen_toggles) throw Stop{Status::full, f};
      fill(line, seen.low + static_cast<int>(k), f);
    }
    if (vector()) trace(seen);
  }

  void fill(const Toggles& line, int y, std::uint8_t f) {
    for_substripes(line, [&](int west, int east) {
      for (int x = west; x < east; ++x) {
        ++picture_.counts.dots;
        picture_.items[static_cast<std::size_t>(y * columns + x)] = static_cast<std::uint8_t>(f + 1);
        if (!vector())
          picture_.raster.set(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), scene_.faces[f].level);
      }
    });
  }

  // The square to the right of a link from (x, y) in a direction; the square to the left is that of the direction before.
  static std::array<int, 2> square(int x, int y, int direction) {
    const int d = direction & 3;
    return {d >= 2 ? x - 1 : x, d == 1 || d == 2 ? y - 1 : y};
  }
  static bool in(const Stripes& seen, const std::array<int, 2>& place) {
    const int k = place[1] - seen.low;
    if (k < 0 || k >= static_cast<int>(seen.lines.size()) || place[0] < 0 || place[0] >= columns) return false;
    return covers(seen.lines[static_cast<std::size_t>(k)], place[0]);
  }
  // No link is drawn beside nearer faces or at the border of the picture.
  [[nodiscard]] bool drawn_beside(const std::array<int, 2>& place) const {
    if (place[0] < 0 || place[0] >= columns || place[1] < 0 || place[1] >= columns) return false;
    return !covers(silhouette_[static_cast<std::size_t>(place[1])], place[0]);
  }

  void trace(const Stripes& seen) {
    std::vector<std::vector<bool>> marked;
    for (const Toggles& line : seen.lines) marked.emplace_back(line.size(), false);
    for (std::size_t k = 0; k < seen.lines.size(); ++k)
      for (std::size_t t = 0; t < seen.lines[k].size(); t += 2)
        if (!marked[k][t]) walk(seen, marked, seen.lines[k][t], seen.low + static_cast<int>(k));
  }

  void walk(const Stripes& seen, std::vector<std::vector<bool>>& marked, int begin_x, int begin_y) {
    int x = begin_x;
    int y = begin_y;
    int direction = 0;
    do {
      if (direction == 0) {
        const auto k = static_cast<std::size_t>(y - seen.low);
        const Toggles& line = seen.lines[k];
        marked[k][static_cast<std::size_t>(std::find(line.begin(), line.end(), x) - line.begin())] = true;
      }
      if (drawn_beside(square(x, y, direction + 3)))
        pen_.link(x, y, direction);
      else
        pen_.end_chain();
      x += (direction == 1) - (direction == 3);
      y += (direction == 0) - (direction == 2);
      if (!in(seen, square(x, y, direction)))
        direction = (direction + 1) & 3;
      else if (in(seen, square(x, y, direction + 3)))
        direction = (direction + 3) & 3;
    } while (direction != 0 || x != begin_x || y != begin_y);
    pen_.end_chain();
  }

  const Scene& scene_;
  TwinPicture& picture_;
  bool overwrite_;
  std::vector<Toggles> silhouette_;
  Pen pen_;
};

// --- Section 8

constexpr int all_layers = 15;

// The columns of a line in which layers change, each with the set of these layers.
using Changes = std::map<int, int>;

struct LayeredStripes {
  int low = 0;
  std::vector<Changes> lines;
};

// The layers of each column.
std::array<int, columns> layers_of(const Changes& changes) {
  std::array<int, columns> layers{};
  int now = 0;
  auto change = changes.begin();
  for (int x = 0; x < columns; ++x) {
    if (change != changes.end() && change->first == x) now ^= (change++)->second;
    layers[static_cast<std::size_t>(x)] = now;
  }
  return layers;
}

class CoverageDrawing {
 public:
  CoverageDrawing(const Scene& scene, TwinPicture& picture) : scene_(scene), picture_(picture) {}

  void run() {
    for (const std::uint8_t f : picture_.order) draw(f);
    for (int y = 0; y < columns; ++y)
      for (int x = 0; x < columns; ++x)
        if (const Dot& dot = at(x, y); dot.layers != all_layers && dot.sum >= 2) show(x, y, dot.sum);
  }

 private:
  struct Dot {
    int layers = 0;
    int sum = 0;
    friend bool operator==(const Dot&, const Dot&) = default;
  };

  Dot& at(int x, int y) { return dots_[static_cast<std::size_t>(y * columns + x)]; }
  void show(int x, int y, int sum) {
    picture_.raster.set(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), static_cast<std::uint8_t>((sum + 2) / 4));
    ++picture_.counts.dots;
  }

  [[nodiscard]] LayeredStripes stripes(std::size_t f) const {
    const Face& face = scene_.faces[f];
    LayeredStripes made;
    made.low = face.low_line;
    made.lines.resize(static_cast<std::size_t>(face.end_line - face.low_line));
    for (const auto& ring : face.rings)
      for (std::size_t k = 0; k < ring.size(); ++k) add_edge(made, ring[k], ring[(k + 1) % ring.size()], f);
    return made;
  }

  static void add_edge(LayeredStripes& made, Corner low, Corner high, std::size_t f) {
    if (low.line() == high.line()) return;
    if (low.line() > high.line()) std::swap(low, high);
    const std::int64_t lines = high.line() - low.line();
    const std::int64_t step = std::int64_t{std::abs(high.x - low.x)} * 256 / lines;
    const std::int64_t sign = high.x >= low.x ? 1 : -1;
    const std::int64_t part = step / 8;
    const std::int64_t beta = std::max<std::int64_t>(0x2000, part);
    const std::int64_t alpha = std::max<std::int64_t>({0x6000, 0x4000 + 2 * part, 3 * part});
    for (std::int64_t k = 0; k < lines; ++k) {
      const std::int64_t middle = std::int64_t{low.x} * 256 + sign * (step / 2 + k * step) + 0x7FFF;
      Changes sides;
      int layer = 1;
      for (const std::int64_t distance : {-alpha, -beta, beta, alpha}) {
        sides[static_cast<int>(std::clamp<std::int64_t>(middle + distance, 0, 0xFFFFFF) >> 16)] |= layer;
        layer *= 2;
      }
      Changes& line = made.lines[static_cast<std::size_t>(low.line() + static_cast<int>(k) - made.low)];
      for (const auto& [column, layers] : sides) {
        if (column == columns) continue;
        if ((line[column] ^= layers) == 0) line.erase(column);
        if (line.size() > most_face_changes) throw Stop{Status::full, f};
      }
    }
  }

  void draw(std::uint8_t f) {
    LayeredStripes seen = stripes(f);
    for (const auto& [face, by] : picture_.cuts) {
      if (face != f) continue;
      const LayeredStripes other = stripes(by);
      for (std::size_t k = 0; k < seen.lines.size(); ++k) {
        const int there = seen.low + static_cast<int>(k) - other.low;
        if (there < 0 || there >= static_cast<int>(other.lines.size())) continue;
        cut(seen.lines[k], other.lines[static_cast<std::size_t>(there)], f);
      }
    }
    for (std::size_t k = 0; k < seen.lines.size(); ++k) add_line(layers_of(seen.lines[k]), seen.low + static_cast<int>(k), f);
  }

  static void cut(Changes& line, const Changes& other, std::uint8_t f) {
    const auto mine = layers_of(line);
    const auto others = layers_of(other);
    line.clear();
    int before = 0;
    for (int x = 0; x < columns; ++x) {
      const auto i = static_cast<std::size_t>(x);
      const int left = mine[i] & ~others[i];
      if (left != before) line[x] = left ^ before;
      before = left;
    }
    if (line.size() > most_face_changes) throw Stop{Status::full, f};
  }

  void add_line(const std::array<int, columns>& layers, int y, std::uint8_t f) {
    std::size_t changes = 0;
    Dot before;
    for (int x = 0; x < columns; ++x) {
      Dot& dot = at(x, y);
      for (int layer = 1; layer < all_layers; layer *= 2)
        if ((layers[static_cast<std::size_t>(x)] & ~dot.layers & layer) != 0) dot.sum += scene_.faces[f].level;
      const int covered = dot.layers;
      dot.layers |= layers[static_cast<std::size_t>(x)];
      if (dot.layers == all_layers && covered != all_layers) {
        show(x, y, dot.sum);
        dot.sum = 0;
      }
      if (!(dot == before)) ++changes;
      before = dot;
    }
    picture_.counts.silhouette_most = std::max(picture_.counts.silhouette_most, static_cast<std::uint32_t>(changes));
    if (changes > most_silhouette_changes) throw Stop{Status::full, f};
  }

  const Scene& scene_;
  TwinPicture& picture_;
  std::vector<Dot> dots_ = std::vector<Dot>(static_cast<std::size_t>(columns) * columns);
};

}  // namespace

TwinPicture run_twin(std::span<const std::uint8_t> stream, Build build) {
  TwinPicture picture;
  picture.items.resize(static_cast<std::size_t>(columns) * columns);
  try {
    const Scene scene = read_scene(stream, build);
    Work work(scene, picture);
    if ((scene.mode & find_priority) != 0) {
      work.rank();
    } else {
      picture.order.resize(scene.faces.size());
      std::iota(picture.order.begin(), picture.order.end(), std::uint8_t{0});
    }
    if (build == Build::coverage)
      CoverageDrawing(scene, picture).run();
    else
      Drawing(scene, picture, build == Build::overwrite).run(work);
    picture.status = Status::complete;
  } catch (const Stop& stop) {
    picture.status = stop.status;
    picture.fault = static_cast<std::uint8_t>(stop.fault);
  }
  return picture;
}

}  // namespace sightline::programs::stripes
