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

/** Whose contrast the checker cannot decide, as lines lie over a selection or beyond an edge, and letters on a chart: see lowContrasts(). */
const UNDECIDED = "#text, #made svg *, #output";
/** @return What the checker finds, as text; what it cannot decide by itself, too. */
const faults = (page) => page.evaluate(async (undecided) => {
  const { violations, incomplete } = await axe.run(document);
  const isJudged = (rule, node) => rule.id === "color-contrast" && document.querySelector(node.target.flat()[0]).matches(undecided);
  const open = incomplete.map((rule) => ({ ...rule, nodes: rule.nodes.filter((node) => !isJudged(rule, node)) }));
  return [...violations, ...open].flatMap((rule) => rule.nodes.map((node) => `${rule.id} ${node.target.flat()}: ${rule.help} (${
    [...node.any, ...node.all, ...node.none].map((each) => each.message)})`));
}, UNDECIDED);
/** @return Texts whose contrast is below 4.5, as WCAG 2 computes it: in the editor, all of which is selected, on the ground of a line, of the
 * line with the cursor and of the selection; on charts; of a command's answer. */
const lowContrasts = (page) => page.evaluate(() => {
  const root = document.getElementById("text").shadowRoot, style = (element) => getComputedStyle(element);
  const luminance = (color) => {
    const [r, g, b] = color.match(/[\d.]+/g).map((number) => number / 255).map((x) => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const colors = (elements, property) => [...new Set([...elements].map((element) => style(element)[property]))];
  const grounds = [".cm-editor", ".cm-activeLine", ".cm-selectionBackground"].map((name) => style(root.querySelector(name)).backgroundColor);
  const pairs = [...colors(root.querySelectorAll(".cm-line, .cm-line span"), "color").flatMap((color) => grounds.map((ground) => [color, ground])),
    ...[...document.querySelectorAll("#made svg")].flatMap((chart) => colors(chart.querySelectorAll("text"), "fill").map((color) =>
      [color, style(chart).backgroundColor])), [style(document.getElementById("output")).color, style(document.body).backgroundColor]];
  return pairs.map(([color, ground]) => {
    const [dark, light] = [luminance(color), luminance(ground)].sort((a, b) => a - b);
    return [color, ground, (light + 0.05) / (dark + 0.05)];
  }).filter(([, , contrast]) => !(contrast >= 4.5)).map(([color, ground, contrast]) => `${color} on ${ground}: ${contrast.toFixed(2)}`);
});
const expectReadable = async (page, where) => {
  await page.focus(".cm-content");
  await page.keyboard.press("Control+a");
  await page.waitForFunction(() => document.getElementById("text").shadowRoot.querySelector(".cm-selectionBackground"), null, { timeout: PATIENCE });
  const low = await lowContrasts(page);
  check(low.length === 0, `${where}: all can be read on its ground${low.map((each) => "\n      " + each)}`);
};
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
  await expectReadable(page, `${name}, at first`);
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
  await editText(page, "camera { position = {0, 0, 5} }\nlight { position = {1, 2, 3} }\nsphere { center = {0, 0, 0}, radius = 1 }\n");
  await page.click("#commands");
  await page.fill("#line", "chart SCENE -s 20x15 --samples 1 --out charts");
  await page.click("#run");
  await page.waitForSelector("#made svg", { timeout: 2 * PATIENCE });
  await expectNone(page, `${name}, with a chart`);
  await expectReadable(page, `${name}, with a chart`);
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

/** @return What has the keyboard; empty: nothing of the page. */
const focused = (page) => page.evaluate(() => {
  const element = document.activeElement;
  return element === document.body ? "" : element.id || element.textContent;
});

/** Tab goes through everything, as it stands on the page; in the editor it indents, unless Esc was pressed before. */
const testOrder = async (browser, url) => {
  const page = await openPage(browser, url, []);
  await settled(page);
  await page.click("#commands");
  await page.focus("#scenes");
  const order = ["scenes"];
  while (order.at(-1) !== "" && order.length < 40) {
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
    const keys = { "Ctrl+f": { key: "f", code: "KeyF", ctrlKey: true }, "Ctrl+r": { key: "r", code: "KeyR", ctrlKey: true },
      "Ctrl++": { key: "+", code: "Equal", ctrlKey: true }, F5: { key: "F5", code: "F5" }, F12: { key: "F12", code: "F12" },
      "Alt+Left": { key: "ArrowLeft", code: "ArrowLeft", altKey: true }, Tab: { key: "Tab", code: "Tab" },
      "Ctrl+z": { key: "z", code: "KeyZ", ctrlKey: true }, "Ctrl+s": { key: "s", code: "KeyS", ctrlKey: true }, Left: { key: "ArrowLeft", code: "ArrowLeft" } };
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
