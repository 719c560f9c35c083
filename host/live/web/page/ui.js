// Elements that all tabs use: labelled controls, file choosers, downloads, a clock.

const MOST_WARNINGS = 5;

export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('aria-') || name === 'role' || name === 'for' || name.startsWith('data-')) made.setAttribute(name, value);
    else made[name] = value;
  }
  made.append(...children.filter(child => child !== null && child !== undefined));
  return made;
}

export function button(label, act, title = label) {
  return element('button', {type: 'button', textContent: label, title, onclick: act});
}

// A labelled list; `entries`: texts, or [value, text]. It releases the focus after a choice, so that the tab receives the keys again, except when
// the arrow keys step through a closed list, where each step is a choice.
// `title`, here and below: the tooltip.
export function choice(label, entries, value, act, title = '') {
  let passing = false;
  const select = element('select', {
    onkeydown: event => { passing = event.key !== 'Enter' && event.key !== ' '; }, onpointerdown: () => { passing = false; },
    onchange: () => { act(select.value); if (!passing) select.blur(); }},
    ...entries.map(entry => {
      const [each, text] = Array.isArray(entry) ? entry : [entry, entry];
      return element('option', {value: each, textContent: text, selected: String(each) === String(value)});
    }));
  return Object.assign(element('label', {className: 'field', title}, element('span', {textContent: label}), select), {select});
}

export function check(label, value, act, title = '') {
  const box = element('input', {type: 'checkbox', checked: value, onchange: () => act(box.checked)});
  return Object.assign(element('label', {className: 'field check', title}, box, element('span', {textContent: label})), {box});
}

// A number beyond its bounds becomes the nearest within them, a whole one where no step is given; what is no number becomes the one before.
export function field(label, value, act, properties = {}, title = '') {
  const {type, min = -Infinity, max = Infinity, step} = properties;
  let before = value;
  const take = () => {
    if (type === 'number') {
      const number = parseFloat(input.value);
      if (Number.isNaN(number)) { input.value = before; return; }
      input.value = Math.min(max, Math.max(min, step ? number : Math.round(number)));
    }
    act(input.value);
  };
  const input = element('input', {value, ...properties, onfocus: () => { before = input.value; }, onchange: take});
  return Object.assign(element('label', {className: 'field', title}, element('span', {textContent: label}), input), {input});
}

export function group(title, ...children) {
  return element('section', {className: 'group', 'aria-label': title}, element('h3', {textContent: title}), ...children);
}

// A group that can be folded. On a narrow page it is folded at first.
export function fold(title, ...children) {
  const open = !matchMedia('(max-width: 700px)').matches;
  return element('details', {className: 'group', open, 'aria-label': title}, element('summary', {textContent: title}), ...children);
}

// The first sentences of a tab: its purpose, and one suggestion. `say`: a narrow page omits text in [brackets].
export function introduction() {
  const box = element('p', {className: 'intro'});
  box.say = text => box.replaceChildren(...text.split(/[[\]]/).map((part, i) => i % 2 ? element('span', {className: 'wide', textContent: part}) : part));
  return box;
}

// Names, values and optional tooltips. `show`, which is called a few times a second, writes the rows and reuses the elements.
export function factList() {
  const box = element('dl', {className: 'facts'});
  box.show = rows => {
    while (box.childElementCount > 2 * rows.length) box.lastElementChild.remove();
    while (box.childElementCount < 2 * rows.length) box.append(element('dt'), element('dd'));
    for (let i = 0; i < rows.length; ++i) {
      for (let part = 0; part < 2; ++part) {
        const shown = box.children[2 * i + part];
        if (shown.textContent !== rows[i][part]) shown.textContent = rows[i][part];
      }
      const name = box.children[2 * i];
      if (name.title !== (rows[i][2] ?? '')) name.title = rows[i][2] ?? '';
    }
  };
  return box;
}

// An error message that screen readers announce; `offers`: remedies, each with a label and an action.
export function notice() {
  const box = element('p', {className: 'notice', role: 'status', hidden: true});
  box.say = (text, wrong = false, offers = []) => {
    box.replaceChildren(text, ...offers.flatMap(([label, act]) => [' ', button(label, act)]));
    box.hidden = !text;
    box.classList.toggle('wrong', wrong);
  };
  return box;
}

// Whether an element uses typed keys: text fields and lists do, check boxes and buttons do not.
export function takesKeys(target) {
  return target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement || (target instanceof HTMLInputElement && !['checkbox', 'file'].includes(target.type));
}

// The reason why a machine has stopped, in one or two words for its screen. `result` and `reason`: from module.run and module.reason.
export function stopName(result, reason) {
  if (result === 1) return 'stopped at a breakpoint';
  return reason === 'stopped by halt' ? 'halted' : reason;
}

// Adds new warnings about the program to `shown`: it uses a missing device, or executes empty memory. If the machine has `halted`, the word at PC will not
// be executed.
export function addWarnings(module, id, shown, halted) {
  const fresh = module.ask({do: 'warnings', id, halted}).warnings.slice(0, MOST_WARNINGS - shown.length);
  shown.push(...fresh);
  return fresh.length > 0;
}

export function download(name, bytes, type = 'application/octet-stream') {
  const link = element('a', {href: URL.createObjectURL(new Blob([bytes], {type})), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// Downloads the content of a canvas as PNG.
export function downloadPicture(name, canvas) {
  canvas.toBlob(blob => blob.arrayBuffer().then(bytes => download(`${name}.png`, bytes, 'image/png')));
}

// A button to choose files, which are opened like dropped ones (files.js).
export function fileTaker(label) {
  const input = element('input', {type: 'file', multiple: true, hidden: true, onchange: () => {
    input.dispatchEvent(new CustomEvent('chosen', {bubbles: true, detail: [...input.files]}));
    input.value = '';
  }});
  return element('span', {}, button(label, () => input.click()), input);
}

// Calls step(seconds since the last call) in every frame while the page is visible, with at most a quarter of a second, so that
// a page does not catch up after a pause. For tests, ?frames=N in the address gives N frames of a sixtieth of a second, by
// timers.
export class Clock {
  constructor(step) {
    this.step = step;
    this.on = false;
    this.last = 0;
    this.frames = Number(new URLSearchParams(location.search).get('frames') ?? 0);
    this.left = this.frames;
    this.tick = now => this.picture(now);
    document.addEventListener('visibilitychange', () => { this.last = 0; });
  }
  start() {
    if (this.on) return;
    this.on = true;
    this.last = 0;
    this.next();
  }
  stop() { this.on = false; }
  next() {
    if (!this.on) return;
    if (this.frames) {
      if (this.left-- > 0) setTimeout(() => this.picture(null), 0);
      else document.documentElement.dataset.frames = 'done';
    } else {
      requestAnimationFrame(this.tick);
    }
  }
  picture(now) {
    if (!this.on) return;
    const seconds = now === null ? 1 / 60 : this.last ? Math.min(0.25, (now - this.last) / 1000) : 1 / 60;
    this.last = now ?? 0;
    this.step(seconds);
    this.next();
  }
}

// Runs a machine for so many ticks in slices, at most for `milliseconds` of host time; returns the result of module.run.
export function runFor(module, id, ticks, slice, milliseconds = 10) {
  const until = module.ticks(id) + ticks;
  const end = performance.now() + milliseconds;
  let result = 0;
  for (let at = module.ticks(id); at < until && result === 0;) {
    at = Math.min(until, at + slice);
    result = module.run(id, at);
    if (performance.now() > end) break;
  }
  return result;
}
