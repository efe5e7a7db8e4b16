// All scenes at 80x60 in each engine: the page's bytes are the desktop's.
"use strict";

const { check, serve } = require("./browser.js");
const { execFileSync } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

/** Engines whose pictures are compared; f32x8 is the page's default. */
const ENGINES = ["f32x1", "f64x1", "f32x4", "f32x8"];

/** The program in an empty page: runs a command line, returns the bytes of the file that it writes. */
const runCommand = async (page, url, program, command, output) => {
  await page.goto(`${url}empty.html`);
  return page.evaluate(async ({ program, command, output }) => {
    const late = (await (await fetch("files.json")).json()).later;
    await new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = program;
      script.onload = resolve;
      script.onerror = reject;
      document.head.append(script);
    });
    const bytes = await new Promise((resolve, reject) => {
      const lines = [];
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
          })).then(() => module.removeRunDependency("files"));
        }],
        print: (line) => lines.push(line),
        printErr: (line) => lines.push(line),
        onAbort: (what) => reject(new Error(String(what) + lines.join("\n"))),
        onExit: (status) => status === 0 ? resolve(Array.from(module.FS.readFile(output))) : reject(new Error(lines.join("\n"))),
      });
    });
    let binary = "";
    for (let i = 0; i < bytes.length; i += 4096) {
      binary += String.fromCharCode(...bytes.slice(i, i + 4096));
    }
    return btoa(binary);
  }, { program, command, output });
};

/** Compares the pictures of a build of the page. @param program Its script. */
const compare = async (browser, url, program, engines) => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "dioptre-web-"));
  const page = await browser.newPage();
  await page.route("**/empty.html", (route) => route.fulfill({ contentType: "text/html", body: "<!DOCTYPE html>",
    headers: { "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" } }));
  const names = process.env.SCENES ? process.env.SCENES.split(" ") : fs.readdirSync("scenes").filter((name) => name.endsWith(".lua"));
  let equal = 0;
  for (const name of names) {
    for (const engine of engines) {
      const options = ["-s", "80x60", "--samples", "1", "--engine", engine];
      const file = path.join(folder, "desktop.bmp");
      execFileSync(process.env.DIOPTRE, ["render", `scenes/${name}`, ...options, "-o", file], { stdio: "ignore" });
      const drawn = await runCommand(page, url, program, ["render", `/scenes/${name}`, ...options, "-o", "/page.bmp"], "/page.bmp")
        .catch((error) => { console.log(error.message.split("\n").slice(0, 3).join(" ")); return ""; });
      if (Buffer.from(drawn, "base64").equals(fs.readFileSync(file))) {
        equal++;
      } else {
        check(false, `${name} in ${engine}: the picture of ${program} is the desktop's`);
      }
    }
  }
  check(equal === names.length * engines.length,
    `${equal} of ${names.length * engines.length} pictures of ${program} are the desktop's, byte for byte`);
  fs.rmSync(folder, { recursive: true });
  await page.close();
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  const engines = process.env.ENGINES ? process.env.ENGINES.split(" ") : ENGINES;
  await compare(browser, url, "dioptre.js", engines);
  await compare(browser, url, "dioptre-single.js", engines.slice(-1));
  server.close();
};
