// A camera of whole numbers that looks from an angle about the vertical and an elevation, in parallel projection.
export function camera(rotation, elevation) {
  const a = rotation * Math.PI / 180, e = elevation * Math.PI / 180;
  const c = Math.round(100 * Math.cos(a)), s = Math.round(100 * Math.sin(a)), down = Math.round(100 * Math.tan(e));
  return {perspective: false, eye: [0, 0, 0], forward: [s, -down, c], right: [c, 0, -s], up: [down * s, c * c + s * s, down * c]};
}
