// Command lines of the program in an empty page.
"use strict";

/** @return An empty page that may have threads. */
const openEmpty = async (browser) => {
  const page = await browser.newPage();
  await page.route("**/empty.html", (route) => route.fulfill({ contentType: "text/html", body: "<!DOCTYPE html>",
    headers: { "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" } }));
  return page;
};

/**
 * Runs a command line of the program in an empty page, which has a canvas for a window.
 * @param program Its script.
 * @param output  The file that it writes, or an array of them; null: none.
 * @param files   [[path, Buffer]] that it finds besides those of the page.
 * @return { lines, bytes, all }: what it says, the first file, and all.
 */
const runCommand = async (page, url, program, command, output, files = []) => {
  await page.goto(`${url}empty.html`);
  const { lines, made } = await page.evaluate(async ({ program, command, outputs, texts }) => {
    const late = (await (await fetch("files.json")).json()).later;
    await new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = program;
      script.onload = resolve;
      script.onerror = reject;
      document.head.append(script);
    });
    const lines = [];
    const canvas = document.body.appendChild(document.createElement("canvas"));
    canvas.id = "canvas";
    const made = await new Promise((resolve, reject) => {
      let module = null;
      createDioptre({
        canvas,
        arguments: command,
        locateFile: (file) => file.replace("-single.data", ".data"),
        preRun: [(started) => {
          module = started;
          Object.assign(module.ENV, { SDL_RENDER_DRIVER: "software", SDL_EMSCRIPTEN_KEYBOARD_ELEMENT: "#canvas", SDL_EMSCRIPTEN_ASYNCIFY: "0" });
          outputs.forEach((path) => module.FS.mkdirTree(path.slice(0, path.lastIndexOf("/")) || "/"));
          module.addRunDependency("files");
          Promise.all(late.map(async (name) => {
            const response = await fetch("scenes/" + name);
            module.FS.mkdirTree("/scenes/" + name.slice(0, name.lastIndexOf("/")));
            module.FS.writeFile("/scenes/" + name, new Uint8Array(await response.arrayBuffer()));
          })).then(() => texts.forEach(([path, text]) => module.FS.writeFile(path, Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0)))))
            .then(() => module.removeRunDependency("files"));
        }],
        print: (line) => lines.push(line),
        printErr: (line) => lines.push(line),
        onAbort: (what) => reject(new Error(String(what) + lines.join("\n"))),
        onExit: (status) => status === 0 ? resolve(outputs.map((path) => module.FS.readFile(path))) : reject(new Error(lines.join("\n"))),
      });
    });
    const base64 = (bytes) => {
      let binary = "";
      for (let i = 0; i < bytes.length; i += 4096) {
        binary += String.fromCharCode(...bytes.slice(i, i + 4096));
      }
      return btoa(binary);
    };
    return { lines, made: made.map(base64) };
  }, { program, command, outputs: output ? [output].flat() : [], texts: files.map(([path, bytes]) => [path, bytes.toString("base64")]) });
  const all = made.map((text) => Buffer.from(text, "base64"));
  return { lines, bytes: all[0] ?? Buffer.alloc(0), all };
};

module.exports = { openEmpty, runCommand };
