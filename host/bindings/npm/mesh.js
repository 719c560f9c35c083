// Meshes as users give them, checked and made into the arrays of the module: those of sightline::Mesh (host/bindings/cpp/hidden_lines.hpp).
import {describe, isList, typeOf, wrongArgument} from './module.js';

const wrong = (place, found, expected) => wrongArgument('bad_input', 'mesh', found, expected, place);
const members = ['positions', 'index', 'faces', 'polylines', 'bodies'];

function checkType(place, value, ...types) {
  if (!types.includes(typeOf(value))) throw wrong(place, describe(value), `a ${types.join(' or ')}`);
}
function checkList(place, value, expected) {
  if (!isList(value)) throw wrong(place, describe(value), expected);
}

// Collects lists of vertex numbers, one after the other.
class Lists {
  numbers = [];
  sizes = [];

  constructor(vertexCount) { this.vertexCount = vertexCount; }

  add(place, list, least) {
    if (list.length < least) throw wrong(place, `${list.length} vertices`, `at least ${least}`);
    for (let i = 0; i < list.length; ++i) {
      const vertex = list[i];
      if (!(Number.isInteger(vertex) && vertex >= 0 && vertex < this.vertexCount))
        throw wrong(`${place}[${i}]`, Number.isInteger(vertex) ? `vertex ${vertex}` : describe(vertex), `a number below ${this.vertexCount}`);
      this.numbers.push(vertex);
    }
    this.sizes.push(list.length);
  }
}

// Copies all that it needs.
export function arraysOf(mesh) {
  if (mesh === null || typeof mesh !== 'object' || isList(mesh)) throw wrongArgument('bad_input', 'mesh', describe(mesh), 'an object with positions');
  for (const name of Object.keys(mesh))
    if (!members.includes(name)) throw wrong(name, 'no such member', members.join(', '));
  const {positions, index, faces, polylines, bodies} = mesh;
  checkType('positions', positions, 'Float32Array', 'Float64Array');
  const vertexCount = positions.length / 3;
  const triangles = index === undefined && faces === undefined && polylines === undefined;
  const multiple = triangles ? 9 : 3;
  if (positions.length % multiple) throw wrong('positions', `${positions.length} numbers`, triangles ? 'a multiple of 9 without index' : 'a multiple of 3');
  const none = new Uint32Array();
  const result = {positions: positions.slice(), indexed: index !== undefined, corners: none, ringSizes: none, faceRings: none, bodies: none,
                  linePoints: none, lineSizes: none};
  if (index !== undefined) {
    checkType('index', index, 'Uint32Array', 'Uint16Array');
    if (faces !== undefined) throw wrong('faces', 'besides index', 'one of them');
    if (index.length % 3) throw wrong('index', `${index.length} numbers`, 'a multiple of 3');
    result.corners = Uint32Array.from(index);
  } else if (triangles) {
    result.corners = Uint32Array.from({length: vertexCount}, (_, i) => i);
  }
  result.ringSizes = new Uint32Array(result.corners.length / 3).fill(3);
  if (faces !== undefined) {
    checkList('faces', faces, 'an array of faces');
    const rings = new Lists(vertexCount);
    const faceRings = [];
    for (let f = 0; f < faces.length; ++f) {
      const face = faces[f];
      checkList(`faces[${f}]`, face, 'an array of vertex numbers, or of an outline and holes');
      if (!isList(face[0])) {
        rings.add(`faces[${f}]`, face, 3);
        faceRings.push(1);
        continue;
      }
      for (let r = 0; r < face.length; ++r) {
        checkList(`faces[${f}][${r}]`, face[r], 'an array of vertex numbers');
        rings.add(`faces[${f}][${r}]`, face[r], 3);
      }
      faceRings.push(face.length);
    }
    result.corners = Uint32Array.from(rings.numbers);
    result.ringSizes = Uint32Array.from(rings.sizes);
    if (faceRings.some(count => count > 1)) result.faceRings = Uint32Array.from(faceRings);
  }
  if (polylines !== undefined) {
    checkList('polylines', polylines, 'an array of polylines');
    const lines = new Lists(vertexCount);
    for (let p = 0; p < polylines.length; ++p) {
      checkList(`polylines[${p}]`, polylines[p], 'an array of vertex numbers');
      lines.add(`polylines[${p}]`, polylines[p], 2);
    }
    result.linePoints = Uint32Array.from(lines.numbers);
    result.lineSizes = Uint32Array.from(lines.sizes);
  }
  if (bodies !== undefined) {
    checkList('bodies', bodies, 'an array of numbers, one for each face');
    for (let i = 0; i < bodies.length; ++i)
      if (!(Number.isInteger(bodies[i]) && bodies[i] >= 0 && bodies[i] < 2 ** 32)) throw wrong(`bodies[${i}]`, describe(bodies[i]), 'a number of a body, from 0');
    result.bodies = Uint32Array.from(bodies);
  }
  return result;
}
