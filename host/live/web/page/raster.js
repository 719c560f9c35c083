// Draws the picture of a raster board on a canvas: 256 by 256 values from 0 to 7, the bottom row first.

// The pixels of the values: three bit planes as colours, and grey levels.
export const COLOURS = Int32Array.from({length: 8}, (_, n) => 0xff000000 | (n & 1 ? 0xff0000 : 0) | (n & 2 ? 0xff00 : 0) | (n & 4 ? 0xff : 0));
export const GREYS = Int32Array.from({length: 8}, (_, n) => 0xff000000 | n * 36 * 0x010101);

export class RasterImage {
  constructor() {
    this.image = new ImageData(256, 256);
    this.pixels = new Int32Array(this.image.data.buffer);
  }
  draw(context, dots, colours = COLOURS) {
    const {pixels} = this;
    for (let y = 0; y < 256; ++y) {
      for (let x = 0; x < 256; ++x) pixels[256 * (255 - y) + x] = colours[dots[256 * y + x] & 7];
    }
    context.putImageData(this.image, 0, 0);
  }
}
