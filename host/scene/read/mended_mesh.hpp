// A mesh while it is mended: its faces in pieces, which vertex each vertex of the file became, and what was wrong with the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/geometry/vector.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/model/edge_table.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/poly_mend.hpp"

namespace sightline::scene {

// A face of the file, or a part of one.
struct Piece {
  Ring ring;
  std::uint32_t body = 0;    // of the file
  std::uint32_t source = 0;  // the face of the file, counted over all bodies from 0
  bool turned = false;
  bool left_out = false;
};

[[nodiscard]] inline bool by_source(const Piece& a, const Piece& b) { return a.source < b.source; }

struct MendedMesh {
  const PolyScene& scene;  // its vertices are the file's on the grid; its bodies have names, and no faces once `pieces` are filled
  const FileFaces& file;
  const MendOptions& options;
  MendReport& report;
  std::vector<VertexIndex> target = {};        // of each vertex of the file: the one that it became
  std::vector<Piece> pieces = {};              // ascending by their source
  std::vector<std::uint32_t> body_starts = {};  // the first face of each body of the file
  Problems faults = {};

  [[nodiscard]] const std::vector<PolyPoint>& points() const { return scene.vertices; }
  // Faces are numbered as in `pieces`.
  [[nodiscard]] EdgeTable edge_table() const;
  // The largest distance of a vertex from the plane through the first one with the direction `normal`, in steps.
  [[nodiscard]] double deviation(const Ring& ring, const geometry::Vector3& normal) const;

  static void leave_out(Piece& piece, std::size_t& count);
  void sort_pieces();

  [[nodiscard]] bool names_faults() const { return options.name_faults && !faults.full(); }
  // Of the face of the file within its body.
  [[nodiscard]] std::size_t face_in_body(const Piece& piece) const { return piece.source - body_starts[piece.body]; }
  [[nodiscard]] std::string place_of(const Piece& piece) const;
  // Does nothing unless faults are named.
  void add_fault(const Piece& piece, const std::string& text);
};

// Removes repeated vertices and spikes, where the ring goes to a vertex and straight back. Fewer than three vertices become none.
void remove_spikes(Ring& ring);

// The representative of i in a forest of parents.
[[nodiscard]] inline std::uint32_t root_of(std::vector<std::uint32_t>& parents, std::uint32_t i) {
  while (parents[i] != i) {
    parents[i] = parents[parents[i]];
    i = parents[i];
  }
  return i;
}

}  // namespace sightline::scene
