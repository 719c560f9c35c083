// The theatre: shows each algorithm step by step on a small scene that can be rotated.

import {choice, element, field, fileTaker, introduction, notice} from './ui.js';
import {makePlayer, releaseKeys} from './player.js';
import {camera} from './camera.js';
import {anyText, named, number, optionsOf} from './links.js';
import {MOST_FACES} from './files.js';

const SCENES = ['house', 'roberts', 'street4', 'boxes-2', 'boxes-3', 'boxes-5', 'bricks-2', 'triangles-3', 'town-2'];
const FUNCTIONS = ['sinc', 'peaks', 'rogers', 'franke'];

export class Theatre {
  constructor(module, lessons, remember) {
    this.module = module;
    this.own = new Set();  // scenes that are files of the user
    this.lessonFile = '';  // name of the lesson's file, if it is a file
    this.lessons = lessons;
    this.remember = remember;
    this.options = {algorithm: 'jones', scene: 'house', function: 'sinc', view: 'own', rotation: 30, elevation: 30};
    this.stage = element('div', {className: 'stage'});
    this.message = notice();
    const o = this.options;
    this.pick = choice('Algorithm', lessons.map(each => [each.algorithm, each.algorithm]), o.algorithm, value => { o.algorithm = value; this.play(); }, 'The algorithm that is shown');
    this.scene = choice('Scene', SCENES, o.scene, value => { o.scene = value; this.play(); }, 'The solids that it draws');
    this.function = choice('Function', FUNCTIONS, o.function, value => { o.function = value; this.play(); }, 'The function of two variables that it draws');
    this.view = choice('View', [['own', "the scene's own"], ['turned', 'parallel, turned']], o.view, value => { o.view = value; this.play(); }, 'The camera of the scene, or a rotated view in parallel projection');
    this.turn = field('Rotation', o.rotation, value => { o.rotation = Number(value) || 0; o.view = 'turned'; this.view.select.value = 'turned'; this.play(); }, {type: 'range', min: -180, max: 180, step: 5}, 'Turns the scene about the vertical axis');
    this.tilt = field('Elevation', o.elevation, value => { o.elevation = Number(value) || 0; o.view = 'turned'; this.view.select.value = 'turned'; this.play(); }, {type: 'range', min: 0, max: 60, step: 5}, 'Tilts the scene: how far it is seen from above');
    const intro = introduction();
    intro.say('Hidden-line algorithms at work[ on small scenes], one step at a time. Press Play, or > for the next step.');
    this.root = element('div', {className: 'theatre'}, intro,
      element('p', {className: 'bar'}, this.pick, this.scene, this.function),
      element('p', {className: 'bar seen'}, this.view, this.turn, this.tilt,
        fileTaker('Open a file')),
      this.message, this.stage);
    releaseKeys(this.root);
  }
  // Returns a complaint, or ''.
  // `addressed`: the address selects the first step.
  play(addressed = false) {
    const o = this.options;
    const lesson = this.lessons.find(each => each.algorithm === o.algorithm) ?? this.lessons[0];
    if (!lesson) return '';
    this.showChoices();
    const request = lesson.heights
      ? {do: 'explain', algorithm: lesson.algorithm, function: o.function, points: 13, slices: 9, rotation: o.rotation, elevation: o.elevation}
      : {do: 'explain', algorithm: lesson.algorithm, scene: o.scene, ...(o.view === 'turned' ? {camera: camera(o.rotation, o.elevation)} : {})};
    const answer = this.module.ask(request);
    this.message.say(answer.error ?? '', Boolean(answer.error));
    if (answer.error) return answer.error;
    this.lessonFile = '';
    this.setPlayer(answer, addressed);
    return '';
  }
  setPlayer(lesson, addressed = false) {
    this.player?.stop();
    this.player = makePlayer(this.stage, lesson, {moved: this.remember, addressed});
    this.remember();
  }
  showChoices() {
    const o = this.options;
    const heights = this.lessons.find(each => each.algorithm === o.algorithm)?.heights ?? false;
    this.scene.hidden = this.view.hidden = heights;
    this.function.hidden = !heights;
    this.pick.select.value = o.algorithm;
    this.scene.select.value = o.scene;
    this.function.select.value = o.function;
    this.view.select.value = o.view;
  }

