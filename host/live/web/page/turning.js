// A solid turning with hidden lines removed on the PDP-7 (firmware/pdp7/turn): its models, its switches by name and its figures.

import {button, check, choice, element, group} from './ui.js';

const BACKWARDS = 0o400000, WIRE = 0o200000, EVENT = 0o100000, SPEED = 0o77777;
const ANGLES = 2 ** 18;
const STATUS = ['right', 'the tape is damaged', 'the display file was full', 'no tape for this machine', 'reads the tape'];
// Built-in models; the solids of examples.txt are listed before them.
const MODELS = [['roberts', 'notched block'], ['boxes-8', 'eight boxes'], ['boxes-20', 'twenty boxes, 32K']];
const PREFIX = 'turn ';

export class Turning {
  // `solids`: files of the page. `tab`: a Pdp7Tab.
  constructor(module, solids, tab) {
    this.module = module;
    this.tab = tab;
    for (const each of solids) module.putFile(each.name, each.text);
    this.models = [...solids.map(each => [each.name, each.title]), ...MODELS];
    this.large = new Set(['boxes-20']);  // models that need 32K
    this.options = {seconds: 8, level: false};
    this.made = null;
    this.group = this.build();
  }

  // The entries for the tab's choice of programs: name and title.
  get programs() { return this.models.map(([name, title]) => [PREFIX + name, `Turn: ${title}`]); }
  owns(program) { return this.models.some(([name]) => PREFIX + name === program); }
  scene(program) { return program.slice(PREFIX.length); }
  programOf(scene) { return PREFIX + scene; }
  // Adds a file of the page as a model, with the memory that it needs. Returns a complaint, or ''.
  add(name) {
    this.large.delete(name);
    for (const memory of ['8k', '32k']) {
      const made = this.module.ask({do: 'turn', scene: name, memory});
      if (made.error && memory === '8k') continue;
      if (made.error) return made.error;
      this.module.ask({do: 'drop', id: made.id});
      if (memory === '32k') this.large.add(name);
      break;
    }
    if (!this.owns(PREFIX + name)) this.models.push([name, name]);
    return '';
  }

  build() {
    const flip = (bit, label, title) => {
      const made = button(label, () => this.flip(bit), title);
      made.setAttribute('aria-pressed', 'false');
      return made;
    };
    this.backwards = flip(BACKWARDS, 'backwards', 'AC switch 0, keys left and right');
    this.wire = flip(WIRE, 'wire frame', 'AC switch 1, key w: every edge whole, for comparison');
    this.stop = button('stop', () => this.standStill(), 'Speed 0: AC switches 3 to 17 down, key s');
    this.event = element('button', {type: 'button', className: 'hold', textContent: 'next event', title: 'AC switch 2, key e: to the next angle at which something appears or vanishes'});
    this.event.addEventListener('pointerdown', event => { this.event.setPointerCapture(event.pointerId); this.hold(true); });
    for (const kind of ['pointerup', 'pointercancel', 'lostpointercapture']) this.event.addEventListener(kind, () => this.hold(false));
    this.event.addEventListener('keydown', event => { if (event.key === ' ' || event.key === 'Enter') { event.preventDefault(); this.hold(true); } });
    this.event.addEventListener('keyup', event => { if (event.key === ' ' || event.key === 'Enter') this.hold(false); });
    this.pace = choice('A turn in', [[2, '2 s'], [4, '4 s'], [8, '8 s'], [16, '16 s'], [60, 'a minute']], this.options.seconds, value => { this.options.seconds = Number(value); this.setSpeed(); }, 'The speed: AC switches 3 to 17, keys up and down');
    this.upright = check('Upright', false, value => { this.options.level = value; this.tab.options.switches = 0; this.tab.restart(); }, 'The model is upright; otherwise it is tilted to show its top');
    return group('Turn', element('div', {className: 'pad'}, this.backwards, this.wire, this.event, this.stop), this.pace, this.upright);
  }

  make() {
    const {options} = this.tab;
    const large = this.large.has(this.scene(options.program));
    const made = this.module.ask({do: 'turn', scene: this.scene(options.program), eae: options.eae, memory: large ? '32k' : '8k', level: this.options.level, ...(options.switches ? {switches: options.switches} : {})});
    this.made = made.error ? null : made;
    if (!this.made) return made;
    this.before = null;
    this.rate = 0;
    if (!options.switches) options.switches = this.step();
    return made;
  }
  // The angle between pictures at which a turn takes the chosen time.
  step() { return Math.max(1, Math.min(SPEED, Math.round(ANGLES / (this.options.seconds * Math.max(1, this.made.pictures_a_second))))); }

  get word() { return this.tab.options.switches; }
  put(word) { this.tab.setSwitches(word); this.tab.remember(); }
  flip(bit) { this.put(this.word ^ bit); }
  hold(down) { this.put(down ? this.word | EVENT : this.word & ~EVENT); }
  standStill() { if (this.made) this.put(this.word & SPEED ? this.word & ~SPEED : this.word | this.step()); }
  setSpeed() { if (this.made) this.put(this.word & ~SPEED | this.step()); }
  faster(times) { if (this.made) this.put(this.word & ~SPEED | Math.max(1, Math.min(SPEED, Math.round((this.word & SPEED || this.step()) * times)))); }

  // Handles a keydown event; true: the key belongs to this program.
  key(event) {
    if (event.key === 'e') return this.tab.holdKey(event, down => this.hold(down));
    const act = {ArrowLeft: () => this.put(this.word | BACKWARDS), ArrowRight: () => this.put(this.word & ~BACKWARDS), ArrowUp: () => this.faster(1.25), ArrowDown: () => this.faster(0.8),
      w: () => this.flip(WIRE), s: () => this.standStill()}[event.key];
    if (!act) return false;
    act();
    return true;
  }
  showSwitches() {
    this.backwards.setAttribute('aria-pressed', String(Boolean(this.word & BACKWARDS)));
    this.wire.setAttribute('aria-pressed', String(Boolean(this.word & WIRE)));
    this.event.classList.toggle('down', Boolean(this.word & EVENT));
    this.stop.textContent = this.word & SPEED ? 'stop' : 'go on';
  }

  get angle() { return this.module.word(this.tab.id, this.made.labels.angle); }
  // The exact visible lines at the machine's current angle.
  lines() {
    const answer = this.module.ask({do: 'turn_sight', scene: this.scene(this.tab.options.program), level: this.options.level, angle: this.angle});
    return this.word & WIRE ? null : answer.lines ?? null;
  }
  // Rows of the tab's facts; `time`: emulated seconds.
  facts(time) {
    const {module, tab, made} = this;
    const angle = this.angle;
    const step = this.word & SPEED;
    const moved = this.before ? Math.abs((angle - this.before.angle + 1.5 * ANGLES) % ANGLES - ANGLES / 2) : 0;
    if (this.before && time > this.before.time && step) this.rate = moved / step / (time - this.before.time);
    if (!this.before || time > this.before.time) this.moves = moved > 0;  // a paused machine keeps its last state
    this.before = {angle, time};
    const status = module.word(tab.id, made.labels.status);
    return [['Angle', `${(angle / ANGLES * 360).toFixed(1)} degrees`], ['Pictures', this.moves ? `${this.rate.toFixed(1)} a second${this.word & WIRE ? ', wire frames' : ''}` : 'stands still'],
      ['Model', `${made.edges} edges, ${made.events} events in a turn, ${made.words.toLocaleString('en')} words of core`], ['Status', STATUS[status] ?? String(status)]];
  }
}
