// The polls with which a program asks a console device for a key and finds none.
#pragma once

namespace sightline::core {

class KeyPollListener {
 public:
  // A poll has found no key. It may end the run at the next boundary.
  virtual void key_polled() = 0;

 protected:
  ~KeyPollListener() = default;
};

// The part of a console device that remembers them.
class KeyPolls {
 public:
  // The program has polled in vain since a key was last typed or read.
  [[nodiscard]] bool any() const { return any_; }
  void add() {
    any_ = true;
    if (listener_ != nullptr) [[unlikely]] listener_->key_polled();
  }
  void forget() { any_ = false; }

  // Null: nobody. The listener must outlive the device's runs.
  void tell(KeyPollListener* listener) { listener_ = listener; }

  // For visit_state().
  [[nodiscard]] bool& state() { return any_; }

 private:
  bool any_ = false;
  KeyPollListener* listener_ = nullptr;
};

}  // namespace sightline::core
