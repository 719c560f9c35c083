// A file of lines that grows while it is made and is continued after an interruption.
//
// Not written beside and renamed, as other outputs are: what is there counts, line by line. A last line
// without its end, which an interruption may leave, is dropped.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace sightline::app {

class SweepFile {
 public:
  // "-" is standard output. Failure io: it cannot be read or written, or is just being written by another.
  explicit SweepFile(const std::string& path);
  ~SweepFile();
  SweepFile(const SweepFile&) = delete;
  SweepFile& operator=(const SweepFile&) = delete;

  // Passes every whole line, with its line feed, to `keep` until that says no; cuts the file off there if
  // what follows is a line without end, or nothing. Returns how many were kept; -1 - that if a whole line was
  // refused, and the file is as it was.
  [[nodiscard]] std::int64_t keep_lines(const std::function<bool(std::string_view)>& keep);

  // Failure io.
  void append(std::string_view line);

 private:
  std::string path_;
  int file_ = -1;
  bool regular_ = false;
};

}  // namespace sightline::app
