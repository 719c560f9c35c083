// See cpm_files.hpp.
#include "host/machines/cpm_files.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace sightline::machines {

namespace {

constexpr unsigned most_drives = 16;
constexpr std::uint32_t records_per_extent = 128;
constexpr std::uint8_t not_found = 0xFF;
constexpr std::uint8_t end_of_text = 0x1A;
constexpr std::uint8_t empty_entry = 0xE5;
// Result codes of reading and writing (Interface Guide, functions 20, 21, 33 and 34).
constexpr std::uint8_t done = 0, behind_end = 1, disk_full = 2, no_extent = 4, behind_disk = 6;

// The characters allowed in a name. CP/M forbids fewer; with these no name leads out of a folder.
bool belongs_in_name(std::uint8_t c) {
  constexpr std::string_view others = "!#$%&'()+-@^_`{}~";
  return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || others.find(static_cast<char>(c)) != std::string_view::npos;
}

std::uint8_t upper(std::uint8_t c) {
  return c >= 'a' && c <= 'z' ? static_cast<std::uint8_t>(c - 'a' + 'A') : c;
}

using Name = std::array<std::uint8_t, 11>;

// "HELLO.TXT"; nullopt for a name that no file can have.
std::optional<std::string> host_name(const Name& name) {
  std::string text;
  for (const auto& [first, last] : {std::pair<std::size_t, std::size_t>{0, 8}, {8, 11}}) {
    std::size_t end = last;
    while (end > first && name[end - 1] == ' ') --end;
    if (first == 0 && end == 0) return std::nullopt;
    if (first == 8 && end > first) text += '.';
    for (std::size_t n = first; n < end; ++n) {
      if (!belongs_in_name(name[n])) return std::nullopt;
      text += static_cast<char>(name[n]);
    }
  }
  return text;
}

// The CP/M name of a host's file; nullopt if it has none.
std::optional<Name> cpm_name(std::string_view host) {
  Name name;
  name.fill(' ');
  std::size_t at = 0;
  bool type = false;
  for (const char each : host) {
    const auto c = upper(static_cast<std::uint8_t>(each));
    if (c == '.' && !type && at != 0) {
      type = true;
      at = 8;
      continue;
    }
    if (at >= (type ? 11U : 8U) || !belongs_in_name(c)) return std::nullopt;
    name[at++] = c;
  }
  if (at == 0 || (type && at == 8)) return std::nullopt;
  return name;
}

std::uint32_t records_of(std::uint64_t bytes) {
  const std::uint64_t records = (bytes + CpmFiles::record - 1) / CpmFiles::record;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(records, CpmFiles::most_records));
}

// The records in one extent, as RC counts them.
std::uint8_t records_in(std::uint32_t records, std::uint32_t extent) {
  const std::uint32_t before = extent * records_per_extent;
  return static_cast<std::uint8_t>(std::min(records - std::min(records, before), records_per_extent));
}

// An empty file has one extent.
bool has_extent(std::uint32_t records, std::uint32_t extent) {
  return extent == 0 || records > extent * records_per_extent;
}

}  // namespace

// --- File control blocks ---

class CpmFiles::Block {
 public:
  Block(std::span<std::uint8_t> memory, std::uint16_t at) : memory_(memory), at_(at) {}
  [[nodiscard]] std::uint8_t& operator[](std::size_t n) const {
    return memory_[static_cast<std::uint16_t>(at_ + n)];
  }
  static constexpr std::size_t extent_at = 12, module_at = 14, count_at = 15, map_at = 16, current_at = 32, random_at = 33;

