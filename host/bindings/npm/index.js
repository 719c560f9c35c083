// Hidden-line removal: a mesh and a camera in, the lines that the camera sees out, exactly. README.md is the manual, index.d.ts
// describes every function.
//
// Every scene has an instance of the WebAssembly module with memory of its own, here or in a worker, which is given up with the
// scene, after a trap, or when a call is aborted. The scene's mesh is kept, so that the next call can begin again.
import {arraysOf} from './mesh.js';
import {describe, Instance, moduleOptions, SightlineError, wrongArgument} from './module.js';

export {SightlineError};

export const version = '@VERSION@';
export const none = 0xffffffff;
export const kindNames = Object.freeze(['silhouette', 'junction', 'boundary', 'crease', 'border', 'intersection', 'polyline', 'flat']);

// ------------------------------------------------------------------------------------------------------- Environment

const inNode = typeof process === 'object' && typeof process.versions?.node === 'string' && process.type !== 'renderer';
// Programs that pack scripts for pages do not follow this import.
const fromNode = name => import(/* webpackIgnore: true */ /* @vite-ignore */ `node:${name}`);

async function compile() {
  const place = new URL('./sightline.wasm', import.meta.url);
  try {
    if (inNode && place.protocol === 'file:') return await WebAssembly.compile(await (await fromNode('fs/promises')).readFile(place));
    const response = await fetch(place);
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
    return await WebAssembly.compile(await response.arrayBuffer());
  } catch (error) {
    throw new SightlineError(`${place}: ${error.message}`, {kind: 'io', argument: String(place), found: error.message});
  }
}
let compiled = null;
function compiledModule() {
  compiled ??= compile().catch(error => {
    compiled = null;
    throw error;
  });
  return compiled;
}

async function newWorker() {
  // Options of the process such as --input-type are not for the worker.
  if (inNode) return new (await fromNode('worker_threads')).Worker(new URL('./worker.js', import.meta.url), {execArgv: []});
  return new Worker(new URL('./worker.js', import.meta.url), {type: 'module'});
}

// ----------------------------------------------------------------------------------------------------------- Engines

// Where a scene is: here.
class Here {
  #instance;

  constructor(module) { this.#instance = new Instance(module); }

  // Calls a method of the instance.
  call(method, values, {signal, progress}) {
    let thrown = null;
    this.#instance.progress = done => {
      try {
        progress?.(done);
      } catch (error) {
        thrown = {error};
      }
      return !thrown && !signal?.aborted;
    };
    try {
      return this.#instance[method](...values);
    } catch (error) {
      throw thrown ? thrown.error : error;
    }
  }
  end() {}
}

// Or in a worker, which does one call at a time.
class Elsewhere {
  #worker;
  #answered = null;  // the call that is being done: resolve, reject, progress

  static async begin(module) {
    const engine = new Elsewhere();
    const worker = engine.#worker = await newWorker();
    const listen = (event, act) => (inNode ? worker.on(event, act) : worker.addEventListener(event, act));
    listen('message', message => engine.#take(inNode ? message : message.data));
    const fail = text => engine.#answered?.reject(new SightlineError(`the worker failed: ${text}`, {kind: 'io', found: text}));
    listen('error', error => fail(error.message ?? 'it cannot be started'));
    if (inNode) listen('exit', code => fail(`it has ended with ${code}`));
    worker.postMessage({module});
    return engine;
  }

  // Rejects with the signal's reason when it is aborted; the engine is then to be ended.
  call(method, values, {signal, progress}) {
    return new Promise((resolve, reject) => {
      const abort = () => this.#answered.reject(signal.reason);
      const settled = act => value => {
        signal?.removeEventListener('abort', abort);
        this.#answered = null;
        this.#worker.unref?.();
        act(value);
      };
      this.#answered = {resolve: settled(resolve), reject: settled(reject), progress};
      if (signal?.aborted) return abort();
      signal?.addEventListener('abort', abort);
      this.#worker.ref?.();
      this.#worker.postMessage({method, values});
    });
  }
  end() {
    this.#answered?.reject(new SightlineError('cancelled: the scene was freed', {kind: 'cancelled', found: 'cancelled'}));
    this.#worker.terminate();
  }

  #take({progress, error, result}) {
    const answered = this.#answered;
    if (answered === null) return;
    if (progress !== undefined) {
      try {
        answered.progress?.(progress);
      } catch (thrown) {
        answered.reject(thrown);
      }
    } else if (error !== undefined) {
      answered.reject(new SightlineError(error.message, error));
    } else {
      answered.resolve(result);
    }
  }
}

// After other errors an engine is of no use.
const isHarmless = error => error instanceof SightlineError && ['bad_input', 'usage', 'cancelled'].includes(error.kind);

// ----------------------------------------------------------------------------------------------------------- Options

const loadNames = ['mend', 'weld', 'planarTolerance', 'eye'];

// Divides options into those that control a call, and all others.
function divided(options) {
  if (options === null || typeof options !== 'object') throw wrongArgument('usage', 'options', describe(options), 'an object');
  const {signal, progress, worker = false, ...others} = options;
  if (signal !== undefined && !(typeof signal?.aborted === 'boolean' && typeof signal.addEventListener === 'function'))
    throw wrongArgument('usage', 'signal', describe(signal), 'an AbortSignal');
  if (progress !== undefined && typeof progress !== 'function') throw wrongArgument('usage', 'progress', describe(progress), 'a function');
  if (typeof worker !== 'boolean') throw wrongArgument('usage', 'worker', describe(worker), 'true or false');
  return {control: {signal, progress}, worker, others};
}

