// What is wanted of a drawing of a height grid, and seen from where.
#pragma once

namespace sightline::algorithms::skala {

enum class Subject { lines, surface, contours };

// Which slices are inked: z constant, x constant, both cell by cell, or the family that is less end-on. For
// contours: the net of the cells, if that is asked for.
enum class Family { along_x, along_z, both, automatic };

inline constexpr int fewest_columns = 16;
inline constexpr int most_columns = 16384;

struct View {
  Subject subject = Subject::lines;
  Family family = Family::automatic;
  double rotation = 0;    // degrees about the vertical; a quarter turn brings x = -1 to the front; finite
  double elevation = 30;  // degrees of the eye above the horizon; negative: seen from below; finite
  int levels = 8;         // contour levels, 0 .. 255, at equal distances inside the range of the heights
  int columns = 4096;  // of the masks over the picture's width; 4096 are 16 to a dot of the 256 of the paper
  bool visibility = true;
  bool rims = true;         // ink the edge of the surface between the ends of slices, and around contours
  bool silhouette = false;  // ink where the surface turns away from the eye
  bool net = false;         // contours: ink every cell's margins
};

}  // namespace sightline::algorithms::skala
