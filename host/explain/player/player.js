// Plays a lesson (schema sightline/explain/1): sheets, a caption, counts, and controls to go forward and back.
//
// The state of a step is the contents of all layers. Every 64th state is stored; the others are built from the one before.
//
// Parameters in the page's address, after ? or #: step=5 is shown first; from=3 and to=12 limit the steps; embed=1 shows the player
// without the rest of the page, for a frame in another page.

const LOOKS = {
  faint: ['there for comparison', 1, []], plain: ['of the matter at hand', 1.5, []], now: ['this step', 2.5, []],
  other: ['compared with', 2, []], seen: ['visible', 2, []], hidden: ['hidden', 1.5, [4, 4]], waiting: ['waiting', 1.5, []],
  mask: ['mask', 2, []],
};
const STATE_INTERVAL = 64;

// The drawing order: the subject of the step is on top.
const ORDER = ['faint', 'mask', 'plain', 'hidden', 'waiting', 'seen', 'other', 'now'];

const parameter = name => new RegExp(`[#&?]${name}=([^&]*)`).exec(location.hash)?.[1] ?? new URLSearchParams(location.search).get(name);

// Whether the page is embedded in another one. The style sheet then hides all but the player.
const embedded = parameter('embed') === '1';
document.documentElement.classList.toggle('embed', embedded);

// The step (from 0) that a parameter of the address requests. A parameter that is out of range or no number adds a sentence to `notes`.
function stepParameter(name, otherwise, length, notes) {
  const text = parameter(name);
  if (text === null) return otherwise;
  if (!/^\d+$/.test(text)) {
    notes.push(`${name}=${text.slice(0, 20)} is ignored: expected the number of a step, from 1 to ${length}.`);
    return otherwise;
  }
  const step = Math.max(1, Math.min(length, Number(text)));
  if (step !== Number(text)) notes.push(`${name}=${text.slice(0, 20)}: the lesson has steps 1 to ${length}, and ${step} is taken.`);
  return step - 1;
}

// Returns the keyboard focus to the player after a choice from a list and when a slider is released.
export function releaseKeys(element) {
  element.addEventListener('change', event => { if (event.target instanceof HTMLSelectElement) event.target.blur(); });
  element.addEventListener('pointerup', event => { if (event.target.type === 'range') event.target.blur(); });
}

