// The PDP-7 tab: Jones's program and others on the PDP-7 with its Type 340, controlled by the switches.

import {Clock, addWarnings, button, check, choice, download, downloadPicture, element, factList, field, fileTaker, fold, group, introduction, notice, runFor, stopName, takesKeys} from './ui.js';
import {Turning} from './turning.js';
import {AFTERGLOWS, PHOSPHOR, POINTS, SIDE} from './phosphor.js';
import {makeTube} from './tube.js';
import {oneOf, flag, named, number, octal, optionsOf} from './links.js';
import {errorText} from './files.js';

const AC = 1, LINK = 2, MQ = 3, SWITCHES = 5;
const MILLISECOND = 1e6;  // ticks
const PEN = 8;  // points; the radius that the light pen sees
const CORE = 8192;  // words of core of the machine for Jones's program

// Colours of exact lines that are drawn, of missing ones, and of points that are lit where no line is. For a pair in red and cyan the lines of the left eye
// are red, like its picture, and missing ones are yellow.
const RIGHT = '#4cc9f0', MISSING = '#ff4d4d', EXTRA = '#ff4dd2', PAIR_LEFT = '#ff8080', PAIR_MISSING = '#ffd43b', PEN_COLOUR = '#ffd43b';

// AC switches 0 to 7 of Jones's program (firmware/pdp7/jones/SPECIFICATION.md, section 6), and 8 and 9 of that with rotation, with their keys.
const WALK = [
  ['left', 'ArrowLeft'], ['right', 'ArrowRight'], ['up', 'u'], ['down', 'd'],
  ['in', 'ArrowUp'], ['out', 'ArrowDown'], ['bigger', '+'], ['smaller', '-'],
  ['turn left', ','], ['turn right', '.'],
];
const TURN = 8;  // the first switch that turns
const ARROWS = {ArrowLeft: '\u2190', ArrowRight: '\u2192', ArrowUp: '\u2191', ArrowDown: '\u2193'};

// A suggestion for each example.
const TRY = {
  'pen.s': 'Press the pointer on the picture: it is the light pen.',
  'echo.s': 'Under Teletype, type in the box.',
  'square.s': 'Under Panel, press START: it is drawn again.',
};

export const PROGRAMS = ['house', 'roberts', 'street4', 'corridor8', 'corridor32'];

export class Pdp7Tab {
  // `examples`: programs of the PDP-7 and, as `solids`, models that turn.
  constructor(module, examples, solids, remember) {
    this.module = module;
    this.turning = new Turning(module, solids, this);
    this.examples = examples.filter(each => each.machine === 'pdp7');
    this.remember = remember;
    this.options = {program: 'house', eae: true, stereo: false, immediate: false, redCyan: false, exact: false, through: false, rotate: false, glow: 'p7', scale: 512, speed: 1, switches: 0};
    this.id = 0;
    this.clock = new Clock(seconds => this.picture(seconds));
    this.litAt = new Float64Array(65536).fill(-1e18);  // time at which each block of 4 by 4 points was last lit
    this.lights = [];
    this.heldKeys = new Map();  // the action on release of each pressed key, by its code
    addEventListener('blur', () => this.releaseKeys());
    this.next = [0, 0, 0, 0];
    this.covered = new Uint8Array(65536);
    this.own = new Set();  // programs that are files of the user
    this.walks = new Set(PROGRAMS);  // scenes of cells
    this.root = this.build();
    this.slow = 0;
  }

