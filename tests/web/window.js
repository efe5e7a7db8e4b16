// The window in the page: keys, editing, errors, hostile scenes, completion, snapshots.
"use strict";

const { PATIENCE, SCHOOL, check, editText, editorText, launchAtSchool, openPage, pause, pixels, ready, screenshot, serve, settled, waitError } = require("./browser.js");
const fs = require("fs");

/** The letter of the key that opens the list is not typed into its search, however late the browser tells it. */
const testOpeningKey = async (page) => {
  const send = (type, init) => page.evaluate(([type, init]) =>
    document.getElementById("canvas").dispatchEvent(new KeyboardEvent(type, { bubbles: true, cancelable: true, key: "f", code: "KeyF", ...init })), [type, init]);
  await page.focus("#canvas");
  await send("keydown", { keyCode: 70 });
  await settled(page);
  await send("keypress", { charCode: 102, keyCode: 102 });
  await send("keyup", { keyCode: 70 });
  await page.keyboard.type("lamps");
  await settled(page);
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.getElementById("scenes").value === "lamps.lua", null, { timeout: PATIENCE });
  check(true, "but not that of the key which opens it");
};

/** @return The hash of the help, which draws the keyboard. @param layout What the browser says of it: [[code, letter]]. */
const helpWith = async (browser, url, layout) => {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, locale: "fr-FR" }), page = await context.newPage();
  await page.addInitScript((entries) => {
    Object.defineProperty(navigator, "keyboard", { value: { getLayoutMap: async () => new Map(entries) } });
  }, layout);
  await page.goto(url);
  await ready(page);
  await page.focus("#canvas");
  await page.keyboard.press("F1");
  const help = await settled(page);
  await screenshot(page, `help-${layout.length}`);
  return { help, page };
};
/** The help draws the keyboard in use: as the browser tells, as the language lets expect, as its keys write. */
const testLayouts = async (browser, url) => {
  const qwerty = [..."abcdefghijklmnopqrstuvwxyz"].map((letter) => ["Key" + letter.toUpperCase(), letter]);
  const azerty = qwerty.map(([code, letter]) => [code, { a: "q", q: "a", w: "z", z: "w", m: "," }[letter] ?? letter]).concat([["Semicolon", "m"],
    ["Comma", ";"], ["Period", ":"], ["Slash", "!"], ["Minus", ")"], ["BracketLeft", "^"], ["BracketRight", "$"], ["Quote", "ù"], ["Backquote", "²"]]);
  const french = await helpWith(browser, url, azerty), guessed = await helpWith(browser, url, []), english = await helpWith(browser, url, qwerty);
  check(french.help === guessed.help && french.help !== english.help, "the help draws the keyboard that the browser tells, or that of the language");
  for (const [code, key] of azerty) {
    await english.page.evaluate(([code, key]) => document.body.dispatchEvent(new KeyboardEvent("keydown", { bubbles: true, code, key })), [code, key]);
  }
  check(await settled(english.page) === french.help, "or whose keys are pressed");
  await Promise.all([french, guessed, english].map(({ page }) => page.context().close()));
};

const testKeys = async (page) => {
  const first = await settled(page);
  await page.focus("#canvas");
  await page.keyboard.down("ArrowLeft");
  await pause(700);
  await page.keyboard.up("ArrowLeft");
  check(await settled(page) !== first, "an arrow key moves the light");
  const [download] = await Promise.all([page.waitForEvent("download", { timeout: PATIENCE }), page.keyboard.press("p")]);
  check(download.suggestedFilename() === "box-0001.bmp", `a snapshot is a download: ${download.suggestedFilename()}`);
  // Cairo draws the rays; what it does not stand ends the program.
  await page.keyboard.press("v");
  const rays = await settled(page);
  check(rays !== first, "the rays of a pixel are shown");
  await page.keyboard.press("v");
  await settled(page);
  await page.keyboard.press("f");
  await settled(page);
  await page.keyboard.type("glass-sph");
  await settled(page);
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.getElementById("scenes").value === "glass-sphere.lua", null, { timeout: PATIENCE });
  check(true, "letters are typed into the list of scenes");
  await testOpeningKey(page);
  await page.selectOption("#scenes", "box.lua");
  await page.waitForFunction(() => /scene box;/.test(document.getElementById("canvas").getAttribute("aria-label")), null, { timeout: PATIENCE });
  await page.focus("#canvas");
  if (await page.evaluate(() => Boolean(navigator.clipboard))) {
    await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await page.keyboard.press("c");
    await page.waitForFunction(async () => /camera/.test(await navigator.clipboard.readText()), null, { timeout: PATIENCE });
    check(true, "the view is copied to the clipboard");
  }
  for (const key of ["Escape", "Escape", "Escape", "Control+q", "Control+q"]) {
    await page.keyboard.press(key);
  }
  await settled(page);
  check(await page.textContent("#message") === "", "neither Esc nor Ctrl+Q ends the program, which would leave a dead page");
};

