#include "host/programs/flight/twin/twin.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace sightline::programs::flight {

namespace {

constexpr std::uint8_t most_planes = 126;

using Coordinates = std::array<std::uint32_t, 3>;

// Reads until a status ends the flight early.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> stream) : stream_(stream) {}

  [[nodiscard]] std::optional<std::uint8_t> byte() {
    const auto value = unsummed();
    if (!value) return value;
    sum_ = static_cast<std::uint8_t>(sum_ + *value);
    sum_of_sums_ = static_cast<std::uint8_t>(sum_of_sums_ + sum_);
    return value;
  }
  // Whether the two check bytes are right; nullopt if the stream ends. After a wrong first byte the second is not read.
  [[nodiscard]] std::optional<bool> check() {
    for (const std::uint8_t expected : {sum_, sum_of_sums_}) {
      const auto value = unsummed();
      if (!value) return std::nullopt;
      if (*value != expected) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] std::optional<std::uint8_t> unsummed() {
    if (at_ >= stream_.size()) return std::nullopt;
    return stream_[at_++];
  }

  std::span<const std::uint8_t> stream_;
  std::size_t at_ = 0;
  std::uint8_t sum_ = 0;
  std::uint8_t sum_of_sums_ = 0;
};

class Run {
 public:
  Run(std::span<const std::uint8_t> stream, bool facing) : reader_(stream), facing_(facing) {}

  TwinFlight run() {
    flight_.status = model();
    while (flight_.status == Status::running) flight_.status = packet();
    return std::move(flight_);
  }

 private:
  Status model() {
    for (const char letter : {'F', facing_ ? 'F' : 'L'}) {
      const auto byte = reader_.byte();
      if (!byte) return Status::host_silent;
      if (*byte != static_cast<std::uint8_t>(letter)) return Status::not_a_flight;
    }
    std::array<std::uint8_t, 4> header{};
    constexpr std::array<std::uint8_t, 4> least{1, 2, 1, 0};
    constexpr std::array<std::uint8_t, 4> most{3, 3, 255, most_planes};
    for (std::size_t i = 0; i < header.size(); ++i) {
      const auto byte = reader_.byte();
      if (!byte) return Status::host_silent;
      if (*byte < least[i] || *byte > most[i]) return Status::out_of_range;
      header[i] = *byte;
    }
    precision_ = static_cast<Precision>(header[0]);
    axes_ = header[1];
    count_ = header[2];
    planes_.resize(header[3]);
    points_count_ = count_ + 2 * planes_.size();
    if (points_count_ > 255) return Status::out_of_range;
    if (facing_)
      if (const Status status = count_directions(); status != Status::running) return status;
    for (std::size_t number = points_count_; number > 0; --number)
      if (const Status status = point(points_[number]); status != Status::running) return status;
    if (!planes_.empty())
      if (const Status status = cells(); status != Status::running) return status;
    if (facing_)
      if (const Status status = entries(); status != Status::running) return status;
    for (std::size_t number = 1; number <= count_; ++number)
      if (!facing_ || faces_[number]) order_.push_back(number);
    if (!facing_) last_order_ = order_;
    return checked(Status::wrong_sum_of_pieces, Status::running);
  }

  // The number of directions; their points follow those of the planes.
  Status count_directions() {
    if (points_count_ == 255) return Status::out_of_range;
    const auto byte = reader_.byte();
    if (!byte) return Status::host_silent;
    origin_ = points_count_ + 1;
    points_count_ += 1U + *byte;
    if (*byte == 0 || points_count_ > 255) return Status::out_of_range;
    directions_.resize(*byte);
    return Status::running;
  }

