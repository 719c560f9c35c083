// Every scene of the firmware in many views, in the module and natively: all strokes and their times, the raster, the complete
// state of the
// machine, the pictures of the priority display. Run by hand:
//
//   node views.mjs MODULE.wasm MODULE.js VIEWS_PROGRAM [VIEWS [PART...]]      (tools/dev check views)
//
// VIEWS: number per scene, 100 by default. PART: jones, turn, skala, stripes, flight; all by default. views.cpp is the native
// side, and
// describes the lines exchanged between the two. module_test.mjs compares the module with the command.

import {spawn} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {createInterface} from 'node:readline';
import {join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

const [wasm, script, program, given = '100', ...parts] = process.argv.slice(2);
const views = Number(given);
const {openModule} = await import(pathToFileURL(script));
const {camera} = await import(new URL('camera.js', pathToFileURL(script)));
const module = await openModule(new WebAssembly.Module(readFileSync(wasm)));

const native = spawn(program, [], {stdio: ['pipe', 'pipe', 'inherit']});
const lines = createInterface({input: native.stdout})[Symbol.asyncIterator]();
native.on('exit', code => { if (code) { console.error(`FAILED: the native program ended with ${code}`); process.exit(1); } });
const tell = line => native.stdin.write(JSON.stringify(line) + '\n');

// A small random number generator, the same in every run.
let seed = 20261124;
const dice = n => { seed = (Math.imul(seed, 1103515245) + 12345) >>> 0; return Math.floor(seed / 2 ** 32 * n); };

// Two sums of 32 bits, computed as in views.cpp.
class Hash {
  a = 0x9e3779b9 | 0;
  b = 0x7f4a7c15 | 0;
  add(word) {
    this.a = Math.imul(this.a ^ word, 0x01000193);
    this.a ^= this.a >>> 15;
    this.b = Math.imul(this.b + word, 0x85ebca6b);
    this.b ^= this.b >>> 13;
  }
  addAll(numbers) { for (let i = 0; i < numbers.length; ++i) this.add(numbers[i]); }
  get sums() { return [this.a >>> 0, this.b >>> 0]; }
}

function fly() {
  const shown = new Hash(), states = [];
  for (let at = 120000, more = true; more; at += 120000) {
    more = module.fly(at);
    shown.addAll(module.flightPicture());
    states.push(module.askForText({do: 'flight_state'}));
  }
  const told = new Hash();
  told.addAll(new TextEncoder().encode(`[${states.join(',')}]`));
  return {ticks: module.flown(), frames: JSON.parse(states.at(-1)).frames, shown: shown.sums, told: told.sums};
}
function run(made, until, second) {
  const strokes = new Hash(), raster = new Hash(), state = new Hash();
  let count = 0;
  for (let at = 0, running = true; running && at < until;) {
    at = Math.min(at + second / 20, until);
    running = module.run(made.id, at) === 0;
    const flashes = module.flashes(made.id);
    count += flashes.count;
    for (let i = 0; i < flashes.count; ++i) {
      const time = flashes.time(i);
      strokes.add(time % 2 ** 32 | 0);
      strokes.add(time / 2 ** 32 | 0);
      strokes.add(flashes.x(i) | flashes.y(i) << 16);
      strokes.add(flashes.level(i));
    }
  }
  const result = {ticks: module.ticks(made.id), instructions: module.instructions(made.id), flashes: count, strokes: strokes.sums};
  raster.addAll(module.raster(made.id) ?? []);
  module.ask({do: 'save', id: made.id});
  state.addAll(module.made());
  module.ask({do: 'drop', id: made.id});
  return {...result, raster: raster.sums, state: state.sums};
}

let failures = 0;
async function compare(part, scene, requests) {
  if (parts.length && !parts.includes(part)) return;
  const begun = Date.now();
  const sum = {views: 0, refused: 0, flashes: 0, ticks: 0, frames: 0};
  let second = 3e6;
  for (const {until, ...request} of requests) {
    if (request.do === 'jones' || request.do === 'turn') second = 1e9;
    tell({request, until: until ?? 0});
    const answer = module.ask(request);
    const here = answer.error ? {} : part === 'flight' ? fly() : run(answer, until, second);
    here.answer = answer;
    const {value, done} = await lines.next();
    const there = done ? {} : JSON.parse(value);
    for (const key of new Set([...Object.keys(here), ...Object.keys(there)])) {
      if (JSON.stringify(here[key]) === JSON.stringify(there[key])) continue;
      ++failures;
      console.error(`FAILED: ${JSON.stringify(request)} until ${until}: ${key}: ${JSON.stringify(here[key])?.slice(0, 300)}, natively ${JSON.stringify(there[key])?.slice(0, 300)}`);
    }
    ++sum.views;
    if (answer.error) ++sum.refused;
    sum.flashes += here.flashes ?? 0;
    sum.ticks += here.ticks ?? 0;
    sum.frames += here.frames ?? 0;
  }
  total.views += sum.views;
  total.flashes += sum.flashes;
  total.frames += sum.frames;
  total.seconds += sum.ticks / second;
  if (sum.refused > sum.views / 2) { ++failures; console.error(`FAILED: ${part} ${scene}: ${sum.refused} of ${sum.views} views are refused`); }
  console.log(`${part} ${scene}: ${sum.views} views, ${sum.refused} refused alike, ${sum.flashes} strokes, ${sum.frames} frames of the priority display, ${(sum.ticks / second).toFixed(1)} emulated seconds; ${((Date.now() - begun) / 1000).toFixed(0)} s`);
}
const total = {views: 0, flashes: 0, frames: 0, seconds: 0};
const many = make => Array.from({length: views}, (_, n) => make(n));

for (const scene of ['house', 'roberts', 'street4', 'corridor8', 'corridor32'])
  await compare('jones', scene, many(n => ({do: 'jones', scene, eae: n % 2 === 0, switches: n ? dice(256) << 10 | dice(4) : 0, scale: n % 5 ? 512 : 256 + dice(1000), until: (700 + dice(800)) * 1e6})));

const solids = fileURLToPath(new URL('../../../../host/examples/turn/', import.meta.url));
const own = ['cube.off', 'block.off', 'lshape.json', 'crossed.off', 'star.off'];
for (const name of own) {
  const text = readFileSync(join(solids, name), 'utf8');
  module.putFile(name, text);
  tell({put: name, text});
}
for (const scene of [...own, 'roberts', 'boxes-8', 'boxes-20'])
  await compare('turn', scene, many(n => ({do: 'turn', scene, eae: n % 2 === 0, memory: scene === 'boxes-20' ? '32k' : '8k', level: n % 4 > 1,
    switches: [0, 0o400000, 0o200000, 0o600000, 0o100000][n % 5] | dice(0o10000), until: (150 + dice(400)) * 1e6})));

const angles = () => ({rotation: dice(360) - 180, elevation: dice(181) - 90});
for (const [f, name] of module.ask({do: 'lists'}).functions.map(each => each.name).entries())
  await compare('skala', name, many(n => ({do: 'skala', function: name, device: ['ef9365', 'alt256', 'calcomp', 'minigraf'][(n + f) % 4], picture: ['lines', 'surface', 'contours'][n % 3], points: 5 + dice(40), slices: 5 + dice(40),
    ...angles(), zoom: n % 4 ? 1 : 0.5 + dice(100) / 64, visibility: n % 7 !== 0, until: 3e6 * 30})));

for (const scene of ['boxes-5', 'boxes-8', 'house', 'roberts', 'town-2', 'star.off', 'crossed.off'])
  await compare('stripes', scene, many(n => ({do: 'stripes', scene, device: n % 2 ? 'ef9365' : 'calcomp', priority_by_host: n % 5 === 0, camera: camera(dice(360) - 180, dice(81)), until: 3e6 * 60})));

// One frame is a view.
for (const scene of ['prisms-9', 'prisms-25', 'town-4', 'town-9', 'town-20', 'town-60'])
  await compare('flight', scene, [8, 12, 16].flatMap(bits => [false, true].map(plan => ({do: 'flight', scene, bits, plan, facing: bits === 12, pieces: 255, frames: Math.max(2, views)}))));

native.stdin.end();
console.log(`${total.views} views, ${total.flashes} strokes, ${total.frames} frames, ${total.seconds.toFixed(0)} emulated seconds, ${failures} differences`);
process.exit(failures ? 1 : 0);
