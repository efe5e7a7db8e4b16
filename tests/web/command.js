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
 * Runs a command line of the program in an empty page.
 * @param program Its script.
 * @param output  The file that it writes; null: none.
 * @param files   [[path, Buffer]] that it finds besides those of the page.
 * @return { lines, bytes }: what it says, and the file.
 */
const runCommand = async (page, url, program, command, output, files = []) => {
  await page.goto(`${url}empty.html`);
  const { lines, base64 } = await page.evaluate(async ({ program, command, output, texts }) => {
    const late = (await (await fetch("files.json")).json()).later;
    await new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = program;
      script.onload = resolve;
      script.onerror = reject;
      document.head.append(script);
    });
    const lines = [];
    const bytes = await new Promise((resolve, reject) => {
      let module = null;
      createDioptre({
        arguments: command,
        locateFile: (file) => file.replace("-single.data", ".data"),
        preRun: [(started) => {
          module = started;
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
        onExit: (status) => status === 0 ? resolve(output ? Array.from(module.FS.readFile(output)) : []) : reject(new Error(lines.join("\n"))),
      });
    });
    let binary = "";
    for (let i = 0; i < bytes.length; i += 4096) {
      binary += String.fromCharCode(...bytes.slice(i, i + 4096));
    }
    return { lines, base64: btoa(binary) };
  }, { program, command, output, texts: files.map(([path, bytes]) => [path, bytes.toString("base64")]) });
  return { lines, bytes: Buffer.from(base64, "base64") };
};

module.exports = { openEmpty, runCommand };
