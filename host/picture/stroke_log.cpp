#include "host/picture/stroke_log.hpp"

#include "host/base/text.hpp"

namespace sightline::picture {

void append_stroke_line(std::string& text, const core::Stroke& stroke) {
  base::append(text, "{} {} {} {} {:05o}\n", core::nanoseconds_of(stroke.time), stroke.x, stroke.y, stroke.intensity,
               stroke.address);
}

}  // namespace sightline::picture