  build() {
    const o = this.options;
    this.canvas = element('canvas', {className: 'tube', 'aria-label': 'Screen of the Type 340', role: 'img'});
    // A layer over the tube, shown only while it has content, because a visible layer costs time in every frame.
    this.glass = element('canvas', {className: 'glass', width: SIDE, height: SIDE, 'aria-hidden': 'true', hidden: true});
    const address = new URLSearchParams(location.search);
    this.tube = makeTube(this.canvas, {plain: address.has('plain'), fine: address.has('frames'), coarse: address.has('coarse')});
    this.message = notice();
    this.note = this.tube.kind !== 'plain' ? '' : 'This browser has no WebGL2 with float targets: the screen is drawn without its phosphor.';
    const screen = element('div', {className: this.tube.kind === 'plain' ? 'screen' : 'screen framed'}, this.canvas, this.glass,
      this.stopped = element('p', {className: 'stopped', role: 'status', hidden: true}));
    const point = event => {
      const box = screen.getBoundingClientRect();
      const x = Math.round((event.clientX - box.left) / box.width * SIDE - PHOSPHOR.margin);
      const y = Math.round((box.bottom - event.clientY) / box.height * SIDE - PHOSPHOR.margin);
      return x >= 0 && x < 1024 && y >= 0 && y < 1024 ? [x, y] : null;
    };
    const pen = (event, down) => {
      const place = down ? point(event) : null;
      if (this.id) this.module.ask({do: 'attach', id: this.id, device: 'pen', text: place ? `0 ${place[0]} ${place[1]} ${PEN}\n` : '0 off\n'});
      this.penAt = place;
      this.drawGlass();
    };
    screen.addEventListener('pointerdown', event => { screen.setPointerCapture(event.pointerId); pen(event, true); });
    screen.addEventListener('pointermove', event => { if (event.buttons) pen(event, true); });
    screen.addEventListener('pointerup', event => pen(event, false));
    screen.addEventListener('pointercancel', event => pen(event, false));

    this.programs = choice('Program', [...PROGRAMS.map(name => [name, `Jones: ${name}`]), ...this.turning.programs, ...this.examples.map(each => [each.name, each.title])], o.program,
      value => { o.program = value; o.switches = 0; this.restart(); }, 'The program that the PDP-7 runs');
    const speed = choice('Speed', [[1, 'real time'], [2, '2 times'], [10, '10 times'], [0, 'as fast as possible'], [0.1, 'a tenth']], o.speed, value => { o.speed = Number(value); }, 'How fast the machine runs, compared with a PDP-7');
    this.glow = choice('Afterglow', Object.entries(AFTERGLOWS).map(([name, {title}]) => [name, title]), o.glow, value => { o.glow = value; this.setGlow(); this.remember(); }, 'How long the screen glows after the beam has passed');
    const set = name => value => { o[name] = value; this.restart(); };
    this.running = button('Pause', () => this.toggle(), 'Run or pause');
    this.lamp = element('span', {className: 'lamp', role: 'img', 'aria-label': 'computing a view'});
    this.facts = factList();

    return element('div', {className: 'tab'}, this.intro = introduction(),
      element('div', {className: 'stage'}, screen,
        element('p', {className: 'under'}, element('span', {}, this.lamp, ' a view is being computed '), this.running)),
      element('div', {className: 'desk'},
        this.message,
        group('Program', this.programs),
        this.walk = group('Walk: hold a switch, or its key', this.walkPad(),
          this.through = check('Through portals, from cell to cell', o.through, value => { o.through = value; if (!value) o.rotate = this.rotate.box.checked = false; this.restart(); }, 'The program finds the cell of the eye and follows it through portals, which Jones left out. Otherwise the eye stays in the cell where it begins.'),
          this.rotate = check('The view turns', o.rotate, value => { o.rotate = value; if (value) o.through = this.through.box.checked = true; this.restart(); }, 'Two more switches turn the view, and the others move where it looks. The program is longer and takes up to twice as long for a view.'),
          button('Back to the start', () => { o.switches = 0; this.restart(); }, 'Back to the start: the program begins again, from the place where the walk began')), this.turning.group,
        fold('Options', speed, this.glow,
          this.eae = check('EAE: multiply and divide in hardware', o.eae, set('eae'), 'The extended arithmetic element, an option of the PDP-7. Without it the program multiplies and divides by subroutines, and is slower.'),
          this.stereo = check('Stereo pair', o.stereo, set('stereo'), 'Two pictures side by side, one for each eye'),
          this.redCyan = check('Pair as red and cyan', o.redCyan, value => this.showRedCyan(value), 'The two pictures of a stereo pair over each other, for red and cyan glasses'),
          this.immediate = check('Lines at once', o.immediate, set('immediate'), 'Each line is shown as soon as it is computed, not the whole view when it is complete'),
          this.scale = field('Scale at the start', o.scale, value => { o.scale = Math.max(64, Math.min(4096, Number(value) || 512)); this.restart(); }, {type: 'number', min: 64, max: 4096, step: 64}, 'Size of the picture when the walk begins, 64 to 4096; at 512 the field of view is 90 degrees'),
          this.exact = check('Exact visible lines over the picture', o.exact, value => { o.exact = value; this.sight(); }, 'Draws the exact visible lines over the picture, and marks the differences')),
        fold('Panel', this.panel()),
        fold('Teletype', this.teletype()),
        fold('State', this.facts,
          element('p', {}, button('Save picture', () => this.savePicture(), 'Save the picture on the screen as PNG'), ' ',
            button('Save state', () => this.save(), 'Save a snapshot, the whole state of the machine, as a file'), ' ',
            fileTaker('Open a file')))));
  }

  introduce() {
    const {program} = this.options;
    this.intro.say(this.walks.has(program) ? "A PDP-7 of 1965[ with its Type 340 display] runs Jones's hidden-line program. Hold an arrow key or a switch of Walk[ and see from another place]."
      : this.turns ? 'A PDP-7 of 1965 turns a solid[ on its Type 340 display], its hidden lines removed. Press “wire frame”[: every edge is shown].'
      : `A PDP-7 of 1965[ with its Type 340 display] ${this.example?.snapshot ? 'continues from a snapshot' : this.example?.file ? 'runs a tape' : 'runs an example'}. ${TRY[program] ?? 'Under Panel, press STOP, then STEP[: one instruction is executed, and the lamps of the panel show what it does].'}`);
  }

