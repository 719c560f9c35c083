// A flight on the 8080 with Willis's priority display (firmware/i8080/flight): its scenes, its picture and its figures.

import {oneOf, flag, named, number as numeric, optionsOf} from './links.js';
import {check, choice, field} from './ui.js';

const SCENES = [['prisms-9', 'nine turned houses'], ['prisms-25', '25 turned houses'], ['town-4', 'four houses of a town'], ['town-9', 'nine houses'], ['town-20', 'twenty houses'], ['town-60', 'sixty houses, the nearest pieces']];
const SIDE = 512;

export class Flight {
  // `again` restarts the flight.
  constructor(module, again) {
    this.module = module;
    this.options = {scene: 'town-20', bits: 8, plan: false, facing: false, pieces: 255, frames: 200};
    const o = this.options;
    const set = name => value => { o[name] = value; again(); };
    const number = name => value => { if (value !== '' && Number.isFinite(Number(value))) { o[name] = Number(value); again(); } };
    this.scene = choice('Scene', SCENES, o.scene, set('scene'), 'The scene of the flight');
    this.bits = choice('Coordinates', [[8, '8 bits'], [12, '12 bits'], [16, '16 bits']], o.bits, number('bits'), 'Bits of a coordinate: with more, distances are more exact and frames slower');
    this.plan = check('Distances without the height', o.plan, set('plan'), 'Distances are measured in plan, seen from above, as in the paper');
    this.facing = check('Keys only for pieces that face the eye', o.facing, set('facing'), 'The 8080 finds the pieces that face the eye, and computes distances and priorities of these only');
    this.pieces = field('Most pieces', o.pieces, number('pieces'), {type: 'number', min: 1, max: 255},
      'The scene is cut into pieces, each with one place in the order. The machine holds up to 255; of more, the nearest are shown.');
    this.controls = [this.bits, this.pieces, this.plan, this.facing];
    this.colours = new Int32Array(1);
    this.image = new ImageData(SIDE, SIDE);
    this.pixels = new Int32Array(this.image.data.buffer);
  }

  request(scene = this.options.scene) { return {do: 'flight', ...this.options, scene}; }
  make() {
    const made = this.module.ask(this.request());
    this.made = made.error ? null : made;
    if (!this.made) return made;
    // Red is the lowest byte of a pixel. Signed, because JavaScript engines store small signed integers without allocation.
    this.colours = Int32Array.from(made.shades, shade => 0xff000000 | (shade & 0xff) << 16 | shade & 0xff00 | shade >> 16);
    this.before = null;
    this.rate = 0;
    return made;
  }

  // ticks and run have the interface that runFor expects of a machine.
  ticks() { return this.module.flown(); }
  run(id, until) { return this.module.fly(until) ? 0 : 2; }

  draw(context) {
    const shown = this.module.flightPicture();
    if (!shown) return;
    const {pixels, colours} = this;
    for (let i = 0; i < SIDE * SIDE; ++i) pixels[i] = colours[shown[i]];
    context.putImageData(this.image, 0, 0);
  }
  get side() { return SIDE; }

  get status() { return this.module.ask({do: 'flight_state'}).status; }
  // Rows of the tab's facts.
  facts() {
    const state = this.state = this.module.ask({do: 'flight_state'});
    const {frame} = state;
    if (!this.made || !frame) return [];
    const count = number => number.toLocaleString('en');
    if (this.before && frame.shown_ms > this.before.ms) this.rate = (state.frames - this.before.frames) / (frame.shown_ms - this.before.ms) * 1000;
    this.before = {frames: state.frames, ms: frame.shown_ms};
    return [
      ['Frames', `${state.frames} of ${this.made.frames}; ${this.rate.toFixed(1)} a second, on average ${state.frames_per_second_mean.toFixed(1)}, at worst ${state.frames_per_second_worst.toFixed(1)}`],
      ['Computing', `${count(frame.t_states)} clock cycles for this frame, then ${count(frame.waiting)} waiting for the display`],
      ['Pieces', `${this.made.pieces}, cut from ${this.made.surfaces} surfaces; ${frame.facing} turned to the eye`],
      ...this.options.facing ? [['Facing', `${frame.with_key} pieces have a key; ${frame.appeared} have come to face the eye and ${frame.vanished} have turned away since the last frame`]] : [],
      ['Order', `${count(frame.moved)} pieces moved, ${count(frame.exchanges)} pairs exchanged since the last frame`, 'The order of the pieces by distance: the nearest has the highest priority'],
      ['Pairs in wrong order', `${count(frame.wrong_orders)} in this frame, ${count(state.wrong_orders)} of ${count(state.pairs)} so far`, 'Pairs of pieces that exact distances put in the other order'],
      ['Wrong pixels', `${count(frame.wrong_points)} in this picture, ${count(state.wrong_points)} in ${state.frames_with_wrong_points} pictures so far`, 'Pixels that show another face than the exact picture'],
      ['Precision', `one step of a coordinate is ${this.made.coordinate_step.toPrecision(3)} of the scene's units; distances that differ by more than ${this.made.distance_error.toPrecision(3)} are in the right order`],
      ['Check', state.difference || 'the same priorities as the same algorithm on this computer', 'The same algorithm, as a native program, also computes every frame']];
  }

  // `local`: the parameters of a link for a file of the user.
  link(local) {
    const o = this.options;
    return `${encodeURIComponent(`flight ${o.scene}`)}?${new URLSearchParams({bits: o.bits, plan: o.plan ? 1 : 0, ...(o.facing ? {facing: 1} : {}), pieces: o.pieces, ...local(o.scene)})}`;
  }
  open(scene, query) {
    const o = this.options;
    const known = scene ? {scene: named('scene', scene, [...this.scene.select.options].map(each => each.value), query)} : {};
    Object.assign(o, {facing: false}, optionsOf(query, {bits: oneOf([8, 12, 16]), plan: flag, facing: flag, pieces: numeric(1, 255)}), known);
    this.scene.select.value = o.scene;
    this.bits.select.value = o.bits;
    this.plan.box.checked = o.plan;
    this.facing.box.checked = o.facing;
    this.pieces.input.value = o.pieces;
  }
}
