// The files of CP/M 2.2: a drive is a folder of the host, and its files are the files there whose names CP/M can have.
//
// As in CP/M, all state of an open file is in the program's file control block (FCB). The host's file is found by the name
// in it, so a machine restored from a snapshot continues with the files that the folder has then. Records are written to
// the host at once. The files of user 0 are in the folder itself, those of user 1 to 15 in its subfolder of that number.
// Decisions beyond the Interface Guide are in host/manual/i8080.md.
// Source: Digital Research, "CP/M 2.2 Interface Guide" (1979), functions 12 to 40.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/state_visitor.hpp"
#include "host/base/result.hpp"

namespace sightline::machines {

// --cpm-drive X=FOLDER[,ro]
struct CpmDrive {
  unsigned number = 0;  // 0 is A
  std::string folder;
  bool read_only = false;
};
// The error says what the text should be, or that there is no such folder.
[[nodiscard]] base::Result<CpmDrive> parse_cpm_drive(std::string_view text);

class CpmFiles {
 public:
  static constexpr std::size_t record = 128;   // bytes
  static constexpr std::uint32_t most_records = 65536;  // of a file: 8 MB

  // Errors after which CP/M prints "Bdos Err On X: ..." and ends the program.
  struct Fault {
    char drive;            // 'A'
    std::string_view why;  // "Select", "R/O", "File R/O" or "Bad Sector"
  };
  struct Answer {
    std::uint16_t hl = 0;  // A is its low half
    std::optional<Fault> fault = {};
  };

  explicit CpmFiles(const std::vector<CpmDrive>& drives, std::uint8_t user = 0);
  ~CpmFiles();
  CpmFiles(const CpmFiles&) = delete;
  CpmFiles& operator=(const CpmFiles&) = delete;

  [[nodiscard]] bool has_drives() const;
  // Function numbers of the Interface Guide.
  enum Function : std::uint8_t {
    version = 12, reset_disks, select_disk, open_file, close_file, search_first, search_next, delete_file, read_sequential,
    write_sequential, make_file, rename_file, login_vector, current_disk, set_transfer, write_protect = 28, read_only_vector,
    file_attributes, user_code = 32, read_direct, write_direct, file_size, random_record, reset_drives, write_zero_filled = 40
  };
  // Whether the function is implemented here.
  [[nodiscard]] static constexpr bool answers(std::uint8_t function) {
    return (function >= version && function <= set_transfer) || (function >= write_protect && function <= file_attributes) ||
           (function >= user_code && function <= reset_drives) || function == write_zero_filled;
  }
  // Whether the function's result depends on the host or the function changes something there.
  [[nodiscard]] static constexpr bool needs_host(std::uint8_t function) {
    return (function >= open_file && function <= rename_file) || function == file_attributes ||
           (function >= read_direct && function <= file_size) || function == write_zero_filled;
  }
  [[nodiscard]] static constexpr bool needs_drive(std::uint8_t function) { return function == select_disk || needs_host(function); }
  // Whether DE is the address of a file control block.
  [[nodiscard]] static constexpr bool has_block(std::uint8_t function) { return needs_host(function) && function != search_next; }
  // `de` as the program passes it; memory is the machine's 64K.
  [[nodiscard]] Answer call(std::uint8_t function, std::uint16_t de, std::span<std::uint8_t> memory);
  // The value of byte 0004: user and current disk.
  [[nodiscard]] std::uint8_t user_and_disk() const { return static_cast<std::uint8_t>(state_.user << 4U | state_.disk); }
  // After a warm boot: function 13, then the user and the disk of this value of byte 0004, if there is such a disk.
  void restart(std::uint8_t user_and_disk);
  // Reads a program of the current user into memory, from 0100 up to `end`.
  enum class Load : std::uint8_t { done, no_drive, no_file, unreadable, too_large };
  [[nodiscard]] Load load(unsigned drive, std::string_view name, std::size_t end, std::span<std::uint8_t> memory);
  // "B3:HELLO.TXT", the file of a block, with the user if not 0.
  [[nodiscard]] std::string file_of(std::uint16_t fcb, std::span<std::uint8_t> memory) const;