// `moved` is called 0.2 s after the last change of the step; `addressed`: the address gives the first step.
export function makePlayer(root, lesson, {moved = () => {}, addressed = true} = {}) {
  const notes = [];
  let first = stepParameter('from', 0, lesson.steps.length, notes);
  let last = stepParameter('to', lesson.steps.length - 1, lesson.steps.length, notes);
  if (first > last) {
    [first, last] = [last, first];
    notes.push(`from comes after to: steps ${first + 1} to ${last + 1} are shown.`);
  }
  const begin = Math.max(first, Math.min(last, addressed ? stepParameter('step', first, lesson.steps.length, notes) : first));
  const states = new Map();
  const order = lesson.sheets.map(() => []);
  for (const step of lesson.steps)
    for (const layer of step.layers)
      if (!order[layer.sheet].includes(layer.name)) order[layer.sheet].push(layer.name);

  function stateOf(n) {
    let from = n - n % STATE_INTERVAL;
    while (from > 0 && !states.has(from)) from -= STATE_INTERVAL;
    let state = states.get(from);
    if (!state) {
      state = lesson.sheets.map(() => ({}));
      apply(state, lesson.steps[0]);
      states.set(0, state);
      from = 0;
    }
    state = state.map(sheet => ({...sheet}));
    for (let i = from + 1; i <= n; ++i) {
      apply(state, lesson.steps[i]);
      if (i % STATE_INTERVAL === 0) states.set(i, state.map(sheet => ({...sheet})));
    }
    return state;
  }
  function apply(state, step) {
    for (const layer of step.layers) state[layer.sheet][layer.name] = layer.marks;
  }

  const make = (tag, properties = {}, ...children) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };
  const caption = make('p', {className: 'caption'});
  caption.setAttribute('aria-live', 'polite');
  const counts = make('ul', {className: 'counts'});
  const slider = make('input', {type: 'range', min: first, max: last, value: first});
  slider.setAttribute('aria-label', 'Step');
  const place = make('span', {className: 'place'});
  const button = (label, title, act) => {
    const b = make('button', {type: 'button', textContent: label, title, onclick: act});
    b.setAttribute('aria-label', title);
    return b;
  };
  const play = button('Play', 'Play or pause (space)', () => toggle());
  const pace = make('select', {title: 'Steps a second'}, ...[1, 2, 5, 15, 60].map(n => make('option', {value: n, textContent: n + ' steps/s', selected: n === 2})));
  pace.setAttribute('aria-label', 'Steps a second');
  const canvases = lesson.sheets.map(sheet => {
    const canvas = make('canvas');
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', sheet.title);
    return canvas;
  });
  const longest = lesson.steps.reduce((text, step) => {
    const words = step.section ? `${step.caption} (${step.section})` : step.caption;
    return words.length > text.length ? words : text;
  }, '');
  const placeholder = make('p', {className: 'longest', textContent: longest});  // reserves the height of the longest caption
  placeholder.setAttribute('aria-hidden', 'true');
  const used = new Set(lesson.steps.flatMap(step => step.layers.flatMap(layer => layer.marks.filter(mark => mark[0] !== 'text' && mark[0] !== 'label').map(mark => mark[1]))));
  const player = make('section', {className: 'player'},
    make('h1', {textContent: lesson.title}),
    ...notes.map(note => make('p', {className: 'note', textContent: note})),
    make('div', {className: 'controls'},
      button('|<', 'First step (Home)', () => show(first)), button('<', 'Back (left arrow)', () => show(at - 1)), play,
      button('>', 'Forward (right arrow)', () => show(at + 1)), button('>|', 'Last step (End)', () => show(last)),
      slider, place, pace),
    make('div', {className: 'words'}, caption, placeholder),
    make('div', {className: 'sheets'}, ...lesson.sheets.map((sheet, i) => make('figure', {}, make('div', {className: 'canvas'}, canvases[i]), make('figcaption', {textContent: sheet.title})))),
    counts,
    make('ul', {className: 'legend'}, ...Object.keys(LOOKS).filter(look => used.has(look)).map(look => {
      const sample = make('i');
      sample.style.background = `var(--${look})`;
      return make('li', {}, sample, LOOKS[look][0]);
    })));
  player.setAttribute('aria-label', lesson.title);
  root.replaceChildren(player);
  releaseKeys(player);

  let at = begin;
  let timer = 0;
  let settling = 0;

  function pause() {
    clearTimeout(timer);
    timer = 0;
    play.textContent = 'Play';
  }
  function toggle() {
    if (timer) return pause();
    if (at === last) show(first);
    tick();
    play.textContent = 'Pause';
  }
  function tick() {
    timer = setTimeout(() => {
      show(at + 1);
      if (at < last) tick(); else pause();
    }, 1000 / Number(pace.value));
  }
  function show(n) {
    const before = at;
    at = Math.max(first, Math.min(last, n));
    if (at !== before) {
      clearTimeout(settling);
      settling = setTimeout(() => moved(at), 200);
    }
    const step = lesson.steps[at];
    slider.value = at;
    place.textContent = last - first + 1 === lesson.steps.length ? `${at + 1} of ${lesson.steps.length}` : `${at + 1} (${first + 1} to ${last + 1} of ${lesson.steps.length})`;
    caption.replaceChildren(step.caption);
    if (step.section) caption.append(' ', make('span', {className: 'section', textContent: `(${step.section})`}));
    counts.replaceChildren(...Object.entries(step.counts).map(([name, value]) => make('li', {}, `${name} `, make('b', {textContent: value}))));
    draw();
  }
  function draw() {
    const state = stateOf(at);
    player.style.setProperty('--above', `${player.getBoundingClientRect().top + scrollY}px`);
    const style = getComputedStyle(player);
    const colours = Object.fromEntries(Object.keys(LOOKS).map(look => [look, style.getPropertyValue('--' + look)]));
    lesson.sheets.forEach((sheet, i) => drawSheet(canvases[i], sheet, order[i].map(name => state[i][name] ?? []), colours, i === 0));
  }

  // Handles a keydown event from anywhere on the page; true if the player uses the key. Lists, fields, other sliders and the browser keep
  // their keys. The page keys, which presenters' remotes send, step only if the page fits its window; otherwise they scroll.
  function key(event) {
    const target = event.target;
    if (event.ctrlKey || event.altKey || event.metaKey || !player.isConnected) return false;
    if (target !== slider && target.matches?.('select, textarea, input:not([type=checkbox], [type=file])')) return false;
    const whole = document.documentElement.scrollHeight <= innerHeight + 1;
    const forward = () => show(at + 1);
    const back = () => show(at - 1);
    const stop = act => () => { pause(); act(); };
    const act = {ArrowRight: stop(forward), ArrowLeft: stop(back), Home: stop(() => show(first)), End: stop(() => show(last)), ...(whole ? {PageDown: stop(forward), PageUp: stop(back)} : {}),
      ...(target.matches?.('button, summary, input[type=checkbox]') ? {} : {' ': toggle})}[event.key];
    act?.();
    return Boolean(act);
  }
  slider.oninput = () => show(Number(slider.value));
  // In the next frame, because drawing changes the layout, and browsers report an error if sizes change during an observer's callback.
  const observer = new ResizeObserver(() => requestAnimationFrame(draw));
  canvases.forEach(canvas => observer.observe(canvas));
  show(begin);
  return {
    show, key, pause, get step() { return at; }, first, length: lesson.steps.length,
    stop() { pause(); clearTimeout(settling); observer.disconnect(); },
  };
}

