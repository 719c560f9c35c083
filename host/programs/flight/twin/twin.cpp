#include "host/programs/flight/twin/twin.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
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
  explicit Run(std::span<const std::uint8_t> stream) : reader_(stream) {}

  TwinFlight run() {
    flight_.status = model();
    while (flight_.status == Status::running) flight_.status = packet();
    return std::move(flight_);
  }

 private:
  Status model() {
    for (const char letter : {'F', 'L'}) {
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
    if (count_ + 2 * planes_.size() > 255) return Status::out_of_range;
    for (std::size_t number = count_ + 2 * planes_.size(); number > 0; --number)
      if (const Status status = point(points_[number]); status != Status::running) return status;
    if (!planes_.empty())
      if (const Status status = cells(); status != Status::running) return status;
    order_.resize(count_);
    std::iota(order_.begin(), order_.end(), std::size_t{1});
    return checked(Status::wrong_sum_of_pieces, Status::running);
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
    for (std::size_t number = 1; number <= count_ + 2 * planes_.size(); ++number) {
      for (std::size_t axis = 0; axis < axes_; ++axis) {
        const std::uint32_t difference = points_[number][axis] - eye[axis];  // its square is right modulo 2^32
        keys[number] += difference * difference;
      }
      keys[number] &= modulus_less_1;
    }
    TwinFrame result;
    for (std::size_t i = 0; i < count_; ++i) {
      const auto before = order_.begin();
      const auto farther = std::count_if(before, before + static_cast<std::ptrdiff_t>(i),
                                         [&](std::size_t other) { return keys[other] > keys[order_[i]]; });
      result.exchanges += static_cast<std::uint32_t>(farther);
      result.moved += farther > 0 ? 1 : 0;
    }
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    if (planes_.empty()) {
      for (std::size_t place = 0; place < count_; ++place)
        result.priorities[order_[place]] = static_cast<std::uint8_t>(count_ - place);
    } else {
      auto left = static_cast<std::uint8_t>(count_);
      give(0x81, keys, left);
      for (const std::size_t number : order_) result.priorities[number] = next_[cell_of_[number]]--;
    }
    flight_.frames.push_back(result);
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

  Reader reader_;
  Precision precision_ = Precision::bits_8;
  std::size_t axes_ = 2;
  std::size_t count_ = 0;
  std::array<Coordinates, 256> points_{};
  std::vector<std::size_t> order_;
  std::vector<std::array<std::uint8_t, 3>> planes_;
  std::array<std::uint8_t, 256> cell_of_{};  // indexed by piece
  std::array<std::uint8_t, 128> sizes_{};    // indexed by cell
  std::array<std::uint8_t, 128> next_{};
  TwinFlight flight_;
};

}  // namespace

TwinFlight run_twin(std::span<const std::uint8_t> stream) { return Run(stream).run(); }

}  // namespace sightline::programs::flight
