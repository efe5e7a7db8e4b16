// Links: what they carry comes back, and hostile ones are refused with a message.
"use strict";

const { PATIENCE, check, editText, editorText, errorText, openPage, pause, serve, settled, waitError } = require("./browser.js");
const fs = require("fs");
const http = require("http");
const zlib = require("zlib");

const fragmentOf = (state) => zlib.deflateRawSync(Buffer.from(typeof state === "string" ? state : JSON.stringify(state))).toString("base64url");
/** The window's state as text, see src/web/state.c. */
const stateOf = (page) => page.evaluate(() => new Promise((resolve) => {
  const { module } = dioptre, before = module.onState;
  module.onState = (text) => { module.onState = before; resolve(text); };
  module._web_ask_state();
}));

/** @return The picture of the window, as its key for snapshots gives it: without what lies over it. */
const snapshot = async (page) => {
  await page.focus("#canvas");
  const [download] = await Promise.all([page.waitForEvent("download", { timeout: PATIENCE }), page.keyboard.press("p")]);
  return fs.readFileSync(await download.path());
};

/** Moves light and camera, changes layer and settings, edits the text: another page shows the same. */
const testRoundTrip = async (browser, url, query) => {
  const problems = [];
  const page = await openPage(browser, url + query, problems);
  const edited = (await editorText(page)) + "\n-- é ∀ 😀\nsphere { center = {0, 1, 0}, radius = 0.3 }\n";
  await settled(page);
  await editText(page, edited);
  await settled(page);
  await page.focus("#canvas");
  for (const key of ["ArrowLeft", "w", "d"]) {
    await page.keyboard.down(key);
    await pause(300);
    await page.keyboard.up(key);
  }
  await page.keyboard.press("2");
  await page.keyboard.press("]");
  await settled(page);
  const picture = await snapshot(page);
  const state = await stateOf(page);
  await page.click("#share");
  await page.waitForFunction(() => location.hash.length > 1);
  const link = page.url();
  const other = await openPage(browser, link, problems);
  await other.waitForFunction(() => document.getElementById("errors").textContent === "");
  await settled(other);
  const otherPicture = await snapshot(other);
  check(await editorText(other) === edited, `a link carries the scene's text (${link.length} characters)`);
  const otherState = await stateOf(other);
  check(/^camera /m.test(state) && /^light 0/m.test(state), "camera and light were moved");
  check(otherState === state, "a link carries camera, light, layer and settings" + (otherState === state ? "" : `:\n${state}\n${otherState}`));
  check(otherPicture.equals(picture), `and gives the same picture, ${picture.length} bytes`);
  await other.context().close();
  await page.context().close();
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
};

