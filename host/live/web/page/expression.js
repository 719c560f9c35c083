// Parses a function of x and y, or of x and z, like muParser in `sightline draw skala --function`: numbers, x, y or z, pi, + - * / ^ ( ),
// comparisons, && || and ?:, and functions. The text is never executed as JavaScript.

const FUNCTIONS = {
  sin: [1, Math.sin], cos: [1, Math.cos], tan: [1, Math.tan], asin: [1, Math.asin], acos: [1, Math.acos], atan: [1, Math.atan],
  atan2: [2, Math.atan2], sinh: [1, Math.sinh], cosh: [1, Math.cosh], tanh: [1, Math.tanh], asinh: [1, Math.asinh], acosh: [1, Math.acosh],
  atanh: [1, Math.atanh], exp: [1, Math.exp], ln: [1, Math.log], log: [1, Math.log], log2: [1, Math.log2], log10: [1, Math.log10],
  sqrt: [1, Math.sqrt], abs: [1, Math.abs], sign: [1, Math.sign], rint: [1, Math.round],
  min: [-1, Math.min], max: [-1, Math.max], sum: [-1, (...v) => v.reduce((a, b) => a + b, 0)], avg: [-1, (...v) => v.reduce((a, b) => a + b, 0) / v.length],
};
const DEEPEST = 100;

// Returns a function (x, z) => number. Throws an Error that says what was found, where, and what was expected.
export function expression(text) {
  let at = 0;
  let depth = 0;
  let second = '';  // the text's name for the second variable
  const blank = () => { while (at < text.length && /\s/.test(text[at])) ++at; };
  const take = token => {
    blank();
    if (!text.startsWith(token, at)) return false;
    at += token.length;
    return true;
  };
  const fail = expected => {
    blank();
    const found = at < text.length ? `"${text[at]}" at column ${at + 1}` : 'the end';
    throw new Error(`found ${found}, expected ${expected}`);
  };
  const deeper = parse => {
    if (++depth > DEEPEST) throw new Error(`found parentheses more than ${DEEPEST} deep, expected fewer`);
    const made = parse();
    --depth;
    return made;
  };

  const choice = () => {
    const condition = either();
    if (!take('?')) return condition;
    const yes = deeper(choice);
    if (!take(':')) fail('":"');
    const no = deeper(choice);
    return (x, z) => condition(x, z) ? yes(x, z) : no(x, z);
  };
  const chain = (next, operators) => () => {
    let left = next();
    for (;;) {
      const found = operators.find(([token]) => take(token));
      if (!found) return left;
      const [, act] = found;
      const a = left;
      const b = next();
      left = (x, z) => act(a(x, z), b(x, z));
    }
  };
  const power = () => {
    const base = atom();
    if (!take('^')) return base;
    const exponent = deeper(sign);
    return (x, z) => Math.pow(base(x, z), exponent(x, z));
  };
  const sign = () => {
    // One sign, as in muParser.
    if (take('-')) { const of = power(); return (x, z) => -of(x, z); }
    take('+');
    return power();
  };
  const product = chain(sign, [['*', (a, b) => a * b], ['/', (a, b) => a / b]]);
  const sum = chain(product, [['+', (a, b) => a + b], ['-', (a, b) => a - b]]);
  const comparison = chain(sum, [['<=', (a, b) => Number(a <= b)], ['>=', (a, b) => Number(a >= b)], ['==', (a, b) => Number(a === b)],
    ['!=', (a, b) => Number(a !== b)], ['<', (a, b) => Number(a < b)], ['>', (a, b) => Number(a > b)]]);
  const both = chain(comparison, [['&&', (a, b) => Number(Boolean(a && b))]]);
  const either = chain(both, [['||', (a, b) => Number(Boolean(a || b))]]);
  const atom = () => {
    blank();
    if (take('(')) {
      const inside = deeper(choice);
      if (!take(')')) fail('")"');
      return inside;
    }
    const number = /^(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?/.exec(text.slice(at));
    if (number) {
      at += number[0].length;
      const value = Number(number[0]);
      return () => value;
    }
    const name = /^[A-Za-z_][A-Za-z_0-9]*/.exec(text.slice(at))?.[0];
    if (!name) fail('a number, x, y, z, a function or "("');
    at += name.length;
    if (name === 'x') return x => x;
    if (name === 'y' || name === 'z') {
      if (second && second !== name) { at -= name.length; throw new Error(`found "${name}" at column ${at + 1} beside ${second}, expected one name for the second variable`); }
      second = name;
      return (x, z) => z;
    }
    if (name === 'pi') return () => Math.PI;
    if (name === 'e') return () => Math.E;
    if (!Object.hasOwn(FUNCTIONS, name)) { at -= name.length; throw new Error(`found "${name}" at column ${at + 1}, expected x, y, z, pi or one of ${Object.keys(FUNCTIONS).join(' ')}`); }
    const [count, act] = FUNCTIONS[name];
    if (!take('(')) fail('"("');
    const values = [deeper(choice)];
    while (take(',')) values.push(deeper(choice));
    if (!take(')')) fail('")"');
    if (count >= 0 && values.length !== count) throw new Error(`${name}: found ${values.length} values, expected ${count}`);
    return (x, z) => act(...values.map(each => each(x, z)));
  };
  const whole = choice();
  blank();
  if (at < text.length) fail('an operator or the end');
  return whole;
}

const places = count => Array.from({length: count}, (_, i) => count > 1 ? -1 + 2 * i / (count - 1) : 0);

// The data of an expression for the module: its heights row by row, and their range at 65 by 65 places.
export function sampled(text, half, points, slices) {
  const value = expression(text);
  const on = (xs, zs) => zs.flatMap(z => xs.map(x => { const v = value(x * half, z * half); return Number.isFinite(v) ? v : null; }));
  const heights = on(places(points), places(slices));
  const usual = on(places(65), places(65)).filter(v => v !== null);
  const finite = usual.length ? usual : heights.filter(v => v !== null);
  return {heights, points, slices, domain: half, range: [Math.min(...finite), Math.max(...finite)]};
}
