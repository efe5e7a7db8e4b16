// Random keys, clicks, drags, sizes and texts, with threads and without: the program lives on, the page answers, nothing is said in the
// console, and neither the program nor the page's scripts use ever more memory. Once a page without threads did not leave the browser its
// turn, and no key came through any more.
// Environment: KEYS_SECONDS, how long each way (20; 1200 by hand); KEYS_SEED, which keys (42); KEYS_WAYS, "threads one-thread".
"use strict";

const { check, editText, editorText, openPage, pause, pixels, serve, settled } = require("./browser.js");

const SECONDS = Number(process.env.KEYS_SECONDS || 20);
/** Seconds from which all of the memory is judged: before, caches and the largest pictures are still to come. */
const LONG = 300;
/** How often the memory is measured. */
const MEASURES = SECONDS >= LONG ? 12 : 4;
/** Keys of the window, but p, whose pictures would fill the disk, and Tab, which leaves the picture. */
const KEYS = [..."abcdefghijklmnoqrstuvwxyz0123456789", ..."[]+-.,<>/\\;'", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "PageUp", "PageDown",
  "Home", "Space", "Enter", "Escape", "Backspace", "F1", "F2", "F3", "F4", "F6", "F7", "F8", "F9", "F10"];
const MODIFIERS = ["", "", "", "", "", "Shift+", "Control+", "Control+Shift+"];
/** With Ctrl the browser has the others; Ctrl+Shift+S would fill the disk, too. */
const IS_BROWSERS = /^Control\+(Shift\+)?[^csyz]$|^Control\+Shift\+s$|^Control\+(Page|F)/;
const SIZES = [[1280, 720], [1280, 720], [390, 844], [820, 1180], [320, 200], [1920, 1080], [200, 900]];
const SCENES = ["box.lua", "glass-sphere.lua", "earth.lua", "cow.lua", "orbits.lua", "lamps.lua", "hundred-thousand-spheres.lua", "lessons/01-shadows.lua",
  "lessons/08-marching.lua"];
const TEXTS = ["sphere { center = {0, 1, 0}, radius = 0.3 }", "camra {}", "box { corner = {", "mesh { file = \"models/cow.obj\" }", "error 'x'"];
/** Share of growth that is no leak: lists and thumbnails that are kept. */
const GROWTH_MAXIMUM = 0.1;
/** Bytes of scripts that come and go: the editor keeps its last changes. */
const HEAP_SLACK = 2e6;
/** WebAssembly's memory never shrinks, and grows by a fifth at a time: one such step may be the largest picture of all. */
const STEP = 1.2;
/** Milliseconds until the page has heard of a key, on a loaded machine: no tile may keep it longer. */
const ANSWER_MAXIMUM = 10000;

/** Numbers that are the same each time. */
const createRandom = (seed) => (maximum) => (seed = (Math.imul(seed, 1103515245) + 12345) >>> 0, (seed >>> 16) % maximum);

/** @return Bytes in use once the page shows the box as at first: what it had to remember of other things is gone.
 * { program, scripts, wasm }: allocated by the program, used by the page's scripts, WebAssembly's whole memory. */
const memoryAtRest = async (page, session) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  await page.focus("#canvas");
  for (let i = 0; i < 8; i++) {
    await page.keyboard.press("Escape");
  }
  await page.keyboard.press("Backspace");
  await page.keyboard.press("1");
  for (const name of ["figure-07", "box"]) { // What belongs to the scene before the last one is freed, too.
    await page.evaluate((path) => dioptre.module.ccall("web_open", null, ["string"], [path]), `/scenes/${name}.lua`);
    await settled(page);
  }
  await session.send("HeapProfiler.collectGarbage");
  const { usedSize } = await session.send("Runtime.getHeapUsage");
  return page.evaluate((scripts) => {
    const { module } = dioptre, pointer = module._malloc(40); // A struct mallinfo, whose uordblks is the eighth number.
    module._mallinfo(pointer);
    const program = new DataView(module.HEAP8.buffer).getUint32(pointer + 28, true);
    module._free(pointer);
    return { program, scripts, wasm: module.HEAP8.length };
  }, usedSize);
};