  walkPad() {
    const pad = element('div', {className: 'pad'});
    this.pads = WALK.map(([name, key], bit) => {
      const b = element('button', {type: 'button', className: 'hold', title: `${name}: AC switch ${bit}, key ${key}`}, `${name} `, element('kbd', {textContent: ARROWS[key] ?? key}));
      b.addEventListener('pointerdown', event => { b.setPointerCapture(event.pointerId); this.hold(bit, true); });
      for (const kind of ['pointerup', 'pointercancel', 'lostpointercapture']) b.addEventListener(kind, () => this.hold(bit, false));
      b.addEventListener('keydown', event => { if (event.key === ' ' || event.key === 'Enter') { event.preventDefault(); this.hold(bit, true); } });
      b.addEventListener('keyup', event => { if (event.key === ' ' || event.key === 'Enter') this.hold(bit, false); });
      pad.append(b);
      return b;
    });
    return pad;
  }

  // Red and cyan also switch the stereo pair on.
  showRedCyan(value) {
    this.options.redCyan = value;
    if (!value || this.options.stereo) return this.drawGlass();
    this.options.stereo = this.stereo.box.checked = true;
    this.restart();
  }

  hold(bit, down) {
    const mask = 1 << (17 - bit);
    this.setSwitches(down ? this.options.switches | mask : this.options.switches & ~mask);
  }
  setSwitches(word) {
    this.options.switches = word;
    if (this.id) this.module.set(this.id, SWITCHES, this.switchWord());
    this.toggles.forEach((box, bit) => box.setAttribute('aria-checked', String(Boolean(this.switchWord() >> (17 - bit) & 1))));
    this.pads.forEach((b, bit) => b.classList.toggle('down', Boolean(word >> (17 - bit) & 1)));
    if (this.turns) this.turning.showSwitches();
  }
  // The switches; those that only Jones's program uses are set by controls.
  switchWord() { return this.turns ? this.options.switches : this.options.switches | (this.options.stereo ? 1 : 0) | (this.options.immediate ? 2 : 0); }

  panel() {
    const row = (name, bits, title) => {
      const lamps = Array.from({length: bits}, () => element('i'));
      const line = element('div', {className: 'lights', role: 'img', 'aria-label': name, title}, element('b', {textContent: name}), element('span', {className: 'bulbs'}, ...lamps));
      this.lights.push({name, line, lamps, bits, shown: -1});
      return line;
    };
    this.toggles = Array.from({length: 18}, (_, bit) => element('button', {
      type: 'button', className: 'switch', role: 'switch', 'aria-checked': 'false', title: `AC switch ${bit}`, 'aria-label': `AC switch ${bit}`,
      onclick: () => { this.setSwitches(this.options.switches ^ (1 << (17 - bit))); this.remember(); },
    }));
    this.address = element('input', {className: 'octal', value: '00100', 'aria-label': 'Address, octal', size: 7});
    const at = () => parseInt(this.address.value, 8) || 0;
    const ask = (request, then = () => {}) => {
      const answer = this.module.ask({id: this.id, ...request});
      if (answer.error) this.message.say(answer.error, true); else { this.message.say(''); then(answer); }
      this.showState();
    };
    return element('div', {className: 'panel'},
      row('AC', 18, 'Accumulator'), row('MQ', 18, 'Multiplier-quotient register of the EAE'), row('L', 1, 'Link: carry of the accumulator'), row('PC', 15, 'Program counter: address of the next instruction'),
      row('MB', 18, 'Memory buffer: the word at that address'), row('RUN', 1, 'Lit while the machine runs'),
      element('div', {className: 'switches', role: 'group', 'aria-label': 'Accumulator switches'}, ...this.toggles),
      element('p', {className: 'keys'},
        element('label', {}, 'address ', this.address), ' ',
        button('START', () => ask({do: 'start', at: at()}, () => this.go(true)), 'START the program at the address'),
        button('STOP', () => this.go(false), 'STOP the machine'), button('CONTINUE', () => this.go(true), 'CONTINUE where it stopped'),
        button('STEP', () => { this.go(false); ask({do: 'step'}); }, 'One instruction'),
        button('BACK', () => { this.go(false); ask({do: 'back'}); }, 'One instruction back in time'),
        button('EXAMINE', () => ask({do: 'memory', at: at(), count: 1}, answer => { this.address.value = (at() + 1).toString(8).padStart(5, '0'); this.message.say(`${answer.address}: ${answer.words[0]}`); }), 'EXAMINE: show the word at the address, and advance to the next address'),
        button('DEPOSIT', () => ask({do: 'put', at: at(), word: this.switchWord()}, () => { this.address.value = (at() + 1).toString(8).padStart(5, '0'); }), 'DEPOSIT: put the word of the switches into the address, and advance to the next address'),
        button('READ IN', () => this.tape ? ask({do: 'load', file: this.tape, start: true}, () => this.readIn()) : this.message.say('Open a tape first.', true), 'READ IN the tape that was opened')));
  }

