// SPDX-License-Identifier: GPL-3.0-or-later
// try.js CREST-VERIFY.JS CREST-VERIFY FOLDER [FLIPS]: every certificate of the folder is checked as a page
// does and by the program. Both must say the same, in the same words: of the certificate, of FLIPS (20)
// bytes flipped, of as many flipped and sealed anew, and of counts that are far too large, sealed anew.
// Prints a table; exit code 1 if they differ.
"use strict";
const fs = require("fs");
const os = require("os");
const path = require("path");
const {createHash} = require("crypto");
const {spawnSync} = require("child_process");

const [script, program, folder, flips = "20"] = process.argv.slice(2);
(0, eval)(fs.readFileSync(script, "utf8"));
const scratch = path.join(fs.mkdtempSync(path.join(os.tmpdir(), "crest-page-")), "c.crest");
process.on("exit", () => fs.rmSync(path.dirname(scratch), {recursive: true}));

const HEADER = 64;
const sha256 = (...pieces) => pieces.reduce((h, p) => h.update(p), createHash("sha256")).digest();

/** The certificate with its digest and seal computed anew. */
const sealed = (bytes) => {
  const copy = Buffer.from(bytes);
  const end = HEADER + Number(copy.readBigUInt64LE(48));
  sha256(copy.subarray(HEADER, end)).copy(copy, 16);
  sha256(copy.subarray(0, HEADER), copy.subarray(end, copy.length - 32)).copy(copy, copy.length - 32);
  return copy;
};

const byProgram = (bytes) => {
  fs.writeFileSync(scratch, bytes);
  const before = process.resourceUsage ? childTime() : 0;
  const run = spawnSync(program, [scratch], {encoding: "utf8", maxBuffer: 1 << 28});
  const lines = run.stdout.trimEnd().split("\n");
  const verdict = lines.pop() ?? "";
  const digest = lines.at(-1)?.startsWith("data digest: ") ? lines.pop().slice(13) : "";
  return {
    claims: lines, digest, accepted: verdict === "ACCEPTED", code: run.status,
    reason: verdict.replace(/^REJECTED: /, "").replace(/^ACCEPTED$/, ""), seconds: childTime() - before,
  };
};
/** Processor time of the children so far. */
function childTime() {
  const fields = fs.readFileSync("/proc/self/stat", "utf8").split(") ")[1].split(" ");
  return (Number(fields[13]) + Number(fields[14])) / 100;
}
const byPage = async (bytes) => {
  const before = process.cpuUsage();
  const verdict = await crestVerify(new Uint8Array(bytes));
  const {user, system} = process.cpuUsage(before);
  return {...verdict, seconds: (user + system) / 1e6};
};

/** Why the two differ, or an empty text. A page may give up where the program does not: no verdict. */
const difference = (page, native) => {
  if (page.accepted !== native.accepted) return page.undecided && !page.accepted ? "" : "verdicts differ";
  if (page.undecided && !native.reason.startsWith("undecided: ")) return "";
  if (page.reason !== native.reason) return "reasons differ";
  if (page.claims.join("\n") !== native.claims.join("\n")) return "claims differ";
  return page.digest === native.digest ? "" : "digests differ";
};

/** Numbers in [0, 1), the same in every run. */
let state = 20041;
const draw = () => (state = (state * 48271) % 2147483647) / 2147483648;

let failures = 0;
const compare = async (what, bytes, must) => {
  const page = await byPage(bytes);
  const native = byProgram(bytes);
  let objection = difference(page, native);
  if (must !== undefined && page.accepted !== must) objection = `accepted: ${page.accepted}`;
  if (objection !== "") {
    ++failures;
    console.log(`${what}: ${objection}\n  page:    ${JSON.stringify(page)}\n  program: ${JSON.stringify(native)}`);
  }
  return [page, native];
};

(async () => {
  await crestVerify(new Uint8Array(0));
  console.log("| certificate | bytes | claims | page, s | program, s | ratio | gave up |\n|---|---|---|---|---|---|---|");
  let checks = 0, gaveUp = 0;
  for (const name of fs.readdirSync(folder).filter((file) => file.endsWith(".crest")).sort()) {
    const bytes = fs.readFileSync(path.join(folder, name));
    const [page, native] = await compare(name, bytes, true);
    let quit = 0;
    const tried = async (what, changed, must) => {
      const [page] = await compare(`${name}, ${what}`, changed, must);
      ++checks;
      if (page.undecided) ++quit;
    };
    for (let i = 0; i < Number(flips); ++i) {
      const at = Math.floor(draw() * bytes.length), bit = 1 << Math.floor(draw() * 8);
      const changed = Buffer.from(bytes);
      changed[at] ^= bit;
      await tried(`byte ${at} ^ ${bit}`, changed, false);
      if (at >= HEADER && at < bytes.length - 32) await tried(`byte ${at} ^ ${bit}, sealed`, sealed(changed));
    }
    const claims = HEADER + Number(bytes.readBigUInt64LE(48));
    for (const start of [HEADER, claims])
      for (let word = 0; word < Number(flips); ++word)
        for (const count of [0xffffffff, 0x55555556, 0x20000000]) {
          const at = start + word;
          if (at + 4 > bytes.length - 32) continue;
          const changed = Buffer.from(bytes);
          changed.writeUInt32LE(count, at);
          await tried(`${count} at ${at}, sealed`, sealed(changed));
        }
    gaveUp += quit;
    console.log(`| ${name.slice(0, -6)} | ${bytes.length} | ${page.claims.length} | ${page.seconds.toFixed(3)} | ` +
      `${native.seconds.toFixed(3)} | ${(page.seconds / Math.max(native.seconds, 0.01)).toFixed(1)} | ${quit} |`);
  }
  console.log(`${checks} changed certificates, ${failures} differences; gave up on ${gaveUp}; ` +
    `${Math.round(process.resourceUsage().maxRSS / 1024)} MB at most`);
  process.exitCode = failures === 0 ? 0 : 1;
})();
