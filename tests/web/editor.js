// The text beside the picture: Ctrl+S saves it, files that are dropped show in it though they are faulty, and its link is copied where
// the page has no clipboard.
"use strict";

const { PATIENCE, SCHOOL, check, drop, editText, editorText, errorText, launchAtSchool, openPage, serve, settled, until, waitError } = require("./browser.js");
const fs = require("fs");

const described = (page, pattern) => page.waitForFunction((source) =>
  new RegExp(source).test(document.getElementById("canvas").getAttribute("aria-label")), pattern.source, { timeout: PATIENCE });

/** Ctrl+S saves the text, and the browser does not save the page. */
const testSave = async (page) => {
  const text = (await editorText(page)) + "-- Of today.\n";
  await editText(page, text);
  await page.evaluate(() => window.addEventListener("keydown", (event) => { window.isTaken = event.defaultPrevented; }));
  for (const [place, selector] of [["in the editor", ".cm-content"], ["on a button", "#share"]]) {
    await page.focus(selector);
    const [download] = await Promise.all([page.waitForEvent("download", { timeout: PATIENCE }), page.keyboard.press("Control+s")]);
    check(download.suggestedFilename() === "box.lua" && fs.readFileSync(await download.path(), "utf8") === text, `Ctrl+S ${place} saves the text`);
    check(await page.evaluate(() => window.isTaken), `and not the page`);
  }
  check(await editorText(page) === text, "the text stays as it is");
};

const FAULTY = "camera { position = {0, 0, 5} }\nlight { position = {1, 2, 3} }\nshpere { center = {0, 0, 0}, radius = 1 }\n";
const MENDED = FAULTY.replace("shpere", "sphere");

/** @return The number of the line that is marked in the editor. */
const markedLine = (page) => page.waitForFunction(() => {
  const root = document.getElementById("text").shadowRoot, mark = root.querySelector(".cm-lintRange-error");
  return mark && [...root.querySelectorAll(".cm-line")].indexOf(mark.closest(".cm-line")) + 1;
}, null, { timeout: PATIENCE }).then((handle) => handle.jsonValue());

/** Waits until the editor shows a text: the error of a file in place of that which is shown can come first. */
const showsText = (page, text) => until(page, (words) => dioptre.editor.text() === words, text);

/** A faulty file is dropped: its text is there with its error at its line; it is drawn once it is mended. */
const testDrop = async (page) => {
  for (const name of ["dropped.lua", "box.lua"]) { // A file of its own, and one in place of that which is shown.
    await page.selectOption("#scenes", "box.lua");
    await described(page, /^The picture of the scene box; /);
    await drop(page, [[name, FAULTY]]);
    const error = await waitError(page, /:3: /);
    check(await showsText(page, FAULTY), `${name}: the editor shows what was dropped`);
    check(error.includes(`${name}:3:`) && await markedLine(page) === 3, `with its error at its line: ${error}`);
    check(await page.inputValue("#scenes") === name, "under its name");
    await described(page, /^The picture of the scene box; /);
    await editText(page, MENDED);
    await described(page, /shapes: 1 sphere;/);
    check(await errorText(page) === "" && await editorText(page) === MENDED, "it is drawn once it is mended");
    await drop(page, [[name, FAULTY]]);
    await waitError(page, /:3: /);
    check(await showsText(page, FAULTY), "dropped once more, it is shown once more");
  }
};

/** The link comes to the clipboard: what is pasted is the page's address. */
const testCopy = async (page, hasClipboard) => {
  check(await page.evaluate(() => Boolean(navigator.clipboard)) === hasClipboard, hasClipboard ? "with a clipboard" : "without navigator.clipboard");
  await settled(page);
  await page.click("#share");
  await waitError(page, /The link is in the clipboard/);
  await page.click("#commands");
  await page.fill("#line", "");
  await page.focus("#line");
  await page.keyboard.press("Control+v");
  const pasted = await page.inputValue("#line");
  check(pasted === page.url() && /#[\w-]{100,}$/.test(pasted), `the link is copied: ${pasted.length} characters`);
  await page.click("#commands");
};

const testEditor = async (browser, url, hasClipboard) => {
  const problems = [];
  const page = await openPage(browser, url, problems, hasClipboard ? { permissions: ["clipboard-read", "clipboard-write"] } : {});
  await testCopy(page, hasClipboard);
  await testSave(page);
  await testDrop(page);
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

module.exports = async (browser) => {
  const hosting = await serve(true), plain = await serve(false);
  await testEditor(browser, `${hosting.url}index.html`, true);
  const atSchool = await launchAtSchool();
  await testEditor(atSchool, `http://${SCHOOL}:${plain.port}/index.html`, false);
  await atSchool.close();
  hosting.server.close();
  plain.server.close();
};
