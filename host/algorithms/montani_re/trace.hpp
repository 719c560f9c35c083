// What the algorithm tells of its work to somebody who watches. Each verb is for work that is done a few times for a face; the
// work inside is the same with and without.
#pragma once

#include <cstdint>

#include "host/algorithms/montani_re/depth_relations.hpp"
#include "host/algorithms/montani_re/faces.hpp"
#include "host/algorithms/montani_re/priority.hpp"

namespace sightline::algorithms::montani_re {

class Trace {
 public:
  virtual ~Trace() = default;
  // The faces that may be seen, each a region of stripes. `whole`: they are all before the eye; else they are those in one
  // of several pyramids.
  virtual void faces(const FaceSet& set, bool whole) = 0;
  // All pairs have been tested.
  virtual void related(const DepthRelations& found) = 0;
  // These faces go behind the FRONT list and before the BACK list.
  virtual void ranked(const PriorityClass& front, const PriorityClass& back) = 0;
  // A relation on a cycle is deleted: its faces do not overlap in the image, or the farther one is cut by the nearer.
  virtual void cycle(const Relation& deleted, bool cut) = 0;
  // What is left of a face after another, or a part of it, was taken away.
  virtual void subtracted(std::uint32_t face, std::uint32_t near, const TrapezoidPcs& left) = 0;
};

}  // namespace sightline::algorithms::montani_re
