// What an experiment is told. An experiment is a function that runs programs and returns plain structs, or throws a base::Error;
// its chapters (page.hpp) say what the page shows of them. sections.cpp lists both.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "host/base/result.hpp"
#include "host/report/document.hpp"

namespace sightline::report {

// What an experiment is told.
struct Context {
  bool full = false;       // take the time a thorough measurement needs; else the whole report takes a minute
  bool host_times = true;  // false: do not measure time on this computer; values of host times are missing
  std::string cache = {};  // folder where what takes long to find is kept for the next report; empty: nowhere
  unsigned jobs = 1;       // processors that may be used
  std::function<void(std::string_view)> progress = [](std::string_view) {
  };  // what is being done, in few words
  // Work that takes times of this computer, to be done when all experiments are finished and nothing else runs.
  std::function<void(std::function<void()>)> when_alone = {};
};

}  // namespace sightline::report
