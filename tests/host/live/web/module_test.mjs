// The module of the page in Node, compared with the command, which another compiler has compiled for another machine: whole
// machines by
// their snapshots, byte for byte, with every stroke and its time; flights by their frames and a picture; lessons by their JSON;
// hostile
// requests by their answers. views.mjs compares all scenes in a hundred views.
//
//   node module_test.mjs MODULE.wasm MODULE.js SIGHTLINE
//
// SIGHTLINE_VIEWS=100 in the environment sets the number of views per scene; 3 by default.

import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {inflateSync} from 'node:zlib';

const [wasm, script, sightline] = process.argv.slice(2);
const {openModule} = await import(pathToFileURL(script));
const module = await openModule(new WebAssembly.Module(readFileSync(wasm)));
const folder = mkdtempSync(join(tmpdir(), 'sightline-page-'));
process.on('exit', () => rmSync(folder, {recursive: true, force: true}));
const views = Number(process.env.SIGHTLINE_VIEWS ?? 3);

let failures = 0;
let checks = 0;
const check = (right, what) => {
  ++checks;
  if (right) return;
  ++failures;
  console.error(`FAILED: ${what}`);
};
const ask = request => {
  const answer = module.ask(request);
  if (answer.error) throw new Error(`${request.do}: ${answer.error}`);
  return answer;
};
const file = name => { ask({do: 'file', name}); return module.made(); };
const native = (...words) => execFileSync(sightline, words, {maxBuffer: 1 << 28, cwd: folder});
const same = (a, b) => a.length === b.length && Buffer.compare(Buffer.from(a), Buffer.from(b)) === 0;

// A small random number generator, the same in every run.
let seed = 12345;
const dice = n => { seed = (Math.imul(seed, 1103515245) + 12345) >>> 0; return Math.floor(seed / 2 ** 32 * n); };

// --- Programs of the PDP-7: from the same core to the same time, on both sides.
let allStrokes = 0;
function comparePdp7(what, made, core, start, milliseconds, options) {
  let strokes = '';
  for (let t = 1; t <= milliseconds; t += 50) {
    const until = Math.min(t + 49, milliseconds);
    module.run(made.id, until * 1e6);
    const flashes = module.flashes(made.id);
    for (let i = 0; i < flashes.count; ++i) strokes += `${flashes.time(i)} ${flashes.x(i)} ${flashes.y(i)} ${flashes.level(i)}\n`;
  }
  writeFileSync(join(folder, 'core.oct'), file(core));
  native('run', 'pdp7', 'core.oct', '--display', ...options, '--start', start.toString(8),
    '--max-time', String(milliseconds / 1000), '--strokes', 'strokes', '--save', 'native.snap', '--json');
  const expected = readFileSync(join(folder, 'strokes'), 'latin1').split('\n').filter(line => line && line[0] !== '#')
    .map(line => line.split(/[\s,]+/).filter(Boolean).slice(0, 4).join(' ')).join('\n');
  // A view of Jones's program that is not complete by then shows nothing.
  allStrokes += expected.length;
  check(expected === strokes.trimEnd(), `${what}: the strokes and their times`);
  ask({do: 'save', id: made.id});
  check(same(module.made(), readFileSync(join(folder, 'native.snap'))), `${what}: the snapshot after ${milliseconds} ms`);
  ask({do: 'drop', id: made.id});
}
function compareJones(scene, eae, switches) {
  const made = ask({do: 'jones', scene, eae, switches});
  comparePdp7(`${scene}, switches ${switches.toString(8)}`, made, '.jones.oct', made.labels.start, 1100 + dice(400), [eae ? '--eae' : '--no-eae', '--switches', switches.toString(8)]);
}
for (const scene of ['house', 'roberts', 'street4', 'corridor8', 'corridor32']) {
  for (let view = 0; view < views; ++view) compareJones(scene, view % 2 === 0, view === 0 ? 0 : dice(256) << 10 | dice(4));
}

