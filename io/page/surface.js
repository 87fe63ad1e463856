// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles: shaded, coloured by a field, coarser while they turn too slowly.

function compile(gl, vertex, fragment, attributes) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  attributes.forEach((name, place) => gl.bindAttribLocation(program, place, name));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  const uniforms = {};
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
  for (let i = 0; i < count; ++i) {
    const {name} = gl.getActiveUniform(program, i);
    uniforms[name] = gl.getUniformLocation(program, name);
  }
  return {program, uniforms};
}

/** Weighted by area; up to the sign, which faces need not agree on. */
function vertexNormals(points, faces) {
  const normals = new Float32Array(points.length);
  for (let i = 0; i < faces.length; i += 3) {
    const a = 3 * faces[i], b = 3 * faces[i + 1], c = 3 * faces[i + 2];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
    const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const corner of [a, b, c]) {
      const along = normals[corner] * n[0] + normals[corner + 1] * n[1] + normals[corner + 2] * n[2];
      for (let k = 0; k < 3; ++k) normals[corner + k] += along < 0 ? -n[k] : n[k];
    }
  }
  for (let i = 0; i < normals.length; i += 3) {  // tiny triangles must not vanish in the shader
    const size = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let k = 0; k < 3; ++k) normals[i + k] /= size;
  }
  return normals;
}

/** Triangles of each level, about; the first has all. */
const coarser = [Infinity, 150000, 40000, 12000];

/** The faces left when the vertices in each cell of a grid become one: at most about `most`. */
function coarsened(points, faces, most) {
  const none = 0xffffffff, stand = new Uint32Array(points.length / 3);
  for (let cells = Math.ceil(Math.sqrt(0.3 * most)); ;) {
    const first = new Map();
    const cell = (x) => Math.floor(0.5 * (x + 1) * cells);
    stand.fill(none);
    for (const v of faces) {
      if (stand[v] !== none) continue;
      const key = (cell(points[3 * v]) * 4096 + cell(points[3 * v + 1])) * 4096 + cell(points[3 * v + 2]);
      if (!first.has(key)) first.set(key, v);
      stand[v] = first.get(key);
    }
    const left = [];
    for (let i = 0; i < faces.length; i += 3) {
      const a = stand[faces[i]], b = stand[faces[i + 1]], c = stand[faces[i + 2]];
      if (a !== b && b !== c && c !== a) left.push(a, b, c);
    }
    if (left.length <= 3 * most || cells < 8) return new Uint32Array(left);
    cells = Math.floor(0.95 * cells * Math.sqrt(3 * most / left.length));  // their number is as cells^2
  }
}

class Surface {
  constructor(gl, data) {
    this.gl = gl;
    this.data = data;
    this.shown = true;
    // Faces of different colours share no corners.
    this.split = data.fields.some((field) => field.face);
    const corners = data.faces, normals = vertexNormals(data.points, corners);
    const spread = (from) => {
      const to = new Float32Array(3 * corners.length);
      for (let i = 0; i < corners.length; ++i)
        for (let k = 0; k < 3; ++k) to[3 * i + k] = from[3 * corners[i] + k];
      return to;
    };
    const onOneSide = (of) => {  // of their first corner's
      for (let i = 0; i < of.length; i += 9)
        for (const j of [i + 3, i + 6])
          if (of[i] * of[j] + of[i + 1] * of[j + 1] + of[i + 2] * of[j + 2] < 0)
            for (let k = 0; k < 3; ++k) of[j + k] = -of[j + k];
      return of;
    };
    this.places = this.split ? spread(data.points) : data.points;
    this.indices = this.split ? Uint32Array.from(corners.keys()) : corners;
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    this.attribute(0, this.places, 3, gl.FLOAT, false);
    this.attribute(1, this.split ? onOneSide(spread(normals)) : normals, 3, gl.FLOAT, false);
    this.colours = this.attribute(2, new Uint8Array(4 * this.places.length / 3), 4, gl.UNSIGNED_BYTE, true);
    this.levels = [{count: this.indices.length, indices: this.indices, elements: this.elements(this.indices)}];
    gl.bindVertexArray(null);
    this.level = 0;
    this.paint(data.coloured ? data.fields[0] : undefined);
  }

  attribute(place, values, size, type, normalised) {
    const {gl} = this, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, type, normalised, 0, 0);
    return buffer;
  }

  elements(indices) {
    const {gl} = this, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
    return buffer;
  }

  /** Colours by a field (undefined: plain). */
  paint(field) {
    this.field = field;
    const {data, split} = this, count = this.places.length / 3;
    const plain = data.colour ? rgbOf(data.colour) : [214, 213, 209];
    const bytes = new Uint8Array(4 * count);
    const map = field && maps[field.map].map(rgbOf);
    if (field) this.range = rangeOf(field);
    const table = [];
    if (field) for (let i = 0; i < 256; ++i) table.push(colourAt(map, i / 255));
    for (let i = 0; i < count; ++i) {
      let colour = plain;
      if (field) {
        const value = field.values[!split ? i : field.face ? Math.floor(i / 3) : data.faces[i]];
        const [low, high] = this.range;
        if (field.map !== "labels")
          colour = table[Math.min(Math.max(Math.round(255 * (value - low) / (high - low)), 0), 255)];
        else if (value >= 0) colour = map[value % map.length];
      }
      bytes.set(colour, 4 * i);
    }
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.colours);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, bytes, this.gl.STATIC_DRAW);
  }

  /** Makes the level if it is not there yet; returns how many triangles it has. */
  prepare(level) {
    level = Math.min(level, coarser.length - 1);
    while (this.levels.length <= level) {
      const most = coarser[this.levels.length];
      const last = this.levels[this.levels.length - 1];
      if (last.count <= 3 * most) {
        this.levels.push(last);
        continue;
      }
      const indices = coarsened(this.places, last.indices, most);
      this.gl.bindVertexArray(null);
      this.levels.push({count: indices.length, indices, elements: this.elements(indices)});
    }
    return this.levels[level].count / 3;
  }

  draw(level) {
    const {gl} = this, {count, elements} = this.levels[Math.min(level, this.levels.length - 1)];
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, elements);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
  }

  /** The nearest face on the ray from `from` along `ahead`, or null. */
  hit(from, ahead) {
    const {points, faces} = this.data;
    let best = null;
    for (let f = 0; 3 * f < faces.length; ++f) {
      const a = 3 * faces[3 * f], b = 3 * faces[3 * f + 1], c = 3 * faces[3 * f + 2];
      const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
      const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
      const px = ahead[1] * vz - ahead[2] * vy, py = ahead[2] * vx - ahead[0] * vz,
        pz = ahead[0] * vy - ahead[1] * vx;
      const size = ux * px + uy * py + uz * pz;
      if (size === 0) continue;
      const x = from[0] - points[a], y = from[1] - points[a + 1], z = from[2] - points[a + 2];
      const s = (x * px + y * py + z * pz) / size;
      if (!(s >= 0 && s <= 1)) continue;
      const qx = y * uz - z * uy, qy = z * ux - x * uz, qz = x * uy - y * ux;
      const t = (ahead[0] * qx + ahead[1] * qy + ahead[2] * qz) / size;
      if (!(t >= 0 && s + t <= 1)) continue;
      const depth = (vx * qx + vy * qy + vz * qz) / size;
      if (!best || depth < best.depth) best = {depth, face: f, corner: s > t ? (s > 1 - s - t ? 1 : 0) : t > 1 - s - t ? 2 : 0};
    }
    return best;
  }
}
