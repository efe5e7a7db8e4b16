// Tests build/web in a real browser: tests/web/page.js [PART...]; see `make test-web`.
// Needs the environment: PLAYWRIGHT, the folder of playwright-core; CHROMIUM, the browser; DIOPTRE, the
// desktop's program, whose pictures are the measure.
"use strict";

const { chromium } = require(process.env.PLAYWRIGHT);
const { execFileSync } = require("child_process");
const fs = require("fs");
const http = require("http");
const os = require("os");
const path = require("path");

const ROOT = "build/web";
/** Engines whose pictures are compared; f32x8 is the page's default. */
const ENGINES = ["f32x1", "f64x1", "f32x4", "f32x8"];
/** Milliseconds that anything may take on a loaded machine. */
const PATIENCE = 60000;
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".json": "application/json",
  ".wasm": "application/wasm", ".svg": "image/svg+xml" };

/** Serves the page. With isHosting the host sends the headers of isolation; else the page must help itself. */
const serve = (isHosting) => new Promise((resolve) => {
  const server = http.createServer((request, response) => {
    const file = path.join(ROOT, path.normalize(decodeURIComponent(new URL(request.url, "http://x").pathname)));
    if (!file.startsWith(ROOT) || !fs.existsSync(file) || fs.statSync(file).isDirectory()) {
      response.writeHead(404);
      response.end();
      return;
    }
    response.setHeader("Content-Type", TYPES[path.extname(file)] || "application/octet-stream");
    if (isHosting) {
      response.setHeader("Cross-Origin-Opener-Policy", "same-origin");
      response.setHeader("Cross-Origin-Embedder-Policy", "require-corp");
    }
    fs.createReadStream(file).pipe(response);
  }).listen(0, "127.0.0.1", () => resolve({ server, url: `http://localhost:${server.address().port}/` }));
});

let failures = 0;
const check = (isRight, words) => {
  console.log(`${isRight ? "ok  " : "FAIL"}  ${words}`);
  failures += isRight ? 0 : 1;
};

/** The program in an empty page: runs a command line, returns the bytes of the file that it writes. */
const runCommand = async (page, url, command, output) => {
  await page.goto(`${url}empty.html`);
  return page.evaluate(async ({ command, output }) => {
    const late = (await (await fetch("files.json")).json()).later;
    const bytes = await new Promise((resolve, reject) => {
      const lines = [];
      self.Module = {
        arguments: command,
        preRun: [() => {
          Module.addRunDependency("files");
          Promise.all(late.map(async (name) => {
            const response = await fetch("scenes/" + name);
            Module.FS.mkdirTree("/scenes/" + name.slice(0, name.lastIndexOf("/")));
            Module.FS.writeFile("/scenes/" + name, new Uint8Array(await response.arrayBuffer()));
          })).then(() => Module.removeRunDependency("files"));
        }],
        print: (line) => lines.push(line),
        printErr: (line) => lines.push(line),
        onAbort: (what) => reject(new Error(String(what) + lines.join("\n"))),
        onExit: (status) => status === 0 ? resolve(Array.from(Module.FS.readFile(output)))
          : reject(new Error(lines.join("\n"))),
      };
      const script = document.createElement("script");
      script.src = "dioptre.js";
      document.head.append(script);
    });
    let binary = "";
    for (let i = 0; i < bytes.length; i += 4096) {
      binary += String.fromCharCode(...bytes.slice(i, i + 4096));
    }
    return btoa(binary);
  }, { command, output });
};

/** All scenes at 80x60 in each engine: the page's bytes are the desktop's. */
const testBits = async (browser, url) => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "dioptre-web-"));
  const page = await browser.newPage();
  await page.route("**/empty.html", (route) => route.fulfill({ contentType: "text/html", body: "<!DOCTYPE html>",
    headers: { "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" } }));
  const names = process.env.SCENES ? process.env.SCENES.split(" ")
    : fs.readdirSync("scenes").filter((name) => name.endsWith(".lua"));
  const engines = process.env.ENGINES ? process.env.ENGINES.split(" ") : ENGINES;
  let equal = 0;
  for (const name of names) {
    for (const engine of engines) {
      const options = ["-s", "80x60", "--samples", "1", "--engine", engine];
      const file = path.join(folder, "desktop.bmp");
      execFileSync(process.env.DIOPTRE, ["render", `scenes/${name}`, ...options, "-o", file], { stdio: "ignore" });
      let drawn = null;
      try {
        drawn = Buffer.from(await runCommand(page, url, ["render", `/scenes/${name}`, ...options, "-o", "/page.bmp"],
          "/page.bmp"), "base64");
      } catch (error) {
        console.log(error.message.split("\n").slice(0, 3).join(" "));
      }
      if (drawn && drawn.equals(fs.readFileSync(file))) {
        equal++;
      } else {
        check(false, `${name} in ${engine}: the page's picture is the desktop's`);
      }
    }
  }
  check(equal === names.length * engines.length,
    `${equal} of ${names.length * engines.length} pictures are the desktop's, byte for byte`);
  fs.rmSync(folder, { recursive: true });
  await page.close();
};

