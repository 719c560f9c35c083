// The screen of the Type 340: a P7 phosphor that keeps the beam's energy.
//
// Each flash is a spot of light in two layers. The blue layer responds at once; the yellow one stores energy and emits it as the
// sum of three exponentials. The picture is the recent light, weighted by the persistence of vision; for a steady picture it
// equals the photograph's exposure of 0.2 s.

import {AFTERGLOWS, CoarsePhosphor, PHOSPHOR, POINTS, SHARE_0, SHARE_1, SHARE_2, SIDE, TAU_0, TAU_1, TAU_2} from './phosphor.js';

// The corners of the glass are round; the shader gives points outside the colour of the frame (page.css). To clip the canvas would cost another layer.
const ROUND = `
vec3 framed(vec3 colour, vec2 at) {
  float outside = length(max(abs(at - 0.5) - 0.41, 0.0)) - 0.09;
  return mix(colour, vec3(43, 45, 48) / 255.0, clamp(outside / fwidth(at.x) + 0.5, 0.0, 1.0));
}`;
const FLASH_VERTEX = `#version 300 es
layout(location=0) in vec2 place; layout(location=1) in float level;
uniform float scale; uniform vec2 side; out float light; out float sigma;
void main() {
  light = ${PHOSPHOR.floor} + ${1 - PHOSPHOR.floor} * pow(level / 7.0, 1.5);
  sigma = ${PHOSPHOR.sigmaBase.toFixed(2)} + ${PHOSPHOR.sigmaGrowth} * level / 7.0;
  gl_Position = vec4((place + ${PHOSPHOR.margin}.5) / side * 2.0 - 1.0, 0, 1);
  gl_PointSize = max(3.0, 13.0 * scale);
}`;
const FLASH_FRAGMENT = `#version 300 es
precision highp float;
in float light; in float sigma; uniform float scale; out vec4 spot;
float area(float s) { return 6.2831853 * s * s; }
void main() {
  vec2 d = (gl_PointCoord - 0.5) * max(3.0, 13.0 * scale) / scale;
  float r = dot(d, d);
  float pixel = 0.35 / scale;  // the pixel widens the spot
  float blue = sqrt(sigma * sigma + pixel * pixel), yellow = sqrt(blue * blue + ${(PHOSPHOR.cascade ** 2).toFixed(3)});
  spot = light * vec4(exp(-r / (2.0 * blue * blue)) / area(blue), exp(-r / (2.0 * yellow * yellow)) / area(yellow), 0, 0);
}`;
const WHOLE_VERTEX = `#version 300 es
out vec2 at; void main() { vec2 p = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0; at = p; gl_Position = vec4(p * 2.0 - 1.0, 0, 1); }`;
const GLOW_FRAGMENT = `#version 300 es
precision highp float;
in vec2 at; uniform sampler2D fresh, glow, film; uniform vec3 keep, keepHalf, share; uniform float eye, weight; uniform bool hold;
layout(location=0) out vec4 glowNext; layout(location=1) out vec4 filmNext;
void main() {
  vec2 f = texture(fresh, at).rg; vec3 g = texture(glow, at).rgb; vec2 seen = texture(film, at).rg;
  vec3 come = f.g * ${1 - PHOSPHOR.blueShare} * share;
  float yellow = dot(g, 1.0 - keep) + dot(come, 1.0 - keepHalf);
  glowNext = vec4(g * keep + come * keepHalf, 0);
  // Held: the light of the afterglow on a film, if that is more than the eye sees.
  filmNext = hold ? vec4(seen.r, max(seen.g, dot(g, 1.0 - keep)), 0, 0) : vec4(seen * eye + weight * vec2(f.r * ${PHOSPHOR.blueShare}, yellow), 0, 0);
}`;
// The mean of each block of 16 by 16 points, by 8 by 8 filtered samples of four points each.
const HALO_FRAGMENT = `#version 300 es
precision highp float;
in vec2 at; uniform sampler2D film; uniform vec2 step; out vec4 mean;
void main() {
  vec4 sum = vec4(0);
  for (int i = 0; i < 8; ++i) for (int j = 0; j < 8; ++j) sum += texture(film, at + (vec2(i, j) - 3.5) * step);
  mean = sum / 64.0;
}`;
const SHOW_FRAGMENT = `#version 300 es
precision highp float;
in vec2 at; uniform sampler2D film, halo; uniform vec2 block; uniform bool pair; uniform float yellow; out vec4 colour;${ROUND}
float srgb(float v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055; }
// The response of the film to the light at a point.
vec3 answer(vec2 at) {
  vec2 around = 0.4 * texture(halo, at).rg + 0.15 * (texture(halo, at + vec2(block.x, 0)).rg + texture(halo, at - vec2(block.x, 0)).rg
    + texture(halo, at + vec2(0, block.y)).rg + texture(halo, at - vec2(0, block.y)).rg);
  vec2 light = texture(film, at).rg * ${1 - PHOSPHOR.haloShare} + around * ${PHOSPHOR.haloShare};
  light.g *= yellow;
  vec3 v = vec3(${PHOSPHOR.ambient}) + ${PHOSPHOR.exposure.toFixed(2)} * (vec3(${PHOSPHOR.blueColour.map(c => c.toFixed(2))}) * light.r + vec3(${PHOSPHOR.yellowColour.map(c => c.toFixed(2))}) * light.g);
  return v / (1.0 + v);
}
void main() {
  vec3 v = answer(at);
  if (pair) {
    // The pictures of a pair are 256 points to the left and right of the middle; they are superimposed in red and cyan.
    vec2 aside = vec2(256.0 / ${SIDE}.0, 0);
    bool inside = abs(at.x - 0.5) < aside.x;
    float left = inside ? answer(at - aside).g : 0.0, right = inside ? answer(at + aside).g : 0.0;
    v = vec3(left, right, right);
  }
  colour = vec4(framed(vec3(srgb(v.r), srgb(v.g), srgb(v.b)), at), 1);
}`;

