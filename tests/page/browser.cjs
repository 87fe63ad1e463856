// SPDX-License-Identifier: GPL-3.0-or-later
// Uses pages in headless Chromium (scripts/test_page.sh); exit code 1 if one does not behave.
"use strict";
const fs = require("fs");
const path = require("path");
const {chromium} = require("playwright-core");

const options = {};
for (let i = 2; i < process.argv.length; ++i) {
  const name = process.argv[i].slice(2);
  options[name] = ["update", "large"].includes(name) ? true : process.argv[++i];
}

let failures = 0, checks = 0;
function check(holds, what) {
  ++checks;
  if (holds) return;
  ++failures;
  console.log(`FAILED: ${what}`);
}

/** Until the page's function says so. Not waitForFunction: it evaluates text, which the policy forbids. */
async function until(page, holds, most, argument) {
  for (const end = Date.now() + most; !await page.evaluate(holds, argument);) {
    if (Date.now() > end) throw new Error(`not within ${most} ms: ${holds}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}

/** Opens a page as a reader would, from a file; whatever it complains of is a failure. */
async function open(browser, name, settings = {}) {
  const context = await browser.newContext({viewport: {width: 900, height: 600}, ...settings});
  const page = await context.newPage();
  page.setDefaultTimeout(120000);  // frames of software GL on a busy machine
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text()))
      check(false, `${name}: console: ${message.text()}`);
  });
  page.on("pageerror", (error) => check(false, `${name}: ${error}`));
  page.on("request", (request) => {
    if (!/^(file|blob|data):/.test(request.url())) check(false, `${name}: asks for ${request.url()}`);
  });
  const file = path.join(options.pages, `${name}.html`);
  await page.goto(`file://${path.resolve(file)}`);
  await until(page, () => window.crestPage !== undefined, 90000);
  await settled(page);
  return page;
}

/** After two frames everything asked for is drawn. */
const settled = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** How many pixels of the canvas differ by more than a little between two data URLs of PNGs. */
const difference = (page, a, b) => page.evaluate(async ([a, b]) => {
  const pixels = async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], {type: "image/png"}));
    const sheet = new OffscreenCanvas(image.width, image.height), pen = sheet.getContext("2d");
    pen.drawImage(image, 0, 0);
    return pen.getImageData(0, 0, image.width, image.height);
  };
  const [one, other] = [await pixels(a), await pixels(b)];
  if (one.width !== other.width || one.height !== other.height) return 1;
  let far = 0;
  for (let i = 0; i < one.data.length; i += 4) {
    const d = [0, 1, 2].map((k) => Math.abs(one.data[i + k] - other.data[i + k]));
    if (Math.max(...d) > 40) ++far;
  }
  return far / (one.width * one.height);
}, [a, b]);

const shot = async (page) => (await page.screenshot()).toString("base64");

/** Against the stored screenshot: words may be set in other fonts, drivers round differently. */
async function compare(page, name) {
  const file = path.join(options.stored, `${name}.png`), now = await page.screenshot();
  if (options.update) {
    fs.mkdirSync(options.stored, {recursive: true});
    fs.writeFileSync(file, now);
    return;
  }
  if (!fs.existsSync(file)) {
    console.log(`SKIPPED: no stored screenshot ${file} (--update)`);
    return;
  }
  const share = await difference(page, now.toString("base64"), fs.readFileSync(file).toString("base64"));
  check(share < 0.03, `${name}: ${(100 * share).toFixed(2)} % of the pixels differ from ${file}`);
  if (share >= 0.03) fs.writeFileSync(path.join(options.pages, `${name}-now.png`), now);
}

/** Where an item of a layer is on the window, in front of everything; null if none is. */
const placeOf = (page, layerName) => page.evaluate((layerName) => {
  const view = crestPage, lines = view.layers.find(({layer}) => layer.name === layerName);
  const {middle, size} = view.window, {right, up, centre, half} = view.camera;
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const places = [];
  for (let i = 0; i < lines.unit.length; i += 3)
    places.push([0, 1, 2].map((k) => lines.unit[i + k] - centre[k]));
  places.sort((a, b) => dot(view.camera.forward, a) - dot(view.camera.forward, b));  // the nearest first
  for (const p of places.slice(0, 20)) {
    const x = (middle[0] + size / half * dot(right, p)) / view.scale;
    const y = (middle[1] - size / half * dot(up, p)) / view.scale;
    const number = view.itemAt(x, y);
    if (number >= lines.base && number < lines.base + lines.layer.count) return {x, y};
  }
  return null;
}, layerName);