  teletype() {
    this.paper = element('pre', {className: 'paper', 'aria-live': 'polite', 'aria-label': 'What the teletype has printed'});
    const keys = element('input', {className: 'keys', placeholder: 'type here', 'aria-label': 'Keys of the teletype', autocomplete: 'off'});
    keys.addEventListener('keydown', event => {
      if (event.key === 'Tab' || event.ctrlKey || event.metaKey || event.altKey) return;
      const code = event.key === 'Enter' ? 13 : event.key === 'Backspace' ? 127 : event.key === 'Escape' ? 27 : event.key.length === 1 ? event.key.charCodeAt(0) : 0;
      if (!code || code > 127 || !this.id) return;
      event.preventDefault();
      this.module.type(this.id, code);
    });
    return element('div', {}, this.paper, keys);
  }

  // --- Machines

  get example() { return this.examples.find(each => each.name === this.options.program); }

  // `restored`: a machine that continues from a snapshot (openSnapshot).
  restart(restored = null) {
    if (this.id) this.module.ask({do: 'drop', id: this.id});
    this.id = 0;
    this.labels = null;
    this.view = null;
    this.lastViews = -1;
    this.begun = false;
    this.lines = null;
    this.warned = [];
    this.facts.show([]);
    this.paper.textContent = '';
    this.begin();
    this.go(false);
    this.stopped.hidden = true;
    const o = this.options;
    this.showParts();
    const {example} = this;
    let made;
    if (restored) {
      made = restored;
      this.labels = made.labels && this.walks.has(o.program) ? made.labels : null;
    } else if (this.walks.has(o.program)) {
      made = this.module.ask({do: 'jones', scene: o.program, eae: o.eae, walk: o.through, rotation: o.rotate, stereo: o.stereo, immediate: o.immediate, scale: o.scale, switches: o.switches});
      this.labels = made.labels;
    } else if (this.turns) {
      made = this.turning.make();
    } else if (example?.snapshot) {
      made = restored = this.module.ask({do: 'make', snapshot: example.snapshot, options: example.with});
    } else {
      const options = {'--display': true, [o.eae ? '--eae' : '--no-eae']: true, '--display-option': ['342', '347']};
      if (example?.file) {
        made = this.module.ask({do: 'make', machine: 'pdp7', options: {...options, '--load': [example.file]}});
      } else {
        const assembled = this.module.ask({do: 'assemble', machine: 'pdp7', name: 'example.rim', sources: [{name: example.name, text: example.text}], options: example.options ?? {}});
        made = assembled.error || !assembled.right
          ? {error: assembled.error ?? assembled.diagnostics.map(each => each.text).join('\n')}
          : {start: assembled.start, ...this.module.ask({do: 'make', machine: 'pdp7', options: {...options, '--load': ['example.rim']}, symbols: assembled.symbols, listing: assembled.listing})};
      }
    }
    if (made.error) return this.message.say(made.error, true);
    this.id = made.id;
    const start = made.labels?.start ?? made.start;
    if (typeof start === 'number') this.address.value = start.toString(8).padStart(5, '0');
    this.message.say((made.warnings ?? []).join('\n') || this.note);
    if (restored) this.takeSwitches();
    this.setSwitches(o.switches);
    this.begin();
    this.go(true);
    this.sight();
    this.remember();
  }
  // Shows the controls of the chosen program.
  showParts() {
    const {program} = this.options;
    const jones = this.walks.has(program);
    this.turns = this.turning.owns(program);
    this.walk.hidden = !jones;
    this.pads.forEach((b, bit) => { b.hidden = bit >= TURN && !this.options.rotate; });
    this.introduce();
    this.turning.group.hidden = !this.turns;
    this.exact.hidden = !jones && !this.turns;
    this.eae.hidden = Boolean(this.example?.snapshot);
    for (const each of [this.stereo, this.redCyan, this.immediate, this.scale, this.lamp.parentElement]) each.hidden = !jones;
  }
  // Sets the controls to the switches of a restored machine.
  takeSwitches() {
    const o = this.options;
    const word = this.module.get(this.id, SWITCHES);
    if (this.labels) { o.stereo = Boolean(word & 1); o.immediate = Boolean(word & 2); }
    o.switches = this.labels ? word & ~3 : word;
    this.eae.box.checked = o.eae;
    this.through.box.checked = o.through;
    this.rotate.box.checked = o.rotate;
    this.stereo.box.checked = o.stereo;
    this.immediate.box.checked = o.immediate;
  }