const COPY_FRAGMENT = `#version 300 es
precision highp float;
in vec2 at; uniform sampler2D picture; out vec4 colour;${ROUND}
void main() { colour = vec4(framed(texture(picture, at).rgb, at), 1); }`;

// Draws flashes on a canvas. Without WebGL2 and float targets it draws fading dots; `kind` says which. `fine`: always with all points;
// `coarse`: with few points.
export function makeTube(canvas, {plain = false, fine = false, coarse = false} = {}) {
  const gl = plain ? null : canvas.getContext('webgl2', {antialias: false, alpha: false, depth: false});
  if (gl && gl.getExtension('EXT_color_buffer_float')) return new GlowTube(canvas, gl, coarse || (!fine && bySoftware(gl)) ? COARSE : SIDE);
  return new PlainTube(canvas);
}

const COARSE = SIDE / 4;
// Whether WebGL runs in software, as far as the browser reports it.
function bySoftware(gl) {
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
}

// The base of both kinds of tube. `pair`: superimpose the pictures of a stereo pair in red and cyan. `afterglow`: one of AFTERGLOWS.
class Tube {
  pair = false;
  afterglow = AFTERGLOWS.p7;
  time = 0;
  began = 0;
  held = false;

  // Clears the screen; `time` is emulated time in seconds.
  clear(time) {
    this.time = this.began = time;
    this.held = false;
    this.darken();
  }
  // Shows the flashes (module.js) up to an emulated time in seconds. `held`: the machine has stopped, and the picture stays. A picture that was drawn in less
  // than the shutter's time is shown with all of its afterglow.
  show(flashes, time, held) {
    const passed = time - this.time;
    this.time = time;
    if (passed > 0) this.picture(flashes, passed);
    if (held && (passed > 0 || !this.held)) this.hold(time - this.began < PHOSPHOR.shutter ? Infinity : PHOSPHOR.shutter);
    this.held = held;
    this.develop();
  }
}

class GlowTube extends Tube {
  constructor(canvas, gl, side) {
    super();
    this.canvas = canvas;
    this.gl = gl;
    this.kind = 'phosphor';
    this.points = new Float32Array(3 * 65536);
    this.lost = false;
    canvas.addEventListener('webglcontextlost', event => { event.preventDefault(); this.lost = true; });
    canvas.addEventListener('webglcontextrestored', () => { this.lost = false; this.held = false; this.build(); });
    this.side = side;
    this.build();
  }

  // Reduces the number of pixels on a slow computer.
  coarser() {
    if (this.side <= COARSE) return false;
    this.side = Math.round(this.side > SIDE / 2 ? SIDE / 2 : this.side > SIDE * 3 / 8 ? SIDE * 3 / 8 : COARSE);
    this.build();
    return true;
  }

