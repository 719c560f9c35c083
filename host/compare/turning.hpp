// A solid turning on the PDP-7 (host/programs/turn), held at one angle and compared: with its twin word for word, and with exact lines
// at the machine's own angle, in points of its display.
//
// The machine's angle is a word, 2^18 to a turn. A camera's vectors are whole numbers below 2^15, and hardly ever that angle. So the
// camera given to exact methods is one between the same two events as the angle, where the structure is the same, and the nearest:
// vertices are then placed at the machine's angle. How far the machine's picture may be away follows from its words
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

// What the machine shows at an angle. Points of the display.
struct TurnPicture {
  std::uint32_t angle = 0;
  scene::PolyCamera camera;  // between the same events
  std::size_t words = 0;     // of the display file
  core::Duration time{};     // that the machine took for the picture
  std::vector<picture::PixelSegment> lines;    // of the vector words
  std::size_t flashes = 0;                     // of the first pass
  picture::PixelGrid lit;                      // by them
  double bound = 0;        // of the lines from exact ones at this angle and of those from the lines
  double view_bound = 0;   // the same of exact lines from the view's camera, if one is given
  double flash_bound = 0;  // of the flashes, likewise
  std::string difference;  // from the twin; empty: identical

  // Of the structure in the machine's core: what each end of each visible piece may be, by edge, ascending along it.
  struct Piece {
    picture::LineEdge edge;
    picture::LinePart part;
    picture::LinePart tolerance;  // of low and high; 0: a vertex
  };
  std::vector<Piece> pieces;
};

// The angle of the machine at which a camera in parallel projection sees the scene; nothing for another camera, or one that does not
// look along the plane of the turn.
[[nodiscard]] std::optional<std::uint32_t> turn_angle_of(const scene::PolyCamera& camera);

// A scene upright on the machine, with the EAE, in 8K of core or else in 32K.
class Turning {
 public:
  // Errors: those of stand_on_axis, of the events and of programs::turn::encode; more edges than fit.
  [[nodiscard]] static base::Result<Turning> of(const scene::PolyScene& scene);
  Turning(Turning&&) noexcept;
  Turning& operator=(Turning&&) noexcept;
  ~Turning();

  // Errors: the machine made no such picture; no camera is between the events around the angle. A view's camera is one of that
  // angle to the nearest word.
  [[nodiscard]] base::Result<TurnPicture> draw(std::uint32_t angle, const scene::PolyCamera* view = nullptr) const;
  // The scene on the axis: its vertices have the same numbers.
  [[nodiscard]] const scene::PolyScene& standing() const;
  // Where lines of the scene are on the screen at an angle.
  [[nodiscard]] std::vector<picture::PixelSegment> on_screen(const picture::LinePicture& lines, std::uint32_t angle) const;
  // Points of the display for one unit of the scene.
  [[nodiscard]] double scale() const;

 private:
  struct Parts;
  explicit Turning(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

// Where the structure is not that of exact pieces; empty: nowhere. The pieces are of the picture's camera.
[[nodiscard]] std::string structure_difference(const TurnPicture& turn, const picture::LinePicture& exact);

struct TurnCheck {
  std::uint32_t angle = 0;  // of the machine: 2^18 a turn
  std::size_t words = 0;    // of the display file
  core::Duration time{};    // that the machine took for the picture
  std::size_t flashes = 0;  // of its first pass
  picture::HausdorffDistance distance;  // of the flashes and the exact lines, in points of the display
  double bound = 0;                     // of the greatest
  picture::RasterDifference raster;     // of the flashes from the exact lines by the program's rule
  std::string difference;  // from the twin, or of the structure from the exact pieces; empty: identical
  picture::LineMetrics metrics{};  // of its pieces on the exact lines of the image, in points of the display; without the distance

  // The machine does what its words can.
  [[nodiscard]] bool agrees() const { return difference.empty() && distance.greatest <= bound; }
};

// Errors: those of Turning.
[[nodiscard]] base::Result<TurnCheck> check_turn(const scene::PolyScene& scene, std::uint32_t angle);
// Of a scene prepared for many angles. Several threads may ask at once.
[[nodiscard]] base::Result<TurnCheck> check_turn(const Turning& turning, std::uint32_t angle);

}  // namespace sightline::compare
