// Joins visible pieces to lines of a drawing. Consecutive pieces are joined as they are drawn; those of contours and
// silhouettes, which are found cell by cell, are joined by the names of their ends.
#pragma once

#include <cstdint>
#include <vector>

#include "host/algorithms/skala/horizon.hpp"
#include "host/picture/vector_drawing.hpp"

namespace sightline::algorithms::skala {

// Converts mask columns to coordinates of the drawing.
class Sheet {
 public:
  Sheet(picture::VectorDrawing& drawing, int columns)
      : drawing_(&drawing), scale_(static_cast<float>(picture_extent / columns)) {}
  [[nodiscard]] picture::DrawingPoint place(Vertex vertex) const {
    return {(vertex.x + 0.5F) * scale_, vertex.y};
  }
  [[nodiscard]] picture::VectorDrawing& drawing() const { return *drawing_; }
  void line(std::uint32_t layer, const std::vector<Vertex>& corners);

 private:
  picture::VectorDrawing* drawing_;
  float scale_;
};

// A line under construction.
class Pen {
 public:
  void draw(Sheet& sheet, std::uint32_t layer, const std::vector<Piece>& pieces) {
    for (const Piece& piece : pieces) draw(sheet, layer, piece.from, piece.to);
  }
  void draw(Sheet& sheet, std::uint32_t layer, Vertex from, Vertex to) {
    if (corners_.empty() || corners_.back() != from || layer != layer_) {
      lift(sheet);
      layer_ = layer;
      corners_.push_back(from);
    }
    corners_.push_back(to);
  }
  void lift(Sheet& sheet) {
    if (!corners_.empty()) sheet.line(layer_, corners_);
    corners_.clear();
  }

 private:
  std::uint32_t layer_ = 0;
  std::vector<Vertex> corners_;
};

// Names a place where pieces may be joined; 0: not joined.
using Joint = std::uint64_t;

class Stitcher {
 public:
  void add(std::uint32_t layer, const Piece& piece, Joint from, Joint to) {
    pieces_.push_back({piece, {from, to}, layer});
  }
  // `from` and `to` name the ends of the segment that these are the visible pieces of.
  void add(std::uint32_t layer, Vertex start, Vertex end, const std::vector<Piece>& pieces, Joint from,
           Joint to) {
    for (const Piece& piece : pieces)
      add(layer, piece, piece.from == start ? from : 0, piece.to == end ? to : 0);
  }
  // Joints belong to one layer. Lines are emitted in the order of their first pieces.
  void finish(Sheet& sheet);

 private:
  struct Stitch {
    Piece piece;
    Joint ends[2];
    std::uint32_t layer;
  };
  [[nodiscard]] std::vector<std::uint32_t> partners() const;
  [[nodiscard]] Vertex end(std::uint32_t end) const {
    return end % 2 == 0 ? pieces_[end / 2].piece.from : pieces_[end / 2].piece.to;
  }

  std::vector<Stitch> pieces_;
};

}  // namespace sightline::algorithms::skala
