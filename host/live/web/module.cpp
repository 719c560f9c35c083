// The C interface of the WebAssembly module: an input buffer, an output buffer, and numbers.
//
// The page writes a text or file to the buffer of `buffer`, where request and file_put read it. Answers are at answer_data.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "host/live/web/page_state.hpp"

#define SIGHTLINE_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace {

using sightline::live::web::MachineSession;
using sightline::live::web::reason_text;
using sightline::live::web::PageState;

struct Page {
  PageState state;
  std::string buffer;
  std::string answer;
};
Page& page() {
  static Page the_page;
  return the_page;
}

using sightline::core::Stroke;
static_assert(sizeof(Stroke) == 16 && offsetof(Stroke, x) == 8 && offsetof(Stroke, y) == 10 && offsetof(Stroke, intensity) == 12);
const Stroke* taken_flashes = nullptr;

int set_answer(std::string answer) {
  page().answer = std::move(answer);
  return static_cast<int>(page().answer.size());
}

}  // namespace

// A buffer for `bytes` bytes, valid until the next call.
SIGHTLINE_EXPORT(buffer) char* buffer(int bytes) {
  page().buffer.resize(static_cast<std::size_t>(bytes));
  return page().buffer.data();
}
SIGHTLINE_EXPORT(answer_data) const char* answer_data() { return page().answer.data(); }

// Executes a request, JSON of `bytes` bytes; returns the length of its answer, also JSON.
SIGHTLINE_EXPORT(request) int request(int bytes) {
  const std::string_view text = std::string_view(page().buffer).substr(0, static_cast<std::size_t>(bytes));
  return set_answer(page().state.answer(text).dump());
}
// The number of bytes that the last request has made; 0: none.
SIGHTLINE_EXPORT(made) int made() {
  const auto& bytes = page().state.workbench.made();
  return set_answer(std::string(bytes.begin(), bytes.end()));
}
// Stores a file: the first `name` bytes of the buffer are its name, the rest is its content.
SIGHTLINE_EXPORT(file_put) void file_put(int name, int bytes) {
  const std::string& buffer = page().buffer;
  const auto begin = buffer.begin() + name;
  page().state.workbench.put_file(buffer.substr(0, static_cast<std::size_t>(name)), {begin, buffer.begin() + bytes});
}

// --- A machine by its number. An unknown number gives 0.

// Runs to a time in the machine's unit, for at most so many instructions. 0: reached, 1: a breakpoint, 2: the machine has
// stopped. The answer is the reason.
SIGHTLINE_EXPORT(run) int run(int id, double until, double instructions) {
  MachineSession* const session = page().state.workbench.session(id);
  if (session == nullptr) return 2;
  const auto halted = session->run(static_cast<std::int64_t>(until), static_cast<std::uint64_t>(instructions));
  set_answer(reason_text(halted));
  return static_cast<int>(halted.why);
}
SIGHTLINE_EXPORT(answer_size) int answer_size() { return static_cast<int>(page().answer.size()); }
SIGHTLINE_EXPORT(ticks) double ticks(int id) {
  MachineSession* const session = page().state.workbench.session(id);
  return session != nullptr ? static_cast<double>(session->machine().ticks()) : 0;
}
SIGHTLINE_EXPORT(instructions) double instructions(int id) {
  MachineSession* const session = page().state.workbench.session(id);
  return session != nullptr ? static_cast<double>(session->machine().instructions()) : 0;
}
SIGHTLINE_EXPORT(get) std::uint32_t get(int id, int number) {
  MachineSession* const session = page().state.workbench.session(id);
  return session != nullptr ? session->machine().get(static_cast<std::size_t>(number)) : 0;
}
SIGHTLINE_EXPORT(set) void set(int id, int number, std::uint32_t value) {
  if (MachineSession* const session = page().state.workbench.session(id)) session->debugger().set(static_cast<std::size_t>(number), value);
}
SIGHTLINE_EXPORT(word) std::uint32_t word(int id, std::uint32_t at) {
  MachineSession* const session = page().state.workbench.session(id);
  return session != nullptr && at < session->machine().words() ? session->machine().word(at) : 0;
}
// Types a key on the teletype of a machine.
SIGHTLINE_EXPORT(type) void type(int id, int key) {
  if (MachineSession* const session = page().state.workbench.session(id)) session->type(static_cast<char>(key));
}
// The length of the text printed since the last call; the text is the answer.
SIGHTLINE_EXPORT(printed) int printed(int id) {
  MachineSession* const session = page().state.workbench.session(id);
  return session != nullptr ? set_answer(session->take_printed()) : 0;
}
// The number of flashes since the last call. They are at flashes_data, 16 bytes each: nanoseconds (64 bits), x and y (16 bits),
// intensity (8 bits).
SIGHTLINE_EXPORT(flashes) int flashes(int id) {
  MachineSession* const session = page().state.workbench.session(id);
  if (session == nullptr) return 0;
  const auto taken = session->take_flashes();
  taken_flashes = taken.data();
  return static_cast<int>(taken.size());
}
SIGHTLINE_EXPORT(flashes_data) const void* flashes_data() { return taken_flashes; }
// 256 by 256 bytes, the bottom row first; null without a raster board.
SIGHTLINE_EXPORT(raster) const void* raster(int id) {
  MachineSession* const session = page().state.workbench.session(id);
  const auto* const shown = session != nullptr ? session->machine().raster() : nullptr;
  return shown != nullptr ? shown->points().data() : nullptr;
}

// --- The flight

// Runs to a T-state; 1 if the flight continues.
SIGHTLINE_EXPORT(fly) int fly(double until) { return page().state.flying.run(static_cast<std::int64_t>(until)) ? 1 : 0; }
SIGHTLINE_EXPORT(flown) double flown() { return static_cast<double>(page().state.flying.t_states()); }
// 512 by 512 face numbers of 32 bits, the top line first; null without a flight.
SIGHTLINE_EXPORT(flight_picture) const void* flight_picture() { return page().state.flying.picture().data(); }
