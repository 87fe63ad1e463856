// SPDX-License-Identifier: GPL-3.0-or-later
// From the page's text to arrays of numbers.

const byId = (id) => document.getElementById(id);

/** A new element with a class and a text (never markup: names come from files). */
function make(tag, className, text) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  if (text !== undefined) element.textContent = text;
  return element;
}

async function inflate(base64) {
  const text = atob(base64);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/** [type, offset, count] of page.cpp as a typed array. */
function arrayOf(buffer, [type, at, count]) {
  if (type === "f64") return new Float64Array(buffer, at, count);
  if (type === "f32") return new Float32Array(buffer, at, count);
  if (type === "u8") return new Uint8Array(buffer, at, count);
  const numbers = new Uint32Array(buffer.slice(at, at + 4 * count));
  for (let i = 1; i < count; ++i) numbers[i] += numbers[i - 1];  // differences modulo 2^32
  return numbers;
}

async function readScene() {
  const scene = JSON.parse(byId("scene").textContent);
  const buffer = await inflate(byId("data").textContent);
  byId("data").remove();
  const get = (spec) => arrayOf(buffer, spec);
  for (const surface of scene.surfaces) {
    surface.points = get(surface.points);
    surface.faces = get(surface.faces);
    for (const field of surface.fields) field.values = get(field.values);
  }
  for (const layer of scene.layers) {
    for (const name of ["items", "runs", "first", "places"]) layer[name] = get(layer[name]);
    for (const column of layer.columns) if (column.values) column.values = get(column.values);
  }
  if (scene.certificate) scene.certificate = get(scene.certificate);
  return scene;
}

/** For slider ends and legends; read-outs show all digits. */
function short(x) {
  if (x === 0) return "0";
  const size = Math.abs(x);
  return size >= 1e5 || size < 1e-3 ? x.toExponential(2) : String(Number(x.toPrecision(4)));
}

const grouped = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, "\u2009");

const rgbOf = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));

const maps = {
  sequential: ["#39236f", "#3b528b", "#2c7b8e", "#22a08a", "#57c06a", "#a8da4c", "#f4e54a"],
  diverging: ["#2a4fb0", "#5a86d6", "#a6c2ea", "#ebe9e6", "#f0b79b", "#d9694f", "#a61c2e"],
  pale: ["#fbfbf8", "#dfe9ee", "#b3cbd9", "#7da3bd", "#4f7d9f"],
  grey: ["#464646", "#fafafa"],
  labels: ["#8fb2e0", "#efb98c", "#98cba2", "#e39fad", "#b9a9dd", "#8fd0d6", "#e4cd83", "#c5a992"],
};

/** The colour at t from 0 to 1. */
function colourAt(map, t) {
  const last = map.length - 1, s = Math.min(Math.max(t, 0), 1) * last;
  const i = Math.min(Math.floor(s), last - 1);
  return map[i].map((c, k) => c + (s - i) * (map[i + 1][k] - c));
}

/** The ends of the colours: all values but the two outermost hundredths, if these reach far. */
function rangeOf(field) {
  const sorted = Float64Array.from(field.values).sort();
  const n = sorted.length;
  if (n === 0) return [0, 1];
  let low = sorted[0], high = sorted[n - 1];
  const inner = [sorted[Math.floor(0.02 * (n - 1))], sorted[Math.ceil(0.98 * (n - 1))]];
  if (inner[1] > inner[0] && high - low > 1.5 * (inner[1] - inner[0])) [low, high] = inner;
  if (field.map === "diverging") {
    const most = Math.max(Math.abs(low), Math.abs(high)) || 1;
    return [-most, most];
  }
  return high > low ? [low, high] : [low - 0.5, low + 0.5];
}
