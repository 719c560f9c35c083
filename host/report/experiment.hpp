// The options of an experiment. An experiment is a function that runs programs and returns plain structs, or throws a
// base::Error. Its chapters (page.hpp) write them to the page. sections.cpp lists both.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "host/base/result.hpp"
#include "host/report/document.hpp"

namespace sightline::report {

// The options of an experiment.
struct Context {
  bool full = false;       // measure thoroughly; otherwise the whole report takes a minute
  bool host_times = true;  // false: do not measure time on this computer; values of host times are missing
  std::string cache = {};  // folder that stores slow results for the next report; empty: none
  unsigned jobs = 1;       // processors that may be used
  std::function<void(std::string_view)> progress = [](std::string_view) {
  };  // called with the current step, in a few words
  // Schedules work that measures times of this computer: it runs when all experiments have finished, alone.
  std::function<void(std::function<void()>)> when_alone = {};
};

}  // namespace sightline::report
