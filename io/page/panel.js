// SPDX-License-Identifier: GPL-3.0-or-later
// The legend with its switches, the sliders, what is said of an item, and the certificate.

function swatch(colour, disc) {
  const box = make("span", disc === "area" ? "swatch area" : disc ? "swatch disc" : "swatch");
  const ink = box.appendChild(make("i"));
  ink.style.background = colour;
  return box;
}

/** A line with a box to tick; `changed` is told the new state. */
function toggle(label, count, sign, shown, changed) {
  const row = make("label", "row"), box = make("input");
  box.type = "checkbox";
  box.checked = shown;
  box.addEventListener("change", () => changed(box.checked));
  row.append(box, sign, make("span", "label", label), make("span", "count", count));
  return row;
}

/** Filters by one column; the slider runs over the items in the order of their values. */
function slider(lines, number, redraw) {
  const filter = lines.layer.filters[number], column = lines.column(filter.column);
  if (!column || !column.values || column.values.length === 0) return null;
  const sorted = Float64Array.from(column.values).sort(), last = sorted.length - 1;
  if (sorted[0] === sorted[last]) return null;
  const box = make("label", "filter"), words = make("span", "words"), value = make("span", "value");
  words.append(make("span", "", filter.label), value);
  const input = make("input");
  input.type = "range";
  input.min = 0;
  input.max = Math.min(last, 1000);
  input.dataset.column = filter.column;
  const change = () => {
    const place = Math.round(Number(input.value) / Number(input.max) * last);
    lines.thresholds[number] = place === 0 ? -Infinity : sorted[place];
    const left = lines.filter();
    value.textContent = place === 0 ? `all of ${grouped(lines.layer.count)}`
      : `\u2265 ${short(sorted[place])} (${grouped(left)} of ${grouped(lines.layer.count)})`;
    redraw();
  };
  const start = filter.start === null ? 0 : sorted.findIndex((x) => x >= filter.start);
  input.value = start < 0 ? input.max : Math.round(start / last * Number(input.max));
  input.addEventListener("input", change);
  change();
  box.append(words, input);
  return box;
}

function addLayer(parent, lines, redraw) {
  const {layer} = lines;
  parent.append(make("h2", "", layer.name));
  if (layer.count === 0) parent.append(make("p", "", "none"));
  layer.kinds.forEach((kind, k) => {
    if (lines.pieces[k] === 0) return;
    const sign = swatch(kind.colour, lines.batches[k].disc);
    if (!lines.batches[k].disc) sign.firstChild.style.height = `${Math.max(3, Math.round(5 * kind.width))}px`;
    const row = toggle(kind.label, grouped(lines.pieces[k]), sign, kind.shown, (shown) => {
      kind.shown = shown;
      redraw();
    });
    row.dataset.kind = kind.label;
    parent.append(row);
  });
  layer.filters.forEach((_, number) => {
    const box = slider(lines, number, redraw);
    if (box) parent.append(box);
  });
}

function addSurface(parent, surface, redraw) {
  const {data} = surface, box = make("div");
  const colour = data.colour || "#d6d5d1";
  parent.append(toggle(data.name, grouped(data.faces.length / 3), swatch(colour, "area"), true, (shown) => {
    surface.shown = shown;
    redraw();
  }), box);
  if (data.fields.length === 0) return;
  const choice = make("select"), bar = make("canvas", "bar"), ends = make("div", "ends");
  choice.setAttribute("aria-label", `Colours of ${data.name}`);
  data.fields.forEach((field, i) => choice.add(new Option(field.name, i)));
  choice.add(new Option("no colours", -1));
  choice.value = data.coloured ? 0 : -1;
  const show = () => {
    const field = data.fields[choice.value];
    surface.paint(field);
    const scale = Boolean(field) && field.map !== "labels";
    bar.hidden = ends.hidden = !scale;
    if (scale) {
      drawBar(bar, maps[field.map].map(rgbOf));
      ends.replaceChildren(...[surface.range[0], (surface.range[0] + surface.range[1]) / 2, surface.range[1]]
        .map((x) => make("span", "", short(x))));
      const all = field.values.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [Infinity, -Infinity]);
      bar.title = `${field.name} from ${all[0]} to ${all[1]}`;
    }
    redraw();
  };
  choice.addEventListener("change", show);
  box.append(choice, bar, ends);
  show();
}

function drawBar(bar, map) {
  bar.width = 256;
  bar.height = 1;
  const pen = bar.getContext("2d");
  for (let i = 0; i < 256; ++i) {
    pen.fillStyle = `rgb(${colourAt(map, i / 255).map(Math.round).join(" ")})`;
    pen.fillRect(i, 0, 1, 1);
  }
}

