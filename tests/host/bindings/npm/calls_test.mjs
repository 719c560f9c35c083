// The package's functions: drawings counted by hand, each kind of wrong input here and in a worker, work that is aborted at any
// moment, and memory that is exhausted.
//
//   node calls_test.mjs PACKAGE_FOLDER

import assert from 'node:assert/strict';
import {cpSync, readFileSync, renameSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const folder = process.argv[2];
const {Drawing, hiddenLines, kindNames, none, Scene, SightlineError} = await import(pathToFileURL(join(folder, 'index.js')));

// Counterclockwise as seen from outside. Corners are in the order of x + 2 y + 4 z.
const quads = ['0462', '1375', '0154', '2673', '0231', '4576'];
const triangles = quads.map(([a, b, c, d]) => a + b + c + a + c + d).join('');
const corners = (low, size) => Array.from({length: 8}, (_, i) => [low[0] + (i & 1) * size[0], low[1] + (i >> 1 & 1) * size[1], low[2] + (i >> 2) * size[2]]).flat();
const cube = () => ({positions: new Float32Array(corners([0, 0, 0], [10, 10, 10])), index: Uint16Array.from(triangles, Number)});
function manyBoxes(side) {
  const positions = [], index = [];
  for (let b = 0; b < side * side; ++b) {
    const [x, y] = [b % side, Math.floor(b / side)];
    positions.push(...corners([3 * x, 0, 3 * y], [2, 1 + (x * 7 + y * 5) % 4, 2]));
    index.push(...Array.from(triangles, c => 8 * b + Number(c)));
  }
  return {positions: new Float64Array(positions), index: Uint32Array.from(index)};
}
const lengthOf = drawing => drawing.kinds.length;

async function errorOf(work) {
  try {
    await work();
  } catch (error) {
    return error;
  }
  assert.fail('no error');
}
async function rejects(work, kind, message) {
  const error = await errorOf(work);
  assert.ok(error instanceof SightlineError, String(error));
  assert.equal(error.kind, kind, error.message);
  if (message instanceof RegExp) assert.match(error.message, message);
  else assert.equal(error.message, message);
  assert.ok(error.found, error.message);
  return error;
}
const isAbort = error => error instanceof DOMException && error.name === 'AbortError';

const tests = {
  async 'of a cube nine edges are visible and three are hidden'() {
    for (const worker of [false, true]) {
      const drawing = await hiddenLines(cube(), {view: 'iso', hidden: true, worker});
      assert.equal(lengthOf(drawing), 12);
      assert.equal(drawing.hidden.reduce((a, b) => a + b), 3);
      assert.deepEqual(drawing.kinds.reduce((counts, kind) => ({...counts, [kindNames[kind]]: (counts[kindNames[kind]] ?? 0) + 1}), {}), {silhouette: 6, crease: 6});
      assert.deepEqual([...drawing.parts.fractions.subarray(0, 4)], [0n, 1n, 1n, 1n]);
      assert.equal(drawing.edges.ends.length, 72);
      assert.equal(drawing.edges.faceOffsets.at(-1), drawing.edges.faces.length);
      assert.equal(drawing.lineEdgeOffsets.at(-1), drawing.lineEdges.length);
      assert.equal(drawing.camera.perspective, false);
      assert.equal(lengthOf(await hiddenLines(cube(), {view: 'iso', worker})), 9);
    }
  },

  async 'triangles with index, triangles without, and faces are one mesh'() {
    const {positions, index} = cube();
    const soup = new Float32Array([...index].flatMap(v => [...positions.subarray(3 * v, 3 * v + 3)]));
    const meshes = [{positions, index}, {positions: Float64Array.from(positions), index: Uint32Array.from(index)}, {positions: soup},
                    {positions, faces: quads.map(quad => Array.from(quad, Number))}, {positions, faces: quads.map(quad => Uint8Array.from(quad, Number))}];
    const expected = (await hiddenLines(meshes[0], {view: 'iso'})).svg();
    for (const mesh of meshes) assert.equal((await hiddenLines(mesh, {view: 'iso'})).svg(), expected);
  },

  // Parts between which the face that hides them stays the same are one.
  async 'a line is seen through the hole of a face'() {
    // A plate with a hole from 4 to 6 in front of a line from -2 to 12: visible from -2 to 0, 4 to 6, and 10 to 12.
    const positions = new Float64Array([0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0, 4, 4, 0, 4, 6, 0, 6, 6, 0, 6, 4, 0, -2, 5, -4, 12, 5, -4]);
    const mesh = {positions, faces: [[[0, 1, 2, 3], [4, 5, 6, 7]]], polylines: [[8, 9]]};
    const drawing = await hiddenLines(mesh, {direction: [0, 0, -1], hidden: true});
    const parts = [];
    for (let p = 0; p < drawing.parts.edges.length; ++p) {
      if (kindNames[drawing.edges.kinds[drawing.parts.edges[p]]] !== 'polyline') continue;
      const part = [...[...drawing.parts.fractions.subarray(4 * p, 4 * p + 4)].map(Number), drawing.parts.hidden[p], drawing.parts.hiddenBy[p]];
      if (parts.at(-1)?.[5] === part[5]) parts.at(-1).splice(2, 2, part[2], part[3]);
      else parts.push(part);
    }
    assert.deepEqual(parts, [[0, 1, 1, 7, 0, none], [1, 7, 3, 7, 1, 0], [3, 7, 4, 7, 0, none], [4, 7, 6, 7, 1, 0], [6, 7, 1, 1, 0, none]]);
    const onlyLines = await hiddenLines({positions, polylines: [[8, 9]]});
    assert.equal(lengthOf(onlyLines), 1);
    assert.equal(onlyLines.edges.bodies[0], none);
  },

  async 'faces and vertices have the numbers of the mesh'() {
    const bodies = new Uint32Array(48).map((_, face) => [3, 0, 2, 1][Math.floor(face / 12)]);
    for (const mend of [true, false]) {
      const {edges} = await hiddenLines({...manyBoxes(2), bodies}, {view: 'iso', hidden: true, mend});
      assert.equal(edges.kinds.length, 48);
      for (let e = 0; e < 48; ++e)
        for (const face of edges.faces.subarray(edges.faceOffsets[e], edges.faceOffsets[e + 1]))
          for (const vertex of edges.vertices.subarray(2 * e, 2 * e + 2)) assert.equal(Math.floor(face / 12), Math.floor(vertex / 8));
    }
  },

  async 'axes, scale and low tell where a point is drawn'() {
    for (const camera of [{view: 'iso'}, {eye: [30, 25, 40]}]) {
      const drawing = await hiddenLines(cube(), {...camera, width: 150, height: 100});
      assert.equal(lengthOf(drawing), 9);
      assert.deepEqual([drawing.width, drawing.height], [150, 100]);
      const {perspective, eye, axes, scale, low} = drawing.camera;
      for (let line = 0; line < 9; ++line) {
        const edge = drawing.lineEdges[drawing.lineEdgeOffsets[line]];
        const places = [0, 1].map(end => {
          const point = drawing.edges.ends.subarray(6 * edge + 3 * end, 6 * edge + 3 * end + 3);
          const along = axis => axes[axis].reduce((sum, c, a) => sum + c * (point[a] - eye[a]), 0);
          return [0, 1].map(axis => scale * (along(axis) / (perspective ? along(2) : 1) - low[axis]));
        }).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
        const found = [...drawing.lines.subarray(4 * line, 4 * line + 4)];
        const [a, b] = [found.slice(0, 2), found.slice(2)].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
        for (const [p, q] of [[a, places[0]], [b, places[1]]]) assert.ok(Math.hypot(p[0] - q[0], p[1] - q[1]) < 1e-6, `${p} ${q}`);
      }
    }
  },

  async 'a scene tells what it is, and draws many views'() {
    for (const worker of [false, true]) {
      const scene = await Scene.of(cube(), {worker});
      assert.deepEqual([scene.faceCount, scene.vertexCount, scene.bounds, scene.step, scene.notes], [12, 8, [[0, 0, 0], [10, 10, 10]], 1, []]);
      const front = await scene.draw({view: 'front'});
      assert.equal(lengthOf(front), 4);
      assert.equal(lengthOf(await scene.draw({view: 'iso'})), 9);
      assert.equal(lengthOf(await scene.draw({view: 'iso', hidden: true})), 12);
      assert.equal(lengthOf(await scene.draw({view: 'iso', edges: 'silhouette'})), 6);
      const together = await Promise.all(['front', 'iso', 'top'].map(view => scene.draw({view})));
      assert.deepEqual(together.map(lengthOf), [4, 9, 4]);
      scene.free();
      assert.equal(lengthOf(front), 4);
      assert.match(front.svg(), /^<\?xml/);
      await rejects(() => scene.draw(), 'usage', 'scene: found a freed one, expected one that was not freed');
      scene.free();
    }
    const rounded = await Scene.of({positions: new Float64Array([0, 0, 0, Math.PI, 0, 0, 0, Math.E, 0])});
    assert.match(rounded.notes[0], /^coordinates rounded to a step of /);
  },

  async 'files have the beginning of their format, and a title'() {
    const drawing = await hiddenLines(cube());
    const text = new TextDecoder('latin1');
    for (const [format, beginning] of Object.entries({svg: '<?xml', pdf: '%PDF-', dxf: '  0\nSECTION', hpgl: 'IN;'}))
      assert.equal(text.decode(drawing.file({format})).slice(0, beginning.length), beginning);
    assert.match(drawing.svg({title: 'a < b'}), /<title>a &lt; b<\/title>/);
    assert.match(drawing.svg({margin: 0}), /width="200.000mm"/);
    assert.equal((await errorOf(() => drawing.file({format: 'bmp'}))).message, 'format: found "bmp", expected svg, pdf, dxf, hpgl, png or steps');
    assert.equal((await errorOf(() => drawing.file({format: 'png'}))).message, 'format: found "png", expected svg, pdf, dxf, hpgl or steps');
    assert.equal((await errorOf(() => drawing.svg({pen: 'thick'}))).message, 'pen: found "thick", expected a number');
    assert.equal((await errorOf(() => drawing.svg({Title: ''}))).message, 'Title: no such option, expected format, title, margin, pen, asFound');
  },

  async 'damage of a mesh is named with its place'() {
    const wrong = {
      'mesh: found null, expected an object with positions': null,
      'mesh: found an array of 3, expected an object with positions': [1, 2, 3],
      'mesh: indices: found no such member, expected positions, index, faces, polylines, bodies': {...cube(), indices: []},
      'mesh: positions: found undefined, expected a Float32Array or Float64Array': {},
      'mesh: positions: found an array of 9, expected a Float32Array or Float64Array': {positions: [0, 0, 0, 1, 0, 0, 0, 1, 0]},
      'mesh: positions: found Int32Array of 9, expected a Float32Array or Float64Array': {positions: new Int32Array(9)},
      'mesh: positions: found 10 numbers, expected a multiple of 9 without index': {positions: new Float32Array(10)},
      'mesh: positions: found 25 numbers, expected a multiple of 3': {...cube(), positions: new Float32Array(25)},
      'mesh: index: found an array of 3, expected a Uint32Array or Uint16Array': {...cube(), index: [0, 1, 2]},
      'mesh: index: found null, expected a Uint32Array or Uint16Array': {...cube(), index: null},
      'mesh: index: found 4 numbers, expected a multiple of 3': {...cube(), index: new Uint16Array(4)},
      'mesh: index[2]: found vertex 8, expected a number below 8': {...cube(), index: new Uint16Array([0, 1, 8])},
      'mesh: faces: found besides index, expected one of them': {...cube(), faces: []},
      'mesh: faces: found "abc", expected an array of faces': {...cube(), index: undefined, faces: 'abc'},
      'mesh: faces[0]: found 7, expected an array of vertex numbers, or of an outline and holes': {...cube(), index: undefined, faces: [7]},
      'mesh: faces[1]: found 2 vertices, expected at least 3': {...cube(), index: undefined, faces: [[0, 1, 2], [0, 1]]},
      'mesh: faces[0][2]: found vertex 8, expected a number below 8': {...cube(), index: undefined, faces: [[0, 1, 8]]},
      'mesh: faces[0][2]: found vertex -1, expected a number below 8': {...cube(), index: undefined, faces: [[0, 1, -1]]},
      'mesh: faces[0][1]: found 0.5, expected a number below 8': {...cube(), index: undefined, faces: [[0, 0.5, 1]]},
      'mesh: faces[0][1]: found 5, expected an array of vertex numbers': {...cube(), index: undefined, faces: [[[0, 1, 2], 5]]},
      'mesh: faces[0][1][0]: found "0", expected a number below 8': {...cube(), index: undefined, faces: [[[0, 1, 2], ['0', 1, 2]]]},
      'mesh: polylines: found 1, expected an array of polylines': {...cube(), polylines: 1},
      'mesh: polylines[0]: found 1 vertices, expected at least 2': {...cube(), polylines: [[1]]},
      'mesh: polylines[0][1]: found null, expected a number below 8': {...cube(), polylines: [[1, null]]},
      'mesh: bodies: found 1 numbers, expected 12, one for each face': {...cube(), bodies: [0]},
      'mesh: bodies[0]: found -1, expected a number of a body, from 0': {...cube(), bodies: [-1]},
      'mesh: bodies[11]: found 4294967295, expected a number below 12, the number of faces': {...cube(), bodies: [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4294967295]},
      'mesh: vertex 2: found nan, expected a finite number': {positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, NaN, 0])},
      'mesh: vertex 1: found inf, expected a finite number': {positions: new Float64Array([0, 0, 0, 1, Infinity, 0, 0, 1, 0])},
      'mesh: found no faces, expected a mesh; points alone make no drawing': {positions: new Float32Array(0)},
    };
    for (const [message, mesh] of Object.entries(wrong)) {
      for (const worker of [false, true]) {
        const error = await rejects(() => hiddenLines(mesh, {worker}), 'bad_input', message);
        assert.equal(error.argument, 'mesh');
        assert.equal(error.message, `mesh: ${error.place ? `${error.place}: ` : ''}${error.found}${error.expected ? `, expected ${error.expected}` : ''}`
                                    + (error.message.includes(';') ? '; points alone make no drawing' : ''));
      }
    }
  },

  async 'wrong options and cameras are named'() {
    const usage = {
      'options: found 5, expected an object': 5,
      'lookat: no such option, expected view, perspective, direction, eye, lookAt, up, vertical, edges, crease, hidden, width, height, scale, field, minLength': {lookat: [0, 0, 0]},
      'hidden: found 1, expected true or false': {hidden: 1},
      'view: found 3, expected a text': {view: 3},
      'view: found null, expected a text': {view: null},
      'eye: found an array of 2, expected three numbers': {eye: [1, 2]},
      'lookAt: found an array of 3, expected three numbers': {lookAt: [1, 2, '3']},
      'up: found a function, expected three numbers': {up: () => 0},
      'width: found "10", expected a number': {width: '10'},
      'width: found nan, expected a number above 0, at most 1e9': {width: NaN},
      'width: found -1, expected a number above 0, at most 1e9': {width: -1},
      'minLength: found -1, expected a finite number, at least 0': {minLength: -1},
      'planarTolerance: found -1, expected a finite number, at least 0': {planarTolerance: -1},
      'mend: found false with weld or planarTolerance, expected true': {mend: false, weld: 1},
      'mend: found an object, expected true or false': {mend: {}},
      'crease: found inf, expected a finite number of degrees': {crease: Infinity},
      'eye: found besides view, expected one of them': {view: 'iso', eye: [1, 2, 3]},
      'look_at: found this name, expected lookAt': {eye: [40, 30, 50], look_at: [0, 0, 0]},
      'direction: found 0,0,0, expected a direction': {direction: [0, 0, 0]},
      'scale: found in perspective, expected parallel projection': {eye: new Float32Array([30, 30, 30]), scale: 2},
      'field: found in parallel projection, expected perspective, or scale': {view: 'iso', field: 60},
      'signal: found an object, expected an AbortSignal': {signal: {}},
      'progress: found true, expected a function': {progress: true},
      'worker: found "yes", expected true or false': {worker: 'yes'},
    };
    for (const [message, options] of Object.entries(usage))
      for (const worker of options.worker ? [options.worker] : [false, true])
        await rejects(() => hiddenLines(cube(), typeof options === 'object' ? {...options, worker} : options), 'usage', message);
    await rejects(() => hiddenLines(cube(), {view: 'side'}), 'usage', /^view: found "side", expected front, back, /);
    const inside = await rejects(() => hiddenLines(cube(), {eye: [5, 5, 5]}), 'bad_input', /inside this solid/);
    assert.equal(inside.argument, 'mesh');
    await rejects(async () => (await Scene.of(cube())).draw({worker: true}), 'usage', 'worker: found true, expected the option of Scene.of');
    await rejects(() => new Scene(), 'usage', /Scene\.of/);
    await rejects(() => new Drawing(), 'usage', /scene\.draw/);
    // An error leaves the scene as it was.
    for (const worker of [false, true]) {
      const scene = await Scene.of(cube(), {worker});
      await rejects(() => scene.draw({view: 'side'}), 'usage', /^view/);
      assert.equal(lengthOf(await scene.draw({view: 'iso'})), 9);
      scene.free();
    }
  },

  async 'progress ascends, and what it throws the caller gets'() {
    const mesh = manyBoxes(20);
    for (const worker of [false, true]) {
      const told = [];
      await hiddenLines(mesh, {view: 'iso', hidden: true, worker, progress: done => { told.push(done); }});
      assert.ok(told.length > 3);
      assert.ok(told.every((done, i) => done >= (told[i - 1] ?? 0) && done <= 1), String(told));
      for (const at of [0, 2, told.length - 1]) {
        let calls = 0;
        const error = await errorOf(() => hiddenLines(mesh, {view: 'iso', hidden: true, worker, progress() { if (calls++ === at) throw new RangeError('mine'); }}));
        assert.equal(error.message, 'mine');
      }
    }
  },

  async 'a worker is ended at any moment, and afterwards the scene draws as before'() {
    const mesh = manyBoxes(40);
    const options = {view: 'iso', hidden: true};
    const scene = await Scene.of(mesh, {worker: true});
    const begun = performance.now();
    const expected = (await scene.draw(options)).svg();
    const whole = performance.now() - begun;
    let aborted = 0;
    const moments = 12;
    for (let moment = 0; moment <= moments; ++moment) {
      const stop = new AbortController();
      const timer = setTimeout(() => stop.abort(), whole * moment / moments);
      // Some are whole before the moment comes.
      const work = moment % 2 ? hiddenLines(mesh, {...options, worker: true, signal: stop.signal}) : scene.draw({...options, signal: stop.signal});
      const result = await work.catch(error => error);
      clearTimeout(timer);
      if (result instanceof Drawing) {
        assert.equal(result.svg(), expected);
      } else {
        assert.ok(isAbort(result), String(result));
        ++aborted;
      }
      if (moment % 3 === 0) assert.equal((await scene.draw(options)).svg(), expected);
    }
    assert.ok(aborted > 0);
    // Moments that do not depend on the clock: before the call, at each message of progress.
    const before = await errorOf(() => scene.draw({...options, signal: AbortSignal.abort()}));
    assert.ok(isAbort(before), String(before));
    for (const worker of [false, true]) {
      for (const at of [0, 1, 3, 5]) {
        let calls = 0;
        const stop = new AbortController();
        const error = await errorOf(() => hiddenLines(mesh, {...options, worker, signal: stop.signal, progress() { if (calls++ === at) stop.abort(); }}));
        assert.ok(isAbort(error), String(error));
        assert.equal(calls, at + 1, 'no call after the last one');
      }
    }
    assert.equal(await errorOf(() => scene.draw({...options, signal: AbortSignal.abort('mine')})), 'mine');
    // Others that wait are done.
    const stop = new AbortController();
    const first = scene.draw({...options, signal: stop.signal, progress: () => stop.abort()});
    const second = scene.draw(options);
    assert.ok(isAbort(await errorOf(() => first)));
    assert.equal((await second).svg(), expected);
    // Freed in the middle of the work.
    const [third, fourth] = [scene.draw({...options, progress: () => scene.free()}), scene.draw(options)].map(work => work.catch(error => error));
    assert.equal((await third).kind, 'cancelled');
    assert.match((await fourth).message, /freed/);
    assert.equal((await hiddenLines(mesh, {...options, worker: true})).svg(), expected);
  },

  // The module's memory is limited by its own file.
  async 'exhausted memory is an error, and the next call works'() {
    const small = `${folder}-small`;
    cpSync(folder, small, {recursive: true});
    writeFileSync(join(small, 'sightline.wasm'), withMemory(readFileSync(join(folder, 'sightline.wasm')), 40));
    const limited = await import(pathToFileURL(join(small, 'index.js')));
    const options = {view: 'iso', hidden: true};
    for (const worker of [false, true]) {
      for (const side of [20, 100]) {
        const error = await errorOf(() => limited.hiddenLines(manyBoxes(side), {...options, worker}));
        assert.ok(error instanceof limited.SightlineError, String(error));
        assert.equal(error.kind, 'out_of_memory', error.message);
        assert.match(error.message, /^out of memory/);
        assert.equal(lengthOf(await limited.hiddenLines(cube(), {...options, worker})), 12);
      }
      // A scene for which there is memory, but not for all its drawings.
      const mesh = manyBoxes(12);
      const scene = await limited.Scene.of(mesh, {worker});
      const front = (await scene.draw({view: 'front'})).svg();
      const error = await errorOf(() => scene.draw(options));
      assert.equal(error.kind, 'out_of_memory', error.message);
      assert.equal((await scene.draw({view: 'front'})).svg(), front);
      scene.free();
    }
  },

  async 'a missing file is an error, and the next call looks for it again'() {
    const broken = `${folder}-broken`;
    cpSync(folder, broken, {recursive: true});
    const missing = name => renameSync(join(broken, name), join(broken, `${name}.away`));
    const there = name => renameSync(join(broken, `${name}.away`), join(broken, name));
    missing('sightline.wasm');
    const {hiddenLines: draw} = await import(pathToFileURL(join(broken, 'index.js')));
    const error = await errorOf(() => draw(cube()));
    assert.equal(error.kind, 'io');
    assert.match(error.message, /sightline\.wasm: ENOENT/);
    there('sightline.wasm');
    assert.equal(lengthOf(await draw(cube(), {view: 'iso'})), 9);
    missing('worker.js');
    const unstarted = await errorOf(() => draw(cube(), {worker: true}));
    assert.equal(unstarted.kind, 'io');
    assert.match(unstarted.message, /^the worker failed: /);
    there('worker.js');
    assert.equal(lengthOf(await draw(cube(), {view: 'iso', worker: true})), 9);
  },

  // Two thousand instances one after the other, some kept.
  async 'memory of scenes is given up'() {
    const kept = [];
    for (let n = 0; n < 2000; ++n) {
      const scene = await Scene.of(cube());
      if (n % 20 === 0) kept.push(scene);
    }
    for (const scene of kept) assert.equal(lengthOf(await scene.draw({view: 'iso'})), 9);
  },
};