  // Opens a snapshot, if possible with the program from which it was saved (one of Jones's, or the solid that is chosen or named), otherwise
  // without a known program. Returns a complaint, or ''.
  openSnapshot({name, configuration}) {
    const o = this.options;
    const eae = configuration.includes('--eae');
    const likely = [o.program, name.replace(/( ?\(\d+\))?\.snap$/, '')];
    const before = {...o}, {made: turned} = this.turning;
    // A solid has its tape in the reader, and a machine with another tape rejects the snapshot.
    for (const program of likely.filter(each => this.turning.owns(each))) {
      Object.assign(o, {program, eae});
      const made = this.turning.make();
      if (!made.error && !this.module.ask({do: 'restore', id: made.id, file: name}).error) return this.goOn(program, made);
      if (made.id) this.module.ask({do: 'drop', id: made.id});
    }
    Object.assign(o, before);
    this.turning.made = turned;
    // A snapshot does not contain the tape that was in the reader.
    let given = {}, made = this.module.ask({do: 'make', snapshot: name});
    if (made.error && this.tape) made = this.module.ask({do: 'make', snapshot: name, options: given = {'--reader': this.tape}});
    if (made.error) return made.error.includes('section "reader"') ? `${made.error}\nOpen the tape first, or choose the solid that turned, and then open the snapshot.` : made.error;
    o.eae = eae;
    for (const program of new Set([...likely, ...this.walks])) {
      for (const [through, rotate] of [[false, false], [true, false], [true, true]]) {
        const labels = this.walks.has(program) && this.labelsIn(made.id, program, through, rotate);
        if (!labels) continue;
        Object.assign(o, {through, rotate});
        return this.goOn(program, {...made, labels});
      }
    }
    const program = `snapshot ${name}`;
    this.keep({name: program, snapshot: name, with: given});
    return this.goOn(program, made);
  }
  goOn(program, made) {
    this.options.program = this.programs.select.value = program;
    this.restart(made);
    return '';
  }
  // The labels of Jones's program with a scene, if the machine has them in core: all words of the scene, and those of the program except a few
  // that it changes. A program that goes through portals changes the scene's header and the records of its portals.
  labelsIn(id, scene, through, rotate) {
    const {module} = this;
    const fresh = module.ask({do: 'jones', scene, eae: this.options.eae, walk: through, rotation: rotate});
    if (fresh.error) return null;
    const {labels} = fresh;
    let changed = 0;
    for (let at = 0; at < CORE; ++at) {
      const word = module.word(fresh.id, at);
      const ofScene = at >= labels.scene && at < labels.scene + fresh.scene_words;
      if (word !== module.word(id, at) && (word || ofScene && !through)) changed += ofScene ? CORE : 1;
    }
    module.ask({do: 'drop', id: fresh.id});
    return changed <= 16 ? labels : null;
  }

  // Called after a tape was read in: the labels of the chosen program are no longer valid.
  readIn() {
    const program = `tape ${this.tape}`;
    this.keep({name: program, file: this.tape});
    this.options.program = this.programs.select.value = program;
    this.labels = this.view = this.lines = null;
    this.warned = [];
    this.showParts();
    this.begin();
    this.go(true);
    this.remember();
  }
  // Called when a program begins: clears the screen and the figures.
  begin() {
    this.tube.clear(this.time);
    this.litAt.fill(-1e18);
    this.watchedFrom = this.time;
    this.refresh = null;
    if (this.id) this.before = this.first = this.passes();
    this.drawGlass();
  }
  // Emulated time in seconds.
  get time() { return this.id ? this.module.ticks(this.id) / 1e9 : 0; }
  passes(state = this.module.ask({do: 'state', id: this.id})) { return {time: state.ticks / 1e9, count: state.times.passes}; }

  setGlow() { this.tube.afterglow = AFTERGLOWS[this.options.glow]; }

  // Takes a file (files.js); false: this tab cannot use it. `way`, for a scene: walk or turn.
  take(file, way) {
    const {name, kind} = file;
    if (file.machine !== 'pdp7' && !(kind === 'scene' && way)) return false;
    const refuse = text => { this.message.say(text, true); return true; };
    if (kind === 'program') {
      const done = this.module.ask({do: 'attach', id: this.id, device: 'reader', file: name});
      if (done.error) return refuse(done.error);
      this.tape = name;
      this.message.say(`${name} is in the reader. READ IN loads it as a program.`);
    } else if (kind === 'snapshot') {
      const complaint = this.openSnapshot(file);
      if (complaint) return refuse(complaint);
    } else if (kind === 'source') {
      const text = new TextDecoder().decode(file.bytes);
      const made = this.module.ask({do: 'assemble', machine: 'pdp7', name: 'own.rim', sources: [{name, text}]});
      if (!made.right) { file.error = made.error ?? made.diagnostics.slice(0, 5).map(each => each.text).join('\n'); return false; }
      this.keep({name, text});
      this.add(name, name);
    } else if (way === 'walk') {
      const made = this.module.ask({do: 'jones', scene: name});
      if (made.error) { file.error = errorText(file, made.error); return false; }
      this.module.ask({do: 'drop', id: made.id});
      this.walks.add(name);
      this.add(name, `Jones: ${name}`);
    } else {
      const error = this.turning.add(name);
      if (error) { file.error = errorText(file, error); return false; }
      this.add(this.turning.programOf(name), `Turn: ${name}`);
    }
    return true;
  }
  // Keeps a program of the user that is neither a scene nor a solid.
  keep(example) {
    this.examples = [...this.examples.filter(each => each.name !== example.name), example];
    this.list(example.name, example.name);
  }
  list(program, title) {
    this.own.add(program);
    const {select} = this.programs;
    if (![...select.options].some(each => each.value === program)) select.append(element('option', {value: program, textContent: title}));
  }
  // Adds a program of the user and runs it.
  add(program, title) {
    this.list(program, title);
    this.programs.select.value = this.options.program = program;
    this.options.switches = 0;
    this.restart();
  }
  // Saves the screen as shown, with the exact lines if they are visible.
  savePicture() {
    this.tube.develop();  // draws again, because the browser may have cleared it
    const {width, height} = this.canvas;
    const whole = element('canvas', {width, height});
    const context = whole.getContext('2d');
    for (const each of [this.canvas, this.glass]) if (!each.hidden) context.drawImage(each, 0, 0, width, height);
    downloadPicture(this.options.program, whole);
  }
  save() {
    const done = this.module.ask({do: 'save', id: this.id});
    if (done.error) return this.message.say(done.error, true);
    download(`${this.options.program.replace(/^snapshot |\.snap$/g, '')}.snap`, this.module.made());
  }

