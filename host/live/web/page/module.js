// The module's C interface (host/live/web/module.cpp) as functions of JavaScript. Works in a browser and in Node.

const encoder = new TextEncoder();
const decoder = new TextDecoder();

// The functions of WASI that the module imports, to exit and to write errors; it has no files.
function system(memory) {
  const said = [];
  return {
    environ_get: () => 0,
    environ_sizes_get: (count, size) => {
      new DataView(memory().buffer).setUint32(count, 0, true);
      new DataView(memory().buffer).setUint32(size, 0, true);
      return 0;
    },
    fd_close: () => 8,
    fd_seek: () => 8,
    fd_write: (file, vectors, count, written) => {
      const view = new DataView(memory().buffer);
      let bytes = 0;
      for (let i = 0; i < count; ++i) {
        const at = view.getUint32(vectors + 8 * i, true);
        const length = view.getUint32(vectors + 8 * i + 4, true);
        said.push(decoder.decode(new Uint8Array(memory().buffer, at, length)));
        bytes += length;
      }
      view.setUint32(written, bytes, true);
      return 0;
    },
    proc_exit: code => { throw new Error(`the module has ended with ${code}: ${said.join('')}`); },
  };
}

// Flashes in the module's memory, 16 bytes each: emulated nanoseconds, position on the screen, and intensity, 0 to 7. One object is reused, so that
// frames produce no garbage.
class Flashes {
  count = 0;
  at = 0;
  view = null;
  time(i) { return this.view.getInt32(this.at + 16 * i + 4, true) * 2 ** 32 + this.view.getUint32(this.at + 16 * i, true); }
  x(i) { return this.view.getUint16(this.at + 16 * i + 8, true); }
  y(i) { return this.view.getUint16(this.at + 16 * i + 10, true); }
  level(i) { return this.view.getUint8(this.at + 16 * i + 12); }
}

// `wasm`: a WebAssembly.Module.
export async function openModule(wasm) {
  let exports = null;
  const instance = await WebAssembly.instantiate(wasm, {wasi_snapshot_preview1: system(() => exports.memory)});
  exports = instance.exports;
  exports._initialize();

  const put = bytes => {
    const at = exports.buffer(bytes.length);
    new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
    return bytes.length;
  };
  const taken = size => new Uint8Array(exports.memory.buffer, exports.answer_data(), size);
  const text = size => decoder.decode(taken(size));
  const flashes = new Flashes();
  // Makes a new view of the memory if it has grown or the data has moved.
  const shows = (Kind, length) => {
    let view = null;
    return at => {
      if (!at) return null;
      if (!view || view.buffer !== exports.memory.buffer || view.byteOffset !== at) view = new Kind(exports.memory.buffer, at, length);
      return view;
    };
  };
  const rasterAt = shows(Uint8Array, 65536), flightAt = shows(Uint32Array, 262144);

  return {
    // A request (host/manual/page.md) and its answer; `error` in it is a text for a person.
    ask(request) { return JSON.parse(this.askForText(request)); },
    askForText: request => text(exports.request(put(encoder.encode(JSON.stringify(request))))),
    putFile(name, content) {
      const bytes = typeof content === 'string' ? encoder.encode(content) : content;
      const title = encoder.encode(name);
      const all = new Uint8Array(title.length + bytes.length);
      all.set(title);
      all.set(bytes, title.length);
      put(all);
      exports.file_put(title.length, all.length);
    },
    // The bytes that the last request has made.
    made: () => taken(exports.made()).slice(),

    // Functions for every frame, without JSON.
    run: (id, until, instructions = 2 ** 50) => exports.run(id, until, instructions),
    reason: () => text(exports.answer_size()),
    ticks: id => exports.ticks(id),
    instructions: id => exports.instructions(id),
    get: (id, number) => exports.get(id, number) >>> 0,
    set: (id, number, value) => exports.set(id, number, value),
    word: (id, at) => exports.word(id, at) >>> 0,
    type: (id, key) => exports.type(id, key),
    // One character for each 8-bit code.
    printed: id => { const size = exports.printed(id); return size ? String.fromCharCode(...taken(size)) : ''; },
    // The flashes since the last call; valid until the next call of any function.
    flashes(id) {
      flashes.count = exports.flashes(id);
      flashes.at = exports.flashes_data();
      if (flashes.view?.buffer !== exports.memory.buffer) flashes.view = new DataView(exports.memory.buffer);
      return flashes;
    },
    raster: id => rasterAt(exports.raster(id)),

    // The flight: `fly` runs to a T-state, and is true if the flight continues; `flown` is the T-state reached; `flightPicture` has 512 by 512 face numbers.
    fly: until => exports.fly(until) !== 0,
    flown: () => exports.flown(),
    flightPicture: () => flightAt(exports.flight_picture()),
  };
}
