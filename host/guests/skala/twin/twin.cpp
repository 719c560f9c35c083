#include "host/guests/skala/twin/twin.hpp"

#include "host/guests/skala/twin/drawing.hpp"
#include "host/guests/skala/twin/receipt.hpp"

namespace sightline::harness {

SkalaTwinPicture run_skala_twin(std::span<const std::uint8_t> stream, const SkalaEquipment& equipment) {
  const SkalaReceipt receipt = receive_skala_stream(stream);
  SkalaTwinPicture picture;
  SkalaTwinDrawing drawing(picture, equipment);
  for (const SkalaReceivedCommand& received : receipt.drawn) {
    if (drawing.obey(received)) continue;
    picture.status = SkalaStatus::device_missing;
    picture.bytes_taken = received.last_byte + 1;
    return picture;
  }
  picture.status = receipt.status;
  picture.bytes_taken = receipt.bytes_taken;
  return picture;
}

}  // namespace sightline::harness
