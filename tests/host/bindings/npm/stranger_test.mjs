// A stranger's path: the first program of the package's README, in an empty folder with the package in node_modules. Its SVG must
// show the tetrahedron from the corner of a cube: a triangle of three equal sides, as wide as the drawing.
//
//   node stranger_test.mjs PACKAGE_FOLDER

import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

const folder = process.argv[2];
const home = join(folder, '..', '..');
const text = readFileSync(join(folder, 'README.md'), 'utf8');
const program = text.match(/## First drawing\n\n```js\n([\s\S]*?)```/)[1];
assert.ok(program.split('\n').length <= 11);
writeFileSync(join(home, 'first.mjs'), program);
execFileSync(process.execPath, ['first.mjs'], {cwd: home, stdio: 'inherit'});
const svg = readFileSync(join(home, 'tetrahedron.svg'), 'utf8');
assert.match(svg, /<svg [^>]*width="220.000mm" height="220.000mm"/);
const paths = [...svg.matchAll(/<path d="M([^"]*)"/g)].map(match => match[1].split('l')[1].match(/-?[\d.]+/g).map(Number));
assert.equal(paths.length, 1);
const sides = [0, 2, 4].map(i => Math.hypot(paths[0][i], paths[0][i + 1]));
assert.equal(paths[0].length, 6);
for (const side of sides) assert.ok(Math.abs(side - 200) < 0.01, String(sides));
for (const axis of [0, 1]) assert.ok(Math.abs(paths[0][axis] + paths[0][2 + axis] + paths[0][4 + axis]) < 0.002, 'it ends where it began');

// A program on the command line whose scene is in a worker, and is not freed: the process ends all the same.
const inWorker = `
  import {Scene} from 'sightline-hidden-lines';
  const scene = await Scene.of({positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0])}, {worker: true});
  console.log((await scene.draw()).kinds.length);`;
assert.equal(execFileSync(process.execPath, ['--input-type=module', '-e', inWorker], {cwd: home, encoding: 'utf8', timeout: 60000}), '3\n');
// CommonJS.
const common = `import('sightline-hidden-lines').then(({version}) => console.log(version))`;
assert.match(execFileSync(process.execPath, ['-e', common], {cwd: home, encoding: 'utf8', timeout: 60000}), /^[0-9.]+\n$/);

// Every other file that package.json or a script names is there.
for (const name of ['worker.js', 'sightline.wasm', 'index.d.ts', 'LICENSE', 'example.html']) assert.ok(readFileSync(join(folder, name)).length > 0, name);
const names = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
assert.equal(names.name, 'sightline-hidden-lines');
for (const file of ['index.js', 'mesh.js', 'module.js', 'worker.js'])
  for (const [, imported] of readFileSync(join(folder, file), 'utf8').matchAll(/(?:from|URL\() ?'(\.\/[^']+)'/g)) readFileSync(join(folder, imported));