// --- With the walk the switches left and in lead through the door of the kitchen, without it to the wall beside the door.
for (const walk of [false, true]) {
  const made = ask({do: 'jones', scene: 'house', walk, switches: 0o420000});
  module.run(made.id, 12e9);
  const [x, z] = ['ex', 'ez'].map(name => module.word(made.id, made.labels[name]));
  check(x === 1 && (walk ? z > 500 && z < 750 : z === 399), `house, ${walk ? 'with' : 'without'} the walk: the eye is at x ${x}, z ${z}`);
  check(module.word(made.id, made.labels.status) === 0, 'and its view is complete');
  ask({do: 'drop', id: made.id});
}

// --- With rotation the switches turn, and lead where the view looks.
{
  const made = ask({do: 'jones', scene: 'house', rotation: true, switches: 0o021000});
  module.run(made.id, 3e9);
  const [x, angle, status] = ['ex', 'angle', 'status'].map(name => module.word(made.id, made.labels[name]));
  check(x < 470 && angle > 180 && angle < 300 && status === 0, `house, turning: x ${x}, ${angle} degrees, status ${status}`);
  ask({do: 'drop', id: made.id});
  check(module.ask({do: 'jones', scene: 'street4', rotation: true}).error?.includes('words too many'), 'a scene too large for the program with rotation is refused');
}

// --- A snapshot of the command continues in a machine with its configuration: saved again it has the same bytes, immediately and
// later.
writeFileSync(join(folder, 'bare.oct'), '00100: 060110 600100\n');
writeFileSync(join(folder, 'bare.hex'), ':03010000C3000138\n:00000001FF\n');
for (const [machine, program, ...words] of [['pdp7', 'bare.oct'], ['pdp7', 'bare.oct', '--display', '--no-eae', '--memory', '32k', '--display-option', '342'], ['pdp7', 'bare.oct', '--timing', 'reader_line=5000000'],
  ['i8080', 'bare.hex', '--board', 'ef9365', '--clock', '2000000', '--hold', '100+10/1000'], ['i8080', 'bare.hex', '--cpm', '--console', 'ascii'], ['i8080', 'bare.hex', '--terminal', '2sio', '--baud', '300']]) {
  const start = machine === 'pdp7' ? ['--start', '100'] : words.includes('--cpm') ? [] : ['--start', '100'];
  native('run', machine, program, ...start, ...words, '--max-instructions', '100', '--save', 'begun.snap', '--json');
  native('run', machine, '--restore', 'begun.snap', ...words, '--max-instructions', '100', '--save', 'later.snap', '--json');
  module.putFile('begun.snap', readFileSync(join(folder, 'begun.snap')));
  const {id} = ask({do: 'make', snapshot: 'begun.snap'});
  const saved = () => { ask({do: 'save', id}); return module.made(); };
  check(same(saved(), readFileSync(join(folder, 'begun.snap'))), `${machine} ${words}: the snapshot again`);
  module.run(id, 2 ** 50, 100);
  check(same(saved(), readFileSync(join(folder, 'later.snap'))), `${machine} ${words}: the snapshot 100 instructions later`);
  ask({do: 'drop', id});
}

