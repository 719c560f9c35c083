// The phosphor of the Type 340: its parameters, those of host/picture/phosphor.hpp, which cites the sources; and a phosphor on a coarse grid, in which
// a flash does not spread to other points. It replaces the shaders of tube.js on computers without a graphics card. Dark points take almost no time.

export const PHOSPHOR = {
  margin: 24, floor: 0.15, sigmaBase: 0.6, sigmaGrowth: 0.2, cascade: 1.9, blueShare: 0.25,
  yellow: [[0.0116 / 0.2324, 0.04], [0.0768 / 0.2324, 0.16], [0.144 / 0.2324, 2.4]],
  blueColour: [0.10, 0.22, 1.0], yellowColour: [0.55, 0.80, 0.10], haloShare: 0.03,
  ambient: [0.011, 0.017, 0.012], exposure: 3.5, shutter: 0.2, eye: 0.06,
};
// Settings of the afterglow: the factor of its times, the visible share of the yellow layer, and the persistence of vision in seconds. Without the yellow
// layer only the blue one is visible, as behind a blue filter; moving lines are then smeared only by the persistence of vision. It is as short as a steady
// picture allows: with 0.03 s, 50 refreshes and 60 frames per second, the light of a point stays within a third of its mean; with 0.02 s it would fall to
// half of it and flicker.
export const AFTERGLOWS = {
  p7: {title: 'P7 as it was', times: 1, yellow: 1, eye: PHOSPHOR.eye},
  short: {title: 'shorter: a twentieth', times: 0.05, yellow: 1, eye: PHOSPHOR.eye},
  off: {title: 'off: the blue layer alone', times: 1, yellow: 0, eye: 0.03},
};
export const [[SHARE_0, TAU_0], [SHARE_1, TAU_1], [SHARE_2, TAU_2]] = PHOSPHOR.yellow;
export const POINTS = 1024;
export const SIDE = POINTS + 2 * PHOSPHOR.margin;
const LEVELS = Array.from({length: 8}, (_, i) => PHOSPHOR.floor + (1 - PHOSPHOR.floor) * (i / 7) ** 1.5);

const DARK = 1e-7;
const STEPS = 16384;
// v / (1 + v), the response of the film to the light v, in sRGB.
const SRGB = Uint8Array.from({length: STEPS + 1}, (_, i) => { const v = i / STEPS; return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055)); });
const shown = light => SRGB[STEPS * light / (1 + light) | 0];

export class CoarsePhosphor {
  constructor(side) {
    const floats = () => new Float32Array(side * side);
    this.side = side;
    this.sums = floats();  // light of the flashes of this frame
    this.glow = [floats(), floats(), floats()];
    this.blue = floats();  // light of either layer that the eye sees
    this.yellow = floats();
    this.held = floats();  // the yellow layer of a held picture
    this.seen = this.yellow;
    this.afterglow = AFTERGLOWS.p7;
    this.lit = new Uint8Array(side * side);
    this.blocks = Math.ceil(side / 16);
    this.means = new Float32Array(2 * this.blocks * this.blocks);
    this.around = new Float32Array(2 * this.blocks * this.blocks);
    this.rowBlue = new Float32Array(this.blocks);
    this.rowYellow = new Float32Array(this.blocks);
    this.green = new Float32Array(side);
    this.bytes = new Uint8Array(4 * side * side);
    this.pixels = new Uint32Array(this.bytes.buffer);
    // For each column and row: the block before its middle, and the fraction of the distance to the next block.
    this.block = Uint8Array.from({length: side}, (_, i) => Math.max(0, Math.min(this.blocks - 2, Math.floor((i + 0.5) / side * this.blocks - 0.5))));
    this.part = Float32Array.from({length: side}, (_, i) => Math.max(0, Math.min(1, (i + 0.5) / side * this.blocks - 0.5 - this.block[i])));
  }

  clear() {
    for (const each of [this.sums, ...this.glow, this.blue, this.yellow, this.held, this.lit]) each.fill(0);
    this.seen = this.yellow;
  }
  // The same computation as the shaders of GlowTube.
  picture(flashes, seconds) {
    const {side, sums, lit, blue, yellow} = this;
    const {times, eye: persistence} = this.afterglow;
    this.seen = yellow;
    const [glow0, glow1, glow2] = this.glow;
    const scale = side / SIDE;
    for (let i = 0; i < flashes.count; ++i) {
      const at = ((flashes.y(i) + PHOSPHOR.margin + 0.5) * scale | 0) * side + ((flashes.x(i) + PHOSPHOR.margin + 0.5) * scale | 0);
      sums[at] += LEVELS[flashes.level(i) & 7] * scale * scale;
      lit[at] = 1;
    }
    const keep0 = Math.exp(-seconds / TAU_0 / times), keep1 = Math.exp(-seconds / TAU_1 / times), keep2 = Math.exp(-seconds / TAU_2 / times);
    const half0 = Math.sqrt(keep0), half1 = Math.sqrt(keep1), half2 = Math.sqrt(keep2);
    const eye = Math.exp(-seconds / persistence), weight = PHOSPHOR.shutter * (1 - eye) / seconds;
    for (let i = 0; i < lit.length; ++i) {
      if (!lit[i]) continue;
      const fresh = sums[i], come = fresh * (1 - PHOSPHOR.blueShare);
      const come0 = come * SHARE_0, come1 = come * SHARE_1, come2 = come * SHARE_2;
      const given = glow0[i] * (1 - keep0) + glow1[i] * (1 - keep1) + glow2[i] * (1 - keep2) + come0 * (1 - half0) + come1 * (1 - half1) + come2 * (1 - half2);
      const g0 = glow0[i] = glow0[i] * keep0 + come0 * half0;
      const g1 = glow1[i] = glow1[i] * keep1 + come1 * half1;
      const g2 = glow2[i] = glow2[i] * keep2 + come2 * half2;
      const b = blue[i] = blue[i] * eye + weight * fresh * PHOSPHOR.blueShare;
      const y = yellow[i] = yellow[i] * eye + weight * given;
      sums[i] = 0;
      if (g0 + g1 + g2 + b + y < DARK) lit[i] = glow0[i] = glow1[i] = glow2[i] = blue[i] = yellow[i] = 0;
    }
  }