/** The scene of a link may be faulty, such as that of a pupil who asks what is wrong: its text is there to be mended. */
const testFaulty = async (browser, url, query) => {
  const problems = [], text = "camra { position = {0, 0, 5} }\nlight { position = {1, 2, 3} }\nsphere { center = {0, 0, 0}, radius = 1 }\n";
  const page = await openPage(browser, `${url}${query}#${fragmentOf({ name: "box", text, view: "" })}`, problems);
  check(await editorText(page) === text, "the text of a faulty scene comes with its link");
  check(true, `and its error: ${await waitError(page, /box\.lua:1: .*camra/)}`);
  await editText(page, text.replace("camra", "camera"));
  await page.waitForFunction(() => /shapes: 1 sphere;/.test(document.getElementById("canvas").getAttribute("aria-label")), null, { timeout: PATIENCE });
  check(await errorText(page) === "", "it is drawn once it is mended");
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

/** A scene of the Standard Procedural Databases comes with its own format. */
const testNff = async (browser, url, query) => {
  const problems = [], text = "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 64 48\nl 3 4 5\nf 1 0.5 0.2 1 0 0 0 0\ns 0 0 0 1\n";
  const page = await openPage(browser, `${url}${query}#${fragmentOf({ name: "ball.nff", text, view: "" })}`, problems);
  await page.waitForFunction(() => /shapes: 1 sphere;/.test(document.getElementById("canvas").getAttribute("aria-label")), null, { timeout: PATIENCE });
  check(await editorText(page) === text && await errorText(page) === "", "a link carries a scene in NFF");
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

/** What strangers may send, and a word of the answer. */
const HOSTILE = {
  "too long": ["A".repeat(70000), /too long/],
  "bad base64": ["%3Cscript%3E", /damaged/],
  "a part of a link": [fragmentOf({ name: "box", text: "x".repeat(999) }).slice(0, 20), /damaged/],
  "random bytes": [Buffer.from(Array.from({ length: 300 }, (_, i) => (i * 7919) % 251)).toString("base64url"), /damaged/],
  "a bomb": [fragmentOf(JSON.stringify({ name: "box", text: " ".repeat(30 << 20) })), /more than 1 MB/],
  "no JSON": [fragmentOf("camera"), /no scene/],
  "no text": [fragmentOf({ name: "box", text: 7 }), /no scene/],
  "a name that is a path": [fragmentOf({ name: "../../etc/x", text: "" }), /no scene/],
  "a view of nonsense": [null, /view is left out/, "camera nan inf 0 0 0 0 0 0 0 0 0\n"],
  "a light that is not there": [null, /view is left out/, "light 99 1 2 3\n"],
  "a layer that is not there": [null, /view is left out/, "picture 0 9999 0 - 0 0 0 0 0 0 0\n"],
  "an engine that is not there": [null, /view is left out/, "picture 0 0 1 f99x1 0 0 0 0 0 0 0\n"],
  "samples without end": [null, /view is left out/, "picture 0 0 16 - 0 0 0 2000000000 0 0 0\n"],
  "an edit of nothing": [null, /view is left out/, "edit sphere 7777 radius 1 0 0\n"],
  "an edit beyond limits": [null, /view is left out/, "edit sphere 1 radius -1 0 0\n"],
  "edits that are right only alone": [null, /view is left out/, "edit material 1 reflectivity 0.9 0.9 0.9\nedit material 1 transparency 0.9 0.9 0.9\n"],
};

const testHostile = async (browser, url) => {
  const problems = [];
  const page = await openPage(browser, `${url}index.html`, problems);
  const text = await editorText(page);
  for (const [name, [fragment, answer, view]] of Object.entries(HOSTILE)) {
    await page.goto("about:blank");
    await page.goto(`${url}index.html#${fragment ?? fragmentOf({ name: "box", text, view })}`);
    const said = await waitError(page, answer).catch(async () => `nothing but: ${await errorText(page)}`);
    check(answer.test(said), `${name}: ${said}`);
  }
  await page.goto("about:blank");
  await page.goto(`${url}index.html?embed`);
  await page.waitForFunction(() => window.dioptre, null, { timeout: PATIENCE });
  check(!await page.isVisible("header") && !await page.isVisible("#editor") && await page.isVisible("#canvas"), "?embed shows the picture alone");
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

/** A slide of another site shows a link in a frame; a frame that is confined shows the page that is one file. */
const testFrames = async (browser, url) => {
  const text = "camera { position = {0, 0, 5} }\nlight { position = {1, 2, 3} }\nsphere { center = {0, 0, 0}, radius = 1 }\n";
  const fragment = fragmentOf({ name: "slide", text });
  const frames = { "a frame": `<iframe src="${url}index.html?embed#${fragment}"></iframe>`,
    "a confined frame": `<iframe sandbox="allow-scripts" src="${url}dioptre.html?embed#${fragment}"></iframe>` };
  for (const [name, html] of Object.entries(frames)) {
    const slide = http.createServer((request, response) => response.setHeader("Content-Type", "text/html").end(`<!DOCTYPE html>${html}`));
    await new Promise((resolve) => slide.listen(0, resolve));
    const context = await browser.newContext(), page = await context.newPage(), problems = [];
    page.on("pageerror", (error) => problems.push(error.message));
    await page.goto(`http://127.0.0.1:${slide.address().port}/`);
    const frame = page.frames()[1];
    const described = frame.waitForFunction(() => /slide; shapes: 1 sphere;/.test(document.getElementById("canvas")?.getAttribute("aria-label")), null, { timeout: PATIENCE });
    check(await described.then(() => true, () => false) && problems.length === 0,
      `${name} of another site shows a link${problems.map((problem) => ": " + problem)}`);
    await context.close();
    slide.closeAllConnections();
    slide.close();
  }
};

/** Neither a script that a stranger brings in nor a request to another host gets through, whatever the page may be made to do. */
const testPolicy = async (browser, url) => {
  let requests = 0;
  const other = http.createServer((request, response) => {
    requests++;
    response.writeHead(200, { "Access-Control-Allow-Origin": "*", "Cross-Origin-Resource-Policy": "cross-origin" });
    response.end();
  });
  await new Promise((resolve) => other.listen(0, resolve));
  const page = await openPage(browser, url, []);
  const refused = await page.evaluate(async (elsewhere) => {
    const refused = [];
    document.addEventListener("securitypolicyviolation", (event) => refused.push(event.effectiveDirective));
    await fetch(elsewhere).catch(() => null);
    await new Promise((resolve) => { Object.assign(new Image(), { onload: resolve, onerror: resolve, src: elsewhere + "picture" }); });
    const script = document.createElement("script");
    script.textContent = "window.isInlined = true;";
    document.body.append(script);
    await new Promise((resolve) => setTimeout(resolve, 100));
    return [...refused, window.isInlined ? "an inline script has run" : "none has run"].join(" ");
  }, `http://localhost:${other.address().port}/`);
  check(requests === 0 && refused === "connect-src img-src script-src-elem none has run", `${url.replace(/:.*\//, ": ")}: refused: ${refused}; ${requests} requests elsewhere`);
  await page.context().close();
  other.close();
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  await testPolicy(browser, `${url}index.html`);
  await testPolicy(browser, `file://${process.cwd()}/build/web/dioptre.html`);
  await testRoundTrip(browser, `${url}index.html`, "");
  await testRoundTrip(browser, `${url}index.html`, "?one-thread");
  await testFaulty(browser, `${url}index.html`, "");
  await testFaulty(browser, `${url}index.html`, "?one-thread");
  await testNff(browser, `${url}index.html`, "");
  await testHostile(browser, url);
  await testFrames(browser, url);
  server.close();
};