// --- The exact lines over the picture of Jones's program, in blocks of 4 by 4 points, as the page counts them: every line is
// lit, and nothing
// outside the lines is. The guest's pieces end within a point or two of the exact ones, less than a block.
const spread = (x, y, visit) => {
  for (let dy = -1; dy <= 1; ++dy) for (let dx = -1; dx <= 1; ++dx) visit(256 * ((y >> 2) + dy) + (x >> 2) + dx);
};
for (const scene of ['house', 'roberts', 'street4', 'corridor8', 'corridor32']) {
  for (const [stereo, angle] of [[false], [true], [false, 325], [true, 20]]) {
    if (angle !== undefined && scene === 'street4') continue;  // too large for the program with rotation
    const made = ask({do: 'jones', scene, stereo, rotation: angle !== undefined, angle});
    const until = 3.5e9;
    const lit = new Set();
    for (let at = 0; at <= until; at += 5e7) {
      module.run(made.id, at);
      const flashes = module.flashes(made.id);
      for (let i = 0; i < flashes.count; ++i) if (flashes.time(i) > until - 3e8) lit.add(256 * (flashes.y(i) >> 2) + (flashes.x(i) >> 2));
    }
    const eye = ['ex', 'ey', 'ez'].map(name => { const word = module.word(made.id, made.labels[name]); return word & 0o400000 ? word - 0o1000000 : word; });
    const {lines} = ask({do: 'sight', scene, eye, scale: module.word(made.id, made.labels.scale), angle: angle && module.word(made.id, made.labels.angle), stereo});
    const covered = new Set();
    let places = 0, missing = 0;
    for (const [x0, y0, x1, y1] of lines) {
      const parts = Math.max(1, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / 4));
      for (let i = 0; i < parts; ++i) {
        const t = (i + 0.5) / parts;
        let right = false;
        spread(x0 + (x1 - x0) * t, y0 + (y1 - y0) * t, block => { covered.add(block); right ||= lit.has(block); });
        ++places;
        if (!right) ++missing;
      }
    }
    const extra = [...lit].filter(block => !covered.has(block)).length;
    check(places > 500 && missing === 0 && extra === 0, `${scene}${stereo ? ', a pair' : ''}${angle ? `, turned by ${angle}` : ''}: ${missing} of ${places} places of exact lines are dark, ${extra} beside them are lit`);
    ask({do: 'drop', id: made.id});
  }
}
check(module.ask({do: 'sight', scene: 'house', eye: [480, 160, -20]}).error?.length > 20, 'no exact lines from outside all cells');

// --- Turning solids: at speeds in both directions, as wire frames, and from event to event.
const solids = fileURLToPath(new URL('../../../../host/examples/turn/', import.meta.url));
const onPage = ['cube.off', 'block.off', 'lshape.json', 'crossed.off', 'star.off'];
for (const name of onPage) module.putFile(name, readFileSync(join(solids, name)));
for (const [n, scene] of [...onPage, 'roberts', 'boxes-8', 'boxes-20'].entries()) {
  for (let view = 0; view < Math.max(1, views - 2); ++view) {
    const eae = (n + view) % 2 === 0;
    const switches = [0, 0o400000, 0o200000, 0o600000, 0o100000][(n + view) % 5] | dice(0o10000);
    const made = ask({do: 'turn', scene, eae, switches, memory: scene === 'boxes-20' ? '32k' : '8k', level: scene === 'boxes-20'});
    writeFileSync(join(folder, 'tape.rim'), file('.turn.tape'));
    comparePdp7(`${scene} turning, switches ${switches.toString(8)}`, made, '.turn.oct', made.labels.begin, 300 + dice(300),
      [eae ? '--eae' : '--no-eae', '--switches', switches.toString(8), '--reader', 'tape.rim', ...(scene === 'boxes-20' ? ['--memory', '32k'] : [])]);
    check(made.edges > 0 && made.step > 0, `${scene}: what the room says of it`);
  }
}

check(allStrokes > 100000, 'strokes were compared');

// --- The kind of a file is recognised by its content, under a meaningless name.
const examples = fileURLToPath(new URL('../../../../host/examples/', import.meta.url));
for (const [name, kind, machine] of [['turn/cube.off', 'scene'], ['turn/lshape.json', 'scene'], ['bracket.obj', 'scene'], ['rooms.json', 'scene'], ['crater.csv', 'grid'], ['hills.csv', 'grid'],
  ['square.s', 'source', 'pdp7'], ['pdp7/turning.s', 'source', 'pdp7'], ['hello.asm', 'source', 'i8080'], ['boards/ef9365.asm', 'source', 'i8080']]) {
  module.putFile('file', readFileSync(join(examples, name)));
  const told = module.ask({do: 'kind', file: 'file'});
  check(!told.error && told.kind === kind && told.machine === machine, `${name} is told by its content: ${JSON.stringify(told)}`);
}