  // Takes a file (files.js); false: this tab cannot use it, or cannot show it and sets the file's `error`.
  take(file) {
    const {name, kind} = file;
    const o = this.options;
    if (kind === 'lesson') {
      const lesson = JSON.parse(new TextDecoder().decode(file.bytes));
      if (!isLesson(lesson)) { this.message.say(`${name}: found a lesson without sheets or steps, or with steps that draw on no sheet; expected one that sightline explain has written.`, true); return true; }
      this.message.say('');
      this.lessonFile = name;
      this.setPlayer(lesson);
      return true;
    }
    if (kind !== 'scene') return false;
    if (file.faces > MOST_FACES) return false;
    const before = {...o};
    // Jones's lesson of a mesh takes many seconds, because its space must be decomposed first.
    const keeps = !this.lessons.find(each => each.algorithm === o.algorithm).heights && (file.cells || o.algorithm !== 'jones');
    this.own.add(name);
    let error = '';
    for (const algorithm of new Set([keeps ? o.algorithm : 'exact', 'exact'])) {
      Object.assign(o, {algorithm, scene: name, view: 'own'});
      error = this.play();
      if (!error) break;
    }
    if (error) {
      Object.assign(o, before);
      file.error = error;
    } else if (![...this.scene.select.options].some(each => each.value === name)) {
      this.scene.select.append(element('option', {value: name, textContent: name}));
    }
    this.showChoices();
    return !error;
  }
  enter() { if (!this.player) this.play(true); }
  leave() { this.player?.pause(); }
  key(event, down) { return down && Boolean(this.player?.key(event)); }
  link() {
    const o = this.options;
    if (this.lessonFile) return `theatre/lesson/${encodeURIComponent(this.lessonFile)}?file=1`;
    const parts = new URLSearchParams();
    if (o.view === 'turned') { parts.set('rotation', o.rotation); parts.set('elevation', o.elevation); }
    const lesson = this.lessons.find(each => each.algorithm === o.algorithm);
    if (!lesson?.heights && this.own.has(o.scene)) parts.set('file', '1');
    if (this.player && this.player.step !== this.player.first) parts.set('step', this.player.step + 1);
    const text = parts.toString();
    return `theatre/${o.algorithm}/${encodeURIComponent(lesson?.heights ? o.function : o.scene)}${text ? '?' + text : ''}`;
  }
  open(part, query) {
    const o = this.options;
    const [algorithm, ...rest] = part.split('/');
    const what = rest.join('/');
    if (algorithm === 'lesson') throw new Error(`${what} was a file of your computer: open it again.`);
    const changes = {};
    if (algorithm) changes.algorithm = named('algorithm', algorithm, this.lessons.map(each => each.algorithm));
    const {heights} = this.lessons.find(each => each.algorithm === (algorithm || o.algorithm));
    if (what && heights) changes.function = named('function', what, FUNCTIONS, query);
    else if (what) changes.scene = named('scene', what, [...this.scene.select.options].map(each => each.value), query);
    const {rotation, elevation} = optionsOf(query, {rotation: number(-180, 180), elevation: number(-90, 90), step: anyText, embed: anyText, from: anyText, to: anyText});
    if (rotation !== undefined || elevation !== undefined) Object.assign(changes, {view: 'turned', rotation: rotation ?? o.rotation, elevation: elevation ?? o.elevation});
    Object.assign(o, changes);
    this.turn.input.value = o.rotation;
    this.tilt.input.value = o.elevation;
    this.showChoices();
    this.play(true);
  }
}

// Whether a lesson has all that makePlayer needs.
function isLesson({sheets, steps}) {
  const isPoint = point => Array.isArray(point) && point.length === 2 && point.every(Number.isFinite);
  return Array.isArray(sheets) && sheets.length > 0 && sheets.every(sheet => sheet && isPoint(sheet.low) && isPoint(sheet.high))
    && Array.isArray(steps) && steps.length > 0 && steps.every(step => step && typeof step.caption === 'string' && step.counts && typeof step.counts === 'object' && Array.isArray(step.layers)
      && step.layers.every(layer => layer && Number.isInteger(layer.sheet) && sheets[layer.sheet] && Array.isArray(layer.marks) && layer.marks.every(Array.isArray)));
}