// The same call as a part of a longer one.
function part({signal, progress}, low, high) {
  return {signal, progress: progress && (done => progress(low + (high - low) * done))};
}

// ------------------------------------------------------------------------------------------------ The public classes

// What only this file can make: the constructors of Scene and Drawing ask for it.
const secret = Symbol('sightline');
function demand(key, what, instead) {
  if (key !== secret) throw wrongArgument('usage', what, 'a call of its constructor', instead);
}

export class Drawing {
  #module;
  #picture;

  constructor(key, module, drawn) {
    demand(key, 'Drawing', 'scene.draw()');
    const of = name => drawn[name];
    const group = (prefix, ...names) => Object.fromEntries(names.map(name => [name, drawn[`${prefix}.${name}`]]));
    this.#module = module;
    this.#picture = of('picture');
    this.lines = of('lines');
    this.kinds = of('kinds');
    this.hidden = of('hidden');
    this.lineEdges = of('lineEdges');
    this.lineEdgeOffsets = of('lineEdgeOffsets');
    this.parts = group('parts', 'edges', 'fractions', 'hidden', 'hiddenBy');
    this.edges = group('edges', 'kinds', 'ends', 'vertices', 'bodies', 'faces', 'faceOffsets');
    const c = [...of('camera')];
    this.camera = {perspective: c[0] !== 0, eye: c.slice(1, 4), axes: [c.slice(4, 7), c.slice(7, 10), c.slice(10, 13)], scale: c[13],
                   low: c.slice(14, 16), error: c[16]};
    [this.width, this.height] = new Float64Array(this.#picture.buffer, 0, 2);
    this.notes = of('notes');
  }

  svg(options = {}) { return new TextDecoder().decode(this.file({...options, format: 'svg'})); }

  file(options = {}) {
    if (options === null || typeof options !== 'object') throw wrongArgument('usage', 'options', describe(options), 'an object');
    return new Instance(this.#module).file(this.#picture, moduleOptions(options));
  }
}

export class Scene {
  #mesh;
  #options;
  #inWorker;
  #engine = null;
  #last = Promise.resolve();  // the call before the next one
  #freed = false;

  constructor(key, mesh, options, inWorker) {
    demand(key, 'Scene', 'Scene.of()');
    this.#mesh = mesh;
    this.#options = options;
    this.#inWorker = inWorker;
  }

  static async of(mesh, options = {}) {
    const {control, worker, others} = divided(options);
    const scene = new Scene(secret, arraysOf(mesh), moduleOptions(others), worker);
    await scene.#next(() => scene.#loaded(control), control);
    return scene;
  }

  async draw(options = {}) {
    const {control, worker, others} = divided(options);
    if (worker) throw wrongArgument('usage', 'worker', 'true', 'the option of Scene.of');
    const view = moduleOptions(others);
    return this.#next(async () => {
      const reloads = this.#engine === null;
      if (reloads) await this.#loaded(part(control, 0, 0.5));
      const drawn = await this.#engine.call('draw', [view], reloads ? part(control, 0.5, 1) : control);
      return new Drawing(secret, await compiledModule(), drawn);
    }, control);
  }

  free() {
    this.#freed = true;
    this.#mesh = null;
    this.#end();
  }

  async #loaded(control) {
    const module = await compiledModule();
    control.signal?.throwIfAborted();
    const engine = this.#inWorker ? await Elsewhere.begin(module) : new Here(module);
    if (this.#freed) engine.end();
    this.#demandLife();
    this.#engine = engine;
    try {
      Object.assign(this, await engine.call('load', [this.#mesh, this.#options], control));
    } catch (error) {
      this.#end();
      throw error;
    }
  }

  #demandLife() {
    if (this.#freed) throw wrongArgument('usage', 'scene', 'a freed one', 'one that was not freed');
  }

  #end() {
    this.#engine?.end();
    this.#engine = null;
  }

  // Works after the calls before. The promise rejects as soon as the signal is aborted.
  #next(work, {signal}) {
    const result = this.#last.then(async () => {
      this.#demandLife();
      signal?.throwIfAborted();
      try {
        const value = await work();
        signal?.throwIfAborted();
        return value;
      } catch (error) {
        if (!isHarmless(error)) this.#end();
        if (signal?.aborted) throw signal.reason;
        throw error;
      }
    });
    this.#last = result.catch(() => {});
    if (signal === undefined) return result;
    return new Promise((resolve, reject) => {
      const abort = () => reject(signal.reason);
      signal.addEventListener('abort', abort);
      if (signal.aborted) abort();
      result.then(resolve, reject).finally(() => signal.removeEventListener('abort', abort));
    });
  }
}

export async function hiddenLines(mesh, options = {}) {
  const {control, worker, others} = divided(options);
  const load = Object.fromEntries(Object.entries(others).filter(([name]) => loadNames.includes(name)));
  const draw = Object.fromEntries(Object.entries(others).filter(([name]) => name === 'eye' || !loadNames.includes(name)));
  const scene = await Scene.of(mesh, {...load, ...part(control, 0, 0.5), worker});
  try {
    return await scene.draw({...draw, ...part(control, 0.5, 1)});
  } finally {
    scene.free();
  }
}
