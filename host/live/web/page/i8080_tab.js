// The 8080 tab: Skala's pictures of functions, scenes in the stripes of Montani and Re, a flight with Willis's priorities. A raster board, a
// plotter or the priority display draws the picture at the machine's own speed.

import {Clock, button, check, choice, download, downloadPicture, element, factList, field, fileTaker, fold, group, introduction, notice, runFor} from './ui.js';
import {camera} from './camera.js';
import {Flight} from './flight.js';
import {oneOf, anyText, named, number as numeric, optionsOf} from './links.js';
import {COLOURS, GREYS, RasterImage} from './raster.js';
import {errorText} from './files.js';

const CLOCK = 3e6;  // T-states per second
const DOMAIN = 6;  // an expression is drawn from -6 to 6
const PENS = {calcomp: 'CalComp 565', minigraf: 'Minigraf 0507'};
const SCENES = [['boxes-5', 'five boxes'], ['boxes-8', 'eight boxes'], ['house', 'house'], ['roberts', 'notched block'], ['town-2', 'two houses of a town'], ['star.off', 'star'], ['crossed.off', 'two bars that interlock']];

export class I8080Tab {
  constructor(module, functions, remember) {
    this.module = module;
    this.functions = functions;
    this.remember = remember;
    this.options = {program: 'skala', scene: 'boxes-5', function: functions[0]?.name ?? 'sinc', text: '', picture: 'lines', device: 'ef9365', rotation: 30, elevation: 30, zoom: 1,
      points: 33, slices: 33, levels: 8, subdivide: 1, visibility: true, masks: true, antialias: false, speed: 1};
    this.flight = new Flight(module, () => this.restart());
    this.own = new Set();  // grids and scenes that are files of the user
    this.id = 0;
    this.clock = new Clock(seconds => this.picture(seconds));
    this.root = this.build();
  }

