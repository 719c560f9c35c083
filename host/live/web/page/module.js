// The module's C interface (host/live/web/module.cpp) as functions of JavaScript. Works in a browser and in Node.

const encoder = new TextEncoder();
const decoder = new TextDecoder();

// The module asks for these where a program would end or write an error; it has no files.
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

// Flashes in the module's memory, 16 bytes each: nanoseconds of the machine's time, where on the screen, and how bright, 0 to 7. One object is used
// again and again, so that a picture leaves nothing to be collected.
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
    const at = exports.room(bytes.length);
    new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
    return bytes.length;
  };
  const taken = size => new Uint8Array(exports.memory.buffer, exports.answer_data(), size);
  const text = size => decoder.decode(taken(size));
  const flashes = new Flashes();
  // Views of the memory are made again when it has grown or what they show has moved.
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

    // What a machine does in every picture, without texts.
    run: (id, until, instructions = 2 ** 50) => exports.run(id, until, instructions),
    reason: () => text(exports.answer_size()),
    ticks: id => exports.ticks(id),
    instructions: id => exports.instructions(id),
    get: (id, number) => exports.get(id, number) >>> 0,
    set: (id, number, value) => exports.set(id, number, value),
    word: (id, at) => exports.word(id, at) >>> 0,
    type: (id, key) => exports.type(id, key),
    // Codes of eight bits, a character each.
    printed: id => { const size = exports.printed(id); return size ? String.fromCharCode(...taken(size)) : ''; },
    // The flashes since the last call. Valid until the next call of anything here.
    flashes(id) {
      flashes.count = exports.flashes(id);
      flashes.at = exports.flashes_data();
      if (flashes.view?.buffer !== exports.memory.buffer) flashes.view = new DataView(exports.memory.buffer);
      return flashes;
    },
    raster: id => rasterAt(exports.raster(id)),

    // The flight: to a T-state, whether there is more of it; the T-state reached; what the priority display shows, 512 by 512 numbers of faces.
    fly: until => exports.fly(until) !== 0,
    flown: () => exports.flown(),
    flightPicture: () => flightAt(exports.flight_picture()),
  };
}
