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

/** Serves the page. With isHosting the host sends the headers of isolation; else the page must help itself. `lost` names a file
 * for which the connection breaks. */
const serve = (isHosting, lost) => new Promise((resolve) => {
  const server = http.createServer((request, response) => {
    const file = path.join(ROOT, path.normalize(decodeURIComponent(new URL(request.url, "http://x").pathname).replace(/\/$/, "/index.html")));
    if (!file.startsWith(ROOT) || !fs.existsSync(file) || fs.statSync(file).isDirectory()) {
      response.writeHead(404);
      response.end();
      return;
    }
    if (path.basename(file) === lost) {
      request.socket.destroy();
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

/** Where screenshots are left, to be looked at. */
const SCREENS = "build/web-work/screens";
/** Leaves a screenshot. */
const screenshot = (page, name) => {
  fs.mkdirSync(SCREENS, { recursive: true });
  return page.screenshot({ path: `${SCREENS}/${name}.png` });
};

const launch = () => chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });
/** A browser that takes a name for a stranger's host: what it serves over plain http has neither threads nor the clipboard. */
const SCHOOL = "school.test";
const launchAtSchool = () => chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox", `--host-resolver-rules=MAP ${SCHOOL} 127.0.0.1`] });
/** Puppeteer drives Firefox, by WebDriver BiDi: Playwright needs a Firefox of its own. */
const launchFirefox = (language) => require(process.env.NODE_MODULES + "/puppeteer-core").launch({ browser: "firefox",
  executablePath: process.env.FIREFOX, headless: true, extraPrefsFirefox: { "intl.accept_languages": language } });

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
  const end = Date.now() + PATIENCE;
  let last = null, now = await pixels(page);
  while (last !== now) {
    if (Date.now() > end) throw new Error(`the window has not settled within ${PATIENCE} ms`);
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

/** Opens the page in Firefox. @param viewport { width, height, deviceScaleFactor } */
const openInFirefox = async (firefox, url, problems, viewport) => {
  const page = await firefox.newPage();
  page.on("pageerror", (error) => problems.push(error.message));
  await page.setViewport(viewport);
  await page.goto(url);
  await until(page, () => window.dioptre && window.dioptre.editor.text() !== "");
  return page;
};
/** Waits in any browser until a function of the page gives something. @return That. */
const until = async (page, question, ...words) => {
  const end = Date.now() + PATIENCE;
  let answer = await page.evaluate(question, ...words);
  while (!answer && Date.now() < end) {
    await pause(50);
    answer = await page.evaluate(question, ...words);
  }
  if (!answer) {
    throw new Error(`not within ${PATIENCE} ms: ${question} ${words}`);
  }
  return answer;
};

/** Drops files on the page. @param files [[name, text]] */
const drop = (page, files) => page.evaluate((all) => {
  const data = new DataTransfer();
  all.forEach(([name, text]) => data.items.add(new File([text], name)));
  document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
}, files);

const editorText = (page) => page.evaluate(() => dioptre.editor.text());
const editText = (page, text) => page.evaluate((words) => dioptre.editor.replace(words), text);
const errorText = async (page) => (await page.textContent("#errors")).trim();
const waitError = async (page, pattern) => {
  await page.waitForFunction((source) => new RegExp(source).test(document.getElementById("errors").textContent), pattern.source,
    { timeout: PATIENCE });
  return errorText(page);
};

module.exports = { PATIENCE, ROOT, SCHOOL, check, drop, editText, editorText, errorText, launch, launchAtSchool, launchFirefox, openInFirefox, openPage,
  pause, pixels, ready, result, screenshot, serve, settled, until, waitError };