function showRows(name, rows) {
  byId("item-name").textContent = name;
  byId("item-rows").replaceChildren(...rows.map(([what, value]) => {
    const row = make("tr");
    row.append(make("td", "", what), make("td", "", value));
    return row;
  }));
  byId("item").hidden = false;
}

function describeItem(lines, item) {
  const {layer} = lines, kind = layer.kinds[lines.kindOf[item]];
  const rows = [["kind", kind.label]];
  for (const {name, values, texts, words} of layer.columns) {
    if (!words) rows.push([name, texts ? texts[item] : String(values[item])]);
    else if (words[values[item]]) rows.push([name, words[values[item]]]);
  }
  let run = layer.items.indexOf(item), first = layer.first[run];
  if (lines.batches[layer.runs[run]].disc)
    "xyz".split("").forEach((axis, k) => rows.push([axis, String(layer.places[3 * first + k])]));
  showRows(`${layer.name} ${item}`, rows);
}

function describeFace(scene, {data}, {face, corner}) {
  const vertex = data.faces[3 * face + corner], rows = [["face", face], ["nearest vertex", vertex]];
  for (const field of data.fields) rows.push([field.name, String(field.values[field.face ? face : vertex])]);
  // Single precision, as the page keeps surfaces: seven digits of the extent at most.
  "xyz".split("").forEach((axis, k) =>
    rows.push([axis, `\u2248 ${short(scene.centre[k] + scene.radius * data.points[3 * vertex + k])}`]));
  showRows(data.name, rows);
}

function download(blob, name) {
  const link = make("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const fileName = (title) => title.replace(/[^\p{L}\p{N}._-]+/gu, "-").slice(0, 60) || "crest";

/** Runs the checker on bytes, in a thread of its own. */
function verify(bytes, progress) {
  const program = byId("checker").textContent + `
;onmessage = async ({data}) => {
  try {
    postMessage({verdict: await crestVerify(data, (text) => postMessage({progress: String(text)}))});
  } catch (error) {
    postMessage({verdict: {accepted: false, claims: [], undecided: true, reason: "the checker failed: " + error}});
  }
};`;
  const address = URL.createObjectURL(new Blob([program], {type: "text/javascript"}));
  return new Promise((resolve) => {
    const worker = new Worker(address);
    const end = (verdict) => {
      worker.terminate();
      URL.revokeObjectURL(address);
      resolve(verdict);
    };
    worker.onmessage = ({data}) => data.verdict ? end(data.verdict) : progress(data.progress);
    worker.onerror = (error) =>
      end({accepted: false, claims: [], undecided: true, reason: `the checker does not run here: ${error.message}`});
    worker.postMessage(bytes);
  });
}

function showVerdict(verdict, seconds, tampered) {
  const out = byId("verdict"), lines = [];
  lines.push(verdict.accepted ? "Accepted." : verdict.undecided ? "Could not be checked: neither proven nor refuted."
    : tampered ? "Rejected, as it must be." : "Rejected.");
  if (verdict.accepted) lines.push(...verdict.claims);
  if (verdict.reason) lines.push(verdict.reason);
  lines.push(`${seconds.toFixed(1)} s in this browser`);
  out.className = verdict.accepted ? "good" : "bad";
  out.textContent = lines.join("\n");
  out.dataset.accepted = verdict.accepted;
}

function addProof(scene) {
  const {certificate} = scene;
  if (!certificate) return;
  const able = byId("checker").textContent.length > 0, name = `${fileName(scene.title)}.crest`;
  byId("proof").hidden = false;
  byId("proof-words").textContent = `${grouped(certificate.length)} bytes` +
    (scene.digest ? `, data digest ${scene.digest.slice(0, 16)}\u2026` : "") +
    (able ? ". The checker in this page reads the certificate alone and trusts neither the program nor " +
      "this drawing." : `. To verify: save it, then run crest-verify ${name}`);
  byId("save-proof").addEventListener("click", () => download(new Blob([certificate]), name));
  const run = async (bytes, tampered) => {
    const buttons = [byId("verify"), byId("tamper")], out = byId("verdict"), start = performance.now();
    for (const button of buttons) button.disabled = true;
    out.className = "";
    delete out.dataset.accepted;
    out.textContent = "verifying\u2026";
    const verdict = await verify(bytes, (text) => out.textContent = text);
    showVerdict(verdict, (performance.now() - start) / 1000, tampered);
    for (const button of buttons) button.disabled = false;
  };
  byId("verify").hidden = byId("tamper").hidden = !able;
  byId("verify").addEventListener("click", () => run(certificate, false));
  byId("tamper").addEventListener("click", () => {
    const copy = certificate.slice();
    copy[Math.floor(copy.length / 2)] ^= 1;
    run(copy, true);
  });
}
