#include "host/guests/i8080/machine.hpp"

namespace sightline::guests {

machines::I8080StopReason GuestI8080::run(const machines::I8080Limits& limits) { return I8080Machine::run(limits); }

}  // namespace sightline::guests
