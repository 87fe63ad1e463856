// SPDX-License-Identifier: GPL-3.0-or-later
// The scene on its canvas, and what moves it.

class View {
  constructor(scene) {
    this.scene = scene;
    this.canvas = byId("view");
    const gl = this.gl = this.canvas.getContext("webgl2", {antialias: true});
    if (!gl) throw new Error("this browser has no WebGL 2");
    this.surfaceProgram = compile(gl, surfaceVertex, surfaceFragment, ["a_place", "a_normal", "a_colour"]);
    this.lineProgram = compile(gl, lineVertex, lineFragment, lineAttributes);
    this.idProgram = compile(gl, lineVertex, idFragment, lineAttributes);
    this.surfaces = scene.surfaces.map((data) => new Surface(gl, data));
    let base = 1;
    this.layers = scene.layers.map((layer) => {
      const lines = new Lines(gl, scene, layer, base);
      base += layer.count;
      return lines;
    });
    this.length = this.layers.reduce((sum, lines) => sum + lines.length, 0);
    this.points = this.layers.reduce((sum, lines) => sum + lines.points, 0);
    this.camera = new Camera(scene);
    this.chosen = 0;  // number of an item, from 1 on
    this.through = false;
    this.level = 0;   // of surfaces: 0 is all of them; the last one has fewer pixels, too
    this.sharp = 1;   // pixels of the picture a pixel of the window, along an axis
    this.frames = [];
    this.waiting = false;
    this.resize();
    this.fit();
    this.camera.fromHash(location.hash);
    this.draw();
  }

  /** The window in pixels of the picture; the free part is what the panel leaves. */
  resize() {
    const {canvas} = this, scale = this.scale = this.sharp * Math.min(window.devicePixelRatio || 1, 2);
    const wide = canvas.clientWidth, high = canvas.clientHeight;
    canvas.width = Math.max(1, Math.round(wide * scale));
    canvas.height = Math.max(1, Math.round(high * scale));
    const panel = byId("panel").getBoundingClientRect();
    const sheet = panel.width >= wide, free = [wide, high];
    if (panel.width > 0 && sheet) free[1] -= panel.height;
    else if (panel.width > 0 && wide > 1.6 * panel.width) free[0] = panel.left;
    this.window = {
      width: canvas.width, height: canvas.height, aspect: free[0] / free[1],
      middle: [0.5 * scale * free[0], 0.5 * scale * free[1]], size: 0.5 * scale * free[1],
    };
  }

  /** The first view shows everything. */
  fit() {
    const points = [];
    const few = (places) => {
      const step = 3 * Math.ceil(places.length / 60000);
      for (let i = 0; i < places.length; i += step) points.push(places[i], places[i + 1], places[i + 2]);
    };
    for (const surface of this.surfaces) few(surface.data.points);
    for (const lines of this.layers) few(lines.unit);
    this.camera.fit(points, this.window.aspect);
    this.camera.reset();
  }

