// The page's expressions compared with muParser's, which the command uses: both accept or both reject a text, and the program on
// the 8080
// takes the same T-states for its picture, which depend on the smallest difference of a height.
//
//   node expression_test.mjs MODULE.wasm MODULE.js EXPRESSION.js SIGHTLINE

import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const [wasm, script, expressions, sightline] = process.argv.slice(2);
const {openModule} = await import(pathToFileURL(script));
const {expression, sampled} = await import(pathToFileURL(expressions));
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
  let answer;
  try {
    answer = module.ask({do: 'cost', ...sampled(text, 1, 9, 9), rotation: 30, elevation: 30});
  } catch (error) {
    answer = {error: error.message};
  }
  if ((run.status === 0) !== !answer.error) {
    fail(`"${text}": the page says ${answer.error ?? 'nothing'}, the command ends with ${run.status}: ${run.stderr.trim()}`);
  } else if (run.status === 0 && JSON.parse(run.stdout).t_states !== answer.with) {
    fail(`"${text}": ${answer.with} T-states, the command's ${JSON.parse(run.stdout).t_states}`);
  }
}
// By hand: cases in which both could have the same error.
for (const [text, x, z, expected] of [['2^3^2', 0, 0, 512], ['-2^2', 0, 0, -4], ['7-4-2', 0, 0, 1], ['16/4/2', 0, 0, 2], ['1+2*3', 0, 0, 7], ['x>z?1:2', 1, 0, 1], ['x>z?1:2', 0, 1, 2], ['min(3,1,2)', 0, 0, 1]]) {
  const found = expression(text)(x, z);
  if (found !== expected) fail(`${text}: found ${found}, expected ${expected}`);
}
for (const deep of ['('.repeat(5000), 'sin('.repeat(5000), '-'.repeat(5000) + 'x', 'x?'.repeat(5000)]) {
  try { expression(deep); fail('a text that is too deep is taken'); } catch (error) { if (error instanceof RangeError) fail('a text that is too deep ends in a full stack'); }
}
console.log(`${texts.length} expressions, ${failures} failed`);
process.exit(failures ? 1 : 0);
