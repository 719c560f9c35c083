#include "host/programs/jones/precision/guest_pieces.hpp"

#include <array>
#include <utility>

#include "emulators/machines/pdp7.hpp"
#include "host/machines/pdp7_watch.hpp"

namespace sightline::programs::jones {
namespace {

constexpr pdp7::Address vector_pointer = 010;  // auto-index register that reads the vectors of a chain
constexpr core::Duration time_limit = core::seconds(600);

// A word that the program keeps writing.
struct Cell {
  pdp7::Address address = 0;
  core::Word18 word;
  [[nodiscard]] std::int32_t number() const { return word.twos_complement(); }
};

class PieceWatch final : public machines::ProgramWatch {
 public:
  explicit PieceWatch(const Program& program)
      : labels_(program.labels), piece_(program.symbols.at("piece") + 1) {
    constexpr std::array names{"lax", "lay", "lbx", "lby", "pax", "pay", "pbx", "pby"};
    for (std::size_t i = 0; i < names.size(); ++i) cells_[i].address = program.symbols.at(names[i]);
    cells_[pointer].address = vector_pointer;
    for (const Cell& cell : cells_) mark(cell.address, pdp7::mark::written);
    mark(labels_.file, pdp7::mark::written);
    for (const pdp7::Address label : {labels_.search, labels_.piece, piece_}) mark(label, pdp7::mark::fetched);
  }

  void cycle(const pdp7::Cycle& cycle) override {
    if (cycle.verb == pdp7::Verb::fetch) return fetched_at(cycle.address, cycle.time);
    if (cycle.verb != pdp7::Verb::write && cycle.verb != pdp7::Verb::modify) return;
    for (Cell& cell : cells_) {
      if (cell.address == cycle.address) cell.word = cycle.data;
    }
    // The ends on the screen are written in this order, after the piece was taken down.
    if (cycle.address == cells_[last_point].address && !pieces_.clipped.empty() && searching_) {
      pieces_.on_display.push_back({{at(4), at(5)}, {at(6), at(7)}});
    }
    if (searching_ && cycle.address == labels_.file) {
      pieces_.time = cycle.time + cycle.length - begun_;
      request_stop();
    }
  }
  [[nodiscard]] GuestPieces result() && { return std::move(pieces_); }

 private:
  static constexpr std::size_t last_point = 7, pointer = 8;

  [[nodiscard]] std::int32_t at(std::size_t cell) const { return cells_[cell].number(); }
  void fetched_at(pdp7::Address pc, core::Instant time) {
    if (pc == labels_.search) {
      begun_ = time;
      searching_ = true;
    }
    if (pc == labels_.piece && searching_) pieces_.clipped.back().drawn = true;
    if (pc != piece_ || !searching_) return;
    Piece piece;
    piece.vector_address = static_cast<std::uint16_t>(cells_[pointer].word.value() & pdp7::in_bank_mask);
    piece.line = {{at(0), at(1)}, {at(2), at(3)}};
    piece.drawn = false;  // until room was made for it in the file
    pieces_.clipped.push_back(piece);
  }

  Labels labels_;
  pdp7::Address piece_;
  std::array<Cell, 9> cells_;
  bool searching_ = false;
  core::Instant begun_{};
  GuestPieces pieces_;
};

}  // namespace

GuestPieces run_for_pieces(const Program& program, bool eae, std::int32_t scale) {
  PieceWatch watch(program);
  pdp7::Options options;
  options.model.eae = eae;
  pdp7::Machine machine(options);
  machine.load(0, program.core);
  machine.deposit(program.labels.scale, core::Word18(static_cast<std::uint32_t>(scale)));
  machine.deposit(program.labels.clock, core::Word18(clock_off));
  machine.start(program.labels.start);
  pdp7::Limits limits;
  limits.until = core::Instant(time_limit);
  const bool complete = machine.run(limits, watch) == pdp7::StopReason::observer;
  GuestPieces pieces = std::move(watch).result();
  if (complete) pieces.status = static_cast<Status>(machine.peek(program.labels.status).value());
  return pieces;
}

}  // namespace sightline::programs::jones