  build() {
    const gl = this.gl;
    const compile = (kind, text) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) throw new Error(gl.getShaderInfoLog(shader));
      return shader;
    };
    const program = (vertex, fragment) => {
      const made = gl.createProgram();
      gl.attachShader(made, compile(gl.VERTEX_SHADER, vertex));
      gl.attachShader(made, compile(gl.FRAGMENT_SHADER, fragment));
      gl.linkProgram(made);
      const places = {};
      const count = gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS) ?? 0;
      for (let i = 0; i < count; ++i) {
        const {name} = gl.getActiveUniform(made, i);
        places[name] = gl.getUniformLocation(made, name);
      }
      return {made, places};
    };
    const texture = (side, filter, kind = gl.RGBA16F) => {
      const made = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, made);
      gl.texStorage2D(gl.TEXTURE_2D, 1, kind, side, side);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
      return made;
    };
    const target = (...textures) => {
      const made = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, made);
      textures.forEach((each, i) => gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, each, 0));
      gl.drawBuffers(textures.map((each, i) => gl.COLOR_ATTACHMENT0 + i));
      gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
      if (textures.length > 1) gl.clearBufferfv(gl.COLOR, 1, [0, 0, 0, 0]);
      return made;
    };
    this.canvas.width = this.canvas.height = this.side;
    this.nothing = gl.createVertexArray();
    // If pixels are wider than a spot, CoarsePhosphor computes the picture without WebGL, which runs in software here.
    this.coarse = this.side < SIDE / 2 ? new CoarsePhosphor(this.side) : null;
    if (this.coarse) {
      this.copy = program(WHOLE_VERTEX, COPY_FRAGMENT);
      this.copied = texture(this.side, gl.LINEAR, gl.RGBA8);
      return;
    }
    this.flash = program(FLASH_VERTEX, FLASH_FRAGMENT);
    this.glow = program(WHOLE_VERTEX, GLOW_FRAGMENT);
    this.shown = program(WHOLE_VERTEX, SHOW_FRAGMENT);
    this.halo = program(WHOLE_VERTEX, HALO_FRAGMENT);
    this.blocks = Math.ceil(this.side / 16);
    this.wide = texture(this.blocks, gl.LINEAR);
    this.wideTarget = target(this.wide);
    this.fresh = texture(this.side, gl.NEAREST);
    this.freshTarget = target(this.fresh);
    this.states = [0, 1].map(() => {
      const glow = texture(this.side, gl.NEAREST);
      const film = texture(this.side, gl.LINEAR);
      return {glow, film, target: target(glow, film)};
    });
    this.now = 0;
    this.film = this.states[0].film;
    this.vertices = gl.createVertexArray();
    gl.bindVertexArray(this.vertices);
    this.buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, this.points.byteLength, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 12, 0);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 1, gl.FLOAT, false, 12, 8);
  }

  darken() {
    if (this.lost) return;
    const gl = this.gl;
    if (this.coarse) {
      this.coarse.clear();
    } else {
      for (const {target} of this.states) {
        gl.bindFramebuffer(gl.FRAMEBUFFER, target);
        for (const layer of [0, 1]) gl.clearBufferfv(gl.COLOR, layer, [0, 0, 0, 0]);
      }
    }
    this.develop();
  }
  // Adds what was drawn in the last `seconds` of emulated time.
  picture(flashes, seconds) {
    if (this.lost) return;
    if (this.coarse) {
      this.coarse.afterglow = this.afterglow;
      this.coarse.picture(flashes, seconds);
    } else {
      this.spread(flashes);
      this.fade(seconds);
      this.now = 1 - this.now;
    }
  }
  // Writes to the other state, which the next frame overwrites.
  hold(seconds) {
    if (this.lost) return;
    if (this.coarse) this.coarse.hold(seconds); else this.fade(seconds, true);
  }
  spread(flashes) {
    const gl = this.gl;
    const {count} = flashes;
    gl.viewport(0, 0, this.side, this.side);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.freshTarget);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.useProgram(this.flash.made);
    gl.uniform1f(this.flash.places.scale, this.side / SIDE);
    gl.uniform2f(this.flash.places.side, SIDE, SIDE);
    gl.bindVertexArray(this.vertices);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    for (let from = 0; from < count;) {
      const part = Math.min(count - from, 65536);
      for (let i = 0; i < part; ++i) {
        this.points[3 * i] = flashes.x(from + i);
        this.points[3 * i + 1] = flashes.y(from + i);
        this.points[3 * i + 2] = flashes.level(from + i);
      }
      gl.bufferSubData(gl.ARRAY_BUFFER, 0, this.points, 0, 3 * part);
      gl.drawArrays(gl.POINTS, 0, part);
      from += part;
    }
    gl.disable(gl.BLEND);
  }
  fade(seconds, hold = false) {
    const gl = this.gl;
    const before = this.states[this.now], after = this.states[1 - this.now];
    const {places} = this.glow;
    const {times} = this.afterglow, eye = Math.exp(-seconds / this.afterglow.eye);
    const aged = seconds / times, half = aged / 2;
    gl.useProgram(this.glow.made);
    gl.viewport(0, 0, this.side, this.side);
    gl.bindFramebuffer(gl.FRAMEBUFFER, after.target);
    gl.bindVertexArray(this.nothing);
    this.use(0, this.fresh, places.fresh);
    this.use(1, before.glow, places.glow);
    this.use(2, before.film, places.film);
    gl.uniform3f(places.keep, Math.exp(-aged / TAU_0), Math.exp(-aged / TAU_1), Math.exp(-aged / TAU_2));
    gl.uniform3f(places.keepHalf, Math.exp(-half / TAU_0), Math.exp(-half / TAU_1), Math.exp(-half / TAU_2));
    gl.uniform3f(places.share, SHARE_0, SHARE_1, SHARE_2);
    gl.uniform1f(places.eye, eye);
    gl.uniform1f(places.weight, PHOSPHOR.shutter * (1 - eye) / seconds);
    gl.uniform1i(places.hold, hold ? 1 : 0);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    this.film = after.film;
  }
  develop() {
    if (this.lost) return;
    const gl = this.gl;
    // At most as many pixels as the page shows.
    const shown = Math.max(64, Math.min(this.side, Math.round(this.canvas.clientWidth * (globalThis.devicePixelRatio || 1)) || this.side));
    if (this.canvas.width !== shown) this.canvas.width = this.canvas.height = shown;
    gl.bindVertexArray(this.nothing);
    if (this.coarse) this.showCoarse(shown); else this.showFilm(shown);
  }
  showCoarse(shown) {
    const {gl, coarse} = this;
    coarse.afterglow = this.afterglow;
    coarse.develop(this.pair);
    gl.useProgram(this.copy.made);
    this.use(0, this.copied, this.copy.places.picture);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, this.side, this.side, gl.RGBA, gl.UNSIGNED_BYTE, coarse.bytes);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, shown, shown);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
  showFilm(shown) {
    const {gl, film} = this;
    gl.useProgram(this.halo.made);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.wideTarget);
    gl.viewport(0, 0, this.blocks, this.blocks);
    this.use(0, film, this.halo.places.film);
    gl.uniform2f(this.halo.places.step, 2 / this.side, 2 / this.side);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.useProgram(this.shown.made);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, shown, shown);
    this.use(0, film, this.shown.places.film);
    this.use(1, this.wide, this.shown.places.halo);
    gl.uniform2f(this.shown.places.block, 1 / this.blocks, 1 / this.blocks);
    gl.uniform1i(this.shown.places.pair, this.pair ? 1 : 0);
    gl.uniform1f(this.shown.places.yellow, this.afterglow.yellow);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
  use(unit, texture, place) {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform1i(place, unit);
  }
}

