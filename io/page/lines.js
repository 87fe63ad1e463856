// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and points of constant width on the screen, a batch for each kind of a layer.

const lineAttributes = ["a_from", "a_to", "a_shown", "a_item"];

class Lines {
  /** `base`: the number of its first item among all of the page, from 1 on. */
  constructor(gl, scene, layer, base) {
    this.gl = gl;
    this.layer = layer;
    this.base = base;
    this.thresholds = layer.filters.map(() => -Infinity);
    this.items = new Uint8Array(layer.count).fill(1);
    this.kindOf = new Int32Array(layer.count).fill(-1);  // of the item's first run
    this.pieces = new Uint32Array(layer.kinds.length);   // items a kind
    this.length = 0;
    this.points = 0;
    this.batches = layer.kinds.map(() => ({ends: [], items: []}));
    this.place(scene);
    this.collect();
    for (const batch of this.batches) this.upload(batch);
  }

  /** The places relative to the page's middle, from the doubles. */
  place({centre, radius}) {
    const {places} = this.layer, unit = new Float32Array(places.length);
    for (let i = 0; i < places.length; ++i) unit[i] = (places[i] - centre[i % 3]) / radius;
    this.unit = unit;
  }

  collect() {
    const {items, runs, first, places} = this.layer, at = this.unit;
    const seen = this.batches.map(() => new Set());
    for (let r = 0; r < first.length; ++r) {
      const kind = runs[r], {ends, items: owners} = this.batches[kind];
      const end = r + 1 < first.length ? first[r + 1] : places.length / 3;
      if (this.kindOf[items[r]] < 0) this.kindOf[items[r]] = kind;
      seen[kind].add(items[r]);
      const lone = end - first[r] === 1;
      for (let i = first[r]; i + (lone ? 0 : 1) < end; ++i) {
        const a = 3 * i, b = lone ? a : a + 3;
        const size = Math.hypot(at[b] - at[a], at[b + 1] - at[a + 1], at[b + 2] - at[a + 2]);
        if (!lone && size === 0) continue;
        ends.push(at[a], at[a + 1], at[a + 2], at[b], at[b + 1], at[b + 2]);
        owners.push(items[r]);
        this.length += size;
        this.points += lone ? 1 : 0;
        this.batches[kind].disc = lone;
      }
    }
    seen.forEach((of, kind) => this.pieces[kind] = of.size);
  }

  upload(batch) {
    const {gl, base} = this;
    batch.array = gl.createVertexArray();
    gl.bindVertexArray(batch.array);
    const buffer = (values, usage) => {
      const made = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, made);
      gl.bufferData(gl.ARRAY_BUFFER, values, usage);
      return made;
    };
    buffer(new Float32Array(batch.ends), gl.STATIC_DRAW);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 24, 0);
    gl.vertexAttribPointer(1, 3, gl.FLOAT, false, 24, 12);
    batch.shown = buffer(new Uint8Array(batch.items.length).fill(1), gl.DYNAMIC_DRAW);
    gl.vertexAttribPointer(2, 1, gl.UNSIGNED_BYTE, false, 0, 0);
    buffer(Uint32Array.from(batch.items, (item) => base + item), gl.STATIC_DRAW);
    gl.vertexAttribIPointer(3, 1, gl.UNSIGNED_INT, 0, 0);
    for (let place = 0; place < 4; ++place) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribDivisor(place, 1);
    }
    gl.bindVertexArray(null);
    batch.ends = null;
  }

  column(name) {
    return this.layer.columns.find((column) => column.name === name);
  }

  /** Shows the items that pass all filters; returns how many do. */
  filter() {
    const {gl, layer, items} = this;
    items.fill(1);
    layer.filters.forEach(({column}, i) => {
      const {values} = this.column(column);
      for (let j = 0; j < items.length; ++j) if (!(values[j] >= this.thresholds[i])) items[j] = 0;
    });
    for (const batch of this.batches) {
      gl.bindBuffer(gl.ARRAY_BUFFER, batch.shown);
      gl.bufferSubData(gl.ARRAY_BUFFER, 0, Uint8Array.from(batch.items, (item) => items[item]));
    }
    return items.reduce((sum, shown) => sum + shown, 0);
  }

  visible(item) {
    return this.items[item] === 1 && this.kindOf[item] >= 0 && this.layer.kinds[this.kindOf[item]].shown;
  }

  draw(uniforms, pass) {
    const {gl} = this;
    this.batches.forEach((batch, k) => {
      const kind = this.layer.kinds[k];
      if (!kind.shown || batch.items.length === 0) return;
      gl.uniform1f(uniforms.u_width, pass.line * kind.width + pass.more);
      gl.uniform1f(uniforms.u_disc, pass.disc * kind.width + pass.more);
      if (uniforms.u_colour) gl.uniform3fv(uniforms.u_colour, pass.colour(kind));
      gl.uniform1f(uniforms.u_lift, 0.006 + pass.lift + 0.0006 * k);
      gl.bindVertexArray(batch.array);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, batch.items.length);
    });
  }
}