  // `why`: the reason for which the machine stops.
  go(on, why = 'paused') {
    this.on = on;
    this.lamp.parentElement.style.visibility = on ? '' : 'hidden';  // keeps its space
    this.running.textContent = on ? 'Pause' : 'Run';
    this.stopped.textContent = on ? '' : why;
    this.stopped.hidden = on;
    this.showState();
  }
  toggle() { this.go(!this.on); }
  enter() { if (!this.id) this.restart(); this.clock.start(); }
  leave() {
    this.releaseKeys();
    this.clock.stop();
  }

  key(event, down) {
    if (!down) return this.releaseKey(event.code);
    if (!this.id || event.ctrlKey || event.altKey || event.metaKey || takesKeys(event.target)) return false;
    if (this.turns) return this.turning.key(event);
    const bit = WALK.findIndex(([, key]) => key === event.key || key === event.key.toLowerCase());
    return bit >= 0 && (bit < TURN || this.options.rotate) && Boolean(this.labels) && this.holdKey(event, down => this.hold(bit, down));
  }
  // A key that acts while it is pressed. It is identified by its code, because its character may differ on release.
  holdKey(event, act) {
    if (event.repeat || this.heldKeys.has(event.code)) return true;
    this.heldKeys.set(event.code, () => act(false));
    act(true);
    return true;
  }
  releaseKey(code) {
    const release = this.heldKeys.get(code);
    this.heldKeys.delete(code);
    release?.();
    return Boolean(release);
  }
  // A window without the focus receives no keyup events.
  releaseKeys() { for (const code of [...this.heldKeys.keys()]) this.releaseKey(code); }

  // --- Pictures

  picture(seconds) {
    if (!this.id) return;
    if (this.on) {
      const wanted = this.options.speed ? seconds * 1e9 * this.options.speed : 1e12;
      const result = runFor(this.module, this.id, wanted, this.options.speed && this.options.speed < 3 ? MILLISECOND : 4 * MILLISECOND, this.clock.frames ? 1e9 : 12);
      if (result) {
        const reason = this.module.reason();
        this.go(false, stopName(result, reason));
        addWarnings(this.module, this.id, this.warned, true);
        this.message.say([reason, ...this.warned].join('\n'));
      }
    }
    const flashes = this.module.flashes(this.id);
    if (this.lines) {
      for (let i = 0; i < flashes.count; ++i) this.litAt[256 * (flashes.y(i) >> 2) + (flashes.x(i) >> 2)] = flashes.time(i);
    }
    this.tube.show(flashes, this.time, !this.on);
    const printed = this.module.printed(this.id);
    if (printed) this.paper.textContent = (this.paper.textContent + [...printed].map(c => String.fromCharCode(c.charCodeAt(0) & 127)).join('').replace(/\r|\0|\x7f/g, '')).slice(-8000);
    // Fifteen times a second is fast enough for lamps.
    this.sinceLights = (this.sinceLights ?? 1) + seconds;
    if (this.sinceLights > 0.06 || !this.on) { this.sinceLights = 0; this.showLights(); }
    this.watchViews();
    this.sinceState = (this.sinceState ?? 1) + seconds;
    if (this.sinceState > 0.25) {
      this.sinceState = 0;
      this.showState();
      if (this.on && addWarnings(this.module, this.id, this.warned, false)) this.message.say(this.warned.join('\n'), true);
      if (this.turns && this.options.exact) this.sight();
      else if (this.lines) this.drawGlass();
    }
    // If the frame rate is too low, pictures are drawn with fewer pixels.
    this.slow = seconds > 0.15 ? this.slow + 3 : seconds > 0.036 ? this.slow + 1 : Math.max(0, this.slow - 0.25);
    if (this.slow > 6 && !this.clock.frames && this.on && this.tube.coarser()) this.slow = 0;
  }