// Fading dots, for browsers without WebGL2.
class PlainTube extends Tube {
  constructor(canvas) {
    super();
    this.kind = 'plain';
    this.side = SIDE / 2;
    canvas.width = canvas.height = this.side;
    this.context = canvas.getContext('2d');
    this.light = new Float32Array(this.side * this.side);
    this.row = new Float32Array(this.side);
    this.image = this.context?.createImageData(this.side, this.side);
    if (this.image) this.pixels = new Uint32Array(this.image.data.buffer);
  }
  coarser() { return false; }
  darken() {
    this.light.fill(0);
    this.develop();
  }
  hold() {}
  picture(flashes, seconds) {
    const {side, light} = this;
    const keep = Math.exp(-seconds / (this.afterglow === AFTERGLOWS.p7 ? 0.12 : this.afterglow.eye));
    for (let i = 0; i < light.length; ++i) light[i] *= keep;
    for (let i = 0; i < flashes.count; ++i) {
      const x = flashes.x(i) + PHOSPHOR.margin >> 1;
      const y = flashes.y(i) + PHOSPHOR.margin >> 1;
      light[(side - 1 - y) * side + x] += 0.4;
    }
  }
  develop() {
    if (!this.context) return;
    const {side, light, pixels} = this;
    for (let i = 0; i < light.length; ++i) {
      const v = light[i] > 1 ? 1 : light[i];
      pixels[i] = 0xff000000 | 21 + 119 * v << 16 | 26 + 214 * v << 8 | 20 + 193 * v;
    }
    if (this.pair) {
      // As in the other tube.
      const {row} = this, aside = POINTS / 8;
      for (let y = 0; y < side; ++y) {
        row.set(light.subarray(y * side, (y + 1) * side));
        for (let x = 0; x < side; ++x) {
          const inside = Math.abs(x + 0.5 - side / 2) < aside;
          const left = inside ? 255 * Math.min(1, row[x - aside]) : 0, right = inside ? 255 * Math.min(1, row[x + aside]) : 0;
          pixels[y * side + x] = 0xff000000 | right << 16 | right << 8 | left;
        }
      }
    }
    this.context.putImageData(this.image, 0, 0);
  }
}
