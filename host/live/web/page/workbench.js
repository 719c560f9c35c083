// The workbench: edits, assembles, runs and debugs a program, forward and back, on either machine.

import {Clock, addWarnings, button, check, choice, download, element, field, fileTaker, fold, group, introduction, notice, runFor, stopName} from './ui.js';
import {RasterImage} from './raster.js';
import {makeTube} from './tube.js';
import {named, optionsOf} from './links.js';

const CPM_ORIGIN = 0x100, LARGEST_ADDRESS = 0xFFFF;
const ERRORS = 'The source has errors.';
const MACHINES = {
  pdp7: {title: 'PDP-7', second: 1e9, dialects: ['dec', 'bell'], options: {'--display': true, '--display-option': ['342', '347']}},
  i8080: {title: '8080', second: 3e6, dialects: ['common', 'mac', 'm80', 'intel'], options: {}},
};

export class Workbench {
  constructor(module, examples, remember) {
    this.module = module;
    this.examples = examples;
    this.remember = remember;
    this.own = new Set();  // programs that are files of the user
    this.id = 0;
    this.breaks = new Set();
    this.registers = new Map();
    this.words = new Map();
    this.clock = new Clock(seconds => this.picture(seconds));
    this.current = examples[0];
    this.root = this.build();
    this.show(this.current);
  }

  build() {
    this.message = notice();
    this.shelf = choice('Example', this.examples.map(each => [each.name, each.title]), this.current?.name, value => this.show(this.examples.find(each => each.name === value)), 'A program to begin with');
    this.machine = choice('Machine', Object.entries(MACHINES).map(([name, {title}]) => [name, title]), 'pdp7', () => this.offerDialects(), 'The machine that the source is for');
    this.dialect = choice('Dialect', ['dec'], 'dec', () => {}, 'The assembly language: whose assembler the source was written for');
    this.editor = element('textarea', {className: 'editor', spellcheck: false, 'aria-label': 'Source', wrap: 'off'});
    this.numbers = element('pre', {className: 'numbers', 'aria-hidden': 'true'});
    this.editor.addEventListener('input', () => this.countLines());
    this.editor.addEventListener('scroll', () => { this.numbers.scrollTop = this.editor.scrollTop; });
    this.editor.addEventListener('keydown', event => {
      if (event.key === 'Tab' && !event.shiftKey && !event.ctrlKey) { event.preventDefault(); this.editor.setRangeText('\t', this.editor.selectionStart, this.editor.selectionEnd, 'end'); this.countLines(); }
      if (event.key === 'Escape') this.editor.blur();
    });
    this.errors = element('ul', {className: 'errors', 'aria-live': 'polite'});
    this.listing = element('pre', {className: 'listing', tabIndex: 0, 'aria-label': 'Listing'});
    this.code = element('table', {className: 'code'}, element('caption', {textContent: 'The next instruction is marked; a dot sets a breakpoint'}));
    this.registerBox = element('dl', {className: 'registers'});
    this.memoryAt = field('Memory at', '0', () => this.showMemory(), {size: 8, spellcheck: false}, 'Shows memory from this address on: a number or a name of the program');
    this.memory = element('pre', {className: 'memory', tabIndex: 0, 'aria-label': 'Memory'});
    this.past = element('pre', {className: 'history', tabIndex: 0, 'aria-label': 'Last instructions'});
    this.symbols = element('pre', {className: 'listing', tabIndex: 0, 'aria-label': 'Symbols'});
    this.output = element('pre', {className: 'paper', 'aria-label': 'Console', 'aria-live': 'polite'});
    this.keys = element('input', {placeholder: 'keys for the program', 'aria-label': 'Keys for the program', autocomplete: 'off'});
    this.keys.addEventListener('keydown', event => {
      const code = event.key === 'Enter' ? 13 : event.key.length === 1 && !event.ctrlKey && !event.metaKey ? event.key.charCodeAt(0) : 0;
      if (!code || code > 127 || !this.id) return;
      event.preventDefault();
      this.module.type(this.id, code);
      if (this.waits) this.go(true);
    });
    this.canvas = element('canvas');
    this.stopped = element('p', {className: 'stopped', role: 'status', hidden: true});
    this.screen = element('div', {className: 'screen'}, this.canvas, this.stopped);
    this.status = element('p', {className: 'status', role: 'status'});
    this.question = field('Value of', '', () => this.evaluate(), {placeholder: 'begin+3, AC, time', spellcheck: false}, 'An expression of names of the program, registers and numbers');
    this.answer = element('output', {});
    const perform = act => () => this.act(act);
    return element('div', {className: 'bench'}, this.intro = introduction(),
      element('p', {className: 'bar pick'}, this.shelf),
      element('p', {className: 'bar tools'}, this.machine, this.dialect,
        this.cpm = check('CP/M', false, () => this.load(), 'Runs the program under CP/M, from 100H on: it calls the system at 5, and ends with a jump to 0'),
        button('Assemble', () => this.assemble(), 'Assemble and load (Ctrl-Enter)'),
        fileTaker('Open'),
        button('Save', () => download(this.current?.name ?? 'program.s', this.editor.value, 'text/plain'), 'Save the source')),
      this.message,
      element('p', {className: 'bar run'},
        this.running = button('Run', () => this.go(!this.on), 'Run or pause (F5)'),
        button('Step', perform({do: 'step'}), 'One instruction (F11)'), button('Over', perform({do: 'over'}), 'One instruction; a call with all of its subroutine (F10)'), button('Out', perform({do: 'out'}), 'To the end of the subroutine'),
        button('Back', perform({do: 'back'}), 'One instruction back in time'), button('Back 100', perform({do: 'back', count: 100}), 'A hundred instructions back'),
        button('Back to break', perform({do: 'back_to_breakpoint'}), 'Back to the last breakpoint'),
        button('Reset', () => this.load(), 'Load the program again')),
      element('div', {className: 'source'}, this.errors, element('div', {className: 'sheet'}, this.numbers, this.editor)),
      element('div', {className: 'view'}, this.screen, group('Console', this.output, this.keys)),
      element('div', {className: 'state'}, this.status, this.registerBox, element('div', {className: 'scroll'}, this.code)),
      element('div', {className: 'more'},
        fold('Memory', this.memoryAt, this.memory),
        fold('Last instructions', this.past),
        fold('Value of an expression', this.question, this.answer),
        fold('Snapshot: the whole state of the machine as a file', element('p', {},
          button('Save state', () => this.saveState(), 'Save a snapshot of the machine'), ' ',
          fileTaker('Open state'))),
        element('details', {className: 'group'}, element('summary', {textContent: 'Listing'}), this.listing),
        element('details', {className: 'group'}, element('summary', {textContent: 'Symbols'}), this.symbols)));
  }