  showLights() {
    const {module, id} = this;
    const pc = module.get(id, 0);
    const values = {AC: module.get(id, AC), MQ: module.get(id, MQ), L: module.get(id, LINK), PC: pc, MB: module.word(id, pc), RUN: this.on ? 1 : 0};
    for (const light of this.lights) {
      const value = values[light.name];
      if (value === light.shown) continue;
      const changed = light.shown < 0 ? -1 : value ^ light.shown;
      light.shown = value;
      for (let i = 0; i < light.bits; ++i) {
        if (changed >> (light.bits - 1 - i) & 1) light.lamps[i].className = value >> (light.bits - 1 - i) & 1 ? 'on' : '';
      }
    }
  }

  // Finds the view that is shown and its eye; the program counts complete views.
  watchViews() {
    if (!this.labels) return;
    const {module, id, labels} = this;
    const views = module.word(id, labels.views);
    // The program computes without a pause; the lamp is off for a moment after each complete view.
    if (views !== this.lastViews) this.viewAt = performance.now();
    this.lamp.classList.toggle('on', this.on && performance.now() - this.viewAt > 120);
    if (views !== this.lastViews) {
      // The program has begun the next view: the eye of this one is that of the last frame.
      const [x, y, z, scale, angle] = this.begun ? this.next : this.where();
      this.view = {eye: [x, y, z], scale, angle, views};
      this.lastViews = views;
      this.sight();
    }
    this.where();
    this.begun = true;
  }

  // The eye, the scale and, with rotation, the angle of the view that is being computed.
  where() {
    const {module, id, labels, next} = this;
    const signed = at => { const word = module.word(id, at); return word & 0o400000 ? word - 0o1000000 : word; };
    next[0] = signed(labels.ex);
    next[1] = signed(labels.ey);
    next[2] = signed(labels.ez);
    next[3] = module.word(id, labels.scale);
    next[4] = labels.angle ? module.word(id, labels.angle) : undefined;
    return next;
  }

