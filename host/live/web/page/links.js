// The page's links: what stands behind # in the address, ROOM/PART?OPTIONS. What is wrong with one is thrown as an Error in words.

// `part` is null where there is none.
export function parseLink(text) {
  const [place, ...rest] = text.split('?');
  let decoded;
  try { decoded = decodeURIComponent(place); } catch { throw new Error(`The link is damaged: found "${place}", expected two hexadecimal digits after each %.`); }
  const slash = decoded.indexOf('/');
  return {room: slash < 0 ? decoded : decoded.slice(0, slash), part: slash < 0 ? null : decoded.slice(slash + 1), query: new URLSearchParams(rest.join('?'))};
}

// Whether two links say the same; browsers write some characters in another way.
export function sameLink(a, b) {
  const plain = text => { const {room, part, query} = parseLink(text); return JSON.stringify([room, part, query.toString()]); };
  return plain(a) === plain(b);
}

// One of `names`. What a link marks as a file (file=1) and is not there was one of the person's computer.
export function named(what, name, names, query) {
  if (names.includes(name)) return name;
  throw new Error(query?.get('file') === '1' ? `${name} was a file of your computer: open it again.` : `There is no ${what} "${name}": expected ${listed(names)}.`);
}
const listed = names => names.length < 2 ? names.join() : `${names.slice(0, -1).join(', ')} or ${names.at(-1)}`;

// What the value of an option may be: `read` gives it for a text, or undefined.
export const flag = {read: text => ({0: false, 1: true})[text], expected: '0 or 1'};
export const number = (low, high) => ({
  read: text => text.trim() !== '' && Number(text) >= low && Number(text) <= high ? Number(text) : undefined, expected: `a number from ${low} to ${high}`,
});
export const octal = digits => ({read: text => new RegExp(`^[0-7]{1,${digits}}$`).test(text) ? parseInt(text, 8) : undefined, expected: `an octal number of at most ${digits} digits`});
export const among = names => ({read: text => names.find(each => String(each) === text), expected: listed(names.map(String))});
export const anything = {read: text => text, expected: 'a text'};

// The values of the options that the link has. `known`: by name, what each may be.
export function optionsOf(query, known) {
  const values = {};
  for (const [name, text] of query) {
    if (name === 'file') continue;
    if (!Object.hasOwn(known, name)) throw new Error(`There is no option "${name}" in a link to this: expected ${listed(Object.keys(known))}.`);
    const value = known[name].read(text);
    if (value === undefined) throw new Error(`The link has ${name}=${text}: expected ${known[name].expected}.`);
    values[name] = value;
  }
  return values;
}
