// Scenes of strangers that never end: each function of Lua's libraries that can run without end is ended at the limit of time, with
// threads and with one. On a desktop the worker process ends there; a page has none.
"use strict";

const { check, serve } = require("./browser.js");
const { openEmpty, runCommand } = require("./command.js");

/** Texts that would run for hours or for ever, by what they keep busy. */
const ENDLESS = {
  "a loop": "while true do end",
  "a pattern that is tried in all ways": "local s = ('a'):rep(60); return s:find(('a?'):rep(60) .. s)",
  "a pattern of long runs": "local s = ('a'):rep(1 << 20); return s:find('a*b')",
  "a pattern of brackets": "local s = ('('):rep(1 << 21); return s:find('%b()')",
  "a pattern that repeats a part": "local s = ('a'):rep(1 << 22); return s:find('^(a*)%1b')",
  "a pattern of a long class": "local s = ('a'):rep(1 << 20); return s:find('[' .. ('b'):rep(1 << 20) .. ']')",
  "gsub": "return (('a'):rep(60):gsub(('a?'):rep(60) .. ('a'):rep(60), ''))",
  "gmatch": "for word in ('a'):rep(60):gmatch(('a?'):rep(60) .. ('a'):rep(60)) do end",
  "a search for a long text": "local s = ('a'):rep(1 << 22); return s:find(('a'):rep(1 << 21) .. 'b', 1, true)",
  "nothing, often": "return (''):rep(1 << 53)",
  "table.move up": "return table.move({}, 1, 1 << 53, 2, {})",
  "table.move down": "return table.move({}, 1, 1 << 53, 2)",
  "table.insert": "local t = setmetatable({}, { __len = function() return 1 << 53 end }); table.insert(t, 1, 1)",
  "table.remove": "local t = setmetatable({}, { __len = function() return 1 << 53 end }); table.remove(t, 1)",
};
/** Milliseconds after which a scene counts as endless: many run at a time. */
const END_PATIENCE = 120000;

/** Those that are tried with threads, too: the functions are the same. */
const THREADED = ["a pattern that is tried in all ways", "table.move up"];

/** Runs texts at a time. @param program The script of a build. */
const testEndless = async (browser, url, program, names) => {
  await Promise.all(names.map(async (name) => {
    const text = ENDLESS[name];
    const page = await openEmpty(browser);
    const late = new Promise((resolve) => setTimeout(resolve, END_PATIENCE, "nothing"));
    const run = runCommand(page, url, program, ["info", "/hostile.lua"], null, [["/hostile.lua", Buffer.from(text)]])
      .then(() => "it has ended by itself", (error) => error.message);
    const said = (await Promise.race([run, late])).split("\n").find((line) => /hostile|nothing|itself/.test(line)) ?? "something else";
    check(/10 s/.test(said), `${program}: ${name}: ${said}`);
    await page.close();
  }));
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  await testEndless(browser, url, "dioptre-single.js", Object.keys(ENDLESS));
  await testEndless(browser, url, "dioptre.js", THREADED);
  server.close();
};