  build() {
    const o = this.options;
    this.canvas = element('canvas', {className: 'raster', width: 256, height: 256, role: 'img', 'aria-label': 'Picture of the 8080', tabIndex: 0});
    this.context = this.canvas.getContext('2d');
    this.image = new RasterImage();
    this.message = notice();
    this.facts = factList();
    const again = name => value => { o[name] = value; this.restart(); };
    const number = name => value => { const v = Number(value); if (Number.isFinite(v)) { o[name] = v; this.restart(); } };
    this.pick = choice('Function', [...this.functions.map(f => [f.name, f.name]), ['', 'an expression']], o.function, value => {
      o.function = value;
      this.words.hidden = value !== '';
      if (value !== '' || o.text) this.restart();
    }, 'The function of x and z whose surface is drawn');
    this.program = choice('Program', [['skala', "Skala: functions of two variables"], ['stripes', 'Montani and Re: scenes in stripes'], ['flight', 'Willis: a flight by priorities']], o.program, value => { o.program = value; this.offer(); this.restart(); }, 'The program that the 8080 runs');
    this.scene = choice('Scene', SCENES, o.scene, again('scene'), 'The solids that are drawn');
    this.words = field('f(x, z)', 'sin(x) * cos(z)', value => { o.text = value; this.restart(); }, {spellcheck: false, size: 28}, 'Height of the surface: an expression in x and z, which go from -6 to 6');
    this.words.hidden = true;
    o.text = 'sin(x) * cos(z)';
    this.turn = field('Rotation', o.rotation, number('rotation'), {type: 'number', step: 5}, 'Rotation of the picture about the vertical axis, in degrees');
    this.tilt = field('Elevation', o.elevation, number('elevation'), {type: 'number', min: -90, max: 90, step: 5}, 'Angle from which the picture is seen from above, in degrees');
    this.running = button('Pause', () => this.go(!this.on), 'Run or pause');
    const screen = this.screen = element('div', {className: 'screen board'}, this.canvas);
    this.drag();
    const tab = element('div', {className: 'tab'}, this.intro = introduction(),
      element('div', {className: 'stage'}, screen, element('p', {className: 'under'}, this.hint = element('span', {className: 'wide', textContent: 'Drag the picture to turn it.'}), this.running, ' ', button('Again', () => this.restart(), 'Draw it again'))),
      element('div', {className: 'desk'}, this.message,
        group('Program', this.program, this.scene, this.pick, this.words, this.flight.scene),
        this.look = group('Picture', this.kind = choice('Drawn as', ['lines', 'surface', 'contours'], o.picture, again('picture'), 'Lines of the surface, shaded surface, or lines of equal height'),
          this.device = choice('Device', [['ef9365', 'EF9365 raster board'], ['alt256', 'ALT-256 raster board'], ['calcomp', `${PENS.calcomp} plotter`], ['minigraf', `${PENS.minigraf} plotter`]], o.device, value => { o.device = value; this.offer(); this.restart(); }, 'What the 8080 draws on'),
          this.turn, this.tilt),
        fold('Options', ...this.flight.controls, ...this.ofSkala = [field('Zoom', o.zoom, number('zoom'), {type: 'number', min: 0.1, max: 10, step: 0.1}, 'Size of the picture; 1 fills the device'),
          field('Points along x', o.points, number('points'), {type: 'number', min: 2, max: 128}, 'Points of the grid in each slice; more are finer and slower'),
          field('Slices', o.slices, number('slices'), {type: 'number', min: 2, max: 128}, 'Rows of the grid, from the foreground to the background'),
          field('Contour levels', o.levels, number('levels'), {type: 'number', min: 1, max: 60}, 'Number of heights in a picture of contours'),
          field('Cells cut in', o.subdivide, number('subdivide'), {type: 'number', min: 1, max: 16}, 'Cells along a side of each cell of the grid, on smooth curves: for smooth contours. Lines become smooth, and not more'),
          check('Hidden lines removed', o.visibility, again('visibility'), 'If not set, all lines are drawn completely'),
          check('Temporary masks', o.masks, again('masks'), "If not set, the program leaves out Skala's masks M1T and M1B: lines that fall lose dots")],
          ...this.ofStripes = [check('Smooth edges', o.antialias, again('antialias'), 'Dots at edges have the mixed grey of the faces in them')],
          choice('Speed', [[1, 'real time, 3 MHz'], [10, '10 times'], [100, '100 times'], [0, 'as fast as possible'], [0.05, 'a twentieth']], o.speed, value => { o.speed = Number(value); }, 'How fast the machine runs, compared with an 8080 at 3 MHz')),
        this.cost8080 = fold('What visibility costs', element('p', {}, button('Measure', () => this.cost(), 'Draw the picture with and without its hidden lines, and compare the times')), this.costs = element('p', {role: 'status'})),
        fold('State', this.facts,
          element('p', {}, button('Save picture', () => downloadPicture(this.name, this.canvas), 'Save the picture as PNG'), ' ',
            this.saver = button('Save state', () => this.saveState(), 'Save a snapshot, the whole state of the machine, as a file'), ' ',
            fileTaker('Open a file')))));
    // After a choice from a list, the arrow keys turn the picture again.
    tab.addEventListener('change', event => { if (event.target instanceof HTMLSelectElement && document.activeElement !== event.target) this.canvas.focus({preventScroll: true}); });
    return tab;
  }

