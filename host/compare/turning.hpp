// A solid turning on the PDP-7 (host/programs/turn), stopped at one angle and compared: with its twin word for word,
// and with exact lines at the machine's own angle, in points of its display.
//
// The machine's angle is a word, 2^18 to a turn. A camera's vectors are integers below 2^15 and rarely have that
// angle. So exact methods get the nearest camera between the same two events as the angle, where the structure is the
// same; vertices are then placed at the machine's angle. The bound of the machine's error follows from its words
// (host/programs/turn/precision.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "emulators/core/time.hpp"
#include "host/base/result.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/raster_difference.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

inline constexpr std::string_view turn_name = "turn-pdp7";

// The machine's picture at an angle, in points of the display.
struct TurnPicture {
  std::uint32_t angle = 0;
  scene::PolyCamera camera;  // between the same events
  std::size_t words = 0;     // of the display file
  core::Duration time{};     // of the picture on the machine
  std::vector<picture::PixelSegment> lines;    // of the vector words
  std::size_t flashes = 0;                     // of the first pass
  picture::PixelGrid lit;                      // by the flashes
  double bound = 0;        // of the distance between these lines and the exact ones at this angle, both ways
  double view_bound = 0;   // the same for exact lines from the view's camera, if one is given
  double flash_bound = 0;  // the same for the flashes
  std::string difference;  // from the twin; empty: identical

  // The structure in the machine's core: the position of each visible piece's ends, by edge, ascending along it.
  struct Piece {
    picture::LineEdge edge;
    picture::LinePart part;
    picture::LinePart tolerance;  // of low and high; 0: a vertex
  };
  std::vector<Piece> pieces;
};

// The machine's angle at which a camera in parallel projection sees the scene. Empty for another camera, or one that
// does not look along the plane of the turn.
[[nodiscard]] std::optional<std::uint32_t> turn_angle_of(const scene::PolyCamera& camera);

// A scene upright on the machine, with the EAE, in 8K of core or, if that is too small, in 32K.
class Turning {
 public:
  // Errors: those of stand_on_axis, of the events and of programs::turn::encode; more edges than fit.
  [[nodiscard]] static base::Result<Turning> of(const scene::PolyScene& scene);
  Turning(Turning&&) noexcept;
  Turning& operator=(Turning&&) noexcept;
  ~Turning();

  // Errors: the machine made no such picture; no camera is between the events around the angle. `view` is a camera of
  // that angle, to the nearest word.
  [[nodiscard]] base::Result<TurnPicture> draw(std::uint32_t angle, const scene::PolyCamera* view = nullptr) const;
  // The scene on the axis; its vertices keep their numbers.
  [[nodiscard]] const scene::PolyScene& scene_on_axis() const;
  // The positions of the scene's lines on the screen at an angle.
  [[nodiscard]] std::vector<picture::PixelSegment> on_screen(const picture::LinePicture& lines, std::uint32_t angle) const;
  // Points of the display per unit of the scene.
  [[nodiscard]] double scale() const;

 private:
  struct Parts;
  explicit Turning(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

// The first difference of the structure from the exact pieces, from the picture's camera; empty if there is none.
[[nodiscard]] std::string structure_difference(const TurnPicture& turn, const picture::LinePicture& exact);

struct TurnCheck {
  std::uint32_t angle = 0;  // of the machine: 2^18 per turn
  std::size_t words = 0;    // of the display file
  core::Duration time{};    // of the picture on the machine
  std::size_t flashes = 0;  // of its first pass
  picture::HausdorffDistance distance;  // between the flashes and the exact lines, in points of the display
  double bound = 0;                     // of distance.greatest
  picture::RasterDifference raster;     // between the flashes and the exact lines by the program's rule
  std::string difference;  // from the twin, or of the structure from the exact pieces; empty: identical
  picture::LineMetrics metrics{};  // of its pieces on the exact lines of the image, in points of the display; without the distance

  // The machine's picture is as accurate as its words allow.
  [[nodiscard]] bool agrees() const { return difference.empty() && distance.greatest <= bound; }
};

// Errors: those of Turning.
[[nodiscard]] base::Result<TurnCheck> check_turn(const scene::PolyScene& scene, std::uint32_t angle);
// For a scene prepared for many angles. Thread-safe.
[[nodiscard]] base::Result<TurnCheck> check_turn(const Turning& turning, std::uint32_t angle);

}  // namespace sightline::compare
