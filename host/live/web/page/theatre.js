// The theatre: each algorithm at work on a small scene that can be turned.

import {choice, element, field, fileTaker, introduction, notice} from './ui.js';
import {makePlayer, releaseKeys} from './player.js';
import {camera} from './camera.js';

const SCENES = ['house', 'roberts', 'street4', 'boxes-2', 'boxes-3', 'boxes-5', 'bricks-2', 'triangles-3', 'town-2'];
const FUNCTIONS = ['sinc', 'peaks', 'rogers', 'franke'];

export class Theatre {
  constructor(module, lessons, remember) {
    this.module = module;
    this.lessons = lessons;
    this.remember = remember;
    this.options = {algorithm: 'jones', scene: 'house', function: 'sinc', view: 'own', rotation: 30, elevation: 30};
    this.stage = element('div', {className: 'stage'});
    this.message = notice();
    const o = this.options;
    this.pick = choice('Algorithm', lessons.map(each => [each.algorithm, each.algorithm]), o.algorithm, value => { o.algorithm = value; this.play(); }, 'The algorithm that is shown');
    this.scene = choice('Scene', SCENES, o.scene, value => { o.scene = value; this.play(); }, 'The solids that it draws');
    this.function = choice('Function', FUNCTIONS, o.function, value => { o.function = value; this.play(); }, 'The function of two variables that it draws');
    this.view = choice('View', [['own', "the scene's own"], ['turned', 'parallel, turned']], o.view, value => { o.view = value; this.play(); }, 'From where the scene is seen: from its own eye, or turned, in parallel projection');
    this.turn = field('Rotation', o.rotation, value => { o.rotation = Number(value) || 0; o.view = 'turned'; this.view.select.value = 'turned'; this.play(); }, {type: 'range', min: -180, max: 180, step: 5}, 'Turns the scene about the upright axis');
    this.tilt = field('Elevation', o.elevation, value => { o.elevation = Number(value) || 0; o.view = 'turned'; this.view.select.value = 'turned'; this.play(); }, {type: 'range', min: 0, max: 60, step: 5}, 'Tilts the scene: how far it is seen from above');
    const intro = introduction();
    intro.say('Hidden-line algorithms at work[ on small scenes], one step at a time. Press Play, or > for the next step.');
    this.root = element('div', {className: 'theatre'}, intro,
      element('p', {className: 'bar'}, this.pick, this.scene, this.function),
      element('p', {className: 'bar seen'}, this.view, this.turn, this.tilt,
        fileTaker(this.stage, 'Open a scene', (name, bytes) => {
          module.putFile(name, bytes);
          if (![...this.scene.select.options].some(each => each.value === name)) this.scene.select.append(element('option', {value: name, textContent: name}));
          this.scene.select.value = o.scene = name;
          this.play();
        }, text => this.message.say(text, true))),
      this.message, this.stage);
    releaseKeys(this.root);
  }
  play() {
    const o = this.options;
    const lesson = this.lessons.find(each => each.algorithm === o.algorithm) ?? this.lessons[0];
    if (!lesson) return;
    this.scene.hidden = this.view.hidden = lesson.heights;
    this.function.hidden = !lesson.heights;
    const request = lesson.heights
      ? {do: 'explain', algorithm: lesson.algorithm, function: o.function, points: 13, slices: 9, rotation: o.rotation, elevation: o.elevation}
      : {do: 'explain', algorithm: lesson.algorithm, scene: o.scene, ...(o.view === 'turned' ? {camera: camera(o.rotation, o.elevation)} : {})};
    const answer = this.module.ask(request);
    this.message.say(answer.error ?? '', Boolean(answer.error));
    if (answer.error) return;
    this.player?.stop();
    this.player = makePlayer(this.stage, answer);
    this.remember();
  }
  enter() { if (!this.player) this.play(); }
  leave() { this.player?.pause(); }
  key(event, down) { return down && Boolean(this.player?.key(event)); }
  link() {
    const o = this.options;
    const parts = new URLSearchParams();
    if (o.view === 'turned') { parts.set('rotation', o.rotation); parts.set('elevation', o.elevation); }
    const text = parts.toString();
    const lesson = this.lessons.find(each => each.algorithm === o.algorithm);
    return `theatre/${o.algorithm}/${encodeURIComponent(lesson?.heights ? o.function : o.scene)}${text ? '?' + text : ''}`;
  }
  open(path, query) {
    const o = this.options;
    const [algorithm, what] = path.split('/');
    const lesson = this.lessons.find(each => each.algorithm === algorithm);
    if (lesson) o.algorithm = algorithm;
    if (what && lesson?.heights && FUNCTIONS.includes(what)) o.function = what;
    else if (what && SCENES.includes(what)) o.scene = what;
    if (query.get('rotation')) { o.view = 'turned'; o.rotation = parseFloat(query.get('rotation')) || 0; o.elevation = parseFloat(query.get('elevation')) || 0; }
    this.pick.select.value = o.algorithm;
    this.scene.select.value = o.scene;
    this.function.select.value = o.function;
    this.view.select.value = o.view;
    this.play();
  }
}
