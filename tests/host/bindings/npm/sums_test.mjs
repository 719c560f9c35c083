// The package draws what the library for C++ draws: the sums of ../view_sums.cpp, whose comment says what is summed.
//
//   node sums_test.mjs PACKAGE_FOLDER VIEW_SUMS [SEED BOXES VIEWS]

import {execFileSync} from 'node:child_process';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const [folder, program, seed = '1', boxCount = '6', views = '1000'] = process.argv.slice(2);
const {Scene} = await import(pathToFileURL(join(folder, 'index.js')));

const table = new Uint32Array(256).map((_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? n >>> 1 ^ 0xedb88320 : n >>> 1;
  return n;
});
class Sum {
  #value = 0xffffffff;
  add(array) {
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    let value = this.#value;
    for (let i = 0; i < bytes.length; ++i) value = table[(value ^ bytes[i]) & 255] ^ value >>> 8;
    this.#value = value;
  }
  get text() { return ((this.#value ^ 0xffffffff) >>> 0).toString(16).padStart(8, '0'); }
}

let state = Number(seed) >>> 0;
const below = n => {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return (state >>> 8) % n;
};
const three = n => [below(n), below(n), below(n)];

function boxes(count) {
  const positions = [];
  const faces = [];
  for (let b = 0; b < count; ++b) {
    const low = three(1000);
    const size = three(300).map(s => s + 1);
    for (let i = 0; i < 8; ++i) positions.push(low[0] + (i & 1) * size[0], low[1] + (i >> 1 & 1) * size[1], low[2] + (i >> 2) * size[2]);
    for (const face of ['0264', '1573', '0451', '2376', '0132', '4675']) faces.push([...face].map(c => 8 * b + Number(c)));
  }
  return {positions: new Float64Array(positions), faces};
}
function camera(view) {
  const d = three(1001).map(c => c - 500);
  if (!d.some(c => Math.abs(c) >= 300)) d[0] = 400;
  return view % 2 ? {eye: d.map(c => 500 - 5 * c)} : {direction: d};
}
const counts = offsets => offsets.subarray(1).map((end, i) => end - offsets[i]);

const expected = execFileSync(program, [seed, boxCount, views], {maxBuffer: 1 << 28, encoding: 'utf8'}).trim().split('\n');
const scene = await Scene.of(boxes(Number(boxCount)));
let different = 0;
for (let view = 0; view < Number(views); ++view) {
  const {lines, kinds, hidden, lineEdges, lineEdgeOffsets, parts, edges} = await scene.draw({...camera(view), hidden: true});
  const sum = new Sum();
  for (const column of [lines, kinds, hidden, counts(lineEdgeOffsets), lineEdges, parts.edges, parts.fractions, parts.hidden, parts.hiddenBy,
                        edges.kinds, edges.ends, edges.vertices, counts(edges.faceOffsets), edges.bodies, edges.faces]) sum.add(column);
  const line = `${lines.length / 4} ${sum.text}`;
  if (line === expected[view]) continue;
  if (different++ < 5) console.error(`FAILED: view ${view}: ${line}, natively ${expected[view]}`);
}
console.log(`${views} views of ${boxCount} boxes, seed ${seed}: ${different} different`);
process.exit(different || expected.length !== Number(views) ? 1 : 0);