  // Attributes are the high bits.
  [[nodiscard]] Name name(std::size_t from = 1) const {
    Name name;
    for (std::size_t n = 0; n < name.size(); ++n) name[n] = upper((*this)[from + n] & 0x7FU);
    return name;
  }
  [[nodiscard]] bool ambiguous() const {
    const Name pattern = name();
    return std::find(pattern.begin(), pattern.end(), '?') != pattern.end();
  }
  [[nodiscard]] std::uint32_t extent() const {
    return ((*this)[module_at] & 0x0FU) * 32U + ((*this)[extent_at] & 0x1FU);
  }
  void set_extent(std::uint32_t extent) const {
    (*this)[extent_at] = extent & 0x1FU;
    (*this)[module_at] = static_cast<std::uint8_t>(extent >> 5U);
  }
  [[nodiscard]] std::uint32_t next_record() const { return extent() * records_per_extent + (*this)[current_at]; }
  [[nodiscard]] std::uint32_t random_record() const {
    return static_cast<std::uint32_t>((*this)[random_at] | (*this)[random_at + 1] << 8U | (*this)[random_at + 2] << 16U);
  }
  void set_random_record(std::uint32_t record) const {
    for (std::size_t n = 0; n < 3; ++n) (*this)[random_at + n] = static_cast<std::uint8_t>(record >> (8 * n));
  }
  // Fills the block like a directory entry: the number of records, and a block number for each KB.
  void fill(std::uint32_t extent, std::uint32_t records) const {
    const std::uint8_t count = records_in(records, extent);
    (*this)[count_at] = count;
    for (std::size_t n = 0; n < 16; ++n) (*this)[map_at + n] = n * 8 < count ? static_cast<std::uint8_t>(n + 1) : 0;
  }

 private:
  std::span<std::uint8_t> memory_;
  std::uint16_t at_;
};

// --- The host's side ---

// An open file or folder.
class CpmFiles::Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) static_cast<void>(::close(number_));
  }
  explicit operator bool() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

struct CpmFiles::OpenFile {
  Area area;
  Name name;
  Descriptor file;
  bool writes = false;
  // nullopt: the file no longer exists.
  [[nodiscard]] std::optional<std::uint64_t> length() const {
    struct stat found {};
    if (::fstat(file.number(), &found) != 0 || found.st_nlink == 0) return std::nullopt;
    return static_cast<std::uint64_t>(found.st_size);
  }
};

struct CpmFiles::Host {
  struct Drive {
    Descriptor folder;
    std::string path = {};
    bool read_only = false;
  };
  std::array<Drive, most_drives> drives;
  // The files used last, the latest at the end: reopening a file for each record would take longer than the record.
  static constexpr std::size_t most_open = 8;
  std::vector<OpenFile> open;

  // The folder of an area; none if it does not exist. `make`: it is made. A drive's folder that was removed and made again
  // during the run is opened again.
  [[nodiscard]] Descriptor folder(Area area, bool make = false) {
    constexpr int flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
    Drive& drive = drives[area.drive];
    struct stat found {};
    if (::fstat(drive.folder.number(), &found) != 0) return Descriptor();
    if (found.st_nlink == 0) {
      Descriptor again(::open(drive.path.c_str(), flags));
      if (!again) return again;
      drive.folder = std::move(again);
    }
    if (area.user == 0) return Descriptor(::openat(drive.folder.number(), ".", flags));
    const std::string name = std::to_string(area.user);
    if (make) static_cast<void>(::mkdirat(drive.folder.number(), name.c_str(), 0777));
    return Descriptor(::openat(drive.folder.number(), name.c_str(), flags | O_NOFOLLOW));
  }

