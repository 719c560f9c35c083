// Expressions of the page compared with those of the command: both take a text or both refuse it, and the program on the 8080 takes
// the same T-states for its picture, which the least difference of a height changes.
//
//   node expression_test.mjs MODULE.wasm MODULE.js SIGHTLINE

import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const [wasm, script, sightline] = process.argv.slice(2);
const {openModule} = await import(pathToFileURL(script));
const module = await openModule(new WebAssembly.Module(readFileSync(wasm)));
const folder = mkdtempSync(join(tmpdir(), 'sightline-expressions-'));
process.on('exit', () => rmSync(folder, {recursive: true, force: true}));

const texts = ['x+z', 'x*y-y', 'x+y*z', 'y?z:x', 'sin(x)*cos(z)', '2^3^2*x', '-x^2', '(-x)^2', 'x-z-1', 'x/2/4', 'exp(-x*x-z*z)', 'sqrt(abs(x))', 'x>0?z:-z', 'x<=0 && z>=0', 'min(x,z,0.5)', 'max(x,1)', 'atan2(x,z+2)',
  'ln(x+3)', 'log(x+3)', 'log10(x+3)', 'log2(x+3)', '1e-1*x', '.5*z', 'sum(x,z,1)', 'avg(x,z)', 'x==z', 'x!=z', 'x||z', 'sign(x)', 'rint(2*x)', 'sinh(x)+cosh(z)-tanh(x)', 'asin(x/2)+acos(z/2)', '+x', '- -x', '2*-x',
  'x?1:z?2:3', '1<2', '_pi*x', 'pi*x', '_e*x', 'e*x', 'x+', 'foo(x)', 'sin()', 'sin(x,z)', '(x', 'x)', 'x z', '1..2', 'y', '', 'x=1', 'sin x', '"a"', 'x^', '?x:z', '2x', '0x10*x', 'x,z', 'x>>1', '!x', 'x&z', 'x%2', '1/0', 'sqrt(-1)'];
let failures = 0;
const fail = text => { ++failures; console.error(`FAILED: ${text}`); };
for (const text of texts) {
  const run = spawnSync(sightline, ['skala', 'lines', '--function', text, '--domain', '-1:1', '--points', '9', '--slices', '9', '--rotate', '30', '--elevate', '30', '--json', '-o', folder], {encoding: 'utf8', cwd: folder});
  const answer = module.ask({do: 'cost', expression: text, domain: 1, points: 9, slices: 9, rotation: 30, elevation: 30});
  if ((run.status === 0) !== !answer.error) {
    fail(`"${text}": the page says ${answer.error ?? 'nothing'}, the command ends with ${run.status}: ${run.stderr.trim()}`);
  } else if (run.status === 0 && JSON.parse(run.stdout).t_states !== answer.with) {
    fail(`"${text}": ${answer.with} T-states, the command's ${JSON.parse(run.stdout).t_states}`);
  }
}
console.log(`${texts.length} expressions, ${failures} failed`);
process.exit(failures ? 1 : 0);
