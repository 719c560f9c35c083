#include "host/programs/skala/stream_writer.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace sightline::programs::skala {
namespace {

// The counts of CURVE, SURFACE and GAP are bytes in which 0 means 256.
constexpr std::size_t most_items = 256;
// A CURVE of three dots is no longer than two DRAWs.
constexpr std::size_t shortest_curve = 3;

Command command_of(ChainStep step) {
  switch (step) {
    case ChainStep::draw: return Command::draw;
    case ChainStep::test: return Command::test_draw;
    case ChainStep::mask: return Command::mask;
    case ChainStep::rim: return Command::rim;
    case ChainStep::shade: break;
  }
  return Command::surface;
}

// The end of the longest run of consecutive inked columns from `begin` on.
std::size_t end_of_curve(const std::vector<ChainNode>& nodes, std::size_t begin, std::size_t end) {
  std::size_t next = begin + 1;
  while (next < end && next - begin < most_items && nodes[next].step == ChainStep::draw &&
         nodes[next].column == nodes[next - 1].column + 1) {
    ++next;
  }
  return next;
}

}  // namespace

StreamWriter::StreamWriter(const View& view, const Output& output, int colour, std::optional<int> silhouette)
    : nearer_end_first_(output.serpentine && !is_raster(output.device)), colour_(colour) {
  command(Command::device);
  byte(static_cast<int>(output.device) | (view.visibility ? 0 : no_visibility));
  command(Command::reset);
  if (silhouette) {
    command(Command::silhouette);
    byte(*silhouette);
  }
  command(Command::colour);
  byte(colour);
}

void StreamWriter::colour(int colour) {
  if (colour == colour_) return;
  colour_ = colour;
  command(Command::colour);
  byte(colour);
}

void StreamWriter::to(Command what, const ChainNode& node) {
  command(what);
  byte(node.column);
  byte(node.row);
  if (what == Command::rim) byte(node.level);
  pen_at(node, what != Command::move && what != Command::mask);
}

void StreamWriter::pen_at(const ChainNode& node, bool inked) {
  pen_column_ = node.column;
  pen_row_ = node.row;
  if (!inked) return;
  ink_column_ = node.column;
  ink_row_ = node.row;
}

void StreamWriter::move(const ChainNode& node) {
  if (node.column != pen_column_ || node.row != pen_row_) to(Command::move, node);
}

int StreamWriter::distance(const ChainNode& node) const {
  return std::max(std::abs(node.column - ink_column_), std::abs(node.row - ink_row_));
}

int StreamWriter::distance(const RasterChain& chain) const {
  const Nodes& nodes = chain.nodes();
  return nodes.empty() ? 0 : std::min(distance(nodes.front()), distance(nodes.back()));
}

void StreamWriter::chain(const RasterChain& chain) {
  const Nodes& nodes = chain.nodes();
  if (nodes.empty()) return;
  if (nearer_end_first_ && distance(nodes.back()) < distance(nodes.front())) {
    pieces(chain.reversed().nodes());
  } else {
    pieces(nodes);
  }
}

void StreamWriter::chain_and_commit(const RasterChain& chain_of_lines) {
  if (chain_of_lines.nodes().empty()) return;
  chain(chain_of_lines);
  command(Command::commit);
}

void StreamWriter::test_chains(std::vector<ColouredChain> chains) {
  for (auto next = chains.begin(); next != chains.end(); ++next) {
    if (nearer_end_first_) {
      const auto nearest = std::min_element(next, chains.end(), [&](const auto& a, const auto& b) {
        return distance(a.chain) < distance(b.chain);
      });
      std::rotate(next, nearest, nearest + 1);
    }
    if (next->chain.nodes().empty()) continue;
    colour(next->colour);
    chain(next->chain);
  }
}

void StreamWriter::pieces(const Nodes& nodes) {
  for (std::size_t begin = 0; begin < nodes.size();) {
    std::size_t end = begin + 1;
    while (end < nodes.size() && !nodes[end].fresh) ++end;
    piece(nodes, begin, end);
    begin = end;
  }
}

void StreamWriter::piece(const Nodes& nodes, std::size_t begin, std::size_t end) {
  if (end - begin == 1) {
    dot(nodes[begin]);
    return;
  }
  for (std::size_t i = begin; i + 1 < end;) {
    const ChainStep step = nodes[i + 1].step;
    const std::size_t run = end_of_curve(nodes, i, end);
    if (step == ChainStep::shade) {
      i = surface(nodes, i, end);
    } else if (run - i >= shortest_curve) {
      curve(nodes, i, run);
      i = run - 1;
    } else {
      if (i == begin) move(nodes[i]);
      if (i == begin && step == ChainStep::rim) to(Command::rim, nodes[i]);
      to(command_of(step), nodes[++i]);
    }
  }
}

void StreamWriter::dot(const ChainNode& node) {
  if (node.step == ChainStep::shade) {
    surface_list({node, node});  // the first vertex is only moved to
  } else {
    move(node);
    to(command_of(node.step), node);
  }
}

void StreamWriter::curve(const Nodes& nodes, std::size_t begin, std::size_t end) {
  command(Command::curve);
  byte(nodes[begin].column);
  byte(static_cast<int>(end - begin));
  for (std::size_t i = begin; i < end; ++i) byte(nodes[i].row);
  pen_at(nodes[end - 1], true);
}

std::size_t StreamWriter::surface(const Nodes& nodes, std::size_t begin, std::size_t end) {
  std::size_t next = begin + 1;
  while (next < end && next - begin < most_items && nodes[next].step == ChainStep::shade) ++next;
  const auto at = [&](std::size_t i) { return nodes.begin() + static_cast<std::ptrdiff_t>(i); };
  surface_list(Nodes(at(begin), at(next)));
  return next - 1;
}

void StreamWriter::surface_list(const Nodes& nodes) {
  command(Command::surface);
  byte(static_cast<int>(nodes.size()));
  for (const ChainNode& node : nodes) {
    byte(node.column);
    byte(node.row);
    byte(node.level);
  }
  pen_at(nodes.back(), true);
}

void StreamWriter::gap(int first_column, int last_column) {
  const int first = std::max(first_column, 0);
  const int last = std::min(last_column, 255);
  if (first > last) return;
  command(Command::gap);
  byte(first);
  byte(last - first + 1);
}

void StreamWriter::outline() {
  command(Command::outline);
}

std::vector<std::uint8_t> StreamWriter::finish() {
  command(Command::end);
  return std::exchange(bytes_, {});
}

}  // namespace sightline::programs::skala
