// Who does not see, or has no mouse: axe-core, an automatic checker, finds no fault (names, contrast, roles, order of headings, ...) in
// what the page shows; the key Tab comes to everything in its order and is caught nowhere; the browser keeps its own keys.
"use strict";

const { PATIENCE, check, drop, editText, openPage, serve, settled, waitError } = require("./browser.js");

const AXE = require.resolve(process.env.NODE_MODULES + "/axe-core/axe.min.js");
const SIZES = {
  "a desktop": { viewport: { width: 1280, height: 720 } },
  "a phone": { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 3 },
};
const LANGUAGES = ["en-US", "fr-FR"];

/** @return What the checker finds, as text; what it cannot decide by itself, too. */
const faults = (page) => page.evaluate(async () => {
  const { violations, incomplete } = await axe.run(document);
  return [...violations, ...incomplete].flatMap((rule) => rule.nodes.map((node) => `${rule.id} ${node.target.flat()}: ${rule.help} (${
    [...node.any, ...node.all, ...node.none].map((each) => each.message)})`));
});
const expectNone = async (page, where) => {
  const found = await faults(page);
  check(found.length === 0, `${where}: the checker finds no fault${found.map((fault) => "\n      " + fault)}`);
};

/** What the page shows at most times: a scene, a faulty one, a completion, a command with its picture. */
const testStates = async (browser, url, name, options) => {
  const problems = [];
  const page = await openPage(browser, url, problems, { ...options, bypassCSP: true });
  await page.addScriptTag({ path: AXE });
  await settled(page);
  await expectNone(page, `${name}, at first`);
  await drop(page, [["faulty.lua", "camera {}\ncamra {}\n"]]);
  await waitError(page, /:2: /);
  await expectNone(page, `${name}, with an error`);
  await editText(page, "camera { position = {0, 0, 5} }\nlight { position = {1, 2, 3} }\n");
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+End");
  await page.keyboard.type("sph");
  await page.waitForSelector(".cm-tooltip-autocomplete", { timeout: PATIENCE });
  await expectNone(page, `${name}, with a completion`);
  await page.keyboard.press("Escape");
  await page.click("#commands");
  await page.fill("#line", "chart SCENE -s 20x15 --samples 1 --out charts");
  await page.click("#run");
  await page.waitForSelector("#made svg", { timeout: 2 * PATIENCE });
  await expectNone(page, `${name}, with a chart`);
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

/** @return What has the keyboard. */
const focused = (page) => page.evaluate(() => {
  const element = document.activeElement;
  return element?.id || element?.textContent || "";
});

/** Tab goes through everything, as it stands on the page; in the editor it indents, unless Esc was pressed before. */
const testOrder = async (browser, url) => {
  const page = await openPage(browser, url, []);
  await settled(page);
  await page.click("#commands");
  await page.evaluate(() => document.activeElement.blur());
  const order = [];
  for (let i = 0; i < 40 && (i === 0 || order.at(-1) !== ""); i++) {
    order.at(-1) === "text" && await page.keyboard.press("Escape");
    await page.keyboard.press("Tab");
    order.push(await focused(page));
  }
  const expected = ["scenes", "share", "hide", "commands", "canvas", "text", "info", "render", "probe", "needs", "chart", "lab", "line", "run", "output", ""];
  check(order.join() === expected.join(), `Tab comes to all: ${order}`);
  // Back, too, out of the picture.
  await page.focus("#canvas");
  await page.keyboard.press("Shift+Tab");
  check(await focused(page) === "commands", "and back");
  await page.context().close();
};

/** Keys on the picture: which the browser may have. */
const testKeys = async (browser, url) => {
  const page = await openPage(browser, url, []);
  await page.focus("#canvas");
  // The page must not act on them here: their events are made by hand.
  const taken = await page.evaluate(() => {
    const press = (init) => {
      const event = new KeyboardEvent("keydown", { bubbles: true, cancelable: true, ...init });
      document.getElementById("canvas").dispatchEvent(event);
      return event.defaultPrevented;
    };
    const keys = { "Ctrl+f": { key: "f", code: "KeyF", keyCode: 70, ctrlKey: true }, "Ctrl+r": { key: "r", code: "KeyR", keyCode: 82, ctrlKey: true },
      "Ctrl++": { key: "+", code: "Equal", keyCode: 187, ctrlKey: true }, F5: { key: "F5", code: "F5", keyCode: 116 }, F12: { key: "F12", code: "F12", keyCode: 123 },
      "Alt+Left": { key: "ArrowLeft", code: "ArrowLeft", keyCode: 37, altKey: true }, "Ctrl+z": { key: "z", code: "KeyZ", keyCode: 90, ctrlKey: true },
      "Ctrl+s": { key: "s", code: "KeyS", keyCode: 83, ctrlKey: true }, Space: { key: " ", code: "Space", keyCode: 32 }, Left: { key: "ArrowLeft", code: "ArrowLeft", keyCode: 37 } };
    return Object.entries(keys).filter(([, init]) => press(init)).map(([name]) => name);
  });
  check(taken.join() === "Ctrl+z,Ctrl+s,Left", `of the browser's keys none is taken; ours: ${taken}`);
  await page.context().close();
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  for (const locale of LANGUAGES) {
    for (const [name, options] of Object.entries(SIZES)) {
      await testStates(browser, `${url}index.html`, `${name}, ${locale.slice(0, 2)}`, { ...options, locale });
    }
  }
  for (const query of ["", "?one-thread"]) {
    console.log(query || "threads");
    await testOrder(browser, `${url}index.html${query}`);
    await testKeys(browser, `${url}index.html${query}`);
  }
  server.close();
};
