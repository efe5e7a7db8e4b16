// Lessons are played to their end in Chromium and Firefox, with threads and with one: each question is answered by its key, readers of
// screens get all words, the end card is seen and closed. Environment: LESSONS, names of lessons, instead of the first.
"use strict";

const { PATIENCE, check, drop, launchFirefox, openInFirefox, openPage, pause, pixels, screenshot, serve, settled, until } = require("./browser.js");
const fs = require("fs");

const LESSONS = (process.env.LESSONS || "01-shadows").split(" ");
const SIZE = { width: 1280, height: 720 };
/** What is answered to each question: right at times, at times not. */
const ANSWER = 2;
/** Milliseconds that a lesson may take at most. */
const LESSON_PATIENCE = 600000;

/** @return The right answers of a lesson in the order in which it asks, from its text: `ask {` or `ask(NAME)`. */
const rightAnswers = (text) => {
  const named = Object.fromEntries([...text.matchAll(/^local (\w+) = \{[^]*?\bright = (\d)/gm)].map((match) => [match[1], match[2]]));
  return [...text.matchAll(/^ask(?:\((\w+)\)| ?\{[^]*?\bright = (\d))/gm)].map((match) => Number(match[1] ? named[match[1]] : match[2]));
};
const words = (page) => page.evaluate(() => document.getElementById("lesson").textContent);

/** Plays until the end card. @return What was said at each stop. */
const play = async (page) => {
  const said = [], end = Date.now() + LESSON_PATIENCE;
  for (let now = await words(page); !/^2 {2}again$/m.test(now) && Date.now() < end; now = await words(page)) {
    const key = /what do you predict/i.test(now) ? String(ANSWER) : /^go on \(Space\)$/m.test(now) ? "Space" : null;
    if (key && now !== said.at(-1)) {
      said.push(now);
    }
    if (key) {
      await page.keyboard.press(key === "Space" ? " " : key);
    }
    await pause(100);
  }
  return said;
};

const testLesson = async (page, name, where) => {
  const text = fs.readFileSync(`scenes/lessons/${name}.lua`, "utf8"), right = rightAnswers(text);
  await page.evaluate((file) => {
    const list = document.getElementById("scenes");
    list.value = file;
    list.dispatchEvent(new Event("change"));
  }, `lessons/${name}.lua`);
  await until(page, () => document.getElementById("lesson").textContent !== "");
  await page.focus("#canvas");
  const said = await play(page);
  const card = await settled(page), last = await words(page);
  await screenshot(page, `lesson-${name}-${where}`);
  const questions = said.filter((stop) => /what do you predict/i.test(stop)).length;
  const explained = said.filter((stop) => /^(Right\.|Not what you predicted\.) \d\. /m.test(stop)).length;
  const score = `${right.filter((answer) => answer === ANSWER).length} of ${right.length} predictions right`;
  check(questions === right.length && explained === right.length, `${name}, ${where}: ${questions} questions answered, ${explained} explained, ${said.length} stops`);
  check(last.split("\n").includes(score), `at its end: ${score}`);
  await page.keyboard.press("3");
  await until(page, () => document.getElementById("lesson").textContent === "");
  check(await settled(page) !== card, "the end card is seen, and closed by its key");
};

/** A lesson that is recorded is a download; dropped on the page, it is played. */
const testRecording = async (page) => {
  await page.focus("#canvas");
  await page.keyboard.press("r");
  await page.keyboard.press("ArrowLeft", { delay: 500 });
  const [download] = await Promise.all([page.waitForEvent("download", { timeout: PATIENCE }), page.keyboard.press("r")]);
  const text = fs.readFileSync(await download.path(), "utf8");
  check(/-lesson-0001\.lua$/.test(download.suggestedFilename()) && /^press "(light|camera) left"$/m.test(text), `a recording is a download: ${download.suggestedFilename()}`);
  await drop(page, [["recorded.lua", text]]);
  await until(page, () => /^2 {2}again$/m.test(document.getElementById("lesson").textContent));
  check(true, "dropped on the page, it is played");
  await page.keyboard.press("3");
};

const testAll = async (page, where, problems) => {
  for (const name of LESSONS) {
    await testLesson(page, name, where);
  }
  check(await pixels(page) !== 0 && problems.length === 0, `${where}: the console is silent${problems.map((problem) => ": " + problem)}`);
};

module.exports = async (chromium) => {
  const { server, url } = await serve(true);
  const firefox = await launchFirefox("en-US");
  for (const [query, way] of [["", "threads"], ["?one-thread", "one-thread"]]) {
    const problems = [];
    const page = await openPage(chromium, `${url}index.html${query}`, problems, { viewport: SIZE });
    await testAll(page, `chromium-${way}`, problems);
    await testRecording(page);
    await page.context().close();
    const other = await openInFirefox(firefox, `${url}index.html${query}`, problems, SIZE);
    await testAll(other, `firefox-${way}`, problems);
    await other.close();
  }
  await firefox.close();
  server.close();
};
