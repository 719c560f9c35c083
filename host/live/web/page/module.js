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

// Nanoseconds of the machine's time of the flash that begins at this byte of a view.
export function flashTime(flashes, at) { return flashes.getInt32(at + 4, true) * 2 ** 32 + flashes.getUint32(at, true); }

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

  return {
    // A request (host/manual/page.md) and its answer; `error` in it is a text for a person.
    ask(request) {
      return JSON.parse(text(exports.request(put(encoder.encode(JSON.stringify(request))))));
    },
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
    // A view of the flashes since the last call, 16 bytes each: flashTime, x and y of 16 bits, the intensity of 8. Valid until the next
    // call of anything here.
    flashes(id) {
      const count = exports.flashes(id);
      return new DataView(exports.memory.buffer, count ? exports.flashes_data() : 0, 16 * count);
    },
    raster(id) {
      const at = exports.raster(id);
      return at ? new Uint8Array(exports.memory.buffer, at, 65536) : null;
    },
  };
}
