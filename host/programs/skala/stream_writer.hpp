// Writes chains as the bytes of the Skala program (firmware/i8080/skala/SPECIFICATION.md, section 1), in the shortest
// encoding: no MOVE to the pen's position, no COLOUR that is already set, dots in consecutive columns as CURVE.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/programs/skala/commands.hpp"
#include "host/programs/skala/stream_chain.hpp"
#include "host/algorithms/skala/view.hpp"

namespace sightline::programs::skala {

struct ColouredChain {
  int colour = 0;
  RasterChain chain;
};

class StreamWriter {
 public:
  // DEVICE, RESET; then SILHOUETTE with that colour, 0 for none; then COLOUR.
  StreamWriter(const View& view, const Output& output, int colour, std::optional<int> silhouette = {});

  void colour(int colour);
  // On a plotter, if the output is serpentine, from the end nearer to the pen. An empty chain writes nothing.
  void chain(const RasterChain& chain);
  void chain_and_commit(const RasterChain& chain);
  // Chains of test-only lines, which do not hide each other. On a raster they keep their order, and the last one colours a
  // dot; on a plotter, if the output is serpentine, the one nearest to the pen is always next.
  void test_chains(std::vector<ColouredChain> chains);
  // The slice just sent is undefined in these columns; clipped to the raster, no effect if none are left.
  void gap(int first_column, int last_column);
  void outline();
  // Writes END. The writer is empty afterwards.
  [[nodiscard]] std::vector<std::uint8_t> finish();

 private:
  using Nodes = std::vector<ChainNode>;

  void command(Command command) { bytes_.push_back(static_cast<std::uint8_t>(command)); }
  void byte(int value) { bytes_.push_back(static_cast<std::uint8_t>(value)); }
  void to(Command command, const ChainNode& node);
  void pen_at(const ChainNode& node, bool inked);
  void move(const ChainNode& node);
  void pieces(const Nodes& nodes);
  void piece(const Nodes& nodes, std::size_t begin, std::size_t end);
  void curve(const Nodes& nodes, std::size_t begin, std::size_t end);
  void dot(const ChainNode& node);
  // Writes the shaded lines from `begin` on, as many as one command can hold; returns the index of the node where they end.
  [[nodiscard]] std::size_t surface(const Nodes& nodes, std::size_t begin, std::size_t end);
  void surface_list(const Nodes& nodes);
  [[nodiscard]] int distance(const ChainNode& node) const;
  [[nodiscard]] int distance(const RasterChain& chain) const;

  std::vector<std::uint8_t> bytes_;
  bool nearer_end_first_;
  int colour_;
  int pen_column_ = 0;
  int pen_row_ = 0;
  // The position of a plotter's pen if the last inked line is visible: MASK does not move it.
  int ink_column_ = 0;
  int ink_row_ = 0;
};

}  // namespace sightline::programs::skala