// --- Skala's program: to its halt, on every device.
const functions = ask({do: 'lists'}).functions.map(each => each.name);
for (const [n, device] of ['ef9365', 'alt256', 'calcomp', 'minigraf'].entries()) {
  for (let view = 0; view < views; ++view) {
    const request = {do: 'skala', function: functions[(n + view) % functions.length], device, points: 9 + dice(20), slices: 9 + dice(20), rotation: dice(360) - 180, elevation: dice(90),
      picture: ['lines', 'surface', 'contours'][view % 3]};
    const made = ask(request);
    const limit = 3e6 * 3;
    module.run(made.id, limit);
    writeFileSync(join(folder, 'program.bin'), file('.skala.bin'));
    writeFileSync(join(folder, 'stream'), file('.skala.stream'));
    native('run', 'i8080', 'program.bin', '--parallel', 'stream', ...(n < 2 ? ['--board', device] : ['--plotter', device]), '--max-states', String(limit), '--start', made.start.toString(16), '--save', 'native.snap', '--json');
    ask({do: 'save', id: made.id});
    check(same(module.made(), readFileSync(join(folder, 'native.snap'))), `${JSON.stringify(request)}: the snapshot after ${module.ticks(made.id)} T-states`);
    ask({do: 'drop', id: made.id});
  }
}

// --- Scenes in stripes: to their halt, on both devices.
const {camera} = await import(new URL('camera.js', pathToFileURL(script)));
for (const [n, scene] of ['boxes-5', 'house', 'roberts', 'crossed.off'].entries()) {
  for (let view = 0; view < views; ++view) {
    const device = (n + view) % 2 ? 'ef9365' : 'calcomp';
    const request = {do: 'stripes', scene, device, camera: camera(dice(360) - 180, dice(50))};
    const made = ask(request);
    const limit = 3e6 * 4;
    module.run(made.id, limit);
    writeFileSync(join(folder, 'program.bin'), file('.stripes.bin'));
    writeFileSync(join(folder, 'stream'), file('.stripes.stream'));
    native('run', 'i8080', 'program.bin', '--parallel', 'stream', ...(device === 'ef9365' ? ['--board', device] : ['--plotter', device]), '--max-states', String(limit), '--start', made.start.toString(16), '--save', 'native.snap', '--json');
    ask({do: 'save', id: made.id});
    check(same(module.made(), readFileSync(join(folder, 'native.snap'))), `${JSON.stringify(request)}: the snapshot after ${module.ticks(made.id)} T-states`);
    ask({do: 'drop', id: made.id});
  }
}

