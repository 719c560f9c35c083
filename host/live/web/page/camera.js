// A camera with whole-number vectors in parallel projection, from a rotation about the vertical axis and an elevation below 85 degrees.
export function camera(rotation, elevation) {
  const a = rotation * Math.PI / 180, e = elevation * Math.PI / 180;
  // A steep view has a long forward vector; the smaller unit keeps all numbers below 32768.
  const unit = Math.abs(elevation) > 72 ? 50 : 100;
  const c = Math.round(unit * Math.cos(a)), s = Math.round(unit * Math.sin(a)), down = Math.round(unit * Math.tan(e));
  return {perspective: false, eye: [0, 0, 0], forward: [s, -down, c], right: [c, 0, -s], up: [down * s, c * c + s * s, down * c]};
}
