// Requests of all kinds with values of all kinds, from a seed: each must be answered, and the module must keep working.
//
//   node request_fuzz.mjs MODULE.wasm MODULE.js [COUNT [SEED]]

import {readFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

const [wasm, script, count = '1500', first = '1'] = process.argv.slice(2);
const {openModule} = await import(pathToFileURL(script));
const compiled = new WebAssembly.Module(readFileSync(wasm));

let seed = Number(first);
const dice = n => { seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0; return Math.floor(seed / 2 ** 32 * n); };
const one = list => list[dice(list.length)];

const numbers = [0, 1, -1, 7, 64, 100, 0o17777, 0o20000, 65535, 65536, 262143, 262144, -262144, 2 ** 31, 2 ** 32, 2 ** 53, -(2 ** 53), 1e300, -1e300, 0.5, 1e-9];
const texts = ['', 'house', 'street4', 'boxes-2', 'boxes-99999999', 'triangles-3-7', 'sinc', 'terrain', 'exact', 'jones', 'skala', 'montani-re', 'willis', 'plantinga', 'oracle', 'pdp7', 'i8080', 'program', 'rubbish', 'mesh.off', 'a.s', 'AC', 'PC', 'SR', 'HL',
  'begin', 'begin+3', '1/0', '((((', 'time', 'reader', 'disk', 'pen', '0 100 100 8\n', '0 off\n', 'lac 5', 'MVI A,5', 'hlt', '1', '100', '7777777777', 'ef9365', 'calcomp', 'lines', 'surface', 'contours', '\u0000', 'é', 'x'.repeat(5000), '--load'];
const value = depth => {
  switch (dice(depth > 2 ? 4 : 7)) {
    case 0: return one(numbers);
    case 1: case 2: return one(texts);
    case 3: return one([true, false, null]);
    case 4: return Array.from({length: dice(5)}, () => value(depth + 1));
    case 5: return Array.from({length: 3}, () => one(numbers));
    default: return Object.fromEntries(Array.from({length: dice(4)}, () => [one(keys), value(depth + 1)]));
  }
};
const whats = ['make', 'assemble', 'jones', 'skala', 'turn', 'turn_sight', 'stripes', 'flight', 'flight_state', 'firmware', 'state', 'warnings', 'step', 'over', 'out', 'back', 'back_to_breakpoint', 'break', 'watch', 'breaks', 'unbreak', 'rows', 'memory', 'put', 'set', 'start', 'history', 'stack', 'who', 'evaluate',
  'symbols', 'attach', 'load', 'save', 'restore', 'drop', 'draw', 'explain', 'scene', 'sight', 'cost', 'lists', 'file', 'kind'];
const keys = ['machine', 'options', 'sources', 'name', 'text', 'id', 'at', 'count', 'before', 'word', 'register', 'value', 'instruction', 'device', 'file', 'scene', 'algorithm', 'camera', 'eye', 'forward', 'right', 'up', 'perspective', 'eae', 'stereo', 'immediate',
  'switches', 'memory', 'level', 'seconds', 'angle', 'priority_by_host', 'bits', 'plan', 'pieces', 'frames', 'scale', 'function', 'expression', 'points', 'slices', 'domain', 'picture', 'rotation', 'elevation', 'zoom', 'levels', 'visibility', 'condition', 'number', 'symbols', 'listing', 'lines', 'start'];
const options = {
  pdp7: ['--load', '--start', '--memory', '--eae', '--no-eae', '--set', '--switches', '--display', '--display-option', '--light-pen', '--timing', '--reader', '--disk', '--keyboard', '--console', '--max-instructions', '--max-time', '--strict', '--restore', '--trace', '--vcd'],
  i8080: ['--load', '--start', '--cpm', '--cpm-drive', '--cpm-args', '--clock', '--set', '--max-states', '--strict', '--board', '--plotter', '--terminal', '--baud', '--plotter-start', '--hold', '--parallel', '--serial', '--console', '--interrupt', '--restore', '--bus'],
};
const plain = {'--memory': ['4k', '8k', '16k', '32k'], '--display-option': [['342'], ['347'], ['342', '347']], '--board': ['ef9365', 'alt256'], '--plotter': ['calcomp', 'minigraf'], '--terminal': ['sio', '2sio'], '--console': ['ascii', 'unix'], '--load': [['program'], ['rubbish'], ['a.s'], ['rubbish@100', 'program']]};

let module = null;
let ids = [];
let asked = 0;
async function fresh() {
  module = await openModule(compiled);
  ids = [];
  module.putFile('rubbish', Uint8Array.from({length: 300}, () => dice(256)));
  module.putFile('mesh.off', 'OFF\n4 4 6\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n');
  module.ask({do: 'assemble', machine: 'pdp7', name: 'program', sources: [{name: 'a.s', text: '100/\nbegin,\tlac (5\n\tisz x\n\tjmp begin\n\tjms x\nx,\t0\n\tjmp i x\n\tstart begin\n'}]});
}
for (let n = 0; n < Number(count); ++n) {
  if (n % 500 === 0) await fresh();
  const request = {do: one(whats)};
  for (let i = dice(6); i > 0; --i) request[one(keys)] = value(0);
  if (ids.length && dice(3)) request.id = one(ids);
  if (request.do === 'make') {
    request.machine = one(['pdp7', 'i8080']);
    request.options = {'--load': one(plain['--load'])};
    for (let i = dice(4); i > 0; --i) {
      const name = one(options[request.machine]);
      request.options[name] = plain[name] ? one(plain[name]) : one([true, one(texts), [one(texts)], '5', '100']);
    }
  }
  if (request.do === 'assemble') {
    request.machine = one(['pdp7', 'i8080']);
    request.sources = [{name: 'a.s', text: Array.from({length: dice(20)}, () => `${one(['', 'x,', 'L:', 'begin,'])}\t${one(['lac', 'MVI', 'ORG', 'DB', 'hlt', 'REPT', 'IF', 'MACRO', '100/', 'start', 'END', one(texts)])} ${one(texts).slice(0, 30)}`).join('\n')}];
    request.options = dice(2) ? {'--dialect': one(['dec', 'bell', 'mac', 'm80', 'intel', 'common', 'no'])} : undefined;
  }
  if (['turn', 'turn_sight', 'stripes', 'flight'].includes(request.do)) request.scene = one(['roberts', 'boxes-2', 'mesh.off', 'rubbish', 'triangles-3-7']);
  if ((request.do === 'jones' || request.do === 'explain') && dice(2)) request.scene = one(['house', 'roberts', 'boxes-2', 'mesh.off']);
  if (request.do === 'explain' && dice(2)) request.algorithm = one(['exact', 'jones', 'skala', 'montani-re', 'willis', 'plantinga']);
  let answer;
  try {
    answer = module.ask(request);
    if (request.do === 'flight' && !answer.error) { module.fly(1e6); module.flightPicture(); }
    if (answer.id) ids = [...ids.slice(-3), answer.id];
    if (ids.length) {
      const id = one(ids);
      module.run(id, module.ticks(id) + 2e5, 5000);
      module.flashes(id);
      module.printed(id);
    }
  } catch (error) {
    console.error(`FAILED: request ${n} of seed ${first}: ${JSON.stringify(request)}: ${error.stack}`);
    process.exit(1);
  }
  if (typeof answer !== 'object' || answer === null || Array.isArray(answer)) {
    console.error(`FAILED: ${JSON.stringify(request)}: ${JSON.stringify(answer)}`);
    process.exit(1);
  }
  ++asked;
}
console.log(`${asked} requests answered`);
