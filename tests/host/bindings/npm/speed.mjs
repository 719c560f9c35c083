// The time for SIDE x SIDE boxes (100 by default): scene and drawing with hidden lines. speed.cpp measures the same natively.
//
//   node speed.mjs PACKAGE_FOLDER [SIDE]

import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const {Scene} = await import(pathToFileURL(join(process.argv[2], 'index.js')));
const side = Number(process.argv[3] ?? 100);

const positions = new Float64Array(24 * side * side);
const index = new Uint32Array(36 * side * side);
const triangles = ['026', '064', '157', '173', '045', '051', '237', '276', '013', '032', '467', '475'].join('');
for (let b = 0; b < side * side; ++b) {
  const [x, y] = [b % side, Math.floor(b / side)];
  for (let i = 0; i < 8; ++i) positions.set([3 * x + 2 * (i & 1), (i >> 1 & 1) * (1 + (x * 7 + y * 5) % 4), 3 * y + 2 * (i >> 2)], 24 * b + 3 * i);
  for (let i = 0; i < 36; ++i) index[36 * b + i] = 8 * b + Number(triangles[i]);
}
for (const worker of [false, false, false, true]) {
  const begin = performance.now();
  const scene = await Scene.of({positions, index}, {worker});
  const loaded = performance.now();
  const drawing = await scene.draw({view: 'iso', hidden: true});
  const drawn = performance.now();
  const bytes = drawing.svg().length;
  const written = performance.now();
  scene.free();
  console.log(`scene ${(loaded - begin).toFixed(0)}, draw ${(drawn - loaded).toFixed(0)}, SVG ${(written - drawn).toFixed(0)} ms: ` +
              `${drawing.kinds.length} lines, ${bytes} bytes${worker ? ', in a worker' : ''}`);
}