// --- A flight: every frame's times and orders, and one picture, point by point.
// Rows of a PNG of 8-bit colours, as numbers of 24 bits.
function pointsOf(png) {
  const parts = [];
  let width = 0;
  for (let at = 8; at < png.length;) {
    const size = png.readUInt32BE(at), kind = png.toString('latin1', at + 4, at + 8);
    if (kind === 'IHDR') width = png.readUInt32BE(at + 8);
    if (kind === 'IDAT') parts.push(png.subarray(at + 8, at + 8 + size));
    at += size + 12;
  }
  const bytes = inflateSync(Buffer.concat(parts)), row = 3 * width;
  const points = new Uint32Array(bytes.length / (row + 1) * width);
  const paeth = (a, b, c) => { const p = a + b - c, pa = Math.abs(p - a), pb = Math.abs(p - b), pc = Math.abs(p - c); return pa <= pb && pa <= pc ? a : pb <= pc ? b : c; };
  let above = new Uint8Array(row);
  for (let y = 0; y * (row + 1) < bytes.length; ++y) {
    const kind = bytes[y * (row + 1)], here = new Uint8Array(row);
    for (let i = 0; i < row; ++i) {
      const left = i < 3 ? 0 : here[i - 3], corner = i < 3 ? 0 : above[i - 3];
      here[i] = bytes[y * (row + 1) + 1 + i] + [0, left, above[i], (left + above[i]) >> 1, paeth(left, above[i], corner)][kind];
    }
    for (let x = 0; x < width; ++x) points[y * width + x] = here[3 * x] << 16 | here[3 * x + 1] << 8 | here[3 * x + 2];
    above = here;
  }
  return points;
}
for (const [n, scene] of ['town-9', 'prisms-9', 'town-20', 'prisms-25'].entries()) {
  const bits = [8, 16, 12, 8][n], plan = n === 1 || n === 3, facing = n > 1, frames = 12;
  const what = `a flight through ${scene}, ${bits} bits${facing ? ', with the facing test' : ''}`;
  const made = ask({do: 'flight', scene, bits, plan, facing, frames});
  const out = `flight-${n}`;
  const report = JSON.parse(native('flight', scene, '--bits', String(bits), ...(plan ? ['--plan'] : []), ...(facing ? ['--facing'] : []), '--frames', String(frames), '-o', out, '--json'));
  const rows = readFileSync(join(folder, out, `${scene}-flight.csv`), 'utf8').trim().split('\n').slice(1);
  const shown = pointsOf(readFileSync(join(folder, out, `${scene}-flight.png`)));
  const still = frames / 3;
  let told = [], differing = -1, at = 0;
  for (let more = true; more;) {
    const last = told[still] ? (Number(told[still].split(',')[1]) + 36) * 3000 : 0;
    const looks = differing < 0 && last && at + 20000 >= last;  // the display has scanned it, and starts no other
    more = module.fly(at = looks ? last : at + 20000);
    const {frame, frames: count} = ask({do: 'flight_state'});
    if (count > told.length) told.push([count - 1, frame.shown_ms, frame.t_states, frame.waiting, frame.moved, frame.exchanges, frame.facing, frame.wrong_orders, frame.wrong_points,
      ...(facing ? [frame.with_key, frame.appeared, frame.vanished] : [])].join(','));
    if (looks) differing = module.flightPicture().reduce((sum, face, i) => sum + (made.shades[face] === shown[i] ? 0 : 1), 0);
  }
  const state = ask({do: 'flight_state'});
  check(told.join('\n') === rows.join('\n'), `${what}: the frames`);
  check(differing === 0, `${what}: ${differing} points of a picture`);
  check(state.status === 'complete' && state.difference === '', `${what}: ${state.status}, ${state.difference}`);
  for (const key of ['pieces', 'surfaces', 'coordinate_step', 'distance_error']) check(made[key] === report[key], `${what}: ${key}`);
  for (const key of ['frames', 'frames_per_second_mean', 't_states_worst', 'wrong_orders', 'wrong_points', 'pairs']) check(state[key] === report[key], `${what}: ${key}`);
}

// --- Lessons: the algorithms themselves, step by step.
for (const lesson of ask({do: 'lists'}).lessons) {
  const subjects = lesson.heights ? [{function: 'sinc'}, {function: 'peaks'}] : [{scene: 'house'}, {scene: 'boxes-5'}, {scene: 'roberts'}];
  for (const subject of subjects) {
    const answer = module.ask({do: 'explain', algorithm: lesson.algorithm, ...subject, ...(lesson.heights ? {points: 13, slices: 9, rotation: 30, elevation: 30} : {})});
    let expected;
    try {
      expected = JSON.parse(native('explain', lesson.algorithm, ...(lesson.heights ? [subject.function, '--points', '13', '--slices', '9', '--rotate', '30', '--elevate', '30'] : [subject.scene]), '-o', '-'));
    } catch (error) {
      check(Boolean(answer.error), `${lesson.algorithm} of ${JSON.stringify(subject)}: the command refuses it`);
      continue;
    }
    check(!answer.error && JSON.stringify(answer) === JSON.stringify(expected), `${lesson.algorithm} of ${JSON.stringify(subject)}: ${answer.error ?? 'the lesson'}`);
    check(answer.steps?.length > 5, `${lesson.algorithm}: a lesson of ${answer.steps?.length} steps`);
  }
}

