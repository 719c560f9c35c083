// The page: its tabs and the links to them.

import {element, notice} from './ui.js';
import {openModule} from './module.js';
import {Files} from './files.js';
import {parseLink, sameLink} from './links.js';
import {Pdp7Tab} from './pdp7_tab.js';
import {I8080Tab} from './i8080_tab.js';
import {Workbench} from './workbench.js';
import {Theatre} from './theatre.js';

const TABS = [['jones', 'PDP-7'], ['skala', '8080'], ['bench', 'Workbench'], ['theatre', 'Theatre'], ['about', 'About']];

// `wasm`: the module's bytes. `shelf`: the examples (examples.txt); those from the firmware only have the names of their sources, which are
// in the module.
export async function begin(wasm, shelf) {
  const main = document.getElementById('main');
  const nav = document.getElementById('tabs');
  const began = performance.now();
  const message = notice();
  const module = await openModule(await WebAssembly.compile(wasm));
  main.replaceChildren(message);
  const {sources} = module.ask({do: 'firmware'});
  const examples = shelf.map(each => ({...each, text: (each.sources ?? []).map(name => sources[name]).join('') + each.text,
    includes: Object.entries(sources).filter(([name]) => each.folder && name.startsWith(each.folder + '/')).map(([name, text]) => [name.slice(each.folder.length + 1), text])}));
  const lists = module.ask({do: 'lists'});
  let current = null;
  const remember = () => {
    if (!current || !current.link) return;
    history.replaceState(null, '', '#' + current.link());
  };
  const about = {root: document.getElementById('credits').content.firstElementChild, enter() {}, leave() {}, key: () => false, link: () => 'about', open: part => { if (part) throw new Error(`About has no part "${part}".`); }};
  const opened = {};
  const make = {
    jones: () => new Pdp7Tab(module, examples.filter(each => each.tab), examples.filter(each => each.machine === 'solid'), remember), skala: () => new I8080Tab(module, lists.functions, remember),
    bench: () => new Workbench(module, examples.filter(each => each.machine !== 'solid'), remember), theatre: () => new Theatre(module, lists.lessons, remember), about: () => about,
  };
  const anchors = Object.fromEntries(TABS.map(([name, title]) => [name, element('a', {href: '#' + name, textContent: title})]));
  nav.append(...Object.values(anchors));

  const say = (...what) => (current?.message ?? message).say(...what);
  const visit = name => {
    const tab = opened[name] ??= make[name]();
    if (current !== tab) {
      current?.leave();
      message.say('');
      main.replaceChildren(message, tab.root);
      for (const [each, anchor] of Object.entries(anchors)) anchor.setAttribute('aria-current', each === name ? 'page' : 'false');
      current = tab;
    }
    return tab;
  };
  // Shows what the address requests. If it is unknown, the tab does not change.
  const show = () => {
    let complaint = '';
    try {
      const {tab: name, part, query} = parseLink(location.hash.slice(1) || 'jones');
      if (!Object.hasOwn(make, name)) throw new Error(`There is no tab "${name}": expected ${Object.keys(make).join(', ')}.`);
      const fresh = !opened[name];
      const tab = visit(name);
      if ((part !== null || query.toString()) && (fresh || !sameLink(location.hash.slice(1), tab.link()))) tab.open(part ?? '', query);
    } catch (error) {
      complaint = error.message;
    }
    if (!current) visit('jones');
    current.enter();
    remember();
    if (complaint) say(complaint, true);
  };
  const files = new Files(module, new Set([...lists.functions, ...examples].map(each => each.name)), {
    say, get tab() { return current; }, get shown() { return Object.keys(opened).find(name => opened[name] === current); },
    visit(name) {
      const tab = visit(name);
      tab.enter();
      history.pushState(null, '', '#' + tab.link());
      return tab;
    },
  });
  addEventListener('hashchange', show);
  addEventListener('keydown', event => { if (current?.key(event, true)) event.preventDefault(); });
  addEventListener('keyup', event => { if (current?.key(event, false)) event.preventDefault(); });
  const failed = text => message.say(`Something went wrong: ${text}. Reload the page to begin again.`, true);
  addEventListener('error', event => failed(event.message));
  addEventListener('unhandledrejection', event => failed(event.reason?.message ?? event.reason));
  show();
  document.documentElement.dataset.ready = String(Math.round(performance.now() - began));
  // For tests and for the browser's console.
  globalThis.sightline = {module, files, get tab() { return current; }};
}