  changed() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame((now) => {
      this.waiting = false;
      if (this.moving) this.pace(now);
      this.draw();
    });
  }

  /** While something moves: coarser triangles, in the end fewer pixels, where frames take too long. */
  pace(now) {
    this.frames.push(now);
    const count = this.frames.length - 1, each = (now - this.frames[0]) / count;
    // One frame that takes very long is enough to know.
    if (count < 1 || (count < 3 && each < 200)) return;
    this.frames = [now];
    const most = this.surfaces.reduce((sum, s) => sum + s.levels[0].count / 3, 0);
    const last = coarser.length;  // few triangles need no steps to it
    if (each > 33) this.level = most > coarser.at(-1) ? Math.min(this.level + (each > 200 ? 2 : 1), last) : last;
    for (const surface of this.surfaces) surface.prepare(this.level);
  }

  /** Starts and ends what pace() watches. */
  move(moving) {
    if (moving === this.moving) return;
    this.moving = moving;
    this.frames = [];
    if (moving) return;
    history.replaceState(null, "", `#${this.camera.toHash()}`);
    this.changed();
  }

  say(drawn, all) {
    const less = [];
    if (drawn < all) less.push(`${grouped(drawn)} of ${grouped(all)} triangles`);
    if (this.sharp < 1) less.push("a quarter of the pixels");
    byId("status").textContent = less.length > 0 ? `while it turns: ${less.join(", ")}` : "";
  }

  setCommon(program) {
    const {gl, camera} = this;
    gl.useProgram(program.program);
    gl.uniformMatrix4fv(program.uniforms.u_view, false, camera.matrix(this.window));
  }

  drawSurfaces(opaque) {
    const {gl, surfaceProgram: {uniforms}} = this;
    this.setCommon(this.surfaceProgram);
    gl.uniformMatrix3fv(uniforms.u_turn, false, this.camera.rotation());
    const level = this.moving ? this.level : 0;
    let drawn = 0, all = 0;
    for (const surface of this.surfaces) {
      if (!surface.shown || (surface.data.opacity >= 1) !== opaque) continue;
      gl.uniform1f(uniforms.u_opacity, surface.data.opacity);
      drawn += surface.prepare(level);
      all += surface.levels[0].count / 3;
      surface.draw(level);
    }
    return [drawn, all];
  }

  setLines(program) {
    const {gl, window: {width, height, size}, scale} = this, {uniforms} = program;
    this.setCommon(program);
    gl.uniform2f(uniforms.u_screen, 0.5 * width, 0.5 * height);
    gl.uniform1f(uniforms.u_pixel, scale);
    gl.uniform1f(uniforms.u_half, this.camera.half / size);  // units a pixel
    gl.uniform1ui(uniforms.u_chosen, this.chosen);
  }

  /** Thinner where ink would cover more than its share of the scene. */
  widths() {
    const {window: {size}, scale, camera} = this, pixels = size / camera.half;
    return {
      line: Math.min(Math.max(0.45 * pixels / Math.max(this.length, 1e-9), 1.1 * scale), 2.6 * scale),
      disc: Math.min(Math.max(100 * scale / Math.sqrt(this.points + 1), 4 * scale), 10 * scale),
    };
  }

  drawLines() {
    const {gl, lineProgram, scale} = this, {uniforms} = lineProgram, widths = this.widths();
    this.setLines(lineProgram);
    const colours = new Map();
    const colour = (share) => (kind) => {
      const key = kind.colour + share;
      if (!colours.has(key)) colours.set(key, new Float32Array(rgbOf(kind.colour).map((c) => share * c / 255)));
      return colours.get(key);
    };
    const pass = (marked, share, settings) => {
      gl.uniform3fv(uniforms.u_marked, marked);
      gl.uniform1f(uniforms.u_share, share);
      this.layers.forEach((lines, i) =>
        lines.draw(uniforms, {...widths, ...settings, lift: settings.lift + 0.003 * i}));
    };
    gl.enable(gl.BLEND);
    const rim = 1.4 * scale, unit = this.camera.half / this.window.size;
    // On a surface lines hide nothing: a rim or a soft edge would hide the core of the next segment.
    const alone = !this.surfaces.some(({shown, data}) => shown && data.opacity >= 1);
    gl.depthMask(false);
    pass([0.05, 0.05, 0.05], 1, {more: rim, lift: 0, colour: colour(0.45)});
    gl.depthMask(alone);
    // Wider lines are lifted more, by 1.5 half widths: as much as their rims.
    pass([1, 1, 1], 1, {more: 0, lift: 0.75 * rim * unit, colour: colour(1)});
    gl.depthMask(false);
    gl.depthFunc(gl.GREATER);
    if (this.through && !alone) pass([1, 1, 1], 0.3, {more: 0, lift: 0, colour: colour(1)});
    gl.depthFunc(gl.LEQUAL);
    gl.depthMask(true);
  }

  draw() {
    const {gl} = this, sharp = this.moving && this.level >= coarser.length ? 0.5 : 1;
    if (sharp !== this.sharp) {
      this.sharp = sharp;
      this.resize();
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, this.window.width, this.window.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.disable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const solid = this.drawSurfaces(true);
    this.drawLines();
    gl.depthMask(false);
    const clear = this.drawSurfaces(false);
    gl.depthMask(true);
    this.say(solid[0] + clear[0], solid[1] + clear[1]);
  }

  /** The item within a few pixels of a place of the window, from 1 on; 0: none. */
  itemAt(x, y) {
    const {gl, window: {width, height}, scale} = this;
    if (!this.target) {
      this.target = gl.createFramebuffer();
      this.ids = gl.createRenderbuffer();
      this.depths = gl.createRenderbuffer();
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    for (const [buffer, format, place] of [[this.ids, gl.RGBA8, gl.COLOR_ATTACHMENT0],
      [this.depths, gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
    }
    const column = Math.floor(x * scale), row = height - 1 - Math.floor(y * scale);
    gl.viewport(0, 0, width, height);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(column, row, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.disable(gl.BLEND);
    gl.colorMask(false, false, false, false);
    this.drawSurfaces(true);
    gl.colorMask(true, true, true, true);
    this.setLines(this.idProgram);
    const pass = {...this.widths(), more: 7 * scale};
    this.layers.forEach((lines, i) => lines.draw(this.idProgram.uniforms, {...pass, lift: 0.003 * i}));
    const pixel = new Uint8Array(4);
    gl.readPixels(column, row, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.disable(gl.SCISSOR_TEST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return pixel[0] + 256 * (pixel[1] + 256 * (pixel[2] + 256 * pixel[3]));
  }

  /** The nearest face there: [surface, hit], or null. */
  faceAt(x, y) {
    const {camera, window: {middle, size}, scale} = this, unit = camera.half / size;
    const across = blend(unit * (x * scale - middle[0]), camera.right, unit * (middle[1] - y * scale), camera.up);
    const from = blend(1, blend(1, camera.centre, 1, across), -4, camera.forward);
    let best = null;
    for (const surface of this.surfaces) {
      if (!surface.shown || surface.data.opacity < 1) continue;
      const hit = surface.hit(from, camera.forward);
      if (hit && (!best || hit.depth < best[1].depth)) best = [surface, hit];
    }
    return best;
  }

  /** Shows an item's attributes; 0: of none. */
  choose(number) {
    this.chosen = number;
    byId("item").hidden = number === 0;
    const lines = this.layers.find(({base, layer}) => number >= base && number < base + layer.count);
    if (number > 0 && lines) describeItem(lines, number - lines.base);
    this.changed();
  }

  pick(x, y) {
    const item = this.itemAt(x, y);
    this.choose(item);
    if (item > 0) return;
    const found = this.faceAt(x, y);
    if (found) describeFace(this.scene, ...found);
  }

  /** The next visible item (step 1) or the one before (-1). */
  step(step) {
    const all = this.layers.reduce((sum, {layer}) => sum + layer.count, 0);
    for (let i = 1; i <= all; ++i) {
      const number = 1 + ((this.chosen - 1 + step * i) % all + all) % all;
      const lines = this.layers.find(({base, layer}) => number >= base && number < base + layer.count);
      if (lines.visible(number - lines.base)) return this.choose(number);
    }
  }

  /** The picture with its ground, as a file. */
  save() {
    this.move(false);
    this.draw();
    const sheet = make("canvas"), pen = sheet.getContext("2d");
    [sheet.width, sheet.height] = [this.canvas.width, this.canvas.height];
    const style = getComputedStyle(document.documentElement);
    const ground = pen.createLinearGradient(0, 0, 0, sheet.height);
    ground.addColorStop(0, style.getPropertyValue("--ground").trim());
    ground.addColorStop(1, style.getPropertyValue("--ground-low").trim());
    pen.fillStyle = ground;
    pen.fillRect(0, 0, sheet.width, sheet.height);
    pen.drawImage(this.canvas, 0, 0);
    sheet.toBlob((blob) => download(blob, `${fileName(this.scene.title)}.png`));
  }
}

function addPointers(view) {
  const {canvas, camera} = view, down = new Map();
  let travelled = 0;
  const spread = () => {
    const [a, b] = [...down.values()];
    return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, size: Math.hypot(a.x - b.x, a.y - b.y)};
  };
  const scaled = (pixels) => pixels * view.scale / view.window.size;
  const zoomAt = (factor, x, y) => {
    const {middle, size} = view.window;
    camera.zoom(factor, (x * view.scale - middle[0]) / size, (middle[1] - y * view.scale) / size);
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    if (down.size === 0) travelled = 0;
    down.set(event.pointerId, {x: event.clientX, y: event.clientY, start: performance.now()});
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = down.get(event.pointerId);
    if (!last) return;
    const dx = event.clientX - last.x, dy = event.clientY - last.y;
    const before = down.size === 2 ? spread() : null;
    Object.assign(last, {x: event.clientX, y: event.clientY});
    travelled += Math.abs(dx) + Math.abs(dy);
    if (travelled < 4 && down.size === 1) return;
    view.move(true);
    if (before) {
      const after = spread();
      camera.move(-scaled(after.x - before.x), scaled(after.y - before.y));
      if (before.size > 0) zoomAt(after.size / before.size, after.x, after.y);
    } else if (event.shiftKey || event.buttons & 6) {
      camera.move(-scaled(dx), scaled(dy));
    } else if (camera.flat) {
      camera.move(-scaled(dx), scaled(dy));
    } else {
      camera.turn(2.2 * scaled(dx), 2.2 * scaled(dy));
    }
    view.changed();
  });
  const up = (event) => {
    if (!down.delete(event.pointerId) || down.size > 0) return;
    view.move(false);
    if (event.type === "pointerup" && travelled < 4 && event.button === 0) view.pick(event.clientX, event.clientY);
  };
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  let rest = 0;
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1;
    view.move(true);
    zoomAt(Math.exp(-0.0015 * lines * event.deltaY), event.clientX, event.clientY);
    view.changed();
    clearTimeout(rest);
    rest = setTimeout(() => view.move(false), 250);
  }, {passive: false});
}

function addKeys(view, actions) {
  const {camera} = view, turn = 0.12, arrows = {
    ArrowLeft: [-turn, 0], ArrowRight: [turn, 0], ArrowUp: [0, -turn], ArrowDown: [0, turn],
  };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === "SELECT") return;
    const typing = event.target.type === "range", arrow = arrows[event.key];
    if (arrow && !typing) {
      if (event.shiftKey) camera.move(-arrow[0], arrow[1]);
      else camera.turn(...arrow);
    } else if ("+=-".includes(event.key) && !typing) {
      camera.zoom(event.key === "-" ? 1 / 1.15 : 1.15, 0, 0);
    } else if (actions[event.key.toLowerCase()]) {
      actions[event.key.toLowerCase()]();
    } else {
      return;
    }
    if (arrow) event.preventDefault();
    history.replaceState(null, "", `#${camera.toHash()}`);
    view.changed();
  });
}