  // Reads the entries of each direction. Initially the eye has passed none.
  Status entries() {
    std::array<bool, 256> has_entry{};
    const int limit_bytes = static_cast<int>(precision_) + 1;
    for (std::vector<Entry>& direction : directions_) {
      const auto entry_count = reader_.byte();
      if (!entry_count) return Status::host_silent;
      for (int i = 0; i < *entry_count; ++i) {
        Entry entry;
        for (int k = 0; k < limit_bytes; ++k) {
          const auto byte = reader_.byte();
          if (!byte) return Status::host_silent;
          entry.limit = entry.limit << 8U | *byte;
        }
        if (!direction.empty() && entry.limit < direction.back().limit) return Status::out_of_range;
        const auto number = reader_.byte();
        if (!number) return Status::host_silent;
        if (*number == 0 || *number > count_ || has_entry[*number]) return Status::out_of_range;
        has_entry[*number] = true;
        entry.number = *number;
        const auto side = reader_.byte();
        if (!side) return Status::host_silent;
        if (*side > 1) return Status::out_of_range;
        faces_[*number] = *side == 0;
        direction.push_back(entry);
      }
    }
    for (std::size_t number = 1; number <= count_; ++number)
      if (!has_entry[number]) return Status::out_of_range;
    return Status::running;
  }

  // Reads the places of each plane, and the cell of each piece.
  Status cells() {
    std::array<bool, 256> placed{};
    for (std::size_t plane = 1; plane <= planes_.size(); ++plane) {
      for (std::uint8_t& place : planes_[plane - 1]) {
        const auto byte = reader_.byte();
        if (!byte) return Status::host_silent;
        place = *byte;
        if (place == 0) continue;
        const std::size_t other = place < 0x80 ? 0 : place - 0x80U;
        if (placed[place] || (place >= 0x80 && (other <= plane || other > planes_.size()))) return Status::out_of_range;
        placed[place] = true;
      }
    }
    for (std::size_t number = count_; number > 0; --number) {
      const auto byte = reader_.byte();
      if (!byte) return Status::host_silent;
      if (*byte == 0 || *byte > 127) return Status::out_of_range;
      cell_of_[number] = *byte;
      ++sizes_[*byte];
    }
    return Status::running;
  }

  Status packet() {
    const auto kind = reader_.byte();
    if (!kind) return Status::host_silent;
    if (*kind == 0) return checked(Status::wrong_sum_of_packet, Status::complete);
    if (*kind != 1) return Status::unknown_packet;
    Coordinates eye{};
    if (const Status status = point(eye); status != Status::running) return status;
    const Status status = checked(Status::wrong_sum_of_packet, Status::running);
    if (status == Status::running) frame(eye);
    return status;
  }

  Status checked(Status wrong, Status right) {
    const auto check = reader_.check();
    if (!check) return Status::host_silent;
    return *check ? right : wrong;
  }

  Status point(Coordinates& to) {
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      const auto low = reader_.byte();
      if (!low) return Status::host_silent;
      to[axis] = *low;
      if (precision_ == Precision::bits_8) continue;
      const auto high = reader_.byte();
      if (!high) return Status::host_silent;
      to[axis] += std::uint32_t{*high} << 8U;
      if (precision_ == Precision::bits_12 && to[axis] >= 0x1000) return Status::out_of_range;
    }
    return Status::running;
  }

  void frame(const Coordinates& eye) {
    const std::uint32_t modulus_less_1 = precision_ == Precision::bits_8    ? 0xFFFFU
                                         : precision_ == Precision::bits_12 ? 0xFF'FFFFU
                                                                            : 0xFFFF'FFFFU;
    std::array<std::uint32_t, 256> keys{};
    for (std::size_t number = 1; number <= points_count_; ++number) {
      for (std::size_t axis = 0; axis < axes_; ++axis) {
        const std::uint32_t difference = points_[number][axis] - eye[axis];  // its square is right modulo 2^32
        keys[number] += difference * difference;
      }
      keys[number] &= modulus_less_1;
    }
    TwinFrame result;
    if (facing_) turn(keys, modulus_less_1);
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    count_changes(result);
    if (planes_.empty()) {
      for (std::size_t place = 0; place < order_.size(); ++place)
        result.priorities[order_[place]] = static_cast<std::uint8_t>(count_ - place);
    } else {
      auto left = static_cast<std::uint8_t>(count_);
      give(0x81, keys, left);
      for (const std::size_t number : order_) result.priorities[number] = next_[cell_of_[number]]--;
    }
    flight_.frames.push_back(result);
  }

