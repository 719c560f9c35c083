// What is wanted of a drawing of a height grid, and seen from where: for the native algorithm and for the program on the 8080
// (host/programs/skala), which always has rims and leaves out what says so.
#pragma once

#include <vector>

namespace sightline::algorithms::skala {

enum class Subject { lines, surface, contours };

// Which slices are inked: z constant, x constant, both cell by cell, or the family that is less end-on. For
// contours: the net of the cells, if that is asked for.
enum class Family { along_x, along_z, both, automatic };

// What decides the colour of a facet: its slope, as a grey, or its height (picture::height_colour).
enum class Colouring { slope, heights };

// The proportions of the box around a surface: how long its sides are that stand for the domain's and for the range of heights.
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
  double zoom = 1;        // > 0, about the middle of the picture; of pictures of dots only
  int levels = 8;         // contour levels, 0 .. 255, at equal distances inside the range of the heights
  std::vector<double> level_heights = {};  // contour levels themselves, ascending, at most 255; empty: as `levels` says
  BoxSides sides = {};
  Colouring colouring = Colouring::slope;
  int columns = 4096;  // of the masks over the picture's width; 4096 are 16 to a dot of the 256 of the paper
  bool visibility = true;
  bool rims = true;         // ink the edge of the surface between the ends of slices, and around contours
  bool silhouette = false;  // ink where the surface turns away from the eye
  bool net = false;         // contours and surfaces: ink every cell's margins
};

}  // namespace sightline::algorithms::skala
