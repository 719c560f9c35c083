#include "host/report/experiments/png_picture.hpp"

#include "host/picture/png.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

Picture png_picture(const picture::Image& image, bool pixelated) {
  auto bytes = picture::encode_png(image, {{"Software", "sightline"}});
  if (!bytes) throw base::io_error(bytes.error().message());
  return {"image/png", *std::move(bytes), pixelated};
}

}  // namespace sightline::report
