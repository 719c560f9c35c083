// The WebAssembly module (module.cpp) as functions of JavaScript, and its errors. Works in pages, in Node and in workers.

// A failure. `message` names the argument, the place in it, what was found and what was expected, as do the properties.
export class SightlineError extends Error {
  constructor(message, properties) {
    super(message);
    this.name = 'SightlineError';
    this.kind = properties.kind;
    this.argument = properties.argument ?? '';
    this.place = properties.place ?? '';
    this.found = properties.found ?? '';
    this.expected = properties.expected ?? '';
  }
}

// An error of an argument, in the words that the module uses.
export function wrongArgument(kind, argument, found, expected, place = '') {
  const text = `${argument}: ${place ? `${place}: ` : ''}found ${found}${expected ? `, expected ${expected}` : ''}`;
  return new SightlineError(text, {kind, argument, place, found: `found ${found}`, expected});
}

// Also of arrays that another window has made.
export const typeOf = value => Object.prototype.toString.call(value).slice(8, -1);
export const isList = value => Array.isArray(value) || (ArrayBuffer.isView(value) && typeOf(value) !== 'DataView');

// What a value is, for errors.
export function describe(value) {
  if (value === null || value === undefined || typeof value === 'number' || typeof value === 'boolean') return String(value);
  if (typeof value === 'string') return `"${value}"`;
  if (isList(value)) return `${Array.isArray(value) ? 'an array' : typeOf(value)} of ${value.length}`;
  return typeof value === 'function' ? 'a function' : typeof value === 'object' ? 'an object' : `a ${typeof value}`;
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

// The names of options in JavaScript and in the module.
const camelNames = {look_at: 'lookAt', min_length: 'minLength', planar_tolerance: 'planarTolerance', as_found: 'asFound'};
const moduleNames = Object.fromEntries(Object.entries(camelNames).map(([there, here]) => [here, there]));
const inCamels = text => text.replace(/\b(look_at|min_length|planar_tolerance|as_found)\b/g, name => camelNames[name]);

// The columns of a drawing: the module's names and the types of their numbers.
const columns = {
  lines: Float64Array, kinds: Uint8Array, hidden: Uint8Array, lineEdges: Uint32Array, lineEdgeOffsets: Uint32Array,
  'parts.edges': Uint32Array, 'parts.fractions': BigInt64Array, 'parts.hidden': Uint8Array, 'parts.hiddenBy': Uint32Array,
  'edges.kinds': Uint8Array, 'edges.ends': Float64Array, 'edges.vertices': Uint32Array, 'edges.bodies': Uint32Array,
  'edges.faces': Uint32Array, 'edges.faceOffsets': Uint32Array,
  camera: Float64Array, picture: Uint8Array,
};

// The mesh's arrays in the order of module.cpp.
const meshArrays = ['corners', 'ringSizes', 'faceRings', 'bodies', 'linePoints', 'lineSizes'];

// Options as the module takes them, which is also as a worker can be sent them: Value in module.cpp.
export function moduleOptions(options) {
  const result = [];
  for (const [given, value] of Object.entries(options)) {
    if (value === undefined) continue;
    if (Object.hasOwn(camelNames, given)) throw wrongArgument('usage', given, 'this name', camelNames[given]);
    const option = {name: moduleNames[given] ?? given, type: 4, numbers: [0, 0, 0], text: ''};
    if (typeof value === 'number') [option.type, option.numbers] = [0, [value, 0, 0]];
    else if (typeof value === 'boolean') [option.type, option.numbers] = [1, [Number(value), 0, 0]];
    else if (typeof value === 'string') [option.type, option.text] = [2, value];
    else if (isList(value) && value.length === 3 && [...value].every(c => typeof c === 'number')) [option.type, option.numbers] = [3, [...value]];
    else option.text = describe(value);
    result.push(option);
  }
  return result;
}

// One instance of the module, with memory of its own. After a trap it is of no use.
export class Instance {
  #exports;
  #indexed = false;  // the mesh came with `index`
  progress = null;  // gets the part of the work that is done; the work ends if it returns false

  constructor(compiled) {
    const imports = {sightline: {progress: done => this.progress?.(done) === false ? 0 : 1}};
    this.#exports = new WebAssembly.Instance(compiled, imports).exports;
    this.#exports._initialize();
    this.#exports.begin();
  }

  // `mesh`: of arraysOf (mesh.js); `options`: of moduleOptions, here and below. Returns what is known of the scene.
  load(mesh, options) {
    return this.#guarded(() => {
      this.#indexed = mesh.indexed;
      const {positions} = mesh;
      this.#view(Float64Array, this.#exports.vertices(positions.length / 3), positions.length).set(positions);
      meshArrays.forEach((name, number) => {
        this.#view(Uint32Array, this.#exports.numbers(number, mesh[name].length), mesh[name].length).set(mesh[name]);
      });
      this.#setOptions(0, options);
      this.#check(this.#exports.load());
      const [faceCount, vertexCount] = this.#numbers('scene.counts', Uint32Array);
      const bounds = [...this.#numbers('scene.bounds', Float64Array)];
      return {faceCount, vertexCount, bounds: [bounds.slice(0, 3), bounds.slice(3)], step: this.#numbers('scene.step', Float64Array)[0],
              notes: this.#lines('scene.notes')};
    });
  }

  // Returns columns by their names, and notes.
  draw(options) {
    return this.#guarded(() => {
      this.#setOptions(1, options);
      this.#check(this.#exports.draw());
      const drawn = {notes: this.#lines('notes')};
      for (const [name, Type] of Object.entries(columns)) drawn[name] = this.#numbers(name, Type);
      return drawn;
    });
  }

  // The bytes of a file of a picture.
  file(picture, options) {
    return this.#guarded(() => {
      this.#setOptions(2, options);
      this.#view(Uint8Array, this.#exports.buffer(picture.length), picture.length).set(picture);
      this.#check(this.#exports.file(picture.length));
      return new Uint8Array(this.#answer());
    });
  }

  // Numbers in the module's memory. Valid until the next call of the module, which may make its memory larger.
  #view(Type, at, length) { return new Type(this.#exports.memory.buffer, at, length); }

  // Runs calls of the module. What it did not throw itself is a trap.
  #guarded(work) {
    try {
      return work();
    } catch (error) {
      if (error instanceof SightlineError || !(error instanceof WebAssembly.RuntimeError || error instanceof RangeError)) throw error;
      if (this.#exports.exhausted())
        throw new SightlineError('out of memory: the module has 4 GB at most', {kind: 'out_of_memory', found: 'out of memory'});
      throw new SightlineError(`the module failed: ${error.message}`, {kind: 'defect', found: error.message});
    }
  }

  // Writes texts to the buffer, one after the other; returns their lengths.
  #put(...texts) {
    const parts = texts.map(text => encoder.encode(text));
    let at = this.#exports.buffer(parts.reduce((sum, part) => sum + part.length, 0));
    for (const part of parts) {
      this.#view(Uint8Array, at, part.length).set(part);
      at += part.length;
    }
    return parts.map(part => part.length);
  }

  #setOptions(group, options) {
    this.#exports.reset_options();
    for (const {name, type, numbers, text} of options) {
      const [nameSize, textSize] = this.#put(name, text);
      this.#check(this.#exports.option(group, nameSize, type, ...numbers, textSize));
    }
  }

  #check(done) {
    if (done) return;
    const text = name => inCamels(this.#text(`error.${name}`));
    let [place, message] = [text('place'), text('message')];
    if (this.#indexed && place.startsWith('corners[')) {
      message = message.replace(place, place.replace('corners', 'index'));
      place = place.replace('corners', 'index');
    }
    throw new SightlineError(message, {kind: text('kind'), argument: text('argument'), place, found: text('found'), expected: text('expected')});
  }

  // A copy of what has the name.
  #answer(name) {
    if (name !== undefined) this.#exports.get(this.#put(name)[0]);
    return this.#view(Uint8Array, this.#exports.answer_data(), this.#exports.answer_size()).slice().buffer;
  }
  #numbers(name, Type) { return new Type(this.#answer(name)); }
  #text(name) { return decoder.decode(this.#answer(name)); }
  #lines(name) { return this.#text(name).split('\n').filter(line => line); }
}
