// Lessons are played to their end in Chromium and Firefox, with threads and with one, in English and French: each question is answered by
// its key, readers of screens get all words, the end card is seen and closed.
// Environment: LESSONS, names of lessons, instead of those of each run; LESSON_RUNS, BROWSER-WAY-LANGUAGE each, instead of RUNS' keys.
"use strict";

const { PATIENCE, check, drop, launchFirefox, openInFirefox, openPage, pause, pixels, screenshot, serve, settled, until } = require("./browser.js");
const fs = require("fs");

/** The lessons that each browser plays, in which way and language: each lesson once. */
const RUNS = {
  "chromium-threads-en": "01-shadows 05-one-pixel 09-costs",
  "chromium-one_thread-fr": "02-mirrors 06-acne",
  "firefox-threads-fr": "03-glass 07-depth",
  "firefox-one_thread-en": "04-colours 08-marching",
};
/** What the window says in each language. */
const WORDS = {
  en: { locale: "en-US", ask: /what do you predict/i, wait: /^go on \(Space\)$/m, end: /^2 {2}again$/m,
    verdict: /^(Right\.|Not what you predicted\.) \d\. /m, score: (right, all) => `${right} of ${all} prediction${all > 1 ? "s" : ""} right` },
  fr: { locale: "fr-FR", ask: /à votre avis/i, wait: /^continuer \(Espace\)$/m, end: /^2 {2}recommencer$/m,
    verdict: /^(Bonne réponse\.|Ce n’est pas ce que vous aviez prévu\.) \d\. /m,
    score: (right, all) => `${right} bonne${all > 1 ? "s" : ""} réponse${all > 1 ? "s" : ""} sur ${all}` },
};
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
const play = async (page, { ask, wait, end: card }) => {
  const said = [], end = Date.now() + LESSON_PATIENCE;
  for (let now = await words(page); !card.test(now) && Date.now() < end; now = await words(page)) {
    const key = ask.test(now) ? String(ANSWER) : wait.test(now) ? "Space" : null;
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

const testLesson = async (page, name, where, language) => {
  const text = fs.readFileSync(`scenes/lessons/${name}.lua`, "utf8"), right = rightAnswers(text), began = Date.now();
  await page.evaluate((file) => {
    const list = document.getElementById("scenes");
    list.value = file;
    list.dispatchEvent(new Event("change"));
  }, `lessons/${name}.lua`);
  await until(page, () => document.getElementById("lesson").textContent !== "");
  await page.focus("#canvas");
  const said = await play(page, language);
  const card = await settled(page), last = await words(page);
  await screenshot(page, `lesson-${name}-${where}`);
  const questions = said.filter((stop) => language.ask.test(stop)).length;
  const explained = said.filter((stop) => language.verdict.test(stop)).length;
  const score = language.score(right.filter((answer) => answer === ANSWER).length, right.length);
  check(questions === right.length && explained === right.length,
    `${name}, ${where}: ${questions} questions answered, ${explained} explained, ${said.length} stops, ${Math.round((Date.now() - began) / 1000)} s`);
  check(last.split("\n").includes(score), `at its end: ${score}`);
  await page.keyboard.press("3");
  await until(page, () => document.getElementById("lesson").textContent === "");
  check(await settled(page) !== card, "the end card is seen, and closed by its key");
};

/** A lesson that is recorded is a download; dropped on the page, it is played. */
const testRecording = async (page, { end }) => {
  await page.focus("#canvas");
  await page.keyboard.press("r");
  await page.keyboard.press("ArrowLeft", { delay: 500 });
  const [download] = await Promise.all([page.waitForEvent("download", { timeout: PATIENCE }), page.keyboard.press("r")]);
  const text = fs.readFileSync(await download.path(), "utf8");
  check(/-lesson-0001\.lua$/.test(download.suggestedFilename()) && /^press "(light|camera) left"$/m.test(text), `a recording is a download: ${download.suggestedFilename()}`);
  await drop(page, [["recorded.lua", text]]);
  await until(page, (source) => new RegExp(source, "m").test(document.getElementById("lesson").textContent), end.source);
  check(true, "dropped on the page, it is played");
  await page.keyboard.press("3");
};

/** Plays all lessons in a new page. @param run BROWSER-WAY-LANGUAGE. */
const testRun = async (chromium, url, run) => {
  const [browser, way, name] = run.split("-"), language = WORDS[name], problems = [];
  const address = `${url}index.html${way === "threads" ? "" : "?one-thread"}`;
  const firefox = browser === "firefox" ? await launchFirefox(language.locale) : null;
  const page = firefox ? await openInFirefox(firefox, address, problems, SIZE) :
    await openPage(chromium, address, problems, { viewport: SIZE, locale: language.locale });
  for (const lesson of (process.env.LESSONS || RUNS[run]).split(" ")) {
    await testLesson(page, lesson, run, language);
  }
  if (!firefox) {
    await testRecording(page, language);
  }
  check(await pixels(page) !== 0 && problems.length === 0, `${run}: the console is silent${problems.map((problem) => ": " + problem)}`);
  await (firefox || page.context()).close();
};

module.exports = async (chromium) => {
  const { server, url } = await serve(true);
  for (const run of process.env.LESSON_RUNS?.split(" ") || Object.keys(RUNS)) {
    await testRun(chromium, url, run);
  }
  server.close();
};
