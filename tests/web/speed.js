// How fast the page is, for doc/figures: engines against the desktop's, the first picture, keys, idling, bytes. `make bench-web` runs
// it; no test does, as another program on the machine turns its figures. Environment: SCENES, names of scenes, instead of all;
// LOADS and KEYS, how often a page is loaded and a key pressed.
"use strict";

const { check, launch, pause, ready, serve, settled } = require("./browser.js");
const { openEmpty, runCommand } = require("./command.js");
const { execFileSync } = require("child_process");
const fs = require("fs");
const os = require("os");
const zlib = require("zlib");

const ENGINES = ["f32x4", "f32x8"];
/** What each measurement of an engine takes, milliseconds, and how many pictures are timed: V8 compiles a loop anew once it has run often,
 * in a thread of its own, so that pictures of 0.1 ms must be many. */
const ENGINE_TIME = 600, FRAMES_MINIMUM = 15, FRAMES_MAXIMUM = 5000;
const LOADS = Number(process.env.LOADS || 5), KEYS = Number(process.env.KEYS || 25);
const IDLE_SECONDS = 30;

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];
const digits = (value) => Number(value.toPrecision(4));

/** Writes a table of doc/figures: where and when, the names of columns, rows. */
const writeTable = (name, version, columns, rows) => {
  const processor = os.cpus()[0].model.replace(/[ ,]+/g, " ");
  const day = new Date().toISOString().slice(0, 10);
  fs.writeFileSync(`${process.env.FIGURES || "doc/figures"}/${name}.csv`,
    [`# ${processor},${day},Chromium ${version}`, columns, ...rows.map((row) => row.join(","))].join("\n") + "\n");
};

// --- engines -------------------------------------------------------------------------------------

/** The command line that times pictures of one thread. */
const benchLine = (scene, engine, frames) =>
  ["bench", scene, "--json", "-s", "128x96", "--samples", "1", "--engine", engine, "-j", "1", "--frames", String(frames)];
/** Milliseconds of the fastest picture: others on the machine make a picture slower, nothing makes it faster. */
const desktopTime = (scene, engine, frames) =>
  JSON.parse(execFileSync(process.env.DIOPTRE, benchLine(`scenes/${scene}`, engine, frames), { encoding: "utf8" })).ms_min;
const pageTime = async (page, url, scene, engine, frames) => {
  const { lines } = await runCommand(page, url, "dioptre.js", benchLine(`/scenes/${scene}`, engine, frames), null);
  return JSON.parse(lines.find((line) => line.startsWith("{"))).ms_min;
};

/** Times every scene in each engine, desktop and page in turn. @return Rows of a table. */
const timeEngines = async (browser, url) => {
  const page = await openEmpty(browser);
  const scenes = process.env.SCENES ? process.env.SCENES.split(" ") : fs.readdirSync("scenes").filter((name) => name.endsWith(".lua"));
  const rows = [];
  for (const scene of scenes) {
    const row = [scene.replace(/\.lua$/, "")];
    for (const engine of ENGINES) {
      const estimate = desktopTime(scene, engine, 1);
      const frames = Math.round(Math.min(Math.max(ENGINE_TIME / estimate, FRAMES_MINIMUM), FRAMES_MAXIMUM));
      const before = desktopTime(scene, engine, frames), inPage = await pageTime(page, url, scene, engine, frames);
      row.push(digits(Math.min(before, desktopTime(scene, engine, frames))), digits(inPage));
    }
    console.log(row.join(" "));
    rows.push(row);
  }
  await page.close();
  return rows;
};

// --- the window ----------------------------------------------------------------------------------

/** In the page: notes when the window is drawn, and when keys come. */
const watchFrames = () => {
  const draw = CanvasRenderingContext2D.prototype.putImageData;
  window.drawn = [];
  window.pressed = 0;
  CanvasRenderingContext2D.prototype.putImageData = function (image, ...rest) {
    draw.call(this, image, ...rest);
    const time = performance.now(), words = new Uint32Array(image.data.buffer, image.data.byteOffset, image.data.length >> 2);
    let hash = 0, lit = 0;
    for (let i = 0; i < words.length; i += 61) {
      hash = Math.imul(hash ^ words[i], 16777619);
      lit += (words[i] & 0xffffff) > 0 ? 1 : 0;
    }
    window.drawn.push({ time, hash, isPicture: lit > words.length / 61 / 4 });
  };
  window.addEventListener("keydown", (event) => { window.pressed = event.timeStamp; }, { capture: true });
};

/** @return Milliseconds from the begin of the navigation to the first picture, and what was fetched before. */
const firstPicture = async (page, url) => {
  const requests = [];
  const note = (request) => requests.push(request.url());
  page.on("request", note);
  await page.goto(url);
  await page.waitForFunction(() => window.drawn?.some((frame) => frame.isPicture), null, { polling: 10 });
  page.off("request", note);
  const time = await page.evaluate(() => window.drawn.find((frame) => frame.isPicture).time);
  // What the picture has set off may be on its way before it is seen here.
  const later = await page.evaluate((end) => performance.getEntriesByType("resource").filter((entry) => entry.startTime > end).map((entry) => entry.name), time);
  return { time, requests: requests.filter((request) => !later.includes(request)) };
};

