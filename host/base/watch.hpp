// Long work that a caller follows and may end early.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <utility>

#include "host/base/result.hpp"

namespace sightline::base {

// Copies share the wish to end. Without a function nothing is followed, and go_on is one comparison.
class Watch {
 public:
  // Gets the part of the work that is done, from 0 to 1, which never falls. The work ends if it returns false.
  using Tell = std::function<bool(double done)>;

  Watch() = default;
  explicit Watch(Tell tell) : shared_(std::make_shared<Shared>(std::move(tell))) {}

  // A part of the work, which leads from `low` to `high` of the whole.
  [[nodiscard]] Watch part(double low, double high) const {
    Watch result = *this;
    result.low_ = low_ + low * span_;
    result.span_ = (high - low) * span_;
    return result;
  }

  // Tells how much is done; false: end the work. Only on the thread that called for the work; others ask `ended`.
  [[nodiscard]] bool go_on(double done) const {
    if (shared_ == nullptr) return true;
    shared_->done = std::max(shared_->done, low_ + done * span_);
    if (!shared_->ended && !shared_->tell(shared_->done)) shared_->ended = true;
    return !shared_->ended;
  }
  [[nodiscard]] bool ended() const { return shared_ != nullptr && shared_->ended; }

 private:
  struct Shared {
    explicit Shared(Tell function) : tell(std::move(function)) {}

    Tell tell;
    double done = 0;
    std::atomic<bool> ended{false};
  };

  std::shared_ptr<Shared> shared_;
  double low_ = 0;
  double span_ = 1;
};

// What work returns that was ended early.
[[nodiscard]] inline Error cancelled() { return error_of(ErrorKind::cancelled, "cancelled"); }

}  // namespace sightline::base
