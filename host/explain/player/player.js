// Plays a lesson (schema sightline/explain/1): sheets, a caption, counts, and controls to go forward and back.
//
// The state of a step is the contents of all layers. States are built from the nearest kept one: every 64th is kept.

const LOOKS = {
  faint: ['there for comparison', 1, []], plain: ['of the matter at hand', 1.5, []], now: ['this step', 2.5, []],
  other: ['compared with', 2, []], seen: ['visible', 2, []], hidden: ['hidden', 1.5, [4, 4]], waiting: ['waiting', 1.5, []],
  mask: ['mask', 2, []],
};
const KEPT = 64;

// Drawn in this order, so that what a step is about is not under what was there before.
const ORDER = ['faint', 'mask', 'plain', 'hidden', 'waiting', 'seen', 'other', 'now'];

export function makePlayer(root, lesson) {
  const states = new Map();
  const order = lesson.sheets.map(() => []);
  for (const step of lesson.steps)
    for (const layer of step.layers)
      if (!order[layer.sheet].includes(layer.name)) order[layer.sheet].push(layer.name);

  function stateOf(n) {
    let from = n - n % KEPT;
    while (from > 0 && !states.has(from)) from -= KEPT;
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
      if (i % KEPT === 0) states.set(i, state.map(sheet => ({...sheet})));
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
  const slider = make('input', {type: 'range', min: 0, max: lesson.steps.length - 1, value: 0});
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
  const used = new Set(lesson.steps.flatMap(step => step.layers.flatMap(layer => layer.marks.map(mark => mark[1]))));
  const player = make('section', {className: 'player', tabIndex: 0},
    make('h1', {textContent: lesson.title}),
    make('div', {className: 'controls'},
      button('|<', 'First step (Home)', () => show(0)), button('<', 'Back (left arrow)', () => show(at - 1)), play,
      button('>', 'Forward (right arrow)', () => show(at + 1)), button('>|', 'Last step (End)', () => show(lesson.steps.length - 1)),
      slider, place, pace),
    caption, counts,
    make('div', {className: 'sheets'}, ...lesson.sheets.map((sheet, i) => make('figure', {}, canvases[i], make('figcaption', {textContent: sheet.title})))),
    make('ul', {className: 'legend'}, ...Object.keys(LOOKS).filter(look => used.has(look)).map(look => {
      const sample = make('i');
      sample.style.background = `var(--${look})`;
      return make('li', {}, sample, LOOKS[look][0]);
    })));
  player.setAttribute('aria-label', lesson.title);
  root.replaceChildren(player);

  let at = 0;
  let timer = 0;
  let stopped = false;

  function toggle() {
    if (timer) { clearTimeout(timer); timer = 0; } else { if (at === lesson.steps.length - 1) show(0); tick(); }
    play.textContent = timer ? 'Pause' : 'Play';
  }
  function tick() {
    timer = setTimeout(() => {
      if (stopped) return;
      show(at + 1);
      if (at < lesson.steps.length - 1) tick(); else { timer = 0; play.textContent = 'Play'; }
    }, 1000 / Number(pace.value));
  }
  function show(n) {
    at = Math.max(0, Math.min(lesson.steps.length - 1, n));
    const step = lesson.steps[at];
    slider.value = at;
    place.textContent = `${at + 1} of ${lesson.steps.length}`;
    caption.replaceChildren(step.caption);
    if (step.section) caption.append(' ', make('span', {className: 'section', textContent: `(${step.section})`}));
    counts.replaceChildren(...Object.entries(step.counts).map(([name, value]) => make('li', {}, `${name} `, make('b', {textContent: value}))));
    draw();
  }
  function draw() {
    const state = stateOf(at);
    const style = getComputedStyle(player);
    const colours = Object.fromEntries(Object.keys(LOOKS).map(look => [look, style.getPropertyValue('--' + look)]));
    lesson.sheets.forEach((sheet, i) => drawSheet(canvases[i], sheet, order[i].map(name => state[i][name] ?? []), colours));
  }

  player.addEventListener('keydown', event => {
    if (event.target instanceof HTMLSelectElement || event.target === slider) return;
    const act = {ArrowRight: () => show(at + 1), ArrowLeft: () => show(at - 1), Home: () => show(0), End: () => show(lesson.steps.length - 1)}[event.key];
    if (act) act(); else if (event.key === ' ' && !(event.target instanceof HTMLButtonElement)) toggle(); else return;
    event.preventDefault();
  });
  slider.oninput = () => show(Number(slider.value));
  const observer = new ResizeObserver(draw);
  canvases.forEach(canvas => observer.observe(canvas));
  show(Number(/[#&?]step=(\d+)/.exec(location.hash)?.[1] ?? 1) - 1);
  return {
    show, get step() { return at; }, length: lesson.steps.length,
    stop() { stopped = true; clearTimeout(timer); observer.disconnect(); },
  };
}

function drawSheet(canvas, sheet, layers, colours) {
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
  context.font = '12px system-ui, sans-serif';
  for (const look of ORDER) {
    const [, thickness, dashes] = LOOKS[look];
    context.strokeStyle = context.fillStyle = colours[look];
    context.lineWidth = thickness;
    context.setLineDash(dashes);
    for (const marks of layers) {
      for (const mark of marks) {
        if (mark[1] !== look) continue;
        if (mark[0] === 'text') { context.fillText(mark[4], X(mark[2]) + 4, Y(mark[3]) - 4); continue; }
        context.beginPath();
        if (mark[0] === 'dot') {
          context.arc(X(mark[2]), Y(mark[3]), 3 + thickness / 2, 0, 2 * Math.PI);
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
}
