// SPDX-License-Identifier: GPL-3.0-or-later
// An orthographic camera in the page's units: the scene fits into the unit ball around zero.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const blend = (s, a, t, b) => [0, 1, 2].map((k) => s * a[k] + t * b[k]);
const unit = (a) => blend(1 / Math.hypot(...a), a, 0, a);

class Camera {
  constructor(scene) {
    this.start = {right: scene.right, up: scene.up, forward: scene.forward, half: 1};
    this.flat = scene.flat;
    this.reset();
  }

  reset() {
    Object.assign(this, structuredClone(this.start), {centre: [0, 0, 0]});
  }

  /** The half height that shows all of `points` (xyz, xyz, ...) in a window of this shape. */
  fit(points, aspect) {
    const {right, up} = this.start;
    let wide = 1e-9, high = 1e-9;
    for (let i = 0; i < points.length; i += 3) {
      const p = [points[i], points[i + 1], points[i + 2]];
      wide = Math.max(wide, Math.abs(dot(p, right)));
      high = Math.max(high, Math.abs(dot(p, up)));
    }
    this.start.half = 1.1 * Math.max(high, wide / aspect);
  }

  /** Turns by angles about the screen's axes. */
  turn(x, y) {
    if (this.flat) return this.move(-x / Math.PI, y / Math.PI);
    const about = (v, axis, angle) => blend(1, blend(Math.cos(angle), v, Math.sin(angle), cross(axis, v)),
      (1 - Math.cos(angle)) * dot(axis, v), axis);
    this.forward = unit(about(about(this.forward, this.up, -x), this.right, -y));
    const up = about(this.up, this.right, -y);
    this.right = unit(cross(this.forward, up));
    this.up = cross(this.right, this.forward);
  }

  /** Moves the view by parts of its half height. */
  move(x, y) {
    this.centre = blend(1, this.centre, 1, blend(x * this.half, this.right, y * this.half, this.up));
    const far = Math.hypot(...this.centre);
    if (far > 2) this.centre = blend(2 / far, this.centre, 0, this.centre);
  }

  /** By a factor; the place at (x, y), in half heights from the middle, stays. */
  zoom(factor, x, y) {
    const half = Math.min(Math.max(this.half / factor, 1e-4), 8);
    const change = 1 - half / this.half;
    this.move(x * change, y * change);
    this.half = half;
  }

  /** Column by column, to a window of width x height pixels whose free part is around `middle`. */
  matrix({width, height, middle, size}) {
    const {right, up, forward, half, centre} = this, pixels = 2 * size / half;
    const rows = [blend(pixels / width, right, 0, right), blend(pixels / height, up, 0, up),
      blend(0.25, forward, 0, forward)];
    const shift = [2 * middle[0] / width - 1, 1 - 2 * middle[1] / height, 0];
    const columns = [0, 1, 2].flatMap((k) => [rows[0][k], rows[1][k], rows[2][k], 0]);
    return new Float32Array([...columns, ...rows.map((row, k) => shift[k] - dot(row, centre)), 1]);
  }

  /** Of normals: the eye is along +z. */
  rotation() {
    const {right, up, forward} = this;
    return new Float32Array([0, 1, 2].flatMap((k) => [right[k], up[k], -forward[k]]));
  }

  toHash() {
    const digits = (v) => v.map((x) => Number(x.toFixed(5))).join(",");
    return `view=${digits([...this.forward, ...this.up, ...this.centre, this.half])}`;
  }

  fromHash(hash) {
    const text = /view=([-0-9.,e]+)/.exec(hash);
    const v = text ? text[1].split(",").map(Number) : [];
    if (v.length !== 10 || !v.every(Number.isFinite) || !(v[9] > 0)) return;
    const forward = v.slice(0, 3), right = cross(forward, v.slice(3, 6));
    if (!(Math.hypot(...forward) > 0.1) || !(Math.hypot(...right) > 0.1)) return;
    this.forward = unit(forward);
    this.right = unit(right);
    this.up = cross(this.right, this.forward);
    this.centre = v.slice(6, 9);
    this.half = v[9];
  }
}