  // The picture of a stopped machine: for each point the light that the eye sees, or that of a photograph of so many seconds, whichever is greater.
  hold(seconds) {
    const {lit, yellow, held} = this;
    const [glow0, glow1, glow2] = this.glow;
    const [given0, given1, given2] = [TAU_0, TAU_1, TAU_2].map(each => 1 - Math.exp(-seconds / each / this.afterglow.times));
    for (let i = 0; i < lit.length; ++i) held[i] = lit[i] ? Math.max(yellow[i], glow0[i] * given0 + glow1[i] * given1 + glow2[i] * given2) : 0;
    this.seen = held;
  }

  // The halo of a point: the interpolated means of blocks of 16 by 16 points.
  gather() {
    const {side, blocks, means, around, blue, seen: yellow, lit} = this;
    for (let by = 0; by < blocks; ++by) {
      for (let bx = 0; bx < blocks; ++bx) {
        const left = Math.max(0, Math.round((bx + 0.5) / blocks * side) - 8), low = Math.max(0, Math.round((by + 0.5) / blocks * side) - 8);
        let b = 0, y = 0;
        for (let row = low; row < Math.min(side, low + 16); ++row) {
          for (let i = row * side + left; i < row * side + Math.min(side, left + 16); ++i) if (lit[i]) { b += blue[i]; y += yellow[i]; }
        }
        means[2 * (by * blocks + bx)] = b / 256;
        means[2 * (by * blocks + bx) + 1] = y / 256;
      }
    }
    const last = blocks - 1;
    for (let by = 0; by < blocks; ++by) {
      for (let bx = 0; bx < blocks; ++bx) {
        const here = by * blocks + bx;
        const west = here - (bx > 0 ? 1 : 0), east = here + (bx < last ? 1 : 0), south = here - (by > 0 ? blocks : 0), north = here + (by < last ? blocks : 0);
        for (let layer = 0; layer < 2; ++layer)
          around[2 * here + layer] = 0.4 * means[2 * here + layer] + 0.15 * (means[2 * west + layer] + means[2 * east + layer] + means[2 * south + layer] + means[2 * north + layer]);
      }
    }
  }
  // `bytes`: red, green, blue and 255 of each point, the bottom row first. `pair`: superimposes the pictures of a stereo pair in red and cyan.
  develop(pair) {
    this.gather();
    const {side, blocks, around, rowBlue, rowYellow, blue, seen: yellow, block, part, pixels, green} = this;
    const [blueRed, blueGreen, blueBlue] = PHOSPHOR.blueColour, [yellowRed, yellowGreen, yellowBlue] = PHOSPHOR.yellowColour;
    const [ambientRed, ambientGreen, ambientBlue] = PHOSPHOR.ambient;
    const own = PHOSPHOR.exposure * (1 - PHOSPHOR.haloShare), others = PHOSPHOR.exposure * PHOSPHOR.haloShare;
    const {yellow: share} = this.afterglow, ownYellow = share * own, othersYellow = share * others;
    const aside = Math.round(256 / SIDE * side);
    for (let y = 0; y < side; ++y) {
      const from = 2 * block[y] * blocks, up = part[y];
      for (let bx = 0; bx < blocks; ++bx) {
        const here = from + 2 * bx, above = here + 2 * blocks;
        rowBlue[bx] = others * (around[here] + (around[above] - around[here]) * up);
        rowYellow[bx] = othersYellow * (around[here + 1] + (around[above + 1] - around[here + 1]) * up);
      }
      for (let x = 0; x < side; ++x) {
        const i = y * side + x, bx = block[x], on = part[x];
        const b = own * blue[i] + rowBlue[bx] + (rowBlue[bx + 1] - rowBlue[bx]) * on;
        const g = ownYellow * yellow[i] + rowYellow[bx] + (rowYellow[bx + 1] - rowYellow[bx]) * on;
        if (pair) green[x] = ambientGreen + blueGreen * b + yellowGreen * g;
        else pixels[i] = 0xff000000 | shown(ambientBlue + blueBlue * b + yellowBlue * g) << 16 | shown(ambientGreen + blueGreen * b + yellowGreen * g) << 8 | shown(ambientRed + blueRed * b + yellowRed * g);
      }
      if (!pair) continue;
      for (let x = 0; x < side; ++x) {
        const inside = Math.abs(x + 0.5 - side / 2) < aside;
        const left = inside ? shown(green[x - aside]) : 0, right = inside ? shown(green[x + aside]) : 0;
        pixels[y * side + x] = 0xff000000 | right << 16 | right << 8 | left;
      }
    }
  }
}
