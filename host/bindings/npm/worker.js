// A worker with one scene; index.js tells it what to do. The first message has the compiled module. Each of the others has a method of
// an Instance and its arguments; answers are {progress}, then {result} or {error}.
import {Instance, SightlineError} from './module.js';

// Of the messages' other end: `post`. Returns what takes a message.
function taker(post) {
  let instance = null;
  return ({module, method, values}) => {
    if (module !== undefined) {
      instance = new Instance(module);
      instance.progress = done => { post({progress: done}); };
      return;
    }
    try {
      const result = instance[method](...values);
      post({result}, Object.values(result).filter(ArrayBuffer.isView).map(column => column.buffer));
    } catch (error) {
      const {kind, argument, place, found, expected} = error instanceof SightlineError ? error : {kind: 'defect', found: String(error)};
      post({error: {message: error.message, kind, argument, place, found, expected}});
    }
  };
}

if (typeof self === 'object' && typeof self.postMessage === 'function') {
  const take = taker((message, buffers) => self.postMessage(message, buffers ?? []));
  self.addEventListener('message', event => take(event.data));
} else {
  // In Node, where messages wait for the first listener. Programs that pack scripts for pages do not follow this import.
  import(/* webpackIgnore: true */ /* @vite-ignore */ `node:${'worker_threads'}`).then(({parentPort}) => {
    parentPort.on('message', taker((message, buffers) => parentPort.postMessage(message, buffers)));
  });
}
