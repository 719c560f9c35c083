#include "host/guests/skala/twin/twin.hpp"

#include "host/guests/skala/twin/drawing.hpp"
#include "host/guests/skala/twin/receipt.hpp"

namespace sightline::guests::skala {

TwinPicture run_twin(std::span<const std::uint8_t> stream, const Equipment& equipment) {
  const Receipt receipt = receive_stream(stream);
  TwinPicture picture;
  TwinDrawing drawing(picture, equipment);
  for (const ReceivedCommand& received : receipt.drawn) {
    if (drawing.obey(received)) continue;
    picture.status = Status::device_missing;
    picture.bytes_taken = received.last_byte + 1;
    return picture;
  }
  picture.status = receipt.status;
  picture.bytes_taken = receipt.bytes_taken;
  return picture;
}

}  // namespace sightline::guests::skala