  // Turns the pieces whose limits the eye has passed, or passed back, since the last frame. The last one found is the first of the order.
  void turn(const std::array<std::uint32_t, 256>& keys, std::uint32_t modulus_less_1) {
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const std::uint32_t half = modulus_less_1 / 2 + 1;
      const std::uint32_t value = (keys[origin_] - keys[origin_ + 1 + i] + half) & modulus_less_1;
      std::vector<Entry>& direction = directions_[i];
      const auto turn_one = [&](Entry& entry) {
        if (entry.passed == (value > entry.limit)) return;
        entry.passed = !entry.passed;
        faces_[entry.number] = !faces_[entry.number];
        if (faces_[entry.number])
          order_.insert(order_.begin(), entry.number);
        else
          std::erase(order_, entry.number);
      };
      // Limits that are passed are found from the lowest up, those that are passed back from the highest down.
      std::for_each(direction.begin(), direction.end(), [&](Entry& entry) {
        if (!entry.passed) turn_one(entry);
      });
      std::for_each(direction.rbegin(), direction.rend(), turn_one);
    }
  }

  void count_changes(TwinFrame& result) {
    constexpr std::size_t absent = 256;
    std::array<std::size_t, 256> before{};
    before.fill(absent);
    for (std::size_t place = 0; place < last_order_.size(); ++place) before[last_order_[place]] = place;
    std::uint32_t stay = 0;
    for (auto number = order_.begin(); number != order_.end(); ++number) {
      if (before[*number] == absent) {
        ++result.turned.appeared;
        result.turned.passed = stay;
        continue;
      }
      ++stay;
      const auto passed = std::count_if(number, order_.end(), [&](std::size_t other) { return before[other] < before[*number]; });
      result.exchanges += static_cast<std::uint32_t>(passed);
      result.moved += passed > 0 ? 1 : 0;
    }
    result.turned.vanished = static_cast<std::uint32_t>(last_order_.size()) - stay;
    result.listed = static_cast<std::uint32_t>(order_.size());
    last_order_ = order_;
  }

  // Distributes the remaining priorities over a place and everything below it.
  void give(std::uint8_t place, const std::array<std::uint32_t, 256>& keys, std::uint8_t& left) {
    if (place == 0) return;
    if (place < 0x80) {
      next_[place] = left;
      left = static_cast<std::uint8_t>(left - sizes_[place]);
      return;
    }
    const std::size_t plane = place - 0x80U;
    auto places = planes_[plane - 1];
    if (keys[count_ + 2 * plane - 1] > keys[count_ + 2 * plane]) std::reverse(places.begin(), places.end());
    for (const std::uint8_t below : places) give(below, keys, left);
  }

  struct Entry {
    std::uint32_t limit = 0;
    std::size_t number = 0;
    bool passed = false;
  };

  Reader reader_;
  bool facing_ = false;
  Precision precision_ = Precision::bits_8;
  std::size_t axes_ = 2;
  std::size_t count_ = 0;
  std::array<Coordinates, 256> points_{};
  std::size_t points_count_ = 0;
  std::size_t origin_ = 0;
  std::vector<std::vector<Entry>> directions_;
  std::array<bool, 256> faces_{};
  std::vector<std::size_t> order_;
  std::vector<std::size_t> last_order_;  // of the last frame; before the first, without the facing test, that of the numbers
  std::vector<std::array<std::uint8_t, 3>> planes_;
  std::array<std::uint8_t, 256> cell_of_{};  // indexed by piece
  std::array<std::uint8_t, 128> sizes_{};    // indexed by cell
  std::array<std::uint8_t, 128> next_{};
  TwinFlight flight_;
};

}  // namespace

TwinFlight run_twin(std::span<const std::uint8_t> stream, bool facing) { return Run(stream, facing).run(); }

}  // namespace sightline::programs::flight
