// What all tests of the page share: a server, a browser, the page in it, and its verdicts.
// Needs the environment: NODE_MODULES, the folder with playwright-core and puppeteer-core; CHROMIUM and FIREFOX, the browsers; DIOPTRE,
// the desktop's program, whose pictures are the measure.
"use strict";

const { chromium } = require(process.env.NODE_MODULES + "/playwright-core");
const fs = require("fs");
const http = require("http");
const path = require("path");

const ROOT = "build/web";
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
  }).listen(0, () => resolve({ server, port: server.address().port, url: `http://localhost:${server.address().port}/` }));
});

const result = { failures: 0 };
const check = (isRight, words) => {
  console.log(`${isRight ? "ok  " : "FAIL"}  ${words}`);
  result.failures += isRight ? 0 : 1;
};

const launch = () => chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });

/** @return A hash of the pixels of the window. */
const pixels = (page) => page.evaluate(async () => {
  const canvas = document.getElementById("canvas");
  const bytes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  let hash = 2166136261;
  for (const byte of bytes) {
    hash = Math.imul(hash ^ byte, 16777619);
  }
  return hash >>> 0;
});
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
/** Waits until the window stays as it is. @return A hash of its pixels. */
const settled = async (page) => {
  let last = null, now = await pixels(page);
  while (last !== now) {
    last = now;
    await pause(1500);
    now = await pixels(page);
  }
  return now;
};

/** Waits until the window shows a picture and the editor its text. */
const ready = (page) => page.waitForFunction(() => window.dioptre && window.dioptre.editor.text() !== "", null, { timeout: PATIENCE });
/** Opens the page. @param problems Gets what the console says. */
const openPage = async (browser, url, problems, options) => {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, locale: "en-US", ...options });
  const page = await context.newPage();
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(error.message));
  await page.goto(url);
  await ready(page);
  return page;
};

const editorText = (page) => page.evaluate(() => dioptre.editor.text());
const editText = (page, text) => page.evaluate((words) => dioptre.editor.replace(words), text);
const errorText = async (page) => (await page.textContent("#errors")).trim();
const waitError = async (page, pattern) => {
  await page.waitForFunction((source) => new RegExp(source).test(document.getElementById("errors").textContent), pattern.source,
    { timeout: PATIENCE });
  return errorText(page);
};

module.exports = { PATIENCE, ROOT, check, editText, editorText, errorText, launch, openPage, pause, pixels, ready, result, serve, settled, waitError };