  offerDialects() {
    const {dialects} = MACHINES[this.machine.select.value];
    this.cpm.hidden = this.machine.select.value !== 'i8080';
    this.dialect.select.replaceChildren(...dialects.map(name => element('option', {value: name, textContent: name})));
  }

  show(example) {
    if (!example) return;
    this.current = example;
    this.shelf.select.value = example.name;
    this.machine.select.value = example.machine;
    this.offerDialects();
    this.dialect.select.value = example.options?.['--dialect'] ?? MACHINES[example.machine].dialects[0];
    this.cpm.box.checked = Boolean(example.cpm);
    this.editor.value = example.text;
    this.countLines();
    this.assemble();
    this.remember();
  }
  // Takes a file (files.js); false: this tab cannot use it.
  take(file) {
    const {name, kind, machine} = file;
    if (kind === 'snapshot') {
      this.restore(file);
      return true;
    }
    const program = kind === 'program' && machine === 'i8080';
    if (kind !== 'source' && !program) return false;
    const example = {name, title: name, machine, text: new TextDecoder().decode(file.bytes)};
    if (program) {
      const made = this.module.ask({do: 'make', machine, options: {'--load': [name]}});
      if (made.error) { this.message.say(made.error, true); return true; }
      this.module.ask({do: 'drop', id: made.id});
      Object.assign(example, {text: `; ${name}: a program without its source\n`, program: name, cpm: /\.com$/i.test(name)});
    }
    // A program at 100H without another start address is a CP/M program.
    if (!program && machine === 'i8080') {
      const made = this.module.ask({do: 'assemble', machine, name: 'bench.program', sources: [{name, text: example.text}]});
      example.cpm = Boolean(made.right) && made.lowest === CPM_ORIGIN && [null, CPM_ORIGIN].includes(made.start);
    }
    this.own.add(name);
    const there = this.examples.findIndex(each => each.name === name);
    if (there >= 0) this.examples[there] = example;
    else {
      this.examples.push(example);
      this.shelf.select.append(element('option', {value: name, textContent: name}));
    }
    this.show(example);
    return true;
  }
  countLines() {
    const lines = this.editor.value.split('\n').length;
    if (lines === this.lineCount) return;
    this.lineCount = lines;
    this.numbers.textContent = Array.from({length: lines}, (_, i) => i + 1).join('\n');
  }

