// Random keys and clicks, with threads and without: the program lives on, it does not use ever more memory, nothing is said in the console.
// KEYS_SECONDS says for how long each way (20). A window whose frames take longer than they may must leave the browser its turn
// nevertheless: once a page without threads did not, and no key came through any more.
"use strict";

const { check, openPage, pause, pixels, serve, settled } = require("./browser.js");

/** Keys of the window, but none that wait for an answer of a file. */
const KEYS = [..."abcdefghijklmnoqrstuvwxyz0123456789", ..."[]+-.,<>", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "PageUp", "PageDown",
  "Home", "Tab", "Space", "Enter", "Escape", "F1"].filter((key) => key !== "Tab");
/** Share of growth from the second half's beginning to the end that is no leak: lists and thumbnails that are kept. */
const GROWTH_MAXIMUM = 0.1;

/** Milliseconds until the page has heard of a key, on a loaded machine: no tile may keep it longer. */
const ANSWER_MAXIMUM = 10000;

/** @return Bytes that the program uses once it shows the box as at first: what it had to remember of other things is gone. */
const memoryAtRest = async (page) => {
  for (let i = 0; i < 8; i++) {
    await page.keyboard.press("Escape");
  }
  await page.evaluate(() => dioptre.module.ccall("web_open", null, ["string"], ["/scenes/box.lua"]));
  await settled(page);
  return page.evaluate(() => {
    const { module } = dioptre, pointer = module._malloc(40); // A struct mallinfo, whose uordblks is the eighth number.
    module._mallinfo(pointer);
    const used = new DataView(module.HEAP8.buffer).getUint32(pointer + 28, true);
    module._free(pointer);
    return used;
  });
};

const randomKeys = async (browser, url, seconds) => {
  const problems = [];
  const page = await openPage(browser, url, problems);
  let seed = 42, count = 0, half = 0;
  const random = (maximum) => (seed = (Math.imul(seed, 1103515245) + 12345) >>> 0, (seed >>> 16) % maximum);
  await page.focus("#canvas");
  const start = Date.now();
  let longest = 0;
  while (Date.now() - start < 1000 * seconds) {
    const key = KEYS[random(KEYS.length)], pressed = Date.now();
    await page.keyboard.down(key);
    await pause(random(60));
    await page.keyboard.up(key);
    await page.evaluate(() => 0);
    longest = Math.max(longest, Date.now() - pressed);
    if (random(10) === 0) {
      const box = await page.locator("#canvas").boundingBox();
      await page.mouse.click(box.x + random(Math.floor(box.width)), box.y + 130 + random(Math.floor(box.height) - 140));
    }
    count++;
    if (half === 0 && Date.now() - start > 500 * seconds) {
      half = await memoryAtRest(page);
    }
  }
  const end = await memoryAtRest(page);
  const message = (await page.textContent("#message")).trim();
  check(message === "", `${count} keys in ${seconds} s: the program lives${message}`);
  check(longest < ANSWER_MAXIMUM, `the page answered after ${longest} ms at the latest`);
  check(end <= half * (1 + GROWTH_MAXIMUM), `it uses ${(half / 1e6).toFixed(1)} MB after the first half, ${(end / 1e6).toFixed(1)} MB at the end`);
  check(await pixels(page) !== 0 && problems.length === 0, `the console is silent${problems.slice(0, 3).map((problem) => ": " + problem)}`);
  await page.context().close();
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  const seconds = Number(process.env.KEYS_SECONDS || 20);
  await randomKeys(browser, `${url}index.html`, seconds);
  await randomKeys(browser, `${url}index.html?one-thread`, seconds);
  server.close();
};
