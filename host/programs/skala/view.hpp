// The options of a picture of a function of two variables: which algorithm of Skala (1985), seen from
// where, on which device.
#pragma once

#include "host/programs/skala/commands.hpp"

namespace sightline::programs::skala {

enum class PictureKind { lines, surface, contours };

// Which slices are drawn: along x (z constant), along z (x constant), both cell by cell; automatic takes the
// family that is less end-on. A surface is always one family (both counts as automatic), contours go by
// cells.
enum class Family { along_x, along_z, both, automatic };

struct View {
  PictureKind picture = PictureKind::lines;
  Family family = Family::automatic;
  Device device = Device::ef9365;
  double rotation = 0;    // degrees about the vertical; a quarter turn brings x = -1 to the front
  double elevation = 30;  // degrees of the eye above the horizon; negative: seen from below
  double zoom = 1;        // > 0, about the middle of the picture
  int levels = 8;         // contour levels, 1 .. 255
  bool visibility = true;
  bool serpentine = true;  // plotters: chains are drawn from the end nearer to the pen
  bool net = false;        // contours: every cell's margins are inked, not only the domain's
};

}  // namespace sightline::programs::skala
