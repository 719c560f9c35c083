// What an experiment is told, and how it fails. An experiment is a function that runs programs and returns plain structs;
// its chapters (page.hpp) say what the page shows of them. sections.cpp lists both.
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "host/base/result.hpp"
#include "host/report/document.hpp"

namespace sightline::report {

enum class ErrorKind {
  guest_failed,  // a program on an emulated machine did not do its work
  differs,       // results that must be equal are not: a defect of this program
  missing_tool,  // gnuplot
  bad_input,     // a scene, case or data file that comes with the program cannot be used
  file,          // something cannot be read or written
};

struct ReportError {
  ErrorKind kind = ErrorKind::file;
  std::string message;
};

template <class T>
using Outcome = base::Result<T, ReportError>;

// Thrown by experiments, which cannot go on without what failed; make_report returns it as a ReportError.
class Failure : public std::exception {
 public:
  Failure(ErrorKind kind, std::string message) : error_{kind, std::move(message)} {}
  explicit Failure(ReportError error) : error_(std::move(error)) {}
  [[nodiscard]] const ReportError& error() const { return error_; }
  [[nodiscard]] const char* what() const noexcept override { return error_.message.c_str(); }

 private:
  ReportError error_;
};

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