  // The status of a file; nullopt if it is no regular file.
  [[nodiscard]] static std::optional<struct stat> status(const Descriptor& folder, const std::string& name) {
    struct stat found {};
    if (!folder || ::fstatat(folder.number(), name.c_str(), &found, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    return found;
  }

  // All files of an area in the order of their CP/M names; of names that differ only in case, the first. `unseen` gets the
  // other regular files, except those whose names begin with a dot.
  [[nodiscard]] static std::vector<std::pair<Name, std::string>> list(const Descriptor& area, std::vector<std::string>* unseen = nullptr) {
    std::vector<std::pair<Name, std::string>> files;
    const int folder = area ? ::openat(area.number(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
    if (folder < 0) return files;
    DIR* const entries = ::fdopendir(folder);
    if (entries == nullptr) {
      static_cast<void>(::close(folder));
      return files;
    }
    while (const dirent* const entry = ::readdir(entries)) {
      const auto name = cpm_name(entry->d_name);
      if ((!name && unseen == nullptr) || !status(area, entry->d_name)) continue;
      if (name) files.emplace_back(*name, entry->d_name);
      else if (entry->d_name[0] != '.') unseen->emplace_back(entry->d_name);
    }
    static_cast<void>(::closedir(entries));
    std::sort(files.begin(), files.end());
    const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
    for (std::size_t n = 1; unseen != nullptr && n < files.size(); ++n) {
      if (same(files[n - 1], files[n])) unseen->push_back(files[n].second);
    }
    files.erase(std::unique(files.begin(), files.end(), same), files.end());
    return files;
  }

  // The host's name of a file.
  [[nodiscard]] static std::optional<std::string> find(const Descriptor& folder, const Name& name) {
    const auto upper_case = host_name(name);
    if (!upper_case) return std::nullopt;
    if (status(folder, *upper_case)) return upper_case;  // the first of all spellings
    for (const auto& [each, host] : list(folder)) {
      if (each == name) return host;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::optional<std::string> find(Area area, const Name& name) { return find(folder(area), name); }

  // Null if the file does not exist or the host denies access; then `error` is 0 or the host's.
  [[nodiscard]] OpenFile* use(Area area, const Name& name, bool writes, int& error) {
    error = 0;
    const auto known = std::find_if(open.begin(), open.end(),
                                    [&](const OpenFile& each) { return each.area == area && each.name == name; });
    if (known != open.end()) {
      if (known->length() && (known->writes || !writes)) {
        std::rotate(known, known + 1, open.end());
        return &open.back();
      }
      open.erase(known);
    }
    const Descriptor place = folder(area);
    const auto host = find(place, name);
    if (!host) return nullptr;
    // Follows no link, and does not wait if a pipe has since taken the name.
    const int flags = (writes ? O_RDWR : O_RDONLY) | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    OpenFile file{area, name, Descriptor(::openat(place.number(), host->c_str(), flags)), writes};
    struct stat found {};
    if (!file.file || ::fstat(file.file.number(), &found) != 0) {
      error = errno;
      return nullptr;
    }
    if (!S_ISREG(found.st_mode)) return nullptr;
    if (open.size() == most_open) open.erase(open.begin());
    open.push_back(std::move(file));
    return &open.back();
  }
  void forget(Area area, const Name& name) {
    std::erase_if(open, [&](const OpenFile& each) { return each.area == area && each.name == name; });
  }
  // The attribute R/O is the host's permission.
  [[nodiscard]] static bool is_read_only(const Descriptor& folder, const std::string& name) {
    const auto found = status(folder, name);
    return found && (found->st_mode & S_IWUSR) == 0;
  }
  [[nodiscard]] static std::uint32_t records(const Descriptor& folder, const std::string& name) {
    const auto found = status(folder, name);
    return found ? records_of(static_cast<std::uint64_t>(found->st_size)) : 0;
  }
};

// --- Drives and arguments ---

base::Result<CpmDrive> parse_cpm_drive(std::string_view text) {
  const auto refuse = [text](std::string expected) {
    return base::Error{.file = "--cpm-drive", .found = fmt::format("found \"{}\"", text), .expected = std::move(expected)};
  };
  CpmDrive drive;
  const std::uint8_t letter = text.empty() ? 0 : upper(static_cast<std::uint8_t>(text.front()));
  if (text.size() < 3 || text[1] != '=' || letter < 'A' || letter > 'P')
    return refuse("X=FOLDER or X=FOLDER,ro with X of A to P");
  drive.number = letter - 'A';
  std::string_view folder = text.substr(2);
  constexpr std::string_view lock = ",ro";
  if (folder.size() > lock.size() && folder.substr(folder.size() - lock.size()) == lock) {
    drive.read_only = true;
    folder.remove_suffix(lock.size());
  }
  drive.folder = folder;
  std::error_code failure;
  if (!std::filesystem::is_directory(drive.folder, failure)) return refuse("a folder behind the =");
  return drive;
}

CpmFiles::CpmFiles(const std::vector<CpmDrive>& drives, std::uint8_t user) : host_(std::make_unique<Host>()) {
  for (const CpmDrive& drive : drives) {
    const int folder = ::open(drive.folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    host_->drives[drive.number] = {Descriptor(folder), drive.folder, drive.read_only};
  }
  restart(static_cast<std::uint8_t>(user << 4U | first_disk()));
}

CpmFiles::~CpmFiles() = default;

bool CpmFiles::has_drives() const {
  return std::any_of(host_->drives.begin(), host_->drives.end(), [](const Host::Drive& each) { return bool(each.folder); });
}

// Drive A, or the first existing one.
std::uint8_t CpmFiles::first_disk() const {
  const auto& drives = host_->drives;
  const auto first = std::find_if(drives.begin(), drives.end(), [](const Host::Drive& each) { return bool(each.folder); });
  return first == drives.end() ? std::uint8_t{0} : static_cast<std::uint8_t>(first - drives.begin());
}

unsigned CpmFiles::drive_of(const Block& fcb) const {
  const unsigned code = fcb[0] & 0x1FU;
  return code == 0 ? state_.disk : (code - 1) % most_drives;
}

std::optional<CpmFiles::Fault> CpmFiles::select(unsigned drive) {
  if (!host_->drives[drive].folder) return Fault{static_cast<char>('A' + drive), "Select"};
  state_.logged_in = static_cast<std::uint16_t>(state_.logged_in | 1U << drive);
  return std::nullopt;
}

std::optional<CpmFiles::Fault> CpmFiles::locked(unsigned drive) const {
  if (!host_->drives[drive].read_only && (state_.read_only >> drive & 1U) == 0) return std::nullopt;
  return Fault{static_cast<char>('A' + drive), "R/O"};
}

void CpmFiles::restart(std::uint8_t user_and_disk) {
  const unsigned wanted = user_and_disk & 0x0FU;
  state_.disk = host_->drives[wanted].folder ? static_cast<std::uint8_t>(wanted) : first_disk();
  state_.user = user_and_disk >> 4U;
  state_.transfer = 0x0080;
  state_.logged_in = state_.read_only = 0;
  static_cast<void>(select(state_.disk));
}

CpmFiles::Load CpmFiles::load(unsigned drive, std::string_view name, std::size_t end, std::span<std::uint8_t> memory) {
  constexpr std::size_t begin = 0x0100;
  if (select(drive)) return Load::no_drive;
  Name file_name;
  file_name.fill(' ');
  std::copy_n(name.begin(), std::min<std::size_t>(name.size(), 8), file_name.begin());
  std::copy_n("COM", 3, file_name.begin() + 8);
  const Area area{drive, state_.user};
  int error = 0;
  OpenFile* const file = host_->use(area, file_name, false, error);
  const auto length = file != nullptr ? file->length() : std::nullopt;
  if (!length) {
    if (error == 0) return Load::no_file;
    note_file("reads", area, file_name, error);
    return Load::unreadable;
  }
  const std::size_t size = std::size_t{records_of(*length)} * record;
  if (*length > memory.size() || begin + size > end) return Load::too_large;
  std::fill_n(memory.begin() + begin, size, end_of_text);
  for (std::size_t read = 0; read < *length;) {
    const auto got = ::pread(file->file.number(), memory.data() + begin + read, *length - read, static_cast<off_t>(read));
    if (got < 0) return Load::unreadable;
    if (got == 0) break;
    read += static_cast<std::size_t>(got);
  }
  return Load::done;
}

// --- Troubles ---

namespace {

// A name as a program has it, in which any byte can be.
std::string shown_name(const Name& name) {
  std::string text;
  const auto add = [&text](std::uint8_t c) { text += c > ' ' && c < 0x7F ? std::string(1, static_cast<char>(c)) : fmt::format("\\{:02X}", c); };
  for (const auto& [first, last] : {std::pair<std::size_t, std::size_t>{0, 8}, {8, 11}}) {
    std::size_t end = last;
    while (end > first && name[end - 1] == ' ') --end;
    if (first == 8 && end > first) text += '.';
    for (std::size_t n = first; n < end; ++n) add(name[n]);
  }
  return text;
}

std::string shown_drive(unsigned drive, std::uint8_t user) {
  return static_cast<char>('A' + drive) + (user == 0 ? std::string() : std::to_string(user)) + ":";
}

}  // namespace

std::string CpmFiles::file_of(std::uint16_t fcb, std::span<std::uint8_t> memory) const {
  const Block block(memory, fcb);
  return shown_drive(drive_of(block), state_.user) + shown_name(block.name());
}

void CpmFiles::note(std::string text, int error) {
  constexpr std::size_t most = 100;
  if (error != 0) text += fmt::format(": {}", std::generic_category().message(error));
  const auto known = std::find_if(troubles_.begin(), troubles_.end(), [&text](const Trouble& each) { return each.text == text; });
  if (known != troubles_.end()) ++known->times;
  else if (troubles_.size() < most) troubles_.push_back({std::move(text), 1});
}

void CpmFiles::note_file(std::string_view what, Area area, const Name& name, int error) {
  const std::string file = shown_drive(area.drive, area.user) + shown_name(name);
  const std::string& folder = host_->drives[area.drive].path;
  if (error != 0) {
    note(fmt::format("{}: a program {} this file, and the host does not allow it", file, what), error);
  } else if (!host_->folder({area.drive, 0})) {
    note(fmt::format("{}: a program {} this file, and the folder {} no longer exists", file, what, folder));
  } else {
    note(fmt::format("{}: a program {} this file, and it is not in the folder {}: it was never opened, or has been removed or renamed since",
                     file, what, folder));
  }
}

void CpmFiles::note_name(std::string_view what, const Name& name) {
  note(fmt::format("a program {} \"{}\", expected a name of 1 to 8 and up to 3 of A-Z 0-9 ! # $ % & ' ( ) + - @ ^ _ ` {{ }} ~: the answer "
                   "is FF",
                   what, shown_name(name)));
}

void CpmFiles::note_unseen(unsigned drive) {
  std::vector<std::string> unseen;
  static_cast<void>(Host::list(host_->folder({drive, state_.user}), &unseen));
  if (unseen.empty()) return;
  std::sort(unseen.begin(), unseen.end());
  const std::string others = unseen.size() == 1 ? "" : fmt::format(" and {} more", unseen.size() - 1);
  note(fmt::format("drive {} programs do not see \"{}\"{} in {}: CP/M has 8 and 3 characters for a name, without blanks and case",
                   shown_drive(drive, state_.user), unseen.front(), others, host_->drives[drive].path));
}

// --- Functions ---

CpmFiles::Answer CpmFiles::call(std::uint8_t function, std::uint16_t de, std::span<std::uint8_t> memory) {
  const Block fcb(memory, de);
  const auto low = static_cast<std::uint8_t>(de);
  switch (function) {
    case version: return {0x0022};
    case reset_disks: restart(static_cast<std::uint8_t>(state_.user << 4U | first_disk())); return {};
    case select_disk: {
      const unsigned drive = low % most_drives;
      if (const auto fault = select(drive)) return {0, fault};
      state_.disk = static_cast<std::uint8_t>(drive);
      return {};
    }
    case search_first:
      for (std::size_t n = 0; n < state_.pattern.size(); ++n) state_.pattern[n] = fcb[n];
      state_.searching = true;
      state_.found_extent = 0;
      return search(memory);
    case search_next: return state_.searching ? search(memory) : Answer{not_found};
    case login_vector: return {state_.logged_in};
    case current_disk: return {state_.disk};
    case set_transfer: state_.transfer = de; return {};
    case write_protect: state_.read_only = static_cast<std::uint16_t>(state_.read_only | 1U << state_.disk); return {};
    case read_only_vector: {
      unsigned vector = state_.read_only;
      for (unsigned n = 0; n < most_drives; ++n) vector |= (host_->drives[n].read_only ? 1U : 0U) << n;
      return {static_cast<std::uint16_t>(vector)};
    }
    case user_code:
      if (low == 0xFF) return {state_.user};
      state_.user = low & 0x0FU;
      return {};
    case random_record: fcb.set_random_record(fcb.next_record()); return {};
    case reset_drives:
      state_.logged_in &= static_cast<std::uint16_t>(~de);
      state_.read_only &= static_cast<std::uint16_t>(~de);
      return {};
    default: break;
  }
  if (const auto fault = select(drive_of(fcb))) return {0, fault};
  switch (function) {
    case open_file: return open(fcb);
    case close_file: return close(fcb);
    case delete_file: return remove(fcb);
    case read_sequential: return read_next(fcb, memory);
    case write_sequential: return write_next(fcb, memory);
    case make_file: return make(fcb);
    case rename_file: return rename(fcb);
    case file_attributes: return set_attributes(fcb);
    case read_direct: return read_random(fcb, memory);
    case write_direct:
    case write_zero_filled: return write_random(fcb, memory);
    case file_size: return size(fcb);
    default: return {not_found};
  }
}

// Writes the next directory entry to the transfer address, in the first quarter of a directory record.
CpmFiles::Answer CpmFiles::search(std::span<std::uint8_t> memory) {
  const bool all = state_.pattern[0] == '?';  // the entries of all users
  const Block pattern(state_.pattern, 0);
  const unsigned drive = all ? state_.disk : drive_of(pattern);
  if (const auto fault = select(drive)) return {0, fault};
  const auto fits = [&](const Name& name) {
    for (std::size_t n = 0; n < name.size() && !all; ++n) {
      const std::uint8_t wanted = upper(state_.pattern[n + 1] & 0x7FU);
      if (wanted != '?' && wanted != name[n]) return false;
    }
    return true;
  };
  const bool every_extent = all || state_.pattern[12] == '?';
  const std::uint32_t wanted_extent = state_.pattern[12] & 0x1FU;
  const bool begins = state_.found_extent == 0;
  const std::uint8_t first_user = all ? (begins ? std::uint8_t{0} : state_.found_user) : state_.user;
  const std::uint8_t last_user = all ? std::uint8_t{15} : state_.user;
  for (std::uint8_t user = first_user; user <= last_user; ++user) {
    const Descriptor folder = host_->folder({drive, user});
    const bool same_user = !begins && user == state_.found_user;
    for (const auto& [name, host] : Host::list(folder)) {
      if (!fits(name)) continue;
      const std::uint32_t records = Host::records(folder, host);
      // The last match is this name or an earlier one.
      const bool behind = !same_user || name > state_.found;
      if (!behind && name != state_.found) continue;
      std::uint32_t extent = every_extent ? 0 : wanted_extent;
      if (!behind) {
        if (!every_extent) continue;
        extent = state_.found_extent;
      }
      if (!has_extent(records, extent)) continue;
      state_.found = name;
      state_.found_user = user;
      state_.found_extent = extent + 1;
      for (std::size_t n = 0; n < record; ++n) memory[static_cast<std::uint16_t>(state_.transfer + n)] = n < 32 ? 0 : empty_entry;
      const Block entry(memory, state_.transfer);
      entry[0] = user;
      for (std::size_t n = 0; n < name.size(); ++n) entry[n + 1] = name[n];
      if (Host::is_read_only(folder, host)) entry[9] |= 0x80U;
      entry.set_extent(extent);
      entry.fill(extent, records);
      return {done};
    }
  }
  state_.searching = false;
  note_unseen(drive);
  return {not_found};
}

CpmFiles::Answer CpmFiles::open(Block fcb) {
  const Area area = area_of(fcb);
  Name name = fcb.name();
  if (fcb.ambiguous()) {
    const auto files = Host::list(host_->folder(area));
    const auto first = std::find_if(files.begin(), files.end(), [&name](const auto& file) {
      return std::equal(name.begin(), name.end(), file.first.begin(), [](auto a, auto b) { return a == '?' || a == b; });
    });
    if (first == files.end()) return {not_found};
    name = first->first;
  }
  int error = 0;
  if (host_->use(area, name, false, error) == nullptr) {
    if (error != 0) note_file("opens", area, name, error);
    else if (!host_->folder({area.drive, 0})) note_file("opens", area, name, 0);
    else note_unseen(area.drive);
    return {not_found};
  }
  const Descriptor folder = host_->folder(area);
  const auto host = Host::find(folder, name);
  if (!host) return {not_found};
  const std::uint32_t records = Host::records(folder, *host);
  fcb[Block::module_at] = 0;
  const std::uint32_t extent = fcb.extent();
  if (!has_extent(records, extent)) return {not_found};
  for (std::size_t n = 0; n < name.size(); ++n) fcb[n + 1] = name[n];
  if (Host::is_read_only(folder, *host)) fcb[9] |= 0x80U;
  fcb.fill(extent, records);
  return {done};
}

// Everything has been written already.
CpmFiles::Answer CpmFiles::close(Block fcb) {
  if (host_->find(area_of(fcb), fcb.name())) return {done};
  note_file("closes", area_of(fcb), fcb.name(), 0);
  return {not_found};
}

CpmFiles::Answer CpmFiles::make(Block fcb) {
  const Area area = area_of(fcb);
  if (const auto fault = locked(area.drive)) return {0, fault};
  const auto name = host_name(fcb.name());
  if (!name || fcb.ambiguous()) {
    note_name("makes a file named", fcb.name());
    return {not_found};
  }
  // Like function 15, CP/M clears the module number: MAC leaves other bytes there.
  fcb[Block::module_at] = 0;
  const bool first = fcb.extent() == 0;
  const Descriptor folder = host_->folder(area, true);
  if (Host::find(folder, fcb.name())) {
    // CP/M would make a second entry with the name, which a folder cannot have. A further extent exists once it is written.
    if (first) return {not_found};
  } else {
    const Descriptor made(::openat(folder.number(), name->c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!made) {
      note_file("makes", area, fcb.name(), folder ? errno : 0);
      return {not_found};
    }
  }
  fcb.fill(fcb.extent(), 0);
  return {done};
}

CpmFiles::Answer CpmFiles::remove(Block fcb) {
  const Area area = area_of(fcb);
  if (const auto fault = locked(area.drive)) return {0, fault};
  const Name pattern = fcb.name();
  bool any = false;
  const Descriptor folder = host_->folder(area);
  for (const auto& [name, host] : Host::list(folder)) {
    if (!std::equal(pattern.begin(), pattern.end(), name.begin(), [](auto a, auto b) { return a == '?' || a == b; })) continue;
    if (Host::is_read_only(folder, host)) return {0, Fault{static_cast<char>('A' + area.drive), "File R/O"}};
    host_->forget(area, name);
    if (::unlinkat(folder.number(), host.c_str(), 0) == 0) any = true;
    else if (errno != ENOENT) note_file("deletes", area, name, errno);
  }
  return {any ? done : not_found};
}

// The new name is in the second half of the block.
CpmFiles::Answer CpmFiles::rename(Block fcb) {
  const Area area = area_of(fcb);
  if (const auto fault = locked(area.drive)) return {0, fault};
  const Name to = fcb.name(17);
  const auto host_to = host_name(to);
  if (!host_to) note_name("renames a file to", to);
  const Descriptor folder = host_->folder(area);
  const auto from = Host::find(folder, fcb.name());
  // CP/M would allow a second file of the same name.
  if (!from || !host_to || Host::find(folder, to)) return {not_found};
  if (Host::is_read_only(folder, *from)) return {0, Fault{static_cast<char>('A' + area.drive), "File R/O"}};
  host_->forget(area, fcb.name());
  if (::renameat(folder.number(), from->c_str(), folder.number(), host_to->c_str()) == 0) return {done};
  note_file("renames", area, fcb.name(), errno);
  return {not_found};
}

// The host supports only the attribute R/O.
CpmFiles::Answer CpmFiles::set_attributes(Block fcb) {
  const Area area = area_of(fcb);
  if (const auto fault = locked(area.drive)) return {0, fault};
  int error = 0;
  OpenFile* const file = host_->use(area, fcb.name(), false, error);
  struct stat found {};
  if (file == nullptr || ::fstat(file->file.number(), &found) != 0) return {not_found};
  const bool lock = (fcb[9] & 0x80U) != 0;
  const mode_t writes = S_IWUSR | S_IWGRP | S_IWOTH;
  const mode_t mode = found.st_mode & 07777U;
  if (::fchmod(file->file.number(), lock ? mode & ~writes : mode | S_IWUSR) != 0) {
    note_file("changes attributes of", area, fcb.name(), errno);
    return {not_found};
  }
  host_->forget(area, fcb.name());
  return {done};
}

CpmFiles::Answer CpmFiles::read_record(Block& fcb, std::uint32_t number, std::span<std::uint8_t> memory,
                                       std::uint8_t behind_the_end) {
  int error = 0;
  OpenFile* const file = host_->use(area_of(fcb), fcb.name(), false, error);
  const auto length = file != nullptr ? file->length() : std::nullopt;
  if (!length) {
    note_file("reads", area_of(fcb), fcb.name(), error);
    // The block of an open file with records has its first block number.
    if (fcb[Block::map_at] != 0) return {0, Fault{static_cast<char>('A' + drive_of(fcb)), "Bad Sector"}};
  }
  if (!length || number >= records_of(*length)) return {behind_the_end};
  // Fills the rest of a text's last record.
  std::array<std::uint8_t, record> bytes;
  bytes.fill(end_of_text);
  std::size_t read = 0;
  while (read < record) {
    const auto got = ::pread(file->file.number(), bytes.data() + read, record - read,
                             static_cast<off_t>(std::uint64_t{number} * record + read));
    if (got < 0) return {0, Fault{static_cast<char>('A' + drive_of(fcb)), "Bad Sector"}};
    if (got == 0) break;
    read += static_cast<std::size_t>(got);
  }
  for (std::size_t n = 0; n < record; ++n) memory[static_cast<std::uint16_t>(state_.transfer + n)] = bytes[n];
  fcb[Block::count_at] = records_in(records_of(*length), number / records_per_extent);
  return {done};
}

CpmFiles::Answer CpmFiles::write_record(Block& fcb, std::uint32_t number, std::span<const std::uint8_t> memory) {
  const Area area = area_of(fcb);
  if (const auto fault = locked(area.drive)) return {0, fault};
  const Descriptor folder = host_->folder(area);
  const auto host = Host::find(folder, fcb.name());
  if (!host) {
    note_file("writes", area, fcb.name(), 0);
    return {not_found};
  }
  if (Host::is_read_only(folder, *host)) return {0, Fault{static_cast<char>('A' + area.drive), "File R/O"}};
  int error = 0;
  OpenFile* const file = host_->use(area, fcb.name(), true, error);
  const auto length = file != nullptr ? file->length() : std::nullopt;
  if (!length) {
    note_file("writes", area, fcb.name(), error);
    return {disk_full};
  }
  std::uint64_t end = *length;
  const auto put = [&](std::span<const std::uint8_t> bytes, std::uint64_t at) {
    for (std::size_t written = 0; written < bytes.size();) {
      const auto count = ::pwrite(file->file.number(), bytes.data() + written, bytes.size() - written,
                                  static_cast<off_t>(at + written));
      if (count <= 0) {
        note_file("writes", area, fcb.name(), count < 0 ? errno : ENOSPC);
        return false;
      }
      written += static_cast<std::size_t>(count);
      end = std::max(end, at + written);
    }
    return true;
  };
  std::array<std::uint8_t, record> bytes;
  // A text that ends in an earlier record is padded there as CP/M does.
  const std::uint64_t place = std::uint64_t{number} * record;
  const std::size_t rest = *length < place ? (record - *length % record) % record : 0;
  bytes.fill(end_of_text);
  bool whole = put(std::span(bytes).first(rest), *length);
  for (std::size_t n = 0; n < record; ++n) bytes[n] = memory[static_cast<std::uint16_t>(state_.transfer + n)];
  whole = whole && put(bytes, place);
  if (!whole) {
    // Removes a partly written record.
    if (end > *length) static_cast<void>(::ftruncate(file->file.number(), static_cast<off_t>(*length)));
    return {disk_full};
  }
  fcb.fill(number / records_per_extent, records_of(std::max(*length, place + record)));
  return {done};
}

// The record after the last one of an extent is the first of the next.
CpmFiles::Answer CpmFiles::read_next(Block fcb, std::span<std::uint8_t> memory) {
  const std::uint32_t number = fcb.next_record();
  if (number >= most_records) return {behind_end};
  const Answer answer = read_record(fcb, number, memory, behind_end);
  if (answer.fault || answer.hl != done) return answer;
  fcb.set_extent(number / records_per_extent);
  fcb[Block::current_at] = static_cast<std::uint8_t>(number % records_per_extent + 1);
  return answer;
}

CpmFiles::Answer CpmFiles::write_next(Block fcb, std::span<std::uint8_t> memory) {
  const std::uint32_t number = fcb.next_record();
  if (number >= most_records) return {disk_full};
  const Answer answer = write_record(fcb, number, memory);
  if (answer.fault || answer.hl != done) return answer;
  fcb.set_extent(number / records_per_extent);
  fcb[Block::current_at] = static_cast<std::uint8_t>(number % records_per_extent + 1);
  return answer;
}

// The block then points to the record itself, not past it: a sequential access reads it again.
CpmFiles::Answer CpmFiles::read_random(Block fcb, std::span<std::uint8_t> memory) {
  const std::uint32_t number = fcb.random_record();
  if (number >= most_records) return {behind_disk};
  fcb.set_extent(number / records_per_extent);
  fcb[Block::current_at] = number % records_per_extent;
  const Descriptor folder = host_->folder(area_of(fcb));
  const auto host = Host::find(folder, fcb.name());
  const bool extent_is_there = host && has_extent(Host::records(folder, *host), fcb.extent());
  return read_record(fcb, number, memory, extent_is_there ? behind_end : no_extent);
}

CpmFiles::Answer CpmFiles::write_random(Block fcb, std::span<std::uint8_t> memory) {
  const std::uint32_t number = fcb.random_record();
  if (number >= most_records) return {behind_disk};
  const Answer answer = write_record(fcb, number, memory);
  if (answer.fault || answer.hl != done) return answer;
  fcb.set_extent(number / records_per_extent);
  fcb[Block::current_at] = number % records_per_extent;
  return answer;
}

CpmFiles::Answer CpmFiles::size(Block fcb) {
  const Descriptor folder = host_->folder(area_of(fcb));
  const auto host = Host::find(folder, fcb.name());
  if (!host) return {not_found};
  fcb.set_random_record(Host::records(folder, *host));
  return {done};
}

}  // namespace sightline::machines