  assemble() {
    const machine = this.machine.select.value;
    const name = this.current?.name ?? 'program.s';
    const whole = this.current?.program;
    if (whole && this.editor.value === this.current.text) {
      this.made = {right: true, program: whole, symbols: '', listing: '', lines: [], start: null};
      this.errors.replaceChildren();
      this.listing.textContent = this.symbols.textContent = '';
      this.message.say(`${whole} is loaded.`);
      return this.load();
    }
    for (const [file, text] of this.current?.includes ?? []) this.module.putFile(file, text);
    const made = this.module.ask({do: 'assemble', machine, name: 'bench.program', sources: [{name, text: this.editor.value}],
      options: {...(this.current?.options ?? {}), '--dialect': this.dialect.select.value}});
    if (made.error) {
      this.made = null;
      this.errors.replaceChildren();
      this.listing.textContent = this.symbols.textContent = '';
      this.unload(made.error);
      return this.message.say(made.error, true);
    }
    this.errors.replaceChildren(...made.diagnostics.slice(0, 100).map(each => element('li', {className: each.severity},
      element('button', {type: 'button', textContent: each.text, title: 'Go to the line', onclick: () => this.goTo(each.line, each.column)}))));
    this.made = made;
    this.listing.textContent = made.listing;
    this.symbols.textContent = made.symbols;
    if (!made.right) {
      this.unload(ERRORS);
      return this.message.say(ERRORS, true);
    }
    this.message.say(`${made.words} ${machine === 'pdp7' ? 'words' : 'bytes'} assembled and loaded.`);
    this.load();
  }
  goTo(line, column) {
    const lines = this.editor.value.split('\n');
    const at = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0) + Math.max(0, column - 1);
    this.editor.focus();
    this.editor.setSelectionRange(at, at + 1);
    this.editor.scrollTop = Math.max(0, (line - 5) * (this.editor.scrollHeight / Math.max(1, lines.length)));
  }

  // Unloads the program; Run and Reset repeat the error.
  unload(complaint) {
    this.complaint = complaint;
    if (this.id) this.module.ask({do: 'drop', id: this.id});
    this.id = 0;
    this.go(false, '');
    this.tube?.clear(0);
    this.context?.clearRect(0, 0, this.canvas.width, this.canvas.height);
    this.code.tBodies[0]?.remove();
    for (const each of [this.status, this.registerBox, this.past, this.memory, this.output]) each.replaceChildren();
  }
  load() {
    if (!this.made?.right) return this.message.say(this.made ? this.complaint : 'Press Assemble first.', true);
    const machine = this.machine.select.value;
    const options = {...MACHINES[machine].options, ...(this.current?.run ?? {}), '--load': [...(this.current?.load ?? []), `${this.made.program}${this.current?.at ?? ''}`]};
    const cpm = machine === 'i8080' && this.cpm.box.checked;
    if (cpm) Object.assign(options, {'--cpm': true, '--console': 'ascii', '--load': [this.made.program]});
    if (machine === 'i8080' && this.made.start !== null && !cpm) options['--start'] = this.made.start.toString(16);
    const made = this.module.ask({do: 'make', machine, options, symbols: this.made.symbols, listing: this.made.listing, lines: this.made.lines});
    if (made.error) {
      this.unload(made.error);
      return this.message.say(made.error, true);
    }
    this.begin(made.id, machine, Boolean(options['--board']));
  }
  // Opens a snapshot, with the names and lines of the source if the machine has its words.
  restore({name, machine, configuration}) {
    const source = machine === this.machine.select.value && this.made?.right ? this.made : null;
    const make = known => this.module.ask({do: 'make', snapshot: name, ...(known ? {symbols: source.symbols, listing: source.listing, lines: source.lines} : {})});
    let made = make(source);
    if (made.error) return this.message.say(made.error, true);
    const known = source !== null && this.holds(made.id, source);
    if (source && !known) {
      this.module.ask({do: 'drop', id: made.id});
      made = make(false);
    }
    if (machine !== this.machine.select.value) {
      this.machine.select.value = machine;
      this.offerDialects();
      this.made = null;  // the program is for the other machine
    }
    this.begin(made.id, machine, configuration.some(each => each.startsWith('--board')));
    this.message.say(known ? `${name}: the machine goes on from this snapshot.` : `${name}: a snapshot of another program than this source.`);
  }
  // Whether a machine has the words of a source, except a few that the program may have changed.
  holds(id, source) {
    this.load();
    let words = 0, same = 0;
    for (let at = source.lowest ?? 0; this.id && at <= (source.highest ?? LARGEST_ADDRESS); ++at) {
      const word = this.module.word(this.id, at);
      if (!word) continue;
      ++words;
      if (word === this.module.word(id, at)) ++same;
    }
    return words > 0 && same >= 0.9 * words;
  }
  begin(id, machine, board) {
    if (this.id) this.module.ask({do: 'drop', id: this.id});
    this.id = id;
    this.warned = [];
    this.second = MACHINES[machine].second;
    this.breaks.clear();
    this.registers.clear();
    this.words.clear();
    this.output.textContent = '';
    const fresh = element('canvas', {role: 'img', 'aria-label': 'Screen of the program'});
    this.canvas.replaceWith(fresh);
    this.canvas = fresh;
    this.context = null;
    this.tube = machine === 'pdp7' ? makeTube(fresh) : null;
    this.tube?.clear(0);
    if (!this.tube) fresh.width = fresh.height = 256;
    fresh.className = this.tube ? 'tube' : 'raster';
    this.screen.className = this.tube ? this.tube.kind === 'plain' ? 'screen' : 'screen framed' : 'screen board';
    // A program without a screen shows its console instead.
    this.root.classList.toggle('printing', !this.tube && !board);
    this.intro.say(`A program for the ${machine === 'pdp7' ? 'PDP-7' : '8080'}[ in its assembly language], run forward and back[, one instruction at a time if you like]. Press Run, then Back.`);
    this.memoryAt.input.value = (this.made?.lowest ?? 0).toString(machine === 'pdp7' ? 8 : 16);
    this.go(false, '');
    this.refresh();
  }

  saveState() {
    if (!this.id) return;
    const done = this.module.ask({do: 'save', id: this.id});
    if (done.error) return this.message.say(done.error, true);
    download(`${this.current?.name ?? 'program'}.snap`, this.module.made());
  }
  act(request) {
    if (!this.id) return;
    this.go(false);
    const answer = this.module.ask({id: this.id, ...request});
    if (answer.error) this.message.say(answer.error, true);
    else this.showReason(answer.reason ?? '');
    this.drawTube(true);
    this.hear();
    this.refresh();
  }
  evaluate() {
    if (!this.id) return;
    const answer = this.module.ask({do: 'evaluate', id: this.id, text: this.question.input.value});
    this.answer.textContent = answer.error ?? `${answer.value} decimal, ${answer.value.toString(8)} octal, ${answer.value.toString(16)} hexadecimal`;
  }

  // `why`: the reason for which the machine stops.
  go(on, why = 'paused') {
    if (on && !this.id) return this.message.say(this.complaint, true);
    this.on = on;
    if (on) this.waits = false;
    this.stopped.textContent = on ? '' : why;
    this.stopped.hidden = !this.stopped.textContent;
    this.running.textContent = on ? 'Pause' : 'Run';
    if (!on && this.id) this.refresh();
  }
  enter() { this.clock.start(); }
  leave() { this.clock.stop(); }
  key(event, down) {
    if (!down) return false;
    if (event.key === 'Enter' && event.ctrlKey) { this.assemble(); return true; }
    const act = {F5: () => this.go(!this.on), F10: () => this.act({do: 'over'}), F11: () => this.act({do: 'step'})}[event.key];
    if (!act) return false;
    act();
    return true;
  }

  picture(seconds) {
    if (!this.id) return;
    let result = 0;
    if (this.on) result = runFor(this.module, this.id, seconds * this.second, this.second / 1000, this.clock.frames ? 1e9 : 10);
    const reason = result ? this.module.reason() : '';
    this.drawTube(!this.on || result !== 0);
    if (this.on) {
      if (result) {
        this.go(false, stopName(result, reason));
        this.showReason(reason);
      }
      this.sinceStatus = (this.sinceStatus ?? 1) + seconds;
      if (this.on && this.sinceStatus > 0.2) {
        this.sinceStatus = 0;
        this.showProgress();
        if (addWarnings(this.module, this.id, this.warned, false)) this.message.say(this.warned.join('\n'), true);
      }
    }
    if (!this.tube) this.showRaster();
    this.hear();
  }
  // Shows why the machine has stopped, and warnings about its program.
  showReason(reason) {
    this.waits = reason === 'waits for a key';
    addWarnings(this.module, this.id, this.warned, reason === 'stopped by halt');
    this.message.say([this.waits ? 'The program waits for a key: type under Console.' : reason, ...this.warned].filter(Boolean).join('\n'));
  }
  // Called before the state is shown: the list of the last instructions repeats a run, which discards the flashes.
  drawTube(held) {
    const flashes = this.module.flashes(this.id);
    this.tube?.show(flashes, this.module.ticks(this.id) / this.second, held);
  }
  showProgress() {
    this.status.textContent = `${(this.module.ticks(this.id) / this.second).toFixed(3)} s, ${this.module.instructions(this.id).toLocaleString('en')} instructions`;
  }
  showRaster() {
    const dots = this.module.raster(this.id);
    if (!dots) return;
    this.raster ??= new RasterImage();
    this.raster.draw(this.context ??= this.canvas.getContext('2d'), dots);
  }
  hear() {
    const printed = this.module.printed(this.id);
    if (printed) this.output.textContent = (this.output.textContent + [...printed].map(c => String.fromCharCode(c.charCodeAt(0) & 127)).join('').replace(/\r|\0|\x7f/g, '')).slice(-8000);
  }

  refresh() {
    if (!this.id) return;
    const state = this.module.ask({do: 'state', id: this.id});
    this.status.textContent = `${state.time}, ${state.instructions.toLocaleString('en')} instructions`;
    this.registerBox.replaceChildren(...state.registers.map(each => {
      const changed = this.registers.has(each.name) && this.registers.get(each.name) !== each.value;
      this.registers.set(each.name, each.value);
      return element('div', {}, element('dt', {textContent: each.name}), element('dd', {className: changed ? 'changed' : '', textContent: each.text}));
    }));
    const {rows} = this.module.ask({do: 'rows', id: this.id, at: state.pc, before: 6, count: 18});
    this.code.tBodies[0]?.remove();
    this.code.append(element('tbody', {}, ...(rows ?? []).map(row => {
      const dot = element('button', {type: 'button', className: this.breaks.has(row.at) ? 'dot set' : 'dot', title: `Breakpoint at ${row.address}`, 'aria-pressed': String(this.breaks.has(row.at)),
        onclick: () => {
          const done = this.module.ask({do: 'break', id: this.id, at: row.at});
          if (done.set) this.breaks.add(row.at); else this.breaks.delete(row.at);
          this.refresh();
        }});
      return element('tr', {className: row.at === state.pc ? 'now' : ''}, element('td', {}, dot), element('td', {textContent: row.address}), element('td', {textContent: row.code}), element('td', {textContent: row.text}), element('td', {className: 'label', textContent: row.source || row.label}));
    })));
    this.past.textContent = (this.module.ask({do: 'history', id: this.id, count: 12}).lines ?? []).join('\n');
    this.showMemory();
  }
  showMemory() {
    if (!this.id) return;
    const answer = this.module.ask({do: 'memory', id: this.id, at: this.memoryAt.input.value, count: 64});
    if (answer.error) { this.memory.textContent = answer.error; return; }
    const radix = this.machine.select.value === 'pdp7' ? 8 : 16;
    const digits = radix === 8 ? 5 : 4;
    const parts = [];
    answer.words.forEach((word, i) => {
      if (i % 8 === 0) parts.push(`${i ? '\n' : ''}${(answer.at + i).toString(radix).toUpperCase().padStart(digits, '0')}: `);
      const at = answer.at + i;
      const changed = this.words.has(at) && this.words.get(at) !== word;
      this.words.set(at, word);
      parts.push(changed ? element('b', {className: 'changed', textContent: word}) : word, ' ');
    });
    this.memory.replaceChildren(...parts);
  }

  link() {
    const name = this.current?.name ?? '';
    return `bench/${encodeURIComponent(name)}${this.own.has(name) ? '?file=1' : ''}`;
  }
  open(part, query) {
    if (part) named('program', part, this.examples.map(each => each.name), query);
    optionsOf(query, {});
    if (part) this.show(this.examples.find(each => each.name === part));
  }
}
