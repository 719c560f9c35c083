// Chains as the bytes of the Skala program (firmware/i8080/skala/SPECIFICATION.md, section 1), in the shortest
// encoding: no MOVE to where the pen is, no COLOUR that is on already, dots in consecutive columns
// as CURVE.
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
  // On a plotter, if the output is serpentine, from the end nearer to the pen. Nothing for an empty chain.
  void chain(const RasterChain& chain);
  void chain_and_commit(const RasterChain& chain);
  // Chains of test-only lines, which hide nothing from each other. On a raster in their order, of which the
  // last colours a dot; on a plotter, if the output is serpentine, always the one nearest to the pen.
  void test_chains(std::vector<ColouredChain> chains);
  // The slice just sent is undefined in these columns; cut to the raster, no effect if none are left.
  void gap(int first_column, int last_column);
  void outline();
  // END. The writer is empty afterwards.
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
  // The lines from `begin` on that are shaded, as many as one command takes; answers the node they end at.
  [[nodiscard]] std::size_t surface(const Nodes& nodes, std::size_t begin, std::size_t end);
  void surface_list(const Nodes& nodes);
  [[nodiscard]] int distance(const ChainNode& node) const;
  [[nodiscard]] int distance(const RasterChain& chain) const;

  std::vector<std::uint8_t> bytes_;
  bool nearer_end_first_;
  int colour_;
  int pen_column_ = 0;
  int pen_row_ = 0;
  // Where a plotter's pen is, if what was last drawn in ink is visible: MASK does not move it.
  int ink_column_ = 0;
  int ink_row_ = 0;
};

}  // namespace sightline::programs::skala
