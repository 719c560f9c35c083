// Opens files of the user's computer, dropped anywhere on the page or chosen by a button. The module's request `kind` finds their kind.
// The current tab takes a file, or the page offers the tabs that can.

const LARGEST = 16 << 20;
export const MOST_FACES = 200;  // in the theatre; Jones's lesson of a larger mesh would take a quarter of a minute or more
const MOST_OFFERED = 2000;  // faces; larger meshes exceed the 3000 edges of the turning program and the 64 faces of the stripes program

// The error with the file's name, which occurs once.
export function errorText({name}, error) { return error.startsWith(name) ? error : `${name}: ${error}`; }

export class Files {
  // `reserved`: names that the page itself uses. `page`: `shown` is the name of the current tab, `tab` the tab; `say` shows a sentence with
  // offers there; `visit(name)` shows another tab.
  constructor(module, reserved, page) {
    this.module = module;
    this.reserved = reserved;
    this.page = page;
    this.own = new Set();
    this.opened = 0;  // how often files have been opened
    const over = on => document.documentElement.classList.toggle('over', on);
    addEventListener('dragover', event => {
      if (!event.dataTransfer.types.includes('Files')) return;
      event.preventDefault();
      over(true);
    });
    addEventListener('dragleave', event => { if (!event.relatedTarget) over(false); });
    addEventListener('drop', event => {
      over(false);
      if (!event.dataTransfer.files.length) return;
      event.preventDefault();
      this.open([...event.dataTransfer.files]);
    });
    addEventListener('chosen', event => this.open(event.detail));
  }

  // Opens files one after the other, and then reports those that cannot be opened.
  async open(list) {
    const complaints = [];
    let offers = [], wrong = false;
    const changes = [];
    for (const each of list) {
      const file = await this.read(each);
      if (!file.error && file.kind === 'material' && list.length > 1) continue;
      if (!file.error && !(file.faces > MOST_OFFERED) && this.page.tab.take?.(file)) {
        if (file.changes) changes.push(`${file.name}: ${file.changes}.`);
        continue;
      }
      const reasons = [];
      offers = this.offers(file, reasons);
      const failed = Boolean(file.error) && (offers.length > 0 || !reasons.length);
      wrong ||= failed;
      complaints.push(failed ? file.error : this.describe(file, offers, reasons));
    }
    if (complaints.length || changes.length) this.page.say([...complaints, ...changes].join('\n'), wrong, complaints.length === 1 ? offers : []);
    ++this.opened;
  }

  // The file's name, bytes and kind, or an `error`.
  async read(each) {
    if (each.size > LARGEST) return {error: `${each.name}: found ${each.size.toLocaleString('en')} bytes, expected at most ${LARGEST.toLocaleString('en')}.`};
    let bytes;
    try { bytes = new Uint8Array(await each.arrayBuffer()); } catch { return {error: `${each.name}: found a folder or a file that cannot be read, expected a file.`}; }
    const name = this.nameFor(each.name);
    this.own.add(name);
    this.module.putFile(name, bytes);
    return {name, bytes, given: each.name, ...this.module.ask({do: 'kind', file: name})};
  }
  // The name of a file on the page; it differs if the page itself uses the name.
  nameFor(name) {
    if (this.own.has(name)) return name;
    const taken = name.startsWith('.') || this.reserved.has(name) || !this.module.ask({do: 'file', name}).error || !this.module.ask({do: 'scene', scene: name}).error;
    return taken ? `my-${name}` : name;
  }

  // `reasons`: sentences that say why tabs do not take it.
  describe({name, given, title, kind, faces, changes}, offers, reasons) {
    if (kind === 'material') return `${name}: ${title}, which the page does not need. Open the OBJ file.`;
    const what = `${name} is ${title}${changes ? ` (${changes})` : ''}`;
    if (offers.length) return [`${what}.`, ...reasons].join(' ');
    const word = /^[\w.,+-]+$/.test(given) ? given : `'${given.replaceAll("'", "'\\''")}'`;
    const why = faces > MOST_FACES ? [`${what}: too large for the tabs of this page.`] : [`${what}, which no tab of this page can show.`, ...reasons];
    return [...why, `Draw it with: sightline draw exact ${word} -o picture.svg`].join(' ');
  }

  // A label and an action for each tab that can take the file; adds the reasons of the others to `reasons`.
  offers(file, reasons = []) {
    const {name, kind} = file;
    if (!file.title || file.faces > MOST_OFFERED) return [];  // without a title the file cannot be read
    // Only the main clause of an error.
    const not = (what, why) => { reasons.push(`${what}: ${why.replace(/^(faces|scene|stripes): /, '').split(/[:;]/)[0]}.`); return false; };
    // Whether one of the requests makes a machine.
    const can = (what, ...requests) => {
      let answer;
      for (const request of requests) {
        answer = this.module.ask(request);
        if (answer.id) this.module.ask({do: 'drop', id: answer.id});
        if (!answer.error) return true;
      }
      return not(what, answer.error.startsWith(`${name}: `) ? answer.error.slice(name.length + 2) : answer.error);
    };
    const pdp7 = file.machine === 'pdp7';
    const ways = {
      scene: () => [
        (file.cells ? can('No walk', {do: 'jones', scene: name}) : not('No walk', 'it is no scene of cells')) && ["Walk through it with Jones's program on the PDP-7", 'jones', 'walk'],
        can('No turning on the PDP-7', ...['8k', '32k'].map(memory => ({do: 'turn', scene: name, memory}))) && ['Turn it on the PDP-7', 'jones', 'turn'],
        can('No stripes', {do: 'stripes', scene: name}) && ['Draw it in stripes on the 8080', 'skala', 'stripes'],
        (file.faces <= MOST_FACES || not('No lesson', `${file.faces} faces, expected at most ${MOST_FACES}`)) && ['Explain it in the theatre', 'theatre'],
      ],
      grid: () => [["Draw it with Skala's program on the 8080", 'skala']],
      source: () => [['Open it in the workbench', 'bench'], pdp7 && ['Run it on the PDP-7', 'jones']],
      program: () => [pdp7 ? ["Put it into the PDP-7's reader", 'jones'] : ['Load it in the workbench', 'bench']],
      snapshot: () => [pdp7 ? ['Continue it in the PDP-7 tab', 'jones'] : ['Continue it in the 8080 tab', 'skala'], ['Continue it in the workbench', 'bench']],
      lesson: () => [['Show it in the theatre', 'theatre']],
    }[kind];
    return (ways?.() ?? []).filter(each => each && (each[2] || each[1] !== this.page.shown)).map(([label, tab, way]) => [label, () => this.give(file, tab, way)]);
  }
  give(file, name, way) {
    file.error = undefined;
    const tab = this.page.visit(name);
    this.page.say('');
    if (!tab.take(file, way)) this.page.say(file.error ?? `${file.name} is ${file.title}.`, true, this.offers(file));
    else if (file.changes) this.page.say(`${file.name}: ${file.changes}.`);
  }
}
