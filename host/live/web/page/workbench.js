// The workbench: a program written, assembled, run and looked into, forward and back, on either machine.

import {Clock, button, choice, download, element, field, fileTaker, group, notice, runFor} from './ui.js';
import {RasterImage} from './raster.js';
import {makeTube} from './tube.js';
import {named, optionsOf} from './links.js';

const MACHINES = {
  pdp7: {title: 'PDP-7 with the Type 340', second: 1e9, dialects: ['dec', 'bell'], options: {'--display': true, '--display-option': ['342', '347']}},
  i8080: {title: '8080', second: 3e6, dialects: ['common', 'mac', 'm80', 'intel'], options: {}},
};

export class Workbench {
  constructor(module, examples, remember) {
    this.module = module;
    this.examples = examples;
    this.remember = remember;
    this.own = new Set();  // programs that are files of the person's
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
    this.shelf = choice('Example', this.examples.map(each => [each.name, each.title]), this.current?.name, value => this.show(this.examples.find(each => each.name === value)));
    this.machine = choice('Machine', Object.entries(MACHINES).map(([name, {title}]) => [name, title]), 'pdp7', () => this.offerDialects());
    this.dialect = choice('Dialect', ['dec'], 'dec', () => {});
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
    this.code = element('table', {className: 'code'}, element('caption', {textContent: 'Instructions; click the dot for a breakpoint'}));
    this.registerBox = element('dl', {className: 'registers'});
    this.memoryAt = field('Memory at', '0', () => this.showMemory(), {size: 8, spellcheck: false});
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
      if (this.waits) { this.waits = false; this.go(true); }
    });
    this.canvas = element('canvas', {className: 'small', role: 'img', 'aria-label': 'Screen of the program'});
    this.status = element('p', {className: 'status', role: 'status'});
    this.question = field('Value of', '', () => this.evaluate(), {placeholder: 'begin+3, AC, time', spellcheck: false});
    this.answer = element('output', {});
    const desk = act => () => this.act(act);
    return element('div', {className: 'bench'},
      element('div', {className: 'write'},
        element('p', {className: 'bar'}, this.shelf, this.machine, this.dialect,
          button('Assemble', () => this.assemble(), 'Assemble and load (Ctrl-Enter)'),
          fileTaker('Open'),
          button('Save', () => download(this.current?.name ?? 'program.s', this.editor.value, 'text/plain'), 'Save the source')),
        this.message, this.errors,
        element('div', {className: 'sheet'}, this.numbers, this.editor),
        element('details', {}, element('summary', {textContent: 'Listing'}), this.listing),
        element('details', {}, element('summary', {textContent: 'Symbols'}), this.symbols)),
      element('div', {className: 'look'},
        element('p', {className: 'bar'},
          this.running = button('Run', () => this.go(!this.on), 'Run or pause (F5)'),
          button('Step', desk({do: 'step'}), 'One instruction (F11)'), button('Over', desk({do: 'over'}), 'Over a call (F10)'), button('Out', desk({do: 'out'}), 'Out of a subroutine'),
          button('Back', desk({do: 'back'}), 'One instruction back in time'), button('Back 100', desk({do: 'back', count: 100}), 'A hundred instructions back'),
          button('Back to break', desk({do: 'back_to_breakpoint'}), 'Back to the last breakpoint'),
          button('Reset', () => this.load(), 'Load the program again'),
          button('Save state', () => this.saveState(), 'Save a snapshot of the machine'),
          fileTaker('Open state')),
        this.status,
        element('div', {className: 'panes'}, element('div', {className: 'scroll'}, this.code), element('div', {}, this.registerBox, this.canvas)),
        group('Console', this.output, this.keys),
        group('Memory', this.memoryAt, this.memory),
        group('Look', this.question, this.answer),
        element('details', {open: true}, element('summary', {textContent: 'Last instructions'}), this.past)));
  }

  offerDialects() {
    const {dialects} = MACHINES[this.machine.select.value];
    this.dialect.select.replaceChildren(...dialects.map(name => element('option', {value: name, textContent: name})));
  }

  show(example) {
    if (!example) return;
    this.current = example;
    this.shelf.select.value = example.name;
    this.machine.select.value = example.machine;
    this.offerDialects();
    this.dialect.select.value = example.options?.['--dialect'] ?? MACHINES[example.machine].dialects[0];
    this.editor.value = example.text;
    this.countLines();
    this.assemble();
    this.remember();
  }
  // A file (files.js); false: not one for this room.
  take(file) {
    const {name, kind, machine} = file;
    if (kind === 'snapshot' && this.id && machine === this.loaded) {
      this.act({do: 'restore', file: name});
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
    if (made.error) return this.message.say(made.error, true);
    this.errors.replaceChildren(...made.diagnostics.slice(0, 100).map(each => element('li', {className: each.severity},
      element('button', {type: 'button', textContent: each.text, title: 'Go to the line', onclick: () => this.goTo(each.line, each.column)}))));
    this.made = made;
    this.listing.textContent = made.listing;
    this.symbols.textContent = made.symbols;
    if (!made.right) { this.message.say('The source has errors.', true); return; }
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

  load() {
    if (!this.made?.right) return;
    if (this.id) this.module.ask({do: 'drop', id: this.id});
    const machine = this.machine.select.value;
    const options = {...MACHINES[machine].options, ...(this.current?.run ?? {}), '--load': [...(this.current?.load ?? []), `${this.made.program}${this.current?.at ?? ''}`]};
    if (machine === 'i8080' && this.current?.cpm) Object.assign(options, {'--cpm': true, '--console': 'ascii', '--load': [this.made.program]});
    if (machine === 'i8080' && this.made.start !== null && !this.current?.cpm) options['--start'] = this.made.start.toString(16);
    const made = this.module.ask({do: 'make', machine, options, symbols: this.made.symbols, listing: this.made.listing, lines: this.made.lines});
    if (made.error) { this.id = 0; return this.message.say(made.error, true); }
    this.id = made.id;
    this.loaded = machine;
    this.second = MACHINES[machine].second;
    this.breaks.clear();
    this.registers.clear();
    this.words.clear();
    this.output.textContent = '';
    const fresh = element('canvas', {className: 'small', role: 'img', 'aria-label': 'Screen of the program'});
    this.canvas.replaceWith(fresh);
    this.canvas = fresh;
    this.context = null;
    this.tube = machine === 'pdp7' ? makeTube(fresh) : null;
    if (!this.tube) { fresh.width = fresh.height = 256; fresh.hidden = !options['--board']; }
    this.memoryAt.input.value = (this.made.lines[0]?.at ?? 0).toString(machine === 'pdp7' ? 8 : 16);
    this.go(false);
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
    else this.message.say(answer.reason ?? '');
    this.hear();
    this.refresh();
  }
  evaluate() {
    if (!this.id) return;
    const answer = this.module.ask({do: 'evaluate', id: this.id, text: this.question.input.value});
    this.answer.textContent = answer.error ?? `${answer.value} decimal, ${answer.value.toString(8)} octal, ${answer.value.toString(16)} hexadecimal`;
  }

  go(on) {
    if (on && !this.id) return;
    this.on = on;
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
    const from = this.module.ticks(this.id);
    if (this.on) {
      const result = runFor(this.module, this.id, seconds * this.second, this.second / 1000, this.clock.frames ? 1e9 : 10);
      if (result) {
        const reason = this.module.reason();
        this.waits = reason === 'waits for a key';
        this.message.say(this.waits ? 'The program waits for a key.' : `Stopped: ${reason}`);
        this.go(false);
      }
      this.sinceStatus = (this.sinceStatus ?? 1) + seconds;
      if (this.on && this.sinceStatus > 0.2) { this.sinceStatus = 0; this.showProgress(); }
    }
    const flashes = this.module.flashes(this.id);
    if (this.tube) this.tube.picture(flashes, this.on ? (this.module.ticks(this.id) - from) / this.second : seconds);
    else this.showRaster();
    this.hear();
  }
  showProgress() {
    this.status.textContent = `${(this.module.ticks(this.id) / this.second).toFixed(3)} s, ${this.module.instructions(this.id).toLocaleString('en')} instructions`;
  }
  showRaster() {
    const dots = this.module.raster(this.id);
    if (!dots) return;
    this.canvas.hidden = false;
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
    this.status.textContent = `${state.time}, ${state.instructions.toLocaleString('en')} instructions; ${state.status.split('\n')[0]}`;
    this.registerBox.replaceChildren(...state.registers.flatMap(each => {
      const changed = this.registers.has(each.name) && this.registers.get(each.name) !== each.value;
      this.registers.set(each.name, each.value);
      return [element('dt', {textContent: each.name}), element('dd', {className: changed ? 'changed' : '', textContent: each.text})];
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