// `cut`: marks are clipped to the sheet's box, as the image is at its borders.
function drawSheet(canvas, sheet, layers, colours, cut) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  if (!width || !height) return;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = canvas.getContext('2d');
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  const margin = 10;
  let sx = (width - 2 * margin) / (sheet.high[0] - sheet.low[0] || 1);
  let sy = (height - 2 * margin) / (sheet.high[1] - sheet.low[1] || 1);
  if (!sheet.stretched) sx = sy = Math.min(sx, sy);
  const ox = (width - sx * (sheet.high[0] - sheet.low[0])) / 2 - sx * sheet.low[0];
  const oy = height - (height - sy * (sheet.high[1] - sheet.low[1])) / 2 + sy * sheet.low[1];
  const X = x => ox + sx * x;
  const Y = y => oy - sy * y;
  context.lineJoin = context.lineCap = 'round';
  const style = getComputedStyle(canvas);
  const scale = parseFloat(style.fontSize) / 16;
  const words = [];
  context.save();
  context.beginPath();
  context.rect(X(sheet.low[0]) - 1, Y(sheet.high[1]) - 1, sx * (sheet.high[0] - sheet.low[0]) + 2, sy * (sheet.high[1] - sheet.low[1]) + 2);
  if (cut) context.clip();
  for (const look of ORDER) {
    const [, thickness, dashes] = LOOKS[look];
    context.strokeStyle = context.fillStyle = colours[look];
    context.lineWidth = thickness * scale;
    context.setLineDash(dashes.map(dash => dash * scale));
    for (const marks of layers) {
      for (const mark of marks) {
        if (mark[1] !== look) continue;
        if (mark[0] === 'text' || mark[0] === 'label') {
          words.unshift({text: mark[4], look, centred: mark[0] === 'label', x: X(mark[2]), y: Y(mark[3])});
          continue;
        }
        context.beginPath();
        if (mark[0] === 'dot') {
          context.arc(X(mark[2]), Y(mark[3]), (3 + thickness / 2) * scale, 0, 2 * Math.PI);
          context.fill();
          continue;
        }
        for (let i = 2; i < mark.length; i += 2) context.lineTo(X(mark[i]), Y(mark[i + 1]));
        if (mark[0] === 'area') {
          context.closePath();
          context.globalAlpha = 0.18;
          context.fill();
          context.globalAlpha = 1;
        }
        context.stroke();
      }
    }
  }
  context.restore();
  context.font = `600 ${Math.max(11, Math.min(14 * scale, width / 22))}px system-ui, sans-serif`;
  drawWords(context, words, width, height, colours, style.backgroundColor);
}

// Texts are placed beside their points and labels on theirs, or at the nearest free place. The subject of the step is placed first; texts
// that only accompany it are omitted if there is no room.
function drawWords(context, words, width, height, colours, paper) {
  const line = parseFloat(context.font.split(' ')[1]) * 1.15;
  const taken = [];
  context.textBaseline = 'middle';
  for (const {text, look, centred, x, y} of words) {
    const wide = context.measureText(text).width;
    const places = (centred ? [0, 1, -1, 2, -2].map(n => [x - wide / 2, y + n * line])
      : [-1, 1, 3, -3, 5, -5, 7, -7].flatMap(n => [[x + 5, y + n * line / 2], [x - 5 - wide, y + n * line / 2]]))
      .map(([left, middle]) => [Math.max(2, Math.min(width - wide - 2, left)), Math.max(line / 2, Math.min(height - line / 2, middle))]);
    if (taken.some(other => other.x === x && other.y === y && (other.text === text || look === 'plain'))) continue;
    const free = places.find(([left, middle]) => !taken.some(other =>
      left < other.left + other.wide + 3 && other.left < left + wide + 3 && Math.abs(middle - other.middle) < line));
    if (!free && (look === 'plain' || look === 'faint' || (!centred && look !== 'now'))) continue;
    const [left, middle] = free ?? places[0];
    taken.push({text, x, y, left, middle, wide});
    context.strokeStyle = paper;
    context.lineWidth = line / 4;
    context.strokeText(text, left, middle);
    context.fillStyle = colours[look];
    context.fillText(text, left, middle);
  }
}