  drag() {
    let from = null;
    const o = this.options;
    const turn = (dx, dy) => {
      o.rotation = Math.round((from ? from.rotation : o.rotation) + dx * 0.5);
      o.elevation = Math.max(-90, Math.min(90, Math.round((from ? from.elevation : o.elevation) + dy * 0.4)));
      this.turn.input.value = o.rotation;
      this.tilt.input.value = o.elevation;
    };
    this.canvas.addEventListener('pointerdown', event => {
      if (this.flies) return;
      from = {x: event.clientX, y: event.clientY, rotation: o.rotation, elevation: o.elevation};
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener('pointermove', event => {
      if (!from) return;
      turn(event.clientX - from.x, event.clientY - from.y);
      this.fast = true;
      this.restart();
    });
    const end = () => { if (from && this.fast) { this.fast = false; } from = null; };
    this.canvas.addEventListener('pointerup', end);
    this.canvas.addEventListener('pointercancel', end);
    this.canvas.addEventListener('keydown', event => {
      const step = {ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, 12.5], ArrowDown: [0, -12.5]}[event.key];
      if (!step || this.flies) return;
      event.preventDefault();
      event.stopPropagation();
      turn(...step);
      this.restart();
    });
  }

  get flies() { return this.options.program === 'flight'; }
  // The name of the picture, for files.
  get name() {
    const o = this.options;
    return o.program === 'skala' ? o.function || 'expression' : this.flies ? this.flight.options.scene : o.scene;
  }
  // Shows the controls of the program.
  offer() {
    const {program} = this.options;
    const skala = program === 'skala';
    for (const each of [this.pick, this.kind, this.cost8080, ...this.ofSkala]) each.hidden = !skala;
    this.words.hidden = !skala || this.options.function !== '';
    this.scene.hidden = program !== 'stripes';
    for (const each of [this.flight.scene, ...this.flight.controls]) each.hidden = !this.flies;
    for (const each of [this.look, this.hint, this.saver]) each.hidden = this.flies;
    this.intro.say({
      skala: "An 8080[ of 1974, at 3 MHz,] draws a function of two variables[ by Skala's algorithm of 1985, its hidden lines removed]. Drag the picture to turn it.",
      stripes: 'An 8080[ of 1974, at 3 MHz,] draws solids in stripes[ after Montani and Re (1985), hidden parts removed]. Drag the picture to turn it.',
      flight: 'An 8080[ of 1974, at 3 MHz,] flies through houses: the nearer face hides the other[ (Willis 1977)]. Choose another scene.',
    }[program]);
    for (const option of this.device.select.options) option.hidden = option.disabled = program === 'stripes' && !['ef9365', 'calcomp'].includes(option.value);
    if (program === 'stripes' && !['ef9365', 'calcomp'].includes(this.options.device)) this.device.select.value = this.options.device = 'ef9365';
    for (const each of this.ofStripes) each.hidden = program !== 'stripes' || this.options.device !== 'ef9365';
  }

  // `name`: of a function or a file; empty: the expression. Throws if the expression is wrong.
  request(what, name = this.options.function) {
    const o = this.options;
    if (what === 'stripes') return {do: what, scene: o.scene, device: o.device, antialias: o.antialias, camera: camera(o.rotation, Math.max(0, Math.min(80, o.elevation)))};
    const request = {do: what, picture: o.picture, device: o.device, rotation: o.rotation, elevation: o.elevation, zoom: o.zoom, levels: o.levels, visibility: o.visibility, subdivide: o.subdivide, temporary_masks: o.masks};
    if (name !== '') return {...request, function: name, points: o.points, slices: o.slices};
    return {...request, function: o.text, expression: o.text, domain: DOMAIN, points: Math.min(128, o.points), slices: Math.min(128, o.slices)};
  }

  restart() {
    if (this.id) this.module.ask({do: 'drop', id: this.id});
    this.id = 0;
    let made;
    try { made = this.flies ? this.flight.make() : this.module.ask(this.request(this.options.program)); } catch (error) { made = {error: error.message}; }
    this.made = null;
    if (made.error) return this.message.say(made.error, true);
    this.message.say('');
    this.costs.textContent = '';
    this.id = made.id ?? 0;
    this.stream = made.stream;
    this.made = made;
    this.ended = this.shown = false;
    this.clearPaper();
    this.go(true);
    if (this.fast) this.picture(0);
    this.remember();
  }
  saveState() {
    const done = this.module.ask({do: 'save', id: this.id});
    if (done.error) return this.message.say(done.error, true);
    download(`${this.name}.snap`, this.module.made());
  }
  // Takes a file (files.js); false: this tab cannot use it. `way`, for a scene: stripes.
  take(file, way) {
    const o = this.options;
    const {name, kind} = file;
    if (kind === 'snapshot' && file.machine === 'i8080') {
      const refuse = text => { this.message.say(text, true); return true; };
      if (this.flies) return refuse(`${name}: a snapshot of a machine; a flight has none. Choose another program first.`);
      if (!this.id) return refuse(`${name}: a snapshot, and there is no machine to take it: choose the program that it was saved from.`);
      const done = this.module.ask({do: 'restore', id: this.id, file: name});
      if (done.error) return refuse(done.error);
      this.message.say('');
      this.clearPaper();
      this.ended = this.shown = false;
      this.go(true);
      return true;
    }
    if (kind !== 'grid' && kind !== 'scene') return false;
    const program = kind === 'grid' ? 'skala' : this.flies && !way ? 'flight' : 'stripes';
    // Tried before anything changes: if a flight cannot be made, the previous one stays.
    const tried = this.module.ask({skala: () => this.request(program, name), stripes: () => ({...this.request(program), scene: name}),
      flight: () => this.flight.request(name)}[program]());
    if (tried.error) { file.error = errorText(file, tried.error); return false; }
    if (tried.id) this.module.ask({do: 'drop', id: tried.id});
    const [box, options, option] = program === 'skala' ? [this.pick, o, 'function'] : program === 'stripes' ? [this.scene, o, 'scene'] : [this.flight.scene, this.flight.options, 'scene'];
    this.own.add(name);
    if (![...box.select.options].some(each => each.value === name)) box.select.append(element('option', {value: name, textContent: name}));
    box.select.value = options[option] = name;
    this.program.select.value = o.program = program;
    this.offer();
    this.restart();
    return true;
  }
  cost() {
    const answer = this.module.ask(this.request('cost'));
    if (answer.error) return this.message.say(answer.error, true);
    const ms = states => `${(states / CLOCK * 1000).toFixed(0)} ms`;
    this.costs.textContent = `With hidden lines removed ${ms(answer.with)} (${answer.with.toLocaleString('en')} clock cycles), all lines whole ${ms(answer.without)}: ${(answer.with / answer.without).toFixed(2)} times as long.`;
  }

  go(on) {
    this.on = on;
    this.running.textContent = on ? 'Pause' : 'Run';
  }
  enter() { this.offer(); if (!this.made) this.restart(); this.clock.start(); }
  leave() { this.clock.stop(); }
  key() { return false; }

  clearPaper() {
    const plotter = !this.flies && this.options.device in PENS;
    this.canvas.width = this.canvas.height = plotter ? 768 : this.flies ? this.flight.side : 256;
    this.canvas.classList.toggle('plotter', plotter);
    this.screen.classList.toggle('sheeted', plotter);
    this.penDown = false;
    if (plotter) { this.context.fillStyle = '#fbfaf4'; this.context.fillRect(0, 0, 768, 768); }
  }

  picture(seconds) {
    if (!this.made || this.shown) return;
    if (this.on && !this.ended) {
      const wanted = this.fast || !this.options.speed ? 1e12 : seconds * CLOCK * this.options.speed;
      const result = runFor(this.flies ? this.flight : this.module, this.id, wanted, 30000, this.fast ? 60 : this.clock.frames ? 1e9 : 12);
      if (result) {
        this.ended = true;
        this.reason = this.flies ? this.flight.status : this.module.reason();
        if (this.made.texts) this.reason = this.made.texts[this.module.word(this.id, this.made.status)];
      }
    }
    if (this.flies) this.flight.draw(this.context);
    else if (this.options.device in PENS) this.drawPen();
    else this.drawRaster();
    this.sinceState = (this.sinceState ?? 1) + seconds;
    if (this.sinceState > 0.2 || this.ended) { this.sinceState = 0; this.showState(); }
    this.shown = this.ended;  // nothing changes any more
  }
  drawRaster() {
    const dots = this.module.raster(this.id);
    if (dots) this.image.draw(this.context, dots, this.options.program === 'stripes' ? GREYS : COLOURS);
  }
  drawPen() {
    const marks = this.module.flashes(this.id);
    const {context} = this;
    context.fillStyle = context.strokeStyle = '#20304f';
    context.lineWidth = 1.6;
    for (let i = 0; i < marks.count; ++i) {
      const x = 3 * marks.x(i) + 1;
      const y = 766 - 3 * marks.y(i);
      if (this.penDown && Math.abs(this.penX - x) <= 3 && Math.abs(this.penY - y) <= 3) {
        context.beginPath();
        context.moveTo(this.penX, this.penY);
        context.lineTo(x, y);
        context.stroke();
      } else {
        context.fillRect(x - 0.8, y - 0.8, 1.6, 1.6);
      }
      this.penDown = true;
      this.penX = x;
      this.penY = y;
    }
  }
  showState() {
    const states = this.flies ? this.flight.ticks() : this.module.ticks(this.id);
    const rows = [['Emulated time', `${(states / CLOCK).toFixed(3)} s`], ['Clock cycles', states.toLocaleString('en'), 'T-states of the 8080: 3 million a second']];
    if (this.flies) rows.push(...this.flight.facts()); else rows.push(['Instructions', this.module.instructions(this.id).toLocaleString('en')]);
    rows.push(['Data received', `${this.stream.toLocaleString('en')} bytes`, 'What the 8080 reads: the heights of the function or the scene, as the computer beside it sends them']);
    if (this.made.faces) rows.push(['Faces', String(this.made.faces), 'Faces of the solids that the 8080 received']);
    if (this.ended) rows.push(['Done', this.reason]);
    this.facts.show(rows);
  }

  link() {
    const o = this.options;
    const local = name => this.own.has(name) ? {file: 1} : {};
    if (this.flies) return `skala/${this.flight.link(local)}`;
    const seen = {device: o.device, rotation: o.rotation, elevation: o.elevation};
    if (o.program === 'stripes') return `skala/${encodeURIComponent(`stripes ${o.scene}`)}?${new URLSearchParams({...seen, ...local(o.scene)})}`;
    return `skala/${encodeURIComponent(o.function)}?${new URLSearchParams({picture: o.picture, ...seen, ...(o.function === '' ? {f: o.text} : local(o.function))})}`;
  }
  open(part, query) {
    const o = this.options;
    const has = ({select}) => [...select.options].map(each => each.value);
    const program = ['stripes', 'flight'].find(each => part === each || part.startsWith(each + ' ')) ?? 'skala';
    const scene = part.slice(program.length + 1);
    if (program === 'flight') {
      this.flight.open(scene, query);
      o.program = program;
    } else {
      const look = {device: oneOf(program === 'stripes' ? ['ef9365', 'calcomp'] : has(this.device)), rotation: numeric(-1e6, 1e6), elevation: numeric(-90, 90)};
      const stripes = program === 'stripes';
      const changes = stripes ? (scene ? {scene: named('scene', scene, has(this.scene), query)} : {})
        : part ? {function: named('function', part, has(this.pick).filter(Boolean), query)} : query.has('f') ? {function: ''} : {};
      const {f, ...given} = optionsOf(query, stripes ? look : {picture: oneOf(has(this.kind)), ...look, ...(part ? {} : {f: anyText})});
      if (f !== undefined) {
        const {error} = this.module.ask({do: 'expression', expression: f});
        if (error) throw new Error(`The link has f=${f}: ${error}.`);
        changes.text = f;
      }
      Object.assign(o, {program}, changes, given);
    }
    this.pick.select.value = o.function;
    this.program.select.value = o.program;
    this.scene.select.value = o.scene;
    this.offer();
    this.words.input.value = o.text;
    this.device.select.value = o.device;
    this.kind.select.value = o.picture;
    this.turn.input.value = o.rotation;
    this.tilt.input.value = o.elevation;
    this.restart();
  }
}