/** Waits until the window shows another picture, or stays as it is. @return A hash of its pixels. */
const pixels = (page) => page.evaluate(async () => {
  const canvas = document.getElementById("canvas");
  const bytes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  const hash = await crypto.subtle.digest("SHA-256", bytes);
  return String(new Uint8Array(hash));
});
const settled = async (page) => {
  let last = "", now = await pixels(page);
  while (last !== now) {
    last = now;
    await page.waitForTimeout(1500);
    now = await pixels(page);
  }
  return now;
};

/** Opens the page. @param problems Gets what the console says. */
const openPage = async (browser, url, problems, options) => {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, locale: "en-US", ...options });
  const page = await context.newPage();
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(error.message));
  await page.goto(url);
  await page.waitForFunction(() => window.Module && Module.SDL2 && Module.SDL2.image, null, { timeout: PATIENCE });
  return page;
};

const editText = (page, text) => page.fill("#text", text);
const errorText = (page) => page.textContent("#errors");

/** The window: keys, editing, errors, a hostile scene, a link. */
const testWindow = async (browser, url) => {
  const problems = [];
  const page = await openPage(browser, `${url}index.html`, problems);
  const text = await page.inputValue("#text");
  check(text === fs.readFileSync("scenes/box.lua", "utf8"), "the editor shows the text of the box");
  const first = await settled(page);
  await page.focus("#canvas");
  await page.keyboard.down("ArrowLeft");
  await page.waitForTimeout(700);
  await page.keyboard.up("ArrowLeft");
  check(await settled(page) !== first, "an arrow key moves the light");

  const [download] = await Promise.all([page.waitForEvent("download", { timeout: PATIENCE }), page.keyboard.press("p")]);
  check(download.suggestedFilename() === "box-0001.bmp", `a snapshot is a download: ${download.suggestedFilename()}`);
  // Cairo draws the rays; what it does not stand ends the program.
  await page.keyboard.press("v");
  await settled(page);
  await page.keyboard.press("v");

  await editText(page, text.replace("camera", "camra"));
  await page.waitForFunction(() => document.getElementById("errors").textContent !== "", null, { timeout: PATIENCE });
  check(/:\d+: /.test(await errorText(page)), `a mistake is said with its line: ${(await errorText(page)).trim()}`);
  await editText(page, text);
  await page.waitForFunction(() => document.getElementById("errors").textContent === "", null, { timeout: PATIENCE });

  await editText(page, "while true do end");
  await page.waitForFunction(() => document.getElementById("errors").textContent !== "", null, { timeout: PATIENCE });
  check(/10 s/.test(await errorText(page)), `an endless loop ends: ${(await errorText(page)).trim()}`);
  await editText(page, "local s = 'x' while true do s = s .. s end");
  await page.waitForFunction(() => /MiB|memory/.test(document.getElementById("errors").textContent), null, { timeout: PATIENCE });
  check(true, `memory has its limit: ${(await errorText(page)).trim()}`);

  const edited = text.replace(/position\s*=\s*\{[^}]*\}/, (place) => place.replace(/-?\d+(\.\d+)?/, "0.5"));
  await editText(page, edited);
  await settled(page);
  await page.click("#share");
  await page.waitForFunction(() => location.hash.length > 1);
  const link = page.url();
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();

  const other = await openPage(browser, link, problems);
  await other.waitForFunction(() => document.getElementById("text").value !== "");
  check(await other.inputValue("#text") === edited, "a link carries the scene's text");
  await other.context().close();
};

/** A host that sends no headers: the service worker does; afterwards the page works without network. */
const testPlainHost = async (browser) => {
  const { server, url } = await serve(false);
  const problems = [];
  const page = await openPage(browser, `${url}index.html`, problems, { locale: "fr-FR" });
  check(await page.evaluate(() => self.crossOriginIsolated), "a plain host: isolated by the service worker");
  check(await page.evaluate(() => document.documentElement.lang) === "fr", "French by the browser's language");
  await page.waitForFunction(() => document.body.dataset.complete === "yes", null, { timeout: PATIENCE });
  await page.reload();
  await page.waitForFunction(() => document.body.dataset.complete === "yes", null, { timeout: PATIENCE });
  await page.context().setOffline(true);
  server.closeAllConnections();
  await new Promise((resolve) => server.close(resolve));
  await page.reload();
  await page.waitForFunction(() => window.Module && Module.SDL2 && Module.SDL2.image, null, { timeout: PATIENCE });
  check(true, "it starts without network after the first visits");
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

(async () => {
  const parts = { window: testWindow, host: testPlainHost, bits: testBits };
  const asked = process.argv.slice(2);
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });
  const { server, url } = await serve(true);
  for (const name of asked.length > 0 ? asked : Object.keys(parts)) {
    await parts[name](browser, url);
  }
  await browser.close();
  server.close();
  process.exitCode = failures > 0 ? 1 : 0;
})();
