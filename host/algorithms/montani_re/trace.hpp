// The events that the algorithm reports to a listener. Each is for work done a few times per face; the computation is the
// same with and without a listener.
#pragma once

#include <cstdint>

#include "host/algorithms/montani_re/depth_relations.hpp"
#include "host/algorithms/montani_re/faces.hpp"
#include "host/algorithms/montani_re/priority.hpp"

namespace sightline::algorithms::montani_re {

class Trace {
 public:
  virtual ~Trace() = default;
  // The faces that may be seen, each with its region of stripes. `whole`: these are all faces in front of the eye; otherwise
  // those of one of several pyramids.
  virtual void faces(const FaceSet& set, bool whole) = 0;
  // All pairs are tested.
  virtual void related(const DepthRelations& found) = 0;
  // These faces are added behind the FRONT list and before the BACK list.
  virtual void ranked(const PriorityClass& front, const PriorityClass& back) = 0;
  // A relation on a cycle is deleted, either because its faces do not overlap in the image or because the nearer one was
  // subtracted from the farther one (`cut`).
  virtual void cycle(const Relation& deleted, bool cut) = 0;
  // What is left of a face after another face, or a part of it, was subtracted.
  virtual void subtracted(std::uint32_t face, std::uint32_t near, const TrapezoidPcs& left) = 0;
};

}  // namespace sightline::algorithms::montani_re