  // What the host's folders and files did not allow, in the order of its first occurrence.
  struct Trouble {
    std::string text;
    std::uint64_t times = 0;
  };
  [[nodiscard]] const std::vector<Trouble>& troubles() const { return troubles_; }

  // Everything that later calls depend on, except the files themselves.
  struct State {
    std::uint8_t disk = 0;
    std::uint8_t user = 0;
    std::uint16_t transfer = 0x0080;  // "DMA address"
    std::uint16_t logged_in = 0;      // bit 0: A
    std::uint16_t read_only = 0;      // by function 28
    // Functions 17 and 18: the search pattern and the last match, after which the next search begins.
    bool searching = false;
    std::array<std::uint8_t, 13> pattern{};  // drive, name, extent
    std::array<std::uint8_t, 11> found{};    // a name without attributes
    std::uint8_t found_user = 0;
    std::uint32_t found_extent = 0;          // plus one; 0: no match yet

    void visit_state(core::StateVisitor& visit) {
      visit("disk", disk, 15);
      visit("user", user, 15);
      visit("transfer", transfer);
      visit("logged_in", logged_in);
      visit("read_only", read_only);
      visit("searching", searching);
      visit.bytes("pattern", std::span<std::uint8_t>(pattern), 0xFF);
      visit.bytes("found", std::span<std::uint8_t>(found), 0x7F);
      visit("found_user", found_user, 15);
      visit("found_extent", found_extent);
    }
  };
  [[nodiscard]] State& state() { return state_; }

 private:
  class Descriptor;
  struct Host;
  struct OpenFile;
  using Name = std::array<std::uint8_t, 11>;  // without attributes

  // A file control block in memory; addresses wrap.
  class Block;
  // A user's area of a drive.
  struct Area {
    unsigned drive;
    std::uint8_t user;
    friend bool operator==(Area, Area) = default;
  };

  Answer search(std::span<std::uint8_t> memory);
  Answer open(Block fcb);
  Answer close(Block fcb);
  Answer make(Block fcb);
  Answer remove(Block fcb);
  Answer rename(Block fcb);
  Answer set_attributes(Block fcb);
  Answer read_next(Block fcb, std::span<std::uint8_t> memory);
  Answer write_next(Block fcb, std::span<std::uint8_t> memory);
  Answer read_random(Block fcb, std::span<std::uint8_t> memory);
  Answer write_random(Block fcb, std::span<std::uint8_t> memory);
  Answer size(Block fcb);

  [[nodiscard]] std::uint8_t first_disk() const;
  [[nodiscard]] std::optional<Fault> select(unsigned drive);
  [[nodiscard]] std::optional<Fault> locked(unsigned drive) const;
  [[nodiscard]] unsigned drive_of(const Block& fcb) const;
  [[nodiscard]] Area area_of(const Block& fcb) const { return {drive_of(fcb), state_.user}; }
  // Adds a trouble; `error`: of the host, 0: none.
  void note(std::string text, int error = 0);
  // Of an operation on a file that the host did not allow.
  void note_file(std::string_view what, Area area, const Name& name, int error);
  // Of names that no file can have, asked for by a program, and of host's files that no name can have.
  void note_name(std::string_view what, const Name& name);
  void note_unseen(unsigned drive);
  Answer read_record(Block& fcb, std::uint32_t number, std::span<std::uint8_t> memory, std::uint8_t behind_the_end);
  Answer write_record(Block& fcb, std::uint32_t number, std::span<const std::uint8_t> memory);

  std::unique_ptr<Host> host_;
  State state_;
  std::vector<Trouble> troubles_;
};

}  // namespace sightline::machines