// The module with a limit of 64 KiB pages in its memory section (id 5: one memory, flags, least and most pages).
function withMemory(bytes, pages) {
  const parts = [bytes.subarray(0, 8)];
  let at = 8;
  const number = () => {
    let result = 0;
    for (let shift = 0;; shift += 7) {
      const byte = bytes[at++];
      result |= (byte & 127) << shift;
      if (byte < 128) return result;
    }
  };
  const leb = n => (n < 128 ? [n] : [n & 127 | 128, ...leb(n >>> 7)]);
  let found = false;
  while (at < bytes.length) {
    const begin = at;
    const id = bytes[at++];
    const end = number() + at;
    if (id === 5) {
      at += 2;
      const least = number();
      const content = [1, 1, ...leb(least), ...leb(pages)];
      parts.push(Buffer.from([5, ...leb(content.length), ...content]));
      found = true;
    } else {
      parts.push(bytes.subarray(begin, end));
    }
    at = end;
  }
  assert.ok(found);
  return Buffer.concat(parts);
}

let failures = 0;
for (const [name, test] of Object.entries(tests)) {
  if (process.argv[3] && !name.includes(process.argv[3])) continue;
  const begun = performance.now();
  try {
    await test();
    console.log(`${name}: ${Math.round(performance.now() - begun)} ms`);
  } catch (error) {
    ++failures;
    console.error(`FAILED: ${name}: ${error.stack}`);
  }
}
process.exitCode = failures ? 1 : 0;
