// The commands besides view, in a worker with a program of its own: the window stays alive, and a command can be stopped.
import { readFile } from "./files.js";

/** What the worker does; it is text, so that the page can be one file. */
const WORKER = `
  self.onmessage = async ({ data }) => {
    const { words, files, wasm, preloaded, language } = data;
    const text = (kind) => (line) => self.postMessage({ kind, line });
    const module = {
      arguments: words, print: text("out"), printErr: text("err"),
      instantiateWasm: (imports, done) => { WebAssembly.instantiate(wasm, imports).then((instance) => done(instance, wasm)); return {}; },
      getPreloadedPackage: () => preloaded,
      preRun: [(module) => {
        module.ENV.LANGUAGE = module.ENV.LANG = language;
        module.FS.mkdirTree("/work");
        module.addRunDependency("scenes");
        // Behind the preloaded files, which the page's own replace.
        setTimeout(() => {
          for (const [path, bytes] of files) {
            module.FS.mkdirTree(path.slice(0, path.lastIndexOf("/")) || "/");
            module.FS.writeFile(path, bytes);
          }
          module.FS.chdir("/work");
          module.removeRunDependency("scenes");
        }, 0);
      }],
      onAbort: (reason) => self.postMessage({ kind: "end", status: -1, made: [], reason: String(reason) }),
      onExit: (status) => {
        const made = [], add = (folder) => {
          for (const name of module.FS.readdir(folder).filter((each) => each !== "." && each !== "..")) {
            const path = folder + "/" + name;
            module.FS.isDir(module.FS.stat(path).mode) ? add(path) : made.push([path.slice(6), module.FS.readFile(path)]);
          }
        };
        add("/work");
        self.postMessage({ kind: "end", status, made });
      },
    };
    await createDioptre(module);
  };`;

let parts = null;
/** Reads and compiles the program. */
const loadParts = async () => {
  const [wasm, data, script] = await Promise.all([readFile("dioptre-single.wasm"), readFile("dioptre.data"), readFile("dioptre-single.js")]);
  return { wasm: await WebAssembly.compile(wasm), preloaded: data.slice().buffer,
    url: URL.createObjectURL(new Blob([script, WORKER], { type: "text/javascript" })) };
};
/** The program, compiled once. */
const load = () => parts ??= loadParts().catch((error) => {
  parts = null; // The next command tries again.
  throw error;
});

/** @return The words of a command line; quotes hold words together. */
export const splitWords = (line) => [...line.matchAll(/"([^"]*)"|(\S+)/g)].map((match) => match[1] ?? match[2]);

/**
 * Runs a command.
 * @param words     The command line, without the program's name.
 * @param files     [[path, bytes]] that it finds.
 * @param onLine    Called with each line of text.
 * @return { done, stop }: a promise of { status, made: [[name, bytes]] }; a function that ends it.
 */
export const runCommand = (words, files, language, onLine) => {
  let worker = null, finish = null, isStopped = false;
  const done = new Promise((resolve) => { finish = resolve; });
  load().then(({ wasm, preloaded, url }) => {
    if (isStopped) {
      return;
    }
    worker = new Worker(url);
    worker.onmessage = ({ data }) => {
      if (data.kind === "end") {
        worker.terminate();
        finish(data);
      } else {
        onLine(data.line, data.kind);
      }
    };
    worker.onerror = (event) => finish({ status: -1, made: [], reason: event.message });
    worker.postMessage({ words, files, wasm, preloaded, language });
  }).catch((error) => finish({ status: -1, made: [], reason: error.message }));
  return { done, stop: () => { isStopped = true; worker?.terminate(); finish({ status: 130, made: [] }); } };
};

