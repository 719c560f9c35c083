#include "host/report/write_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "host/report/html_page.hpp"
#include "host/report/table_text.hpp"

namespace sightline::report {

namespace {

namespace files = std::filesystem;

// Creates directories, and removes them again unless they are to be kept.
class MadeDirectories {
 public:
  MadeDirectories() = default;
  MadeDirectories(const MadeDirectories&) = delete;
  MadeDirectories& operator=(const MadeDirectories&) = delete;
  ~MadeDirectories() {
    std::error_code ignored;
    for (auto path = made_.rbegin(); path != made_.rend(); ++path) files::remove(*path, ignored);
  }

  std::optional<base::Error> make(const files::path& path) {
    std::error_code error;
    for (files::path so_far; const files::path& name : path) {
      so_far /= name;
      if (files::is_directory(so_far, error)) continue;
      if (files::create_directory(so_far, error)) {
        made_.push_back(so_far);
      } else if (error) {
        return base::io_error(so_far.string() + ": cannot make a directory: " + error.message());
      }
    }
    if (files::is_directory(path, error)) return std::nullopt;
    return base::io_error(path.string() + ": found a file, expected a directory");
  }

  void keep() { made_.clear(); }

 private:
  std::vector<files::path> made_;
};

bool is_name(const std::string& text, std::string_view between) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [between](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || between.find(c) != std::string_view::npos;
  });
}

// Checks a report by the rules of document.hpp.
class Checker {
 public:
  std::optional<base::Error> check(const Report& report) {
    for (const Section& section : report.sections) {
      id(section.id);
      for (const Block& block : section.blocks) {
        if (const auto* const table = std::get_if<Table>(&block)) check(*table);
        if (const auto* const heading = std::get_if<Heading>(&block); heading != nullptr) id(heading->id);
        if (const auto* const panel = std::get_if<Panel>(&block)) {
          id(panel->id);
          for (const Figure& figure : panel->figures) id(figure.id);
        }
        if (const auto* const figure = std::get_if<Figure>(&block)) id(figure->id);
        if (const auto* const listing = std::get_if<Listing>(&block)) id(listing->id);
        if (const auto* const gallery = std::get_if<Gallery>(&block)) {
          id(gallery->id);
          for (const Figure& figure : gallery->figures) id(figure.id);
        }
      }
    }
    return error_;
  }

 private:
  void check(const Table& table) {
    id(table.id);
    std::set<std::string> keys;
    for (const Column& column : table.columns) {
      if (!is_name(column.key, "_"))
        wrong(fmt::format("{}: column \"{}\": expected a-z, 0-9 and _", table.id, column.key));
      if (!keys.insert(column.key).second) wrong(fmt::format("{}: two columns {}", table.id, column.key));
    }
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      if (table.rows[row].size() == table.columns.size()) continue;
      wrong(fmt::format("{}: row {}: found {} cells, expected {}", table.id, row + 1, table.rows[row].size(),
                        table.columns.size()));
    }
  }

  void id(const std::string& text) {
    if (!is_name(text, "-")) wrong(fmt::format("id \"{}\": expected a-z, 0-9 and -", text));
    if (!ids_.insert(text).second) wrong(fmt::format("id {}: found twice in the report, expected a different id of every section, chapter, table, plot and picture", text));
  }

  void wrong(const std::string& message) {
    if (!error_) error_ = base::bad_input(message);
  }

  std::set<std::string> ids_;
  std::optional<base::Error> error_;
};

// Writes files next to their places, then moves them there in order.
class FileSet {
 public:
  std::optional<base::Error> add(const files::path& path, std::string_view text) {
    auto file = base::AtomicFile::create(path.string());
    if (!file) return file.error();
    file->write(text);
    paths_.push_back(path.string());
    files_.push_back(std::move(*file));
    return std::nullopt;
  }

  base::Result<std::vector<std::string>> commit() {
    for (auto& file : files_)
      if (const auto done = file.commit(); !done) return done.error();
    std::rotate(paths_.begin(), paths_.end() - 1, paths_.end());
    return std::move(paths_);
  }

 private:
  std::vector<std::string> paths_;
  std::vector<base::AtomicFile> files_;
};

std::vector<const Table*> tables_of(const Report& report) {
  std::vector<const Table*> tables;
  for (const Section& section : report.sections)
    for (const Block& block : section.blocks)
      if (const auto* const table = std::get_if<Table>(&block)) tables.push_back(table);
  return tables;
}

constexpr std::string_view page_name = "index.html";
constexpr std::string_view tables_name = "tables";

std::optional<base::Error> make_directories(const std::string& directory, MadeDirectories& made) {
  if (auto error = made.make(directory)) return error;
  return made.make(files::path(directory) / tables_name);
}

}  // namespace

base::Result<base::Done> prepare_directory(const std::string& directory) {
  MadeDirectories made;
  if (const auto error = make_directories(directory, made)) return *error;
  for (const files::path& path :
       {files::path(directory) / page_name, files::path(directory) / tables_name / "try"}) {
    const auto file = base::AtomicFile::create(path.string());
    if (!file) return file.error();
  }
  made.keep();
  return base::Done{};
}

base::Result<std::vector<std::string>> write_report(const Report& report, const std::string& directory) {
  if (const auto error = Checker().check(report)) return *error;
  MadeDirectories made;
  if (const auto error = make_directories(directory, made)) return *error;
  const files::path base(directory);
  FileSet set;
  for (const Table* const table : tables_of(report)) {
    const files::path stem = base / tables_name / table->id;
    if (const auto error = set.add(stem.string() + ".csv", csv_text(*table))) return *error;
    if (const auto error = set.add(stem.string() + ".json", json_text(*table))) return *error;
  }
  if (const auto error = set.add(base / page_name, html_page(report))) return *error;
  auto paths = set.commit();
  if (paths.has_value()) made.keep();
  return paths;
}

}  // namespace sightline::report
