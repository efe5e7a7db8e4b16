// The program in the page: which build runs, and how it starts.
import { isOneFile, readFile, scriptUrl } from "./files.js";

/** Milliseconds that a service worker may take to start. */
const WORKER_PATIENCE = 5000;

/** A service worker adds the headers for shared memory where the host sent none: one reload. @return Whether it reloads. */
const isReloading = async () => {
  if (isOneFile || !navigator.serviceWorker) {
    return false;
  }
  const registration = await navigator.serviceWorker.register("service-worker.js").catch(() => null);
  if (registration && !self.crossOriginIsolated && !sessionStorage.getItem("reloaded")) {
    await Promise.race([navigator.serviceWorker.ready, new Promise((resolve) => setTimeout(resolve, WORKER_PATIENCE))]);
    sessionStorage.setItem("reloaded", "1");
    location.reload();
    return true;
  }
  sessionStorage.removeItem("reloaded");
  return false;
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

const loadScript = (source) => new Promise((resolve, reject) => {
  const element = document.createElement("script");
  element.src = source;
  element.onload = resolve;
  element.onerror = () => reject(new Error(source));
  document.head.append(element);
});

/** Starts the program. @param settings Of the module, which is returned. */
export const startProgram = async (mode, settings) => {
  const name = mode.isThreaded ? "dioptre" : "dioptre-single";
  const own = { locateFile: (file) => file.replace("-single.data", ".data") };
  if (isOneFile) {
    const data = await readFile("dioptre.data");
    own.wasmBinary = await readFile("dioptre-single.wasm");
    own.getPreloadedPackage = () => data.slice().buffer;
  }
  await loadScript(await scriptUrl(name + ".js"));
  const module = { ...own, ...settings };
  self.Module = module;
  return self.createDioptre(module);
};
