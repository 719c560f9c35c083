// A worker with one scene; index.js tells it what to do. The first message has the compiled module. Each of the others has a method of
// an Instance and its arguments; answers are {progress}, then {result} or {error}.
import {Instance, SightlineError} from './module.js';

const port = typeof self === 'undefined' ? (await import(/* webpackIgnore: true */ /* @vite-ignore */ `node:${'worker_threads'}`)).parentPort : self;
let instance = null;

function take({module, method, values}) {
  if (module !== undefined) {
    instance = new Instance(module);
    instance.progress = done => { port.postMessage({progress: done}); };
    return;
  }
  try {
    const result = instance[method](...values);
    const buffers = Object.values(result).filter(ArrayBuffer.isView).map(column => column.buffer);
    port.postMessage({result}, buffers);
  } catch (error) {
    const {kind, argument, place, found, expected} = error instanceof SightlineError ? error : {kind: 'defect', found: String(error)};
    port.postMessage({error: {message: error.message, kind, argument, place, found, expected}});
  }
}
if (port === globalThis.self) port.addEventListener('message', event => take(event.data));
else port.on('message', take);
