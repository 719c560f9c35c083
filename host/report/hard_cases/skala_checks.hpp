// What must be true of pictures in the hard cases of slices, beside what an oracle says.
#pragma once

#include "host/report/hard_cases/skala.hpp"

namespace sightline::harness::report {

// Of dots. Slice 0 is the nearest.
[[nodiscard]] Complaint near_slice_lit(const scene::HeightGrid& grid, const guests::skala::View& view,
                                       const picture::PixelGrid& dots);
// And no other dot.
[[nodiscard]] Complaint near_slice_only(const scene::HeightGrid& grid, const guests::skala::View& view,
                                        const picture::PixelGrid& dots);
[[nodiscard]] Complaint every_slice_lit(const scene::HeightGrid& grid, const guests::skala::View& view,
                                        const picture::PixelGrid& dots);
// Slices of both families.
[[nodiscard]] Complaint whole_net_lit(const scene::HeightGrid& grid, const guests::skala::View& view,
                                      const picture::PixelGrid& dots);
// All dots of one row and no other.
[[nodiscard]] Complaint one_row(const scene::HeightGrid& grid, const guests::skala::View& view,
                                const picture::PixelGrid& dots);
// Slice 1 from column 100 to 155.
[[nodiscard]] Complaint far_slice_in_gap(const scene::HeightGrid& grid, const guests::skala::View& view,
                                         const picture::PixelGrid& dots);
[[nodiscard]] Complaint bottom_lit(const scene::HeightGrid& grid, const guests::skala::View& view,
                                   const picture::PixelGrid& dots);

// Of lines.
[[nodiscard]] Complaint first_line_whole(const scene::HeightGrid& grid,
                                         const picture::VectorDrawing& drawing);
// As long, across, as the picture is wide.
[[nodiscard]] Complaint ink_of_one_row(const scene::HeightGrid& grid, const picture::VectorDrawing& drawing);
[[nodiscard]] Complaint one_line(const scene::HeightGrid& grid, const picture::VectorDrawing& drawing);
[[nodiscard]] Complaint line_a_slice(const scene::HeightGrid& grid, const picture::VectorDrawing& drawing);
[[nodiscard]] Complaint line_a_slice_and_point(const scene::HeightGrid& grid,
                                               const picture::VectorDrawing& drawing);
// Across the middle of the picture.
[[nodiscard]] Complaint line_through_gap(const scene::HeightGrid& grid,
                                         const picture::VectorDrawing& drawing);
[[nodiscard]] Complaint reaches_bottom(const scene::HeightGrid& grid, const picture::VectorDrawing& drawing);
// Of contours at three levels.
[[nodiscard]] Complaint line_a_level(const scene::HeightGrid& grid, const picture::VectorDrawing& drawing);

}  // namespace sightline::harness::report
