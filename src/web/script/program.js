// The program in the page: which build runs, and how it starts.
import { isOneFile, readFile, scriptUrl } from "./files.js";

/** Milliseconds that a service worker may take to start. */
const WORKER_PATIENCE = 5000;

/** A service worker keeps the files for the next visit. */
const register = () => navigator.serviceWorker.register("service-worker.js").catch(() => null);

/** @return The browser's service workers; null where there are none: over plain http, in a page that is one file. */
const serviceWorkers = () => isOneFile ? null : navigator.serviceWorker ?? null;

/** A service worker adds the headers for shared memory where the host sent none: one reload. In a frame, such as a slide's, they would not
 * suffice. @return Whether it reloads. */
const isReloading = async () => {
  if (!serviceWorkers()) {
    return false;
  }
  if (self.crossOriginIsolated || self !== self.top) {
    register(); // Nobody waits for it: that took up to a third of the time to the first picture.
    return false;
  }
  if (!sessionStorage.getItem("reloaded") && await register()) {
    await Promise.race([navigator.serviceWorker.ready, new Promise((resolve) => setTimeout(resolve, WORKER_PATIENCE))]);
    sessionStorage.setItem("reloaded", "1");
    location.reload();
    return true;
  }
  sessionStorage.removeItem("reloaded");
  return false;
};

/** Lets the service worker, and one that replaces it, keep all files of the page for a time without network; body's data say when it has
 * them. */
export const keepFiles = async () => {
  const workers = serviceWorkers();
  const ask = async () => (workers.controller ?? (await workers.ready).active)?.postMessage("keep");
  if (workers) {
    workers.onmessage = () => { document.body.dataset.kept = "yes"; };
    workers.oncontrollerchange = ask;
    await ask();
  }
};

/** The smallest module with an instruction of SIMD. */
const SIMD_MODULE = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11]);

/** @return How the program runs here: { isReloading, hasSimd, isThreaded, threads }. */
export const chooseMode = async () => {
  const hasSimd = typeof WebAssembly === "object" && WebAssembly.validate(SIMD_MODULE);
  const wantsOne = new URLSearchParams(location.search).has("one-thread");
  if (!hasSimd || await isReloading()) {
    return { hasSimd, isReloading: hasSimd };
  }
  const isThreaded = !isOneFile && !wantsOne && self.crossOriginIsolated && typeof SharedArrayBuffer !== "undefined";
  return { hasSimd, isReloading: false, isThreaded, threads: isThreaded ? navigator.hardwareConcurrency || 1 : 1 };
};

/** Runs a script of the page. */
export const loadScript = async (name) => {
  const element = document.createElement("script");
  element.src = await scriptUrl(name);
  return new Promise((resolve, reject) => {
    element.onload = resolve;
    element.onerror = () => reject(new Error(name));
    document.head.append(element);
  });
};

/** Compiles while it is fetched, where the host says what it is. */
const compile = async (name) => {
  const streamed = isOneFile ? null : await WebAssembly.compileStreaming(fetch(name)).catch(() => null);
  return streamed || WebAssembly.compile(await readFile(name));
};

/** Begins to load the program: all parts at once. @return What startProgram() takes. */
export const loadProgram = (mode) => {
  const name = mode.isThreaded ? "dioptre" : "dioptre-single";
  return { wasm: compile(name + ".wasm"), script: loadScript(name + ".js"), data: readFile("dioptre.data") };
};

/** Starts the program. @param parts Of loadProgram(). @param settings Of the module, which is returned. */
export const startProgram = async (parts, settings) => {
  const wasm = await parts.wasm, data = await parts.data;
  await parts.script;
  const own = {
    // The files are there before the scene of a link is written among them: they would not replace it.
    getPreloadedPackage: () => data.slice().buffer,
    instantiateWasm: (imports, done) => {
      WebAssembly.instantiate(wasm, imports).then((instance) => done(instance, wasm));
      return {};
    },
  };
  const module = { ...own, ...settings };
  self.Module = module;
  return self.createDioptre(module);
};