/** Dragging looks around, the wheel narrows the view, a click selects; two things of the description tell where the camera looks. */
const testMouse = async (page) => {
  const { x, y, width, height } = await page.locator("#canvas").boundingBox();
  const label = () => page.getAttribute("#canvas", "aria-label"), before = await label(), at = (right, down) => [x + right * width, y + down * height];
  const first = await settled(page);
  await page.mouse.move(...at(0.5, 0.3));
  await page.mouse.down();
  await page.mouse.move(...at(0.65, 0.35), { steps: 8 });
  await page.mouse.up();
  await page.waitForFunction((old) => document.getElementById("canvas").getAttribute("aria-label") !== old, before, { timeout: PATIENCE });
  check(/looks along \(-?0\.[1-9]/.test(await label()), `dragging looks around: ${/looks along [^;]*/.exec(await label())}`);
  const turned = await settled(page);
  await page.mouse.wheel(0, -300);
  const narrowed = await settled(page);
  check(turned !== first && narrowed !== turned, "the wheel narrows the view");
  await page.keyboard.press("Home");
  await page.waitForFunction((old) => document.getElementById("canvas").getAttribute("aria-label") === old, before, { timeout: PATIENCE });
  const closed = await settled(page);
  await page.mouse.click(...at(0.4, 0.78));
  check(await settled(page) !== closed, "a click selects a thing");
  await page.focus("#canvas");
  await page.keyboard.press("Escape");
};

const testErrors = async (page, text) => {
  await editText(page, text.replace("camera", "camra"));
  const error = await waitError(page, /:\d+: /);
  check(/:\d+: /.test(error), `a mistake is said with its line: ${error}`);
  await page.waitForFunction(() => document.getElementById("text").shadowRoot.querySelector(".cm-lintRange-error"), null, { timeout: PATIENCE });
  check(true, "and marked at its line in the editor");
  await editText(page, text);
  await page.waitForFunction(() => document.getElementById("errors").textContent === "", null, { timeout: PATIENCE });
  await editText(page, "while true do end");
  check(true, `an endless loop ends: ${await waitError(page, /10 s/)}`);
  await editText(page, "local s = ('a'):rep(60); return s:find(('a?'):rep(60) .. s)");
  await page.waitForFunction(() => document.getElementById("errors").textContent === "", null, { timeout: PATIENCE });
  check(true, `so does a pattern without end, which runs no Lua: ${await waitError(page, /10 s/)}`);
  await editText(page, "local s = 'x' while true do s = s .. s end");
  check(true, `memory has its limit: ${await waitError(page, /MiB|memory/)}`);
};

/** What a reader of screens says of the picture follows text and layer. */
const testDescription = async (page, text) => {
  const described = (pattern) => page.waitForFunction((source) => new RegExp(source).test(document.getElementById("canvas").getAttribute("aria-label")),
    pattern.source, { timeout: PATIENCE });
  await described(/box; shapes: 1 sphere, 6 quad, 1 box; mirrors: 2, glass: 0, lights: 1; .*\(0, 0, 6\.5\)/);
  await editText(page, text + "\nsphere { center = {0, 0, 0}, radius = 0.5 }\n");
  await described(/2 sphere.*middle is: sphere/);
  await page.focus("#canvas");
  await page.keyboard.press("2");
  await described(/layer/);
  await page.keyboard.press("1");
  await editText(page, text);
  await described(/1 sphere.*middle is: quad$/);
  check(true, `the picture is described: ${await page.getAttribute("#canvas", "aria-label")}`);
};

/** Words and fields are those of the program's tables. */
const testCompletion = async (page, text) => {
  await editText(page, text);
  const labels = async (typed) => {
    await page.locator(".cm-content").click();
    await page.keyboard.press("Control+End");
    await page.keyboard.type(typed);
    await page.waitForSelector(".cm-tooltip-autocomplete", { timeout: PATIENCE });
    const all = await page.locator(".cm-completionLabel").allTextContents();
    await page.keyboard.press("Escape");
    return all;
  };
  check((await labels("\ncyl")).includes("cylinder"), "the editor completes words");
  const fields = await labels("inder { rad");
  check(fields.includes("radius"), `and fields: ${fields}`);
  const choices = await labels("ius = 1 } light { falloff = \"in");
  check(choices.length > 0 && choices.every((choice) => /in/.test(choice)), `and choices: ${choices}`);
  await editText(page, text);
  const functions = await labels("\nlocal x = math.s");
  check(functions.includes("math.sin") && !functions.includes("radius"), `and functions: ${functions}`);
  await editText(page, `lesson { scene = "box.lua" }`);
  const steps = await labels("\nca");
  check(steps.includes("caption") && steps.includes("camera"), `and the words of lessons: ${steps}`);
  const actions = await labels('ption { en = "x" }\nhold("camera l');
  check(actions.includes("camera left") && !actions.includes("camera"), `and what they hold: ${actions}`);
  await editText(page, text);
};

const testWindow = async (browser, url, mode) => {
  const problems = [];
  const page = await openPage(browser, url, problems);
  check((await page.textContent("#mode")).includes(mode), `it says how it runs: ${await page.textContent("#mode")}`);
  const text = await editorText(page);
  check(text === fs.readFileSync("scenes/box.lua", "utf8"), "the editor shows the text of the box");
  await testDescription(page, text);
  await testMouse(page);
  await testKeys(page);
  await testErrors(page, text);
  await testCompletion(page, text);
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

/** A visit to a host; afterwards the page works without network, commands with their own program, too. */
const testVisit = async (browser, isHosting) => {
  const { server, url } = await serve(isHosting);
  const problems = [];
  const page = await openPage(browser, isHosting ? `${url}index.html` : url, problems, { locale: "fr-FR" });
  check(await page.evaluate(() => self.crossOriginIsolated), isHosting ? "a host that sends headers" : "a plain host: isolated by the service worker");
  check(await page.evaluate(() => document.documentElement.lang) === "fr", "French by the browser's language");
  await page.waitForFunction(() => document.body.dataset.kept === "yes", null, { timeout: PATIENCE });
  const names = await page.locator("#scenes option").allTextContents();
  check(["boîte", "échecs", "Les ombres"].every((name) => names.includes(name)) && names.at(-1) === "Ce qui prend du temps", `the list has French names: ${names.slice(0, 3)}, ${names.slice(-3)}`);
  await page.context().setOffline(true);
  server.closeAllConnections();
  await new Promise((resolve) => server.close(resolve));
  await page.reload();
  await page.waitForFunction(() => document.body.dataset.complete === "yes", null, { timeout: PATIENCE });
  check(true, "it starts without network after the first visit");
  await page.click("#commands");
  await page.click("#run");
  await page.waitForFunction(() => /terminé/.test(document.getElementById("status").textContent), null, { timeout: PATIENCE });
  check(/sphere/.test(await page.textContent("#output")), "a command runs without network");
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};
/** A file that does not come is said, as long as nothing else can be done. */
const testLost = async (browser) => {
  for (const lost of ["dioptre.wasm", "files.json", "dioptre.js"]) {
    // The host loses it: a route would not see what the service worker fetches.
    const { server, url } = await serve(true, lost);
    const page = await browser.newPage();
    await page.goto(`${url}index.html`);
    await page.waitForFunction(() => /could not be loaded/.test(document.getElementById("message").textContent), null, { timeout: PATIENCE });
    check(true, `without ${lost}: ${await page.textContent("#message")}`);
    await page.close();
    server.close();
  }
};
const testHosts = async (browser) => {
  await testVisit(browser, false);
  await testVisit(browser, true);
  await testLost(browser);
};

/** Where no shared memory is: a server without https, which is no localhost, and a file. */
const testOneThread = async () => {
  const { server, port } = await serve(false);
  const browser = await launchAtSchool();
  console.log("a school's plain http server:");
  await testWindow(browser, `http://${SCHOOL}:${port}/index.html`, "one thread");
  console.log("one file, by double click:");
  await testWindow(browser, `file://${process.cwd()}/build/web/dioptre.html`, "one thread");
  console.log("the same file from the server:");
  const problems = [];
  const page = await openPage(browser, `http://${SCHOOL}:${port}/dioptre.html`, problems);
  check(await pixels(page) !== 0 && problems.length === 0, "it runs, and its console is silent");
  await browser.close();
  server.close();
};

module.exports = {
  window: async (browser) => {
    const { server, url } = await serve(true);
    await testWindow(browser, `${url}index.html`, "threads");
    await testLayouts(browser, `${url}index.html`);
    server.close();
  },
  host: testHosts,
  single: testOneThread,
};