// --- Algorithms give the same result here and in the command.
for (const scene of ['house', 'roberts', 'boxes-12', 'bricks-4', 'rooms-2']) {
  const exact = ask({do: 'draw', algorithm: 'exact', scene});
  check(exact.pieces.length > 0, `${scene}: something is seen`);
  for (const {name} of ask({do: 'lists'}).algorithms) {
    const drawn = module.ask({do: 'draw', algorithm: name, scene});
    if (drawn.error || name === 'montani-re') continue;  // drawn once where lines coincide
    check(JSON.stringify(drawn.pieces) === JSON.stringify(exact.pieces), `${scene}: ${name} draws what exact draws`);
  }
}

// --- The debugger: after a step forward and one back the machine is in the same state.
{
  const made = ask({do: 'jones', scene: 'house'});
  module.run(made.id, 3e8);
  ask({do: 'save', id: made.id});
  const before = module.made();
  ask({do: 'step', id: made.id, count: 1000});
  ask({do: 'back', id: made.id, count: 1000});
  ask({do: 'save', id: made.id});
  check(same(before, module.made()), 'a thousand instructions forward and back');
  const set = ask({do: 'break', id: made.id, at: 'search'});
  check(set.set === true, 'a breakpoint at a symbol');
  check(module.run(made.id, 1e11) === 1, 'a run stops at it');
  check(module.get(made.id, 0) === made.labels.search, 'and is there');
}

// --- An assembler's errors have positions.
{
  const made = ask({do: 'assemble', machine: 'i8080', sources: [{name: 'a.asm', text: '\tORG 100H\n\tMVI A\n\tEND\n'}]});
  check(made.right === false && made.diagnostics[0]?.line === 2, 'an error with its line');
}

// --- Every request is answered.
const bad = ['', '{', '[]', '5', 'null', '{"do":5}', '{"do":"make"}', '{"do":"make","machine":"pdp7","options":{"--load":["no"]}}', '{"do":"state","id":99}',
  '{"do":"jones","scene":"boxes-3"}', '{"do":"jones","scene":"nothing"}', '{"do":"draw","scene":"house","algorithm":"x"}',
  '{"do":"draw","scene":"house","algorithm":"exact","camera":{"eye":[1,2]}}', '{"do":"draw","scene":"house","algorithm":"exact","camera":{"forward":[0,0,0]}}',
  '{"do":"skala","expression":"x+","points":2,"slices":2}', '{"do":"skala","expression":["a",null],"domain":"x"}', '{"do":"expression","expression":"x**z"}', '{"do":"skala","function":"no"}',
  '{"do":"explain","algorithm":"exact","scene":"no"}', '{"do":"assemble","machine":"pdp7","sources":[]}', '{"do":"file","name":"no"}'];
for (const text of bad) {
  let request;
  try { request = JSON.parse(text); } catch { request = text; }
  const answer = module.ask(request);
  check(typeof answer === 'object' && typeof answer.error === 'string' && answer.error.length > 10, `${text}: ${JSON.stringify(answer)}`);
}
{
  const made = ask({do: 'jones', scene: 'house'});
  module.putFile('rubbish', Uint8Array.from({length: 5000}, () => dice(256)));
  for (const what of [{do: 'restore', file: 'rubbish'}, {do: 'load', file: 'rubbish'}, {do: 'attach', device: 'disk', file: 'rubbish'}, {do: 'put', at: 99999999, word: 1}, {do: 'put', at: 100, word: -5},
    {do: 'set', register: 'AC', value: 2 ** 40}, {do: 'memory', at: 'no such symbol'}, {do: 'evaluate', text: '((('}, {do: 'unknown'}]) {
    const answer = module.ask({id: made.id, ...what});
    check(typeof answer.error === 'string', `${JSON.stringify(what)}: ${JSON.stringify(answer)}`);
  }
  for (const scene of [new Uint8Array(0), Uint8Array.from({length: 3000}, () => dice(256)), new TextEncoder().encode('{"bodies":[{}]}'), new TextEncoder().encode('OFF\n99999999 1 1\n')]) {
    module.putFile('scene.off', scene);
    check(typeof module.ask({do: 'explain', algorithm: 'exact', scene: 'scene.off'}).error === 'string', 'a scene of rubbish');
  }
}

console.log(`${checks} checks, ${failures} failed`);
process.exit(failures ? 1 : 0);
