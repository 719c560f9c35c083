// The page's output by a native build of the sources in its module (host/live/web): views.mjs sends this program and the module
// the same
// requests and compares all results.
//
// A line of standard input is {"put": NAME, "text": TEXT}, a file of the page, or a view: {"request": {...}, "until": T}, a
// machine to make
// and the time, in its unit, up to which it runs; a flight runs to its end. Each view is answered by one line: the answer to the
// request,
// then the machine's counts and hashes of what it shows.
#include <cstdint>
#include <cstring>
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include "host/base/json.hpp"
#include "host/live/web/page_state.hpp"
#include "host/live/web/requests.hpp"

namespace {

using sightline::base::Json;
using sightline::live::web::MachineSession;
using sightline::live::web::PageState;

// Two sums of 32 bits, computed as in views.mjs.
class Hash {
 public:
  void add(std::uint32_t word) {
    a_ = (a_ ^ word) * 0x01000193U;
    a_ ^= a_ >> 15U;
    b_ = (b_ + word) * 0x85EBCA6BU;
    b_ ^= b_ >> 13U;
  }
  void add_bytes(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) add(byte);
  }
  void add_words(std::span<const std::uint32_t> words) {
    for (const std::uint32_t word : words) add(word);
  }
  [[nodiscard]] std::uint32_t a() const { return a_; }
  [[nodiscard]] std::uint32_t b() const { return b_; }

 private:
  std::uint32_t a_ = 0x9E3779B9U;
  std::uint32_t b_ = 0x7F4A7C15U;
};

Json sums(const Hash& hash) { return Json::array({hash.a(), hash.b()}); }

Json fly(PageState& page) {
  constexpr std::int64_t frame = 120'000;  // of the display, at 3 MHz
  Hash shown;
  Json states = Json::array();
  Json result = Json::object();
  std::int64_t at = 0;
  bool more = true;
  while (more) {
    more = page.flying.run(at += frame);
    shown.add_words(page.flying.picture());
    states.push_back(page.answer(R"({"do":"flight_state"})"));
  }
  const std::string text = states.dump();
  Hash told;
  told.add_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  result["ticks"] = page.flying.t_states();
  result["frames"] = *states[states.size() - 1].find("frames");
  result["shown"] = sums(shown);
  result["told"] = sums(told);
  return result;
}

Json run(PageState& page, const Json& made, std::int64_t until) {
  MachineSession* const session = sightline::live::web::session_of(page.workbench, made);
  if (session == nullptr) return Json::object();
  const std::int64_t slice = session->machine().ticks_per_second() / 20;
  constexpr std::uint64_t no_limit = std::uint64_t{1} << 50U;
  Hash strokes;
  std::int64_t count = 0;
  bool running = true;
  for (std::int64_t at = 0; running && at < until;) {
    at = std::min(at + slice, until);
    running = session->run(at, no_limit).why == sightline::live::Halted::Why::goal;
    for (const auto& stroke : session->take_flashes()) {
      std::array<std::uint32_t, 4> words{};
      std::memcpy(words.data(), &stroke, sizeof words);
      words[3] &= 0xFFU;  // the rest is padding between strokes
      strokes.add_words(words);
      ++count;
    }
  }
  Json result = Json::object();
  result["ticks"] = session->machine().ticks();
  result["instructions"] = session->machine().instructions();
  result["flashes"] = count;
  result["strokes"] = sums(strokes);
  Hash raster;
  if (const auto* const shown = session->machine().raster()) raster.add_bytes(shown->points());
  result["raster"] = sums(raster);
  const auto snapshot = session->debugger().save();
  Hash state;
  state.add_bytes(snapshot);
  result["state"] = sums(state);
  static_cast<void>(page.workbench.answer(Json{{"do", "drop"}, {"id", *made.find("id")}}));
  return result;
}

}  // namespace

int main() {
  PageState page;
  std::string line;
  while (std::getline(std::cin, line)) {
    const auto asked = sightline::base::parse_json(line, "a view");
    if (!asked) {
      std::cerr << asked.error().message() << '\n';
      return 1;
    }
    if (asked->find("put") != nullptr) {
      const std::string text = sightline::live::web::text_of(*asked, "text");
      page.workbench.put_file(sightline::live::web::text_of(*asked, "put"), {text.begin(), text.end()});
      continue;
    }
    const Json* const request = asked->find("request");
    const Json made = page.answer(request->dump());
    Json result = made.find("error") != nullptr ? Json::object()
                  : sightline::live::web::text_of(*request, "do") == "flight"
                      ? fly(page)
                      : run(page, made, static_cast<std::int64_t>(sightline::live::web::number_of(*asked, "until", 0)));
    result["answer"] = made;
    std::cout << result.dump() << std::endl;
  }
}
