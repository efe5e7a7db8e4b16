// The page on a desktop, a tablet and a phone, in Chromium and Firefox: what is needed is in sight, has a name and is large enough for a
// finger. Screenshots are left in build/web-work/screens, to be looked at.
"use strict";

const { PATIENCE, check, launchFirefox, openInFirefox, openPage, pause, screenshot, serve, settled } = require("./browser.js");

const SIZES = {
  desktop: { viewport: { width: 1280, height: 720 } },
  tablet: { viewport: { width: 820, height: 1180 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 },
  phone: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 3 },
};

/** Elements that a reader of screens would call by nothing. */
const nameless = (page) => page.evaluate(() => [...document.querySelectorAll("button, select, input, canvas, [role=textbox]")]
  .filter((element) => !(element.textContent.trim() || element.getAttribute("aria-label") || element.labels?.length))
  .map((element) => element.id || element.tagName));

/** @return Whether the window has the screen's own pixels, and the picture reaches nine tenths of it to the right. */
const isFilled = (page) => page.evaluate(() => {
  const canvas = document.getElementById("canvas");
  const column = canvas.getContext("2d").getImageData(Math.floor(0.9 * canvas.width), 0, 1, canvas.height).data;
  const { width, height } = canvas.getBoundingClientRect();
  const isExact = Math.abs(canvas.width - width * devicePixelRatio) <= 1 && Math.abs(canvas.height - height * devicePixelRatio) <= 1;
  return isExact && column.filter((byte, i) => i % 4 < 3 && byte > 0).length > 0;
});

/** Fingers move over the picture. @param paths Of each finger: from and to, shares of the picture. */
const moveFingers = async (page, paths) => {
  const box = await page.locator("#canvas").boundingBox();
  const client = await page.context().newCDPSession(page);
  const touch = (type, share) => client.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : paths.map(([from, to], id) =>
    ({ id, x: box.x + box.width * (from[0] + share * (to[0] - from[0])), y: box.y + box.height * (from[1] + share * (to[1] - from[1])) })) });
  await touch("touchStart", 0);
  for (let i = 1; i <= 10; i++) {
    await touch("touchMove", i / 10);
  }
  await touch("touchEnd", 1);
};

/** What holds in each browser and size. @return The hash of the window. */
const testPage = async (page, name, { width, height }) => {
  const picture = await settled(page);
  await screenshot(page, name);
  const [canvas, text] = await page.evaluate(() => ["canvas", "text"].map((id) => {
    const { width, height } = document.getElementById(id).getBoundingClientRect();
    return { width, height };
  }));
  check(canvas.width * canvas.height > 0.2 * width * height && text.height > 100, `${name}: picture ${canvas.width}x${canvas.height}, text ${text.width}x${text.height}`);
  check(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name}: nothing is wider than the screen`);
  check(await isFilled(page), `${name}: the picture fills the canvas`);
  const unnamed = await nameless(page);
  check(unnamed.length === 0, `${name}: everything has a name${unnamed.map((each) => ": " + each)}`);
  return picture;
};

const testChromium = async (browser, url, name, options) => {
  const problems = [];
  const page = await openPage(browser, url, problems, options);
  const before = await testPage(page, name, options.viewport);
  if (options.hasTouch) {
    const small = await page.evaluate(() => [...document.querySelectorAll("header button, header select")]
      .filter((element) => element.getBoundingClientRect().height < 40).map((element) => element.id));
    check(small.length === 0, `${name}: what is touched is 40 pixels high${small.map((each) => ": " + each)}`);
    await moveFingers(page, [[[0.5, 0.7], [0.7, 0.7]]]);
    const turned = await settled(page);
    check(turned !== before, `${name}: a finger turns the camera`);
    await moveFingers(page, [[[0.45, 0.5], [0.2, 0.5]], [[0.55, 0.5], [0.8, 0.5]]]);
    check(await settled(page) !== turned, `${name}: two fingers change the field of view`);
  }
  check(problems.length === 0, `${name}: the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

/** A page whose picture has no room for a while, such as a slide's frame that is hidden, draws again once it has. */
const testNoRoom = async (browser, url) => {
  const problems = [];
  const page = await openPage(browser, url, problems);
  const before = await settled(page), stage = (display) => page.evaluate((words) => { document.getElementById("stage").style.display = words; }, display);
  await stage("none");
  await pause(1000);
  await page.evaluate(() => dioptre.module.ccall("web_open", null, ["string"], ["/scenes/lamps.lua"]));
  await pause(1000);
  await stage("");
  await page.waitForFunction(() => document.getElementById("canvas").height > 100, null, { timeout: PATIENCE });
  const other = await settled(page);
  check(await isFilled(page) && other !== before && problems.length === 0, `a picture that had no room is drawn once it has${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  await testNoRoom(browser, `${url}index.html`);
  await testNoRoom(browser, `${url}index.html?one-thread`);
  for (const language of ["en", "fr"]) {
    const firefox = await launchFirefox(language);
    for (const [size, options] of Object.entries(SIZES)) {
      const name = `${size}-${language}`, problems = [];
      await testChromium(browser, `${url}index.html`, name, { ...options, locale: language });
      const page = await openInFirefox(firefox, `${url}index.html`, problems, { ...options.viewport, deviceScaleFactor: options.deviceScaleFactor ?? 1 });
      await testPage(page, `${name}-firefox`, options.viewport);
      check(problems.length === 0, `${name}-firefox: no script fails${problems.map((problem) => ": " + problem)}`);
      await page.close();
    }
    await firefox.close();
  }
  server.close();
};
