// index.d.ts declares what the package has: every export, method and member, every option that the module knows, and no others.
//
//   node types_test.mjs PACKAGE_FOLDER HIDDEN_LINES.hpp

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const [folder, header] = process.argv.slice(2);
const library = await import(pathToFileURL(join(folder, 'index.js')));
const types = readFileSync(join(folder, 'index.d.ts'), 'utf8').replace(/\/\*\*[\s\S]*?\*\/|\/\/.*/g, '');
const same = (found, expected, what) => assert.deepEqual([...found].sort(), [...expected].sort(), what);

// The lines between the braces after the declaration.
function body(declaration) {
  const begin = types.indexOf(declaration);
  assert.ok(begin >= 0, `${declaration} is not declared`);
  let at = types.indexOf('{', begin), depth = 0, text = '';
  for (;; ++at) {
    depth += types[at] === '{' ? 1 : types[at] === '}' ? -1 : 0;
    if (depth === 0) return text.slice(1);
    text += types[at];
  }
}
// The names at the outermost level of a body.
const flat = text => {
  for (let before = ''; before !== text;) [before, text] = [text, text.replace(/\{[^(){}]*\}/g, '').replace(/\([^(){}]*\)/g, '@')];
  return text;
};
const members = text => [...flat(text).matchAll(/^\s*(?:readonly )?(\w+)\??:/gm)].map(match => match[1]);
const methods = text => [...text.matchAll(/^ {2}(static )?(\w+)\(/gm)].filter(match => match[2] !== 'constructor').map(match => (match[1] ?? '') + match[2]);

// --- Exports, and what classes and values they are.
const declared = [...types.matchAll(/export declare (class|function|const) (\w+)/g)];
same(declared.map(match => match[2]), Object.keys(library), 'exports');
for (const [, kind, name] of declared) {
  if (kind !== 'const') assert.equal(typeof library[name], 'function', name);
  if (kind === 'class') assert.match(String(library[name]), /^class/, name);
}
assert.equal(library.none, 0xffffffff);
assert.match(library.version, /^\d+\.\d+\.\d+$/);
assert.equal(JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')).version, library.version);
assert.deepEqual([...types.match(/kindNames: readonly \[(.*)\]/)[1].matchAll(/'(\w+)'/g)].map(match => match[1]), [...library.kindNames]);
const enumeration = readFileSync(header, 'utf8').match(/\nenum class Kind[^{]*\{\n([\s\S]*?)\};/)[1];
assert.deepEqual([...enumeration.matchAll(/^\s*(\w+),/gm)].map(match => match[1]), [...library.kindNames]);

// --- Methods and members.
const mesh = {positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0])};
const scene = await library.Scene.of(mesh);
const drawing = await scene.draw();
const error = await scene.draw({view: 'side'}).catch(thrown => thrown);
const ownMethods = type => [...Object.getOwnPropertyNames(type.prototype).filter(name => name !== 'constructor'),
                            ...Object.getOwnPropertyNames(type).filter(name => typeof type[name] === 'function').map(name => `static ${name}`)];
for (const [name, value] of Object.entries({Scene: scene, Drawing: drawing, SightlineError: error})) {
  const text = body(`export declare class ${name}`);
  same(methods(text), ownMethods(library[name]), `methods of ${name}`);
  same(members(text), Object.keys(value).filter(key => key !== 'name'), `members of ${name}`);
  for (const group of ['parts', 'edges', 'camera'].filter(each => each in value)) same(members(text.match(new RegExp(`readonly ${group}: \\{([^}]*)\\}`))[1]), Object.keys(value[group]), group);
  for (const [, member, type] of text.matchAll(/readonly (\w+): (\w+Array);/g)) {
    const found = [value, value.parts, value.edges].map(each => each[member]).filter(ArrayBuffer.isView);
    assert.ok(found.length > 0, member);
    for (const column of found) assert.equal(column.constructor.name, type, member);
  }
}

// --- Options: those that the module names when it does not know one.
const listed = async work => {
  try {
    await work();
  } catch (thrown) {
    return thrown.expected.split(', ');
  }
  return assert.fail('no error');
};
const options = name => members(body(`export interface ${name}`));
same(options('SceneOptions'), await listed(() => library.Scene.of(mesh, {no_such: 1})), 'SceneOptions');
same([...options('DrawOptions'), ...options('Camera')], await listed(() => scene.draw({no_such: 1})), 'DrawOptions');
same([...options('FileOptions'), 'format'], await listed(() => drawing.file({no_such: 1})), 'FileOptions');
same(options('Mesh'), await listed(() => library.Scene.of({no_such: 1})), 'Mesh');
same([...types.match(/type View = ([^;]*)/)[1].matchAll(/'(\w+)'/g)].map(match => match[1]), error.expected.split(', '), 'View');
same(types.match(/format\?: ([^}]*)/)[1].match(/\w+/g), (await listed(() => drawing.file({format: 'png'}))).flatMap(text => text.split(' or ')), 'formats');
