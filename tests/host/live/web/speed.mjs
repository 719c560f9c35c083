// The speed of the machines in the module, in Node, measured in turn with the command. Run by hand:
//
//   node speed.mjs MODULE.wasm MODULE.js SIGHTLINE [SECONDS]
//
// The programs are those of tests/bench: a PDP-7's loop with an idle display, the same while 200 vectors are refreshed and each
// flash is
// passed on as the page receives it, and an 8080's mix. Times are processor times, so that other work on the computer has little
// effect.

import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const [wasm, script, sightline, seconds = '2'] = process.argv.slice(2);
const {openModule} = await import(pathToFileURL(script));
const module = await openModule(new WebAssembly.Module(readFileSync(wasm)));
const folder = mkdtempSync(join(tmpdir(), 'sightline-speed-'));
process.on('exit', () => rmSync(folder, {recursive: true, force: true}));

const octal = blocks => Object.entries(blocks).map(([at, words]) => `${Number(at).toString(8)}:\n${words.map(w => w.toString(8).padStart(6, '0')).join(' ')}\n`).join('');
// LAC, TAD, DAC, ISZ, JMP; the second JMP is for the one ISZ in 2^18 that skips.
const loop = {0o100: [0o200110, 0o340111, 0o040110, 0o440112, 0o600100, 0o600100, 0o740040, 0o740040, 0, 3, 0]};
// 100 lines, each placed by two point words and drawn by two vectors of 60 steps; the interrupt restarts the display.
const picture = [];
for (let line = 0; line < 100; ++line) picture.push(0o020117, 0o220000 | 100 + line * 8, 0o100000 | 200, 0o200000 | 0o74 << 8 | 0o44, 0o600000 | 0o44 << 8 | 0o74);
picture.push(0o003000);
const refresh = {...loop, 1: [0o040030, 0o200032, 0o700606, 0o200030, 0o700042, 0o620000], 0o30: [0, 0, 0o1000], 0o60: [0o200032, 0o700606, 0o700042, 0o600100], 0o1000: picture};
// MVI, ADD M, DAD, PUSH, CALL, branches: registers, memory, stack.
const mix = [0x31, 0x00, 0x20, 0x21, 0x00, 0x10, 0x06, 0x40, 0xAF, 0x86, 0x77, 0x23, 0xE5, 0xCD, 0x18, 0x00, 0xE1, 0x05, 0xC2, 0x09, 0x00, 0xC3, 0x03, 0x00, 0x07, 0x4F, 0x79, 0xC9];

const machines = [
  {name: 'PDP-7, loop, display idle', machine: 'pdp7', options: {'--display': true}, file: 'loop.oct', text: octal(loop), start: 0o100},
  {name: 'PDP-7, 200 vectors refreshed', machine: 'pdp7', options: {'--display': true}, file: 'refresh.oct', text: octal(refresh), start: 0o60, words: ['--png', 'out.png']},
  {name: '8080, mix', machine: 'i8080', options: {}, file: 'mix.bin', text: Uint8Array.from(mix), start: 0},
];

for (const each of machines) {
  module.putFile(each.file, each.text);
  writeFileSync(join(folder, each.file), each.text);
  const second = each.machine === 'pdp7' ? 1e9 : 1e6;
  const load = each.machine === 'pdp7' ? [each.file] : [`${each.file}@0`];
  const made = module.ask({do: 'make', machine: each.machine, options: {...each.options, '--load': load}});
  if (made.error) throw new Error(made.error);
  module.ask({do: 'start', id: made.id, at: each.start});
  let flashes = 0;
  const slice = each.machine === 'pdp7' ? 0.05 * second : second;
  const run = host => {
    const begun = process.cpuUsage();
    const before = [module.instructions(made.id), module.ticks(made.id)];
    let spent = 0;
    while ((spent = process.cpuUsage(begun).user / 1e6) < host) {
      for (let n = 0; n < 30; ++n) {  // reading the clock takes some time
        module.run(made.id, module.ticks(made.id) + slice);
        flashes += module.flashes(made.id).count;
      }
    }
    return {instructions: (module.instructions(made.id) - before[0]) / spent, ticks: (module.ticks(made.id) - before[1]) / spent, emulated: module.ticks(made.id) - before[1]};
  };
  run(0.5);  // until the engine has optimised it
  flashes = 0;
  const here = run(Number(seconds));
  const limit = each.machine === 'pdp7' ? ['--max-time', String(Math.round(here.emulated / 1e6) / 1e3)] : ['--max-states', String(Math.round(here.emulated))];
  const command = spawnSync('/bin/bash', ['-c', 'TIMEFORMAT=%U; time "$@" >/dev/null 2>/dev/null', 'bash', sightline, 'run', each.machine, '--load', load[0],
    '--start', each.start.toString(each.machine === 'pdp7' ? 8 : 16), ...(each.options['--display'] ? ['--display'] : []), ...limit, ...(each.words ?? [])], {cwd: folder, encoding: 'utf8'});
  const native = Number(command.stderr);
  const unit = each.machine === 'pdp7' ? [here.instructions, 'instructions'] : [here.ticks, 'T-states'];
  const spent = here.emulated / here.ticks;
  console.log(`${each.name}: ${(unit[0] / 1e6).toFixed(1)} million ${unit[1]} a second, ${(here.ticks / (each.machine === 'pdp7' ? 1e9 : 3e6)).toFixed(0)} times the machine, ${(flashes / spent / 1e6).toFixed(1)} million flashes a second; the command takes ${(native / spent).toFixed(2)} of the time`);
}