async function ridges(browser) {
  const page = await open(browser, "ridges", {colorScheme: "light"});
  await compare(page, "ridges");
  const policy = await page.getAttribute("meta[http-equiv]", "content");
  check(!/unsafe-inline|unsafe-eval'|\*|https?:/.test(policy.replace("'wasm-unsafe-eval'", "")), `policy ${policy}`);
  check((await page.title()) === "Ridges of ellipsoid.off", "the title");

  // A switch takes its lines away and brings them back.
  const before = await shot(page);
  const row = page.locator(".row[data-kind='blue elliptic'] input");
  await row.click();
  await settled(page);
  check((await difference(page, before, await shot(page))) > 0.0005, "a switch changes the picture");
  await row.click();
  await page.mouse.move(5, 5);
  await settled(page);
  check((await difference(page, before, await shot(page))) < 0.0005, "and brings it back");

  // A slider leaves fewer items, by exactly its threshold.
  const strength = page.locator("input[data-column='strength']");
  const last = await strength.getAttribute("max");
  await strength.fill(String(Math.ceil(last / 2)));
  const kept = await page.evaluate(() => {
    const lines = crestPage.layers[0], {values} = lines.layer.columns.find(({name}) => name === "strength");
    return lines.items.every((shown, i) => (shown === 1) === (values[i] >= lines.thresholds[0])) &&
      lines.items.includes(0) && lines.items.includes(1);
  });
  check(kept, "a slider shows what is at least its value");
  await strength.fill("0");
  check(await page.evaluate(() => crestPage.layers[0].items.every((shown) => shown === 1)), "and all again");

  // Picking says the item's numbers as the page carries them.
  const place = await placeOf(page, "Ridges");
  check(place !== null, "a ridge can be picked");
  if (place) {
    await page.mouse.click(place.x, place.y);
    const said = await page.locator("#item-rows").innerText();
    const number = await page.evaluate(() => crestPage.layers[0].layer.columns
      .find(({name}) => name === "length").values[crestPage.chosen - crestPage.layers[0].base]);
    check(said.includes(String(number)), `the item's length, all digits: ${said}`);
  }
  await page.keyboard.press("Escape");
  check(await page.locator("#item").isHidden(), "Escape lets go");
  await page.keyboard.press("n");
  check((await page.evaluate(() => crestPage.chosen)) >= 1, "N goes to an item");
  await page.keyboard.press("Escape");

  // Dragging turns, the wheel zooms, R brings the first view back; the address keeps the view.
  const start = await page.evaluate(() => crestPage.camera.toHash());
  await page.mouse.move(250, 300);
  await page.mouse.down();
  await page.mouse.move(330, 340, {steps: 4});
  await page.mouse.up();
  await settled(page);
  const turned = await page.evaluate(() => crestPage.camera.toHash());
  check(turned !== start, "a drag turns");
  check((await page.evaluate(() => location.hash)) === `#${turned}`, "the address has the view");
  const size = await page.evaluate(() => {
    const {right, up, forward} = crestPage.camera;
    return [right, up, forward].map((v) => Math.hypot(...v));
  });
  check(size.every((length) => Math.abs(length - 1) < 1e-9), "the axes stay unit vectors");
  await page.mouse.wheel(0, -300);
  check((await page.evaluate(() => crestPage.camera.half < crestPage.camera.start.half)), "the wheel zooms");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("r");
  check((await page.evaluate(() => crestPage.camera.toHash())) === start, "R resets");
  await page.evaluate((hash) => location.hash = hash, turned);
  await until(page, (hash) => crestPage.camera.toHash() === hash, 5000, turned);

  await proof(page);
  await page.context().close();
}

async function proof(page) {
  check(await page.locator("#proof").isVisible(), "the certificate is shown");
  if ((await page.locator("#checker").textContent()) === "") {
    check((await page.locator("#proof-words").innerText()).includes("crest-verify"), "how to verify by hand");
    console.log("SKIPPED: verification in the page (no CREST_VERIFY_JS, see scripts/wasm.sh)");
    return;
  }
  const verdict = async (button) => {
    await page.click(button);
    await page.waitForSelector("#verdict[data-accepted]", {timeout: 60000});
    return page.getAttribute("#verdict", "data-accepted");
  };
  check((await verdict("#verify")) === "true", `verified: ${await page.locator("#verdict").innerText()}`);
  check((await verdict("#tamper")) === "false", "a tampered certificate is rejected");
  // A page whose certificate was changed on disk: the same through the file.
}

async function features(browser) {
  const page = await open(browser, "features", {colorScheme: "dark"});
  await compare(page, "features-dark");
  check((await page.getAttribute("html", "data-theme")) === "dark", "dark where the reader has it so");
  await page.keyboard.press("l");
  check((await page.getAttribute("html", "data-theme")) === "light", "L changes it");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#png")]);
  check(fs.readFileSync(await download.path()).subarray(1, 4).toString() === "PNG", "the picture can be saved");
  const canvas = await page.evaluate(() => {
    const view = crestPage, {middle} = view.window;
    const hit = view.faceAt(middle[0] / view.scale, middle[1] / view.scale);
    return hit !== null && hit[1].face >= 0;
  });
  check(canvas, "a face is found in the middle");

  // Where frames take too long, fewer triangles turn, and the page says how many.
  const coarse = await page.evaluate(() => {
    const view = crestPage, all = view.surfaces[0].indices.length / 3;
    view.move(true);
    view.level = 3;
    view.draw();
    const said = document.getElementById("status").textContent, drawn = view.surfaces[0].prepare(3);
    view.level = 4;
    view.draw();
    const blurred = {wide: view.canvas.width, said: document.getElementById("status").textContent};
    view.move(false);
    view.draw();
    return {all, drawn, said, blurred, wide: view.canvas.width, after: document.getElementById("status").textContent};
  });
  check(coarse.all > 20000 && coarse.drawn <= 12000 && coarse.drawn > 2000, `coarse: ${JSON.stringify(coarse)}`);
  check(2 * coarse.blurred.wide === coarse.wide && coarse.blurred.said.includes("pixels"),
    `fewer pixels: ${JSON.stringify(coarse)}`);
  check(coarse.said.includes("triangles") && !coarse.said.includes("pixels") && coarse.after === "", "a coarse surface is said, while it moves only");
  await page.context().close();
}

async function reebOnPhone(browser) {
  const page = await open(browser, "reeb",
    {viewport: {width: 390, height: 780}, hasTouch: true, isMobile: true, colorScheme: "light"});
  await compare(page, "reeb-phone");
  const place = await placeOf(page, "Critical points");
  check(place !== null, "a critical point can be touched");
  if (place) {
    await page.touchscreen.tap(place.x, place.y);
    check((await page.locator("#item-rows").innerText()).includes("persistence"), "and says its persistence");
  }
  await page.tap("#open");
  check(await page.locator("#panel").isHidden(), "the panel closes");
  await page.tap("#open");
  check(await page.locator("#panel").isVisible(), "and opens");
  const wide = await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);
  check(wide, "nothing is wider than the phone");
  await page.context().close();
}