  sight() {
    const watched = this.lines !== null;
    this.lines = null;
    if (this.options.exact && this.turns && this.id) this.lines = this.turning.lines();
    if (this.options.exact && this.labels && this.view) {
      const answer = this.module.ask({do: 'sight', scene: this.options.program, eye: this.view.eye, scale: this.view.scale, angle: this.view.angle, stereo: this.options.stereo});
      if (answer.lines) this.lines = answer.lines;
    }
    if (!watched) this.watchedFrom = this.time;
    this.drawGlass();
  }
  drawGlass() {
    const context = this.glassContext ??= this.glass.getContext('2d');
    if (!this.glass.hidden) context.clearRect(0, 0, SIDE, SIDE);
    this.tube.pair = Boolean(this.labels) && this.options.redCyan && this.options.stereo;
    this.glass.hidden = !this.lines && !this.penAt;
    if (this.lines) this.drawLines(context);
    if (this.penAt) {
      const [x, y] = this.penAt;
      context.lineWidth = 2;
      context.strokeStyle = PEN_COLOUR;
      context.beginPath();
      context.arc(x + 0.5 + PHOSPHOR.margin, SIDE - (y + 0.5 + PHOSPHOR.margin), PEN, 0, 2 * Math.PI);
      context.stroke();
    }
  }
  drawLines(context) {
    // In blocks of 4 by 4 points: blocks that a line should light and that are dark, and lit blocks without a line.
    // While the picture moves, the lit blocks are those of a moment ago; only the lines are then drawn.
    // Blocks lit before the lines were requested are unknown.
    const span = this.turns ? 0.1 : 0.3;
    const now = 1e9 * (this.time - span);
    const compared = this.compared = !(this.turns && this.turning.moves) && this.time >= this.watchedFrom + span;
    const lit = block => !compared || this.litAt[block] > now;
    const near = (x, y, test) => {
      for (let dy = -1; dy <= 1; ++dy) for (let dx = -1; dx <= 1; ++dx) {
        const bx = (x >> 2) + dx, by = (y >> 2) + dy;
        if (bx >= 0 && bx < 256 && by >= 0 && by < 256 && test(256 * by + bx)) return true;
      }
      return false;
    };
    const covered = this.covered.fill(0);
    const {pair} = this.tube;
    const quarter = POINTS / 4;
    // For a pair in red and cyan, both halves are in the middle, where the tube shows them.
    const X = (x, left) => x + PHOSPHOR.margin + (!pair ? 0 : left ? quarter : -quarter), Y = y => SIDE - (y + PHOSPHOR.margin);
    context.lineWidth = 2;
    this.missing = this.extra = compared ? 0 : null;
    for (const [x0, y0, x1, y1] of this.lines) {
      const left = x0 + x1 < POINTS;
      const colour = pair && left ? PAIR_LEFT : RIGHT, wrong = pair ? PAIR_MISSING : MISSING;
      const parts = Math.max(1, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / 4));
      const at = t => [x0 + (x1 - x0) * t, y0 + (y1 - y0) * t];
      // The centre of a point.
      const spot = ([x, y]) => [X(x + 0.5, left), Y(y + 0.5)];
      for (let i = 0; i < parts; ++i) {
        const [x, y] = at((i + 0.5) / parts);
        near(x, y, block => { covered[block] = 1; return false; });
        const right = near(x, y, lit);
        if (!right) ++this.missing;
        context.strokeStyle = right ? colour : wrong;
        context.beginPath();
        context.moveTo(...spot(at(i / parts)));
        context.lineTo(...spot(at((i + 1) / parts)));
        context.stroke();
      }
    }
    if (!compared) return;
    context.fillStyle = EXTRA;
    for (let block = 0; block < 65536; ++block) {
      if (covered[block] || !lit(block)) continue;
      ++this.extra;
      context.fillRect(X(4 * (block & 255), (block & 255) < 128), Y(4 * (block >> 8)) - 4, 4, 4);
    }
  }

  showState() {
    if (!this.id) return;
    const state = this.module.ask({do: 'state', id: this.id});
    const times = state.times;
    const now = this.passes(state);
    const elapsed = now.time - this.before.time;
    if (elapsed > 0.2) this.refresh = (now.count - this.before.count) / elapsed;
    if (elapsed > 0.2 || elapsed < 0) this.before = now;  // BACK goes back in time
    const drawn = now.count - this.first.count;
    const rate = this.refresh ? `${this.refresh.toFixed(1)} a second${this.refresh < 30 ? ', it flickers' : ''}` : this.refresh === null && this.on ? 'not measured yet' : 'none';
    const refresh = drawn > 1 ? rate : drawn === 1 ? 'none: the program has drawn once' : 'none';
    const rows = [['Emulated time', state.time], ['Instructions', state.instructions.toLocaleString('en')], ['Stolen cycles', times.stolen_cycles.toLocaleString('en')],
      ['Refresh', refresh], ['Next', state.status.split('\n')[0]]];
    if (this.turns) rows.push(...this.turning.facts(now.time));
    if (this.lines) rows.push(['Exact lines', this.differences()]);
    if (this.labels?.stops && this.options.through) {
      const stops = this.module.word(this.id, this.labels.stops), status = this.module.word(this.id, this.labels.status);
      rows.push(['Walk', status === 7 ? 'the eye is in no cell' : stops ? `a wall stops the eye along ${['x', 'y', 'z'].filter((_, axis) => stops >> axis & 1).join(', ')}` : 'free']);
    }
    if (this.view) rows.push(['View', `${this.view.views}, eye ${this.view.eye.join(' ')}, scale ${this.view.scale}${this.view.angle === undefined ? '' : `, ${this.view.angle} degrees`}`]);
    this.facts.show(rows);
  }

  // The differences between the picture and the exact lines.
  differences() {
    if (!this.compared) return this.turns && this.turning.moves ? 'of this angle; they are compared with the picture when the solid stands still' : 'compared with the picture when the machine has run for a moment';
    const {missing, extra} = this;
    if (!missing && !extra) return 'the picture shows all of them, and nothing else';
    const lengths = `${missing} ${missing === 1 ? 'piece' : 'pieces'} of a line, 4 points long each, ${missing === 1 ? 'is' : 'are'} not in the picture (drawn ${this.tube.pair ? 'yellow' : 'red'})`;
    return `${lengths}; ${extra} ${extra === 1 ? 'square' : 'squares'} of 4 by 4 points ${extra === 1 ? 'is' : 'are'} lit where no line is (magenta)`;
  }

  // --- Links: #jones/street4?switches=400000&eae=0

  link() {
    const o = this.options;
    const parts = new URLSearchParams();
    if (o.switches) parts.set('switches', o.switches.toString(8));
    if (!o.eae) parts.set('eae', '0');
    if (o.through) parts.set('through', '1');
    if (o.rotate) parts.set('rotate', '1');
    if (o.stereo) parts.set('stereo', '1');
    if (o.immediate) parts.set('immediate', '1');
    if (o.exact) parts.set('exact', '1');
    if (o.glow !== 'p7') parts.set('glow', o.glow);
    if (o.scale !== 512) parts.set('scale', o.scale);
    if (this.own.has(o.program)) parts.set('file', '1');
    const text = parts.toString();
    return `jones/${encodeURIComponent(o.program)}${text ? '?' + text : ''}`;
  }
  open(part, query) {
    const o = this.options;
    const program = part ? named('program', part, [...this.programs.select.options].map(each => each.value), query) : o.program;
    const given = optionsOf(query, {switches: octal(6), eae: flag, through: flag, rotate: flag, stereo: flag, immediate: flag, exact: flag, scale: number(64, 4096), glow: oneOf(Object.keys(AFTERGLOWS))});
    Object.assign(o, {switches: 0, eae: true, through: false, rotate: false, stereo: false, immediate: false, exact: false, scale: 512, glow: 'p7', ...given, program});
    if (o.rotate) o.through = true;
    this.scale.input.value = o.scale;
    this.programs.select.value = o.program;
    this.eae.box.checked = o.eae;
    this.through.box.checked = o.through;
    this.rotate.box.checked = o.rotate;
    this.stereo.box.checked = o.stereo;
    this.immediate.box.checked = o.immediate;
    this.exact.box.checked = o.exact;
    this.glow.select.value = o.glow;
    this.setGlow();
    this.restart();
  }
}
