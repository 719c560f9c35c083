// The parameters of a drawing of a height grid, including the point of view. They are used by the native algorithm and by
// the program on the 8080 (host/programs/skala), which always has rims and ignores the parameters marked here.
#pragma once

#include <vector>

namespace sightline::algorithms::skala {

enum class Subject { lines, surface, contours };

// The slices to ink: z constant, x constant, both cell by cell, or the family that is less end-on. For contours: the net
// of the cells, if requested.
enum class Family { along_x, along_z, both, automatic };

// What determines the colour of a facet: its slope (grey), or its height (picture::height_colour).
enum class Colouring { slope, heights };

// The lengths of the sides of the box around a surface, which correspond to the domain and to the range of heights.
struct BoxSides {
  double x = 1;
  double z = 1;
  double height = 0.6;

  friend bool operator==(const BoxSides&, const BoxSides&) = default;
};

inline constexpr int fewest_columns = 16;
inline constexpr int most_columns = 16384;

struct View {
  Subject subject = Subject::lines;
  Family family = Family::automatic;
  double rotation = 0;    // degrees about the vertical; a quarter turn brings x = -1 to the front; finite
  double elevation = 30;  // degrees of the eye above the horizon; negative: seen from below; finite
  double zoom = 1;        // > 0, about the middle of the picture; only for pictures of dots
  int levels = 8;         // number of contour levels, 0 .. 255, evenly spaced inside the range of heights
  std::vector<double> level_heights = {};  // explicit contour levels, ascending, at most 255; empty: `levels` decides
  BoxSides sides = {};
  Colouring colouring = Colouring::slope;
  int columns = 4096;  // of the masks over the picture's width; 4096 is 16 per dot of the paper's 256
  bool visibility = true;
  bool rims = true;         // ink the edge of the surface between the ends of slices, and around contours
  bool silhouette = false;  // ink where the surface turns away from the eye
  bool net = false;         // contours and surfaces: ink the edges of every cell
};

}  // namespace sightline::algorithms::skala