/** Loads the page in new browsers, and in each once more. @return { cold, warm, requests } */
const timeLoads = async (url) => {
  const cold = [], warm = [];
  let requests = [];
  for (let i = 0; i < LOADS; i++) {
    const browser = await launch();
    const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
    await page.addInitScript(watchFrames);
    const first = await firstPicture(page, url);
    cold.push(first.time);
    requests = first.requests;
    await ready(page);
    await page.waitForFunction(() => document.body.dataset.complete === "yes");
    await settled(page);
    warm.push((await firstPicture(page, url)).time);
    await browser.close();
  }
  return { cold, warm, requests };
};

/** @return Bytes of files of the page, compressed as hosts do. */
const compressed = (url, requests) => {
  const names = [...new Set(requests.map((request) => request.replace(url, "")))].filter((name) => fs.existsSync(`build/web/${name}`));
  const files = names.map((name) => fs.readFileSync(`build/web/${name}`));
  const sum = (pack) => files.reduce((total, bytes) => total + pack(bytes).length, 0);
  return { gzip: sum((bytes) => zlib.gzipSync(bytes, { level: 9 })), brotli: sum((bytes) => zlib.brotliCompressSync(bytes)) };
};

/** @return Milliseconds from each key to the first other picture. */
const timeKeys = async (page) => {
  const times = [];
  await page.focus("#canvas");
  for (let i = 0; i < KEYS; i++) {
    await settled(page);
    await page.evaluate(() => { window.before = window.drawn.at(-1).hash; window.drawn.length = 0; });
    await page.keyboard.down(i % 2 ? "ArrowLeft" : "ArrowRight");
    await page.waitForFunction(() => window.drawn.some((frame) => frame.hash !== window.before), null, { polling: 5 });
    await page.keyboard.up(i % 2 ? "ArrowLeft" : "ArrowRight");
    times.push(await page.evaluate(() => window.drawn.find((frame) => frame.hash !== window.before).time - window.pressed));
  }
  return times;
};

/** @return Seconds of processor time that the processes of a browser's pages have taken. */
const processorTime = async (session) => {
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  return processInfo.filter(({ type }) => type === "renderer").reduce((sum, { id }) => {
    const fields = fs.readFileSync(`/proc/${id}/stat`, "utf8").replace(/.*\) /, "").split(" ");
    return sum + (Number(fields[11]) + Number(fields[12])) / Number(execFileSync("getconf", ["CLK_TCK"]));
  }, 0);
};
/** @return Share of a processor that the settled page takes. */
const idleShare = async (browser, page) => {
  const session = await browser.newBrowserCDPSession();
  await settled(page);
  const before = await processorTime(session);
  await pause(1000 * IDLE_SECONDS);
  return (await processorTime(session) - before) / IDLE_SECONDS;
};

/** Measures a page that stands: keys, idling. */
const timeWindow = async (url) => {
  const browser = await launch();
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  await page.addInitScript(watchFrames);
  await firstPicture(page, url);
  await page.waitForFunction(() => document.body.dataset.complete === "yes");
  const keys = await timeKeys(page);
  const idle = await idleShare(browser, page);
  await browser.close();
  return { keys, idle };
};

/** @return Rows of the table of the window: what, with threads, with one. */
const measureWindow = async (url) => {
  const columns = [];
  for (const query of ["", "?one-thread"]) {
    const { cold, warm, requests } = await timeLoads(`${url}index.html${query}`);
    const { gzip, brotli } = compressed(url, requests.map((request) => request.replace(/\?.*/, "")));
    const { keys, idle } = await timeWindow(`${url}index.html${query}`);
    console.log(`${query || "threads"}: cold ${cold.map(Math.round)} ms, warm ${warm.map(Math.round)} ms, keys ${keys.map(Math.round)} ms, ` +
      `idle ${100 * idle} %, gzip ${gzip}, brotli ${brotli}`);
    columns.push([median(cold), median(warm), median(keys), Math.max(...keys), 100 * idle, gzip / 1e6, brotli / 1e6].map(digits));
  }
  return ["cold", "warm", "key", "key_worst", "idle", "gzip", "brotli"].map((name, i) => [name, ...columns.map((column) => column[i])]);
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  const what = process.env.MEASURE || "window engines";
  if (what.includes("window")) {
    writeTable("web-window", browser.version(), "what,threads,one_thread", await measureWindow(url));
  }
  if (what.includes("engines")) {
    const rows = await timeEngines(browser, url);
    writeTable("web-engines", browser.version(), "scene,f32x4_desktop_ms,f32x4_page_ms,f32x8_desktop_ms,f32x8_page_ms", rows);
    for (const [i, engine] of ENGINES.entries()) {
      console.log(`${engine}: ${median(rows.map((row) => row[1 + 2 * i] / row[2 + 2 * i])).toFixed(2)} of the desktop's speed, median`);
    }
  }
  check(true, "measured");
  server.close();
};
