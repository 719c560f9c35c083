// The page's links: TAB/PART?OPTIONS after # in the address. A wrong link throws an Error with a text for a person.

// `part` is null if there is none.
export function parseLink(text) {
  const [place, ...rest] = text.split('?');
  let decoded;
  try { decoded = decodeURIComponent(place); } catch { throw new Error(`The link is damaged: found "${place}", expected two hexadecimal digits after each %.`); }
  const slash = decoded.indexOf('/');
  return {tab: slash < 0 ? decoded : decoded.slice(0, slash), part: slash < 0 ? null : decoded.slice(slash + 1), query: new URLSearchParams(rest.join('?'))};
}

// Whether two links are equivalent; browsers escape some characters differently.
export function sameLink(a, b) {
  const plain = text => { const {tab, part, query} = parseLink(text); return JSON.stringify([tab, part, query.toString()]); };
  return plain(a) === plain(b);
}

// Returns `name` if it is one of `names`. A missing name that the link marks as a file (file=1) was a file of the user's computer.
export function named(what, name, names, query) {
  if (names.includes(name)) return name;
  throw new Error(query?.get('file') === '1' ? `${name} was a file of your computer: open it again.` : `There is no ${what} "${name}": expected ${listed(names)}.`);
}
const listed = names => names.length < 2 ? names.join() : `${names.slice(0, -1).join(', ')} or ${names.at(-1)}`;

// The types of option values: `read` returns the value of a text, or undefined.
export const flag = {read: text => ({0: false, 1: true})[text], expected: '0 or 1'};
export const number = (low, high) => ({
  read: text => text.trim() !== '' && Number(text) >= low && Number(text) <= high ? Number(text) : undefined, expected: `a number from ${low} to ${high}`,
});
export const octal = digits => ({read: text => new RegExp(`^[0-7]{1,${digits}}$`).test(text) ? parseInt(text, 8) : undefined, expected: `an octal number of at most ${digits} digits`});
export const oneOf = names => ({read: text => names.find(each => String(each) === text), expected: listed(names.map(String))});
export const anyText = {read: text => text, expected: 'a text'};

// The values of the options of a link. `known`: the type of each option by name.
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