/** Does anything. @return What, if it is a key. */
const disturb = async (page, random) => {
  const pick = (list) => list[random(list.length)];
  const box = await page.locator("#canvas").boundingBox();
  const point = () => [box.x + random(Math.max(1, Math.floor(box.width))), box.y + random(Math.max(1, Math.floor(box.height)))];
  const move = () => page.mouse.move(...point(), { steps: 5 });
  const acts = {
    click: async () => page.mouse.click(...point()),
    drag: async () => { await move(); await page.mouse.down(); await move(); await page.mouse.up(); },
    wheel: async () => { await move(); await page.mouse.wheel(0, random(400) - 200); },
    size: async () => { const [width, height] = pick(SIZES); await page.setViewportSize({ width, height }); },
    scene: () => page.evaluate((name) => {
      const list = document.getElementById("scenes");
      list.value = name;
      list.dispatchEvent(new Event("change"));
    }, pick(SCENES)),
    button: () => page.evaluate((id) => document.getElementById(id).click(), pick(["hide", "commands", "share"])),
    text: async () => editText(page, (await editorText(page)).slice(0, 4000) + "\n" + pick(TEXTS) + "\n"),
  };
  const chances = { click: 30, drag: 25, wheel: 10, size: 8, scene: 6, button: 6, text: 6 };
  let chance = random(500);
  for (const [name, count] of Object.entries(chances)) {
    if ((chance -= count) < 0) {
      await acts[name]();
      await page.focus("#canvas");
      return;
    }
  }
  const key = pick(MODIFIERS) + pick(KEYS);
  if (!IS_BROWSERS.test(key)) {
    const plain = key.split(/\+(?=.)/);
    for (const each of plain) {
      await page.keyboard.down(each);
    }
    await pause(random(60));
    for (const each of plain.reverse()) {
      await page.keyboard.up(each);
    }
  }
};

/** Judges measures: the least of the second quarter against the least of the second half, as what lists and lessons of a moment take
 * comes on top. */
const judgeMemory = (measures) => {
  const least = (name, from, to) => Math.min(...measures.slice(from * MEASURES, to * MEASURES).map((each) => each[name]));
  const judge = (name, words, maximum) => {
    const early = least(name, SECONDS >= LONG ? 0.25 : 0, 0.5), late = least(name, 0.5, 1);
    check(late <= maximum(early), `${words}: ${(early / 1e6).toFixed(1)} MB early, ${(late / 1e6).toFixed(1)} MB late`);
  };
  const grown = (early) => early * (1 + GROWTH_MAXIMUM);
  judge("program", "the program's memory does not grow", grown);
  judge("scripts", "nor does the scripts'", (early) => grown(early) + HEAP_SLACK);
  SECONDS >= LONG && judge("wasm", "nor WebAssembly's", (early) => early * STEP);
  console.log(`      program, scripts, WebAssembly, MB: ${measures.map(({ program, scripts, wasm }) =>
    [program, scripts, wasm].map((bytes) => (bytes / 1e6).toFixed(1)).join(" ")).join(", ")}`);
};

const randomKeys = async (browser, url, seconds) => {
  const problems = [], measures = [];
  const page = await openPage(browser, url, problems);
  const session = await page.context().newCDPSession(page);
  const random = createRandom(Number(process.env.KEYS_SEED || 42));
  // The pictures of the list of scenes are kept once they are there: before anything is measured.
  await page.focus("#canvas");
  await page.keyboard.press("f");
  await settled(page);
  await page.keyboard.press("Escape");
  let count = 0, longest = 0, spent = 0;
  while (measures.length < MEASURES) {
    const began = Date.now();
    await disturb(page, random);
    await page.evaluate(() => 0);
    longest = Math.max(longest, Date.now() - began);
    spent += Date.now() - began;
    count++;
    if (spent > 1000 * seconds * (measures.length + 1) / MEASURES) {
      measures.push(await memoryAtRest(page, session));
    }
  }
  const message = (await page.textContent("#message")).trim();
  check(message === "", `${count} keys, clicks, drags, sizes and texts in ${seconds} s: the program lives${message}`);
  check(longest < ANSWER_MAXIMUM, `the page answered after ${longest} ms at the latest`);
  judgeMemory(measures);
  check(await pixels(page) !== 0 && problems.length === 0, `the console is silent${problems.slice(0, 3).map((problem) => ": " + problem)}`);
  await page.context().close();
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  for (const way of (process.env.KEYS_WAYS || "threads one-thread").split(" ")) {
    console.log(`${way}:`);
    await randomKeys(browser, `${url}index.html?${way}`, SECONDS);
  }
  server.close();
};