/** Seconds of the processor that the browser's processes have had. */
function processorTime() {
  const children = new Map(), times = new Map();
  for (const id of fs.readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      const fields = fs.readFileSync(`/proc/${id}/stat`, "utf8").split(") ").at(-1).split(" ");
      times.set(id, (Number(fields[11]) + Number(fields[12])) / 100);
      children.set(fields[1], [...(children.get(fields[1]) ?? []), id]);
    } catch (error) {}  // has ended
  }
  const below = (id) => (children.get(id) ?? []).reduce((sum, child) => sum + times.get(child) + below(child), 0);
  return below(String(process.pid));
}

/** Turns a surface of a million triangles: what is drawn, what is said, and what a frame costs. */
async function million(browser) {
  const page = await open(browser, "million");
  const all = await page.evaluate(() => crestPage.surfaces[0].levels[0].count / 3);
  check(all > 990000, `a million triangles: ${all}`);
  console.log("| said while it turns | script, ms a frame | processor time, s a frame | frames a second by the clock |");
  console.log("|---|---|---|---|");
  const turn = (level, frames) => page.evaluate(([level, frames]) => new Promise((done) => {
    const view = crestPage, times = [], script = [];
    view.move(true);
    const step = (now) => {
      const start = performance.now();
      if (level === null) view.pace(now);
      else view.level = level;
      view.camera.turn(0.03, 0.01);
      view.draw();
      script.push(performance.now() - start);
      times.push(now);
      if (times.length <= frames) return requestAnimationFrame(step);
      const said = document.getElementById("status").textContent;
      view.move(false);
      const rate = 1000 * frames / (times.at(-1) - times[0]);
      done({said, rate, level: view.level, script: script.sort((a, b) => a - b)[frames >> 1]});
    };
    requestAnimationFrame(step);
  }), [level, frames]);
  for (const [level, frames] of [[4, 60], [3, 60], [2, 30], [1, 10], [0, 2]]) {
    await turn(level, 1);  // the level is made
    await settled(page);
    const before = processorTime(), {said, rate, script} = await turn(level, frames);
    console.log(`| ${said || `all ${all} triangles`} | ${script.toFixed(1)} | ` +
      `${((processorTime() - before) / frames).toFixed(3)} | ${rate.toFixed(1)} |`);
  }
  await page.evaluate(() => crestPage.level = 0);
  const paced = await turn(null, 40);
  console.log(`by itself: level ${paced.level}, ${paced.said || "all triangles"}`);
  check(paced.level === 0 || paced.said.includes("triangles"), "what is left out is said");
  await page.context().close();
}

(async () => {
  const args = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars"];
  if (process.getuid() === 0) args.push("--no-sandbox");
  const browser = await chromium.launch({executablePath: options.browser, args});
  for (const part of options.large ? [million] : [ridges, features, reebOnPhone]) {
    try {
      await part(browser);
    } catch (error) {
      check(false, `${part.name}: ${error.stack}`);
    }
  }
  await browser.close();
  console.log(`pages in a browser: ${checks - failures} of ${checks} checks hold`);
  process.exit(failures === 0 ? 0 : 1);
})();
