// All algorithms with exact visible edges on one scene: the oracle, `exact`, and native Jones by BSP and, where possible, by
// grid.
// Jones is omitted for scenes with wires, which it does not draw. Pictures must be equal by ==.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/base/result.hpp"
#include "host/scene/cells/bsp/decompose.hpp"
#include "host/scene/cells/grid/decompose.hpp"

namespace sightline::algorithms {

class Agreement {
 public:
  // The scene must be checked, and must outlive this object.
  explicit Agreement(const scene::PolyScene& scene) : scene_(scene), mesh_(exact::make_edge_mesh(scene)) {
    if (!scene.wires.empty()) return;
    add("jones by bsp", scene::decompose_bsp(scene));
    if (!scene::why_no_grid(scene)) add("jones by grid", scene::decompose_grid(scene));
  }

  // Empty if all agree; else one line for each that differs. The eye must be in free space.
  std::string differences(const scene::PolyCamera& camera) {
    const picture::LinePicture truth = oracle::visible_edges(scene_, camera);
    std::string text = no_complex_;
    const auto hold = [&](const std::string& name, const picture::LinePicture& drawn) {
      if (drawn == truth) return;
      text += name + ": " + std::to_string(drawn.pieces.size()) + " pieces, the oracle " +
              std::to_string(truth.pieces.size()) + "\n";
    };
    hold("exact", exact::visible_edges(mesh_, camera));
    for (Cells& cells : cells_) {
      const auto result = cells.walker.visible_edges(camera);
      if (!result) {
        text += cells.name + ": " + result.error().message() + "\n";
      } else {
        hold(cells.name, result->picture);
      }
    }
    return text;
  }

 private:
  struct Cells {
    Cells(std::string cut, scene::CellComplex of_cells)
        : name(std::move(cut)),
          complex(std::make_unique<scene::CellComplex>(std::move(of_cells))),
          prepared(std::make_unique<jones::PreparedComplex>(*complex)),
          walker(*prepared) {}

    std::string name;
    std::unique_ptr<scene::CellComplex> complex;  // at a stable address
    std::unique_ptr<jones::PreparedComplex> prepared;
    jones::Walker walker;
  };

  void add(const std::string& name, base::Result<scene::CellComplex> made) {
    if (!made) {
      no_complex_ += name + ": " + made.error().message() + "\n";
    } else {
      cells_.emplace_back(name, std::move(*made));
    }
  }

  const scene::PolyScene& scene_;
  exact::EdgeMesh mesh_;
  std::vector<Cells> cells_;
  std::string no_complex_;
};

}  // namespace sightline::algorithms
