// crest-verify in a page, version @VERSION@
// SPDX-License-Identifier: GPL-3.0-or-later
// Proves a certificate of Crest's in the reader's browser, or in node: nothing is loaded, nothing sent.
//   crestVerify(bytes: Uint8Array, onProgress?: (text: string) => void, signal?: AbortSignal)
//     -> Promise<{accepted: boolean, undecided: boolean, claims: string[], reason: string, digest: string}>
// The promise is always kept. `undecided`: nothing is refuted and nothing proven (a number that could not
// be enclosed, too little memory, a browser without WebAssembly). Works in a worker; in a window it
// makes one, so that the page stays alive. A content security policy must grant 'wasm-unsafe-eval', and
// worker-src blob: for the worker (else the page stands still meanwhile).
globalThis.crestVerify = (() => {
  "use strict";
  // The checker: WebAssembly, gzip, base64.
  const PACKED = "@WASM@";

  // Sees nothing of what surrounds it: its text becomes the worker's.
  const check = async (packed, bytes, progress) => {
    const HAND = "; check it by the program crest-verify";
    const none = (reason) => ({accepted: false, undecided: true, claims: [], reason, digest: ""});
    const claims = [];
    try {
      if (typeof WebAssembly !== "object" || typeof DecompressionStream !== "function")
        return none("this browser is too old to check certificates" + HAND);
      if (!check.module) {
        progress("unpacking");
        const zipped = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
        const stream = new Blob([zipped]).stream().pipeThrough(new DecompressionStream("gzip"));
        const code = await new Response(stream).arrayBuffer();
        progress("compiling");
        check.module = await WebAssembly.compile(code);
      }
      let memory = null;
      const text = (at) => {
        const all = new Uint8Array(memory.buffer);
        return new TextDecoder().decode(all.slice(at, all.indexOf(0, at)));
      };
      const imports = {};
      for (const {module: from, name} of WebAssembly.Module.imports(check.module))
        (imports[from] ??= {})[name] = () => {
          throw new Error("it asked the system for " + name);
        };
      // An empty environment, which the C library looks at when it starts.
      const system = imports.wasi_snapshot_preview1;
      system.environ_sizes_get = (count, size) => {
        new Uint32Array(memory.buffer, count, 1)[0] = new Uint32Array(memory.buffer, size, 1)[0] = 0;
        return 0;
      };
      system.environ_get = () => 0;
      imports.env.emscripten_notify_memory_growth = () => {};
      imports.env.crest_proved = (at) => {
        claims.push(text(at));
        progress(claims.at(-1));
      };
      const {exports} = await WebAssembly.instantiate(check.module, imports);
      memory = exports.memory;
      exports._initialize();
      const room = exports.crest_room(bytes.length);
      if (room === 0) return none("the certificate is too large for a page" + HAND);
      new Uint8Array(memory.buffer, room, bytes.length).set(bytes);
      progress("checking");
      const answer = exports.crest_check();
      return {
        accepted: answer === 1,
        undecided: answer === 2,
        claims,
        reason: text(exports.crest_reason()),
        digest: text(exports.crest_digest()),
      };
    } catch (problem) {
      return none("it could not be checked here (" + (problem?.message ?? problem) + ")" + HAND);
    }
  };

  const makeWorker = () => {
    if (typeof document === "undefined" || typeof Worker !== "function") return null;
    try {
      const body = `const check = ${check};
        onmessage = async ({data}) => postMessage({verdict: await check(
          data.packed, data.bytes, (text) => postMessage({text}))});`;
      const url = URL.createObjectURL(new Blob([body], {type: "text/javascript"}));
      const worker = new Worker(url);
      URL.revokeObjectURL(url);
      return worker;
    } catch {
      return null;
    }
  };

  return (bytes, onProgress = () => {}, signal = undefined) =>
    new Promise((resolve) => {
      const none = (reason) => ({accepted: false, undecided: true, claims: [], reason, digest: ""});
      if (signal?.aborted) return resolve(none("stopped"));
      const here = () => check(PACKED, bytes, onProgress).then(resolve);
      const worker = makeWorker();
      if (worker === null) return here();
      let started = false;
      const end = (verdict) => {
        worker.terminate();
        signal?.removeEventListener("abort", stop);
        resolve(verdict);
      };
      const stop = () => end(none("stopped"));
      signal?.addEventListener("abort", stop);
      worker.onmessage = ({data}) => {
        started = true;
        if (data.verdict) end(data.verdict);
        else onProgress(data.text);
      };
      worker.onerror = (event) => {
        event.preventDefault();
        worker.terminate();
        signal?.removeEventListener("abort", stop);
        // Forbidden by the policy: without a worker, then.
        if (!started) return here();
        resolve(none("the checker has died" + (event.message ? ": " + event.message : "")));
      };
      worker.postMessage({packed: PACKED, bytes});
    });
})();