function addTheme() {
  const root = document.documentElement, dark = matchMedia("(prefers-color-scheme: dark)");
  const set = (isDark) => root.dataset.theme = isDark ? "dark" : "light";
  set(dark.matches);
  dark.addEventListener("change", () => set(dark.matches));
  return () => set(root.dataset.theme !== "dark");
}

function addWords(scene) {
  byId("title").textContent = document.title = scene.title;
  byId("note").textContent = scene.note;
  byId("summary").textContent = [scene.summary.trim(), ...scene.warnings.map((w) => `warning: ${w}`)].join("\n");
  byId("command").textContent = scene.command;
  byId("made").textContent = `Crest ${scene.version}` + (scene.digest ? `, data digest ${scene.digest}` : "");
}

async function start() {
  const switchTheme = addTheme();
  const panel = byId("panel"), open = byId("open");
  const scene = await readScene();
  addWords(scene);
  const view = new View(scene), redraw = () => view.changed();
  for (const lines of view.layers) addLayer(byId("layers"), lines, redraw);
  if (view.surfaces.length > 0) byId("surfaces").append(make("h2", "", "Surfaces"));
  for (const surface of view.surfaces) addSurface(byId("surfaces"), surface, redraw);
  addProof(scene);
  const showPanel = (shown) => {
    panel.classList.toggle("closed", !shown);
    open.setAttribute("aria-expanded", shown);
    view.resize();
    redraw();
  };
  const actions = {
    r: () => {
      view.camera.reset();
      history.replaceState(null, "", location.pathname + location.search);
    },
    x: () => byId("through").setAttribute("aria-pressed", view.through = !view.through),
    l: switchTheme,
    s: () => view.save(),
    m: () => showPanel(panel.classList.contains("closed")),
    n: () => view.step(1),
    p: () => view.step(-1),
    escape: () => view.choose(0),
  };
  for (const [button, key] of Object.entries({reset: "r", through: "x", theme: "l", png: "s", open: "m", close: "escape"})) {
    byId(button).addEventListener("click", () => {
      actions[key]();
      redraw();
    });
  }
  addPointers(view);
  addKeys(view, actions);
  window.addEventListener("resize", () => {
    const whole = view.camera.half === view.camera.start.half;
    view.resize();
    if (whole) view.fit();
    redraw();
  });
  window.addEventListener("hashchange", () => {
    view.camera.fromHash(location.hash);
    redraw();
  });
  view.canvas.addEventListener("webglcontextlost", () => {
    byId("status").textContent = "The graphics card was lost: reload the page.";
  });
  view.resize();  // the panel is full now
  view.fit();
  view.camera.fromHash(location.hash);
  redraw();
  window.crestPage = view;
}

start().catch((error) => {
  byId("status").textContent = `This page cannot be shown: ${error.message}`;
  throw error;
});
