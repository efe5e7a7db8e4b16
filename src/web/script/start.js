// Starts the page: loads the program, and ties the scene's text to its window.
import { describe } from "./description.js";
import { readFile, isOneFile } from "./files.js";
import { watchLayout } from "./keyboard.js";
import { listenToKeys } from "./keys.js";
import { pack, unpack } from "./link.js";
import { createPanel } from "./panel.js";
import { chooseMode, keepFiles, loadProgram, loadScript, startProgram } from "./program.js";
import { isFrench, say, translate } from "./words.js";

const SCENES = "/scenes/";
/** Where snapshots, lessons and copies of scenes go that the program writes. */
const HOME = "/home/web_user";
/** Where the program finds the one that reads models other than OBJ, and what that reads. */
const READER = "/dioptre/models.wasm", READ_BY_READER = /\.(ply|stl|glb|gltf)$/i;
/** Milliseconds without a key before the text is drawn. */
const EDIT_DELAY = 150;
/** Milliseconds between two looks for what the program has written. */
const OFFER_DELAY = 1000;
/** How often the program is told a size, and milliseconds between. */
const FIT_TRIES = 20, FIT_DELAY = 100;
/** Milliseconds from the program's word that there is a picture until it is on the screen. */
const SCREEN_DELAY = 50;
const $ = (id) => document.getElementById(id);

/** `shown` is the file whose text the editor has, `drawn` the one that the window shows: another while a scene is faulty. */
let module = null, editor = null, shown = "", drawn = "", opened = null, faulty = null;
/** Kept once a picture can be seen: nothing that comes later shall delay it. */
let tellPicture = null;
const picture = new Promise((resolve) => { tellPicture = resolve; });

const setMessage = (words) => { $("message").textContent = words; };
const showError = (words) => { $("errors").textContent = words; };

/** Fetches a file that scenes name, unless it is there. */
const fetchFile = async (name) => {
  const path = SCENES + name;
  if (!module.FS.analyzePath(path).exists) {
    const bytes = await readFile("scenes/" + name).catch(() => null);
    bytes && module.FS.writeFile(path, bytes);
  }
};

const clearErrors = () => {
  showError("");
  editor?.setErrors([]);
};

const addScene = (name, list = $("scenes")) => list.append(new Option(name.split("/").pop().replace(/\.lua$/, ""), name));
/** @return What a scene or lesson is called in the language of the page, from its text; empty: as its file. */
const titleOf = (text) => {
  const language = isFrench ? "fr" : "en";
  return (new RegExp(`^-- ${language} name: (.+)$`, "m").exec(text) ?? new RegExp(`^  title = \\{.*?\\b${language} = "([^"]+)"`, "m").exec(text))?.[1] ?? "";
};
/** The list names scenes and lessons as the window does. */
const nameScenes = () => {
  for (const option of [...$("scenes").options].filter(({ value }) => module.FS.analyzePath(SCENES + value).exists)) {
    option.text = titleOf(module.FS.readFile(SCENES + option.value, { encoding: "utf8" })) || option.text;
  }
};
/** The list shows the scene whose text the editor has. */
const showName = () => {
  const name = shown.slice(SCENES.length);
  if (![...$("scenes").options].some((option) => option.value === name)) {
    addScene(name);
  }
  $("scenes").value = name;
};

/** Until the text is drawn that was typed; 0: it is. */
let editTimer = 0;
/** When the file of the scene was written whose text the editor has, milliseconds. */
let textTime = 0;
const fileTime = () => module.FS.stat(shown).mtime.getTime();
const showText = () => {
  editor?.setText(module.FS.readFile(shown, { encoding: "utf8" }));
  textTime = fileTime();
};
/** Shows the text of a file, unless the editor has it with changes that are not yet written. */
const showFile = (path) => {
  clearErrors();
  if (path !== shown || editTimer === 0) {
    shown = path;
    showText();
  }
  showName();
};

/** Opens a file in the window. */
const openFile = (path) => module.ccall("web_open", null, ["string"], [path]);

/** Whether the window, which has one now, knows the keyboard. */
let hasLayout = false;
/** Shows the text of the scene that the window shows. */
const showScene = (path) => {
  setMessage("");
  if (!hasLayout) {
    hasLayout = true;
    watchLayout((place, letter) => module._web_set_key(place, letter));
  }
  drawn = path;
  showFile(faulty ?? path);
  if (faulty) {
    faulty = null;
    openFile(shown); // The program says what is wrong.
  } else if (opened && path === fileOf(opened.name)) {
    opened.view && module.ccall("web_set_state", null, ["string"], [opened.view]);
    opened = null;
  }
};

/** Writes the text of the editor, and tells the window. */
const applyText = () => {
  clearErrors();
  module.FS.writeFile(shown, editor.text());
  textTime = fileTime();
  if (shown === drawn) {
    module._web_file_changed();
  } else {
    openFile(shown);
  }
};
/** What was typed is drawn at once: another scene or a command follows. */
const endEdit = () => {
  if (editTimer !== 0) {
    clearTimeout(editTimer);
    editTimer = 0;
    applyText();
  }
};
const onEdit = () => {
  clearTimeout(editTimer);
  editTimer = setTimeout(endEdit, EDIT_DELAY);
};
/** The window writes changed objects into the scene's file: the editor shows them, unless it has changes of its own. */
const takeText = () => {
  if (shown && editTimer === 0 && module.FS.analyzePath(shown).exists && fileTime() !== textTime) {
    showText();
  }
};

/** Shows what the program says; an error with its place at that line, too. */
const onError = (line) => {
  console.info(line);
  showError($("errors").textContent + line + "\n");
  const place = shown && new RegExp(shown.replace(/[.\\+]/g, "\\$&") + ":(\\d+): (.*)").exec(line);
  if (place) {
    $("errors").dataset.line = place[1];
    editor?.setErrors([{ line: Number(place[1]), message: place[2] }]);
  }
};

/** Opens a scene in the window; what comes behind the first picture is there before. @param later Names of such files beside it. */
const openScene = async (name, later = []) => {
  endEdit();
  $("canvas").focus();
  await Promise.all(later.filter((each) => each.split("/")[0] === name.split("/")[0]).map(fetchFile));
  const path = SCENES + name, text = module.FS.analyzePath(path).exists ? module.FS.readFile(path, { encoding: "utf8" }) : "";
  await Promise.all(later.filter((each) => text.includes(each.split("/").pop())).map(fetchFile));
  openFile(path);
};

const offerDownload = (name, bytes) => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes], { type: "application/octet-stream" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
};
/** Offers files that the program has written, such as snapshots, as downloads. */
const offerFiles = () => {
  for (const name of module.FS.readdir(HOME).filter((each) => /\.(bmp|png|csv|lua)$/.test(each))) {
    offerDownload(name, module.FS.readFile(HOME + "/" + name));
    module.FS.unlink(HOME + "/" + name);
  }
};

/** Gives a text to the clipboard; where the page may not, as over plain http, through a field that is selected. @return Whether it is there. */
const copyText = async (text) => {
  if (await navigator.clipboard?.writeText(text).then(() => true).catch(() => false)) {
    return true;
  }
  const focused = document.activeElement, field = document.body.appendChild(document.createElement("textarea"));
  field.value = text;
  field.select();
  const isCopied = document.execCommand("copy");
  field.remove();
  focused?.focus();
  return isCopied;
};

/** @return The file of a scene. @param name Without the ending of most scenes, .lua. */
const fileOf = (name) => SCENES + name + (name.endsWith(".nff") ? "" : ".lua");

/** Copies a link to what the window shows. @param view See src/web/state.c. */
const copyLink = async (view) => {
  const ending = shown.endsWith(".nff") ? ".nff" : "";
  const name = shown.slice(SCENES.length).replace(/\.(lua|nff)$/, "").replace(/[^\w-]/g, "-").slice(0, 64) + ending;
  try {
    const text = editor ? editor.text() : module.FS.readFile(shown, { encoding: "utf8" });
    const fragment = await pack({ name, text, view });
    history.replaceState(null, "", "#" + fragment);
  } catch (error) {
    showError(error.message);
    return;
  }
  showError(await copyText(location.href) ? say("The link is in the clipboard: it carries scene, view, layer and settings.")
    : say("Copy this link:") + " " + location.href);
};

/** Fetches the program that reads models other than OBJ (src/web/models), unless it is there. */
const fetchReader = async () => {
  if (!module.FS.analyzePath(READER).exists) {
    const bytes = await readFile("models.wasm").catch(() => null);
    bytes && module.FS.writeFile(READER, bytes);
  }
};

/** Puts files that are dropped beside the scenes; a scene among them is opened. */
const drop = async (event) => {
  event.preventDefault();
  const files = [...event.dataTransfer.files];
  if (files.some((file) => READ_BY_READER.test(file.name))) {
    await fetchReader();
  }
  const nameOf = (file) => file.name.replace(/[^\w.-]/g, "-");
  for (const file of files) {
    module.FS.writeFile(SCENES + nameOf(file), new Uint8Array(await file.arrayBuffer()));
  }
  // Once all of them are there: a scene may name the others.
  files.map(nameOf).filter((name) => /\.(lua|nff)$/.test(name)).forEach((name) => openScene(name));
  module._web_file_changed();
};

/** All files beside the scenes. */
const sceneFiles = (folder = SCENES.slice(0, -1)) => module.FS.readdir(folder).filter((name) => name !== "." && name !== "..")
  .flatMap((name) => {
    const path = folder + "/" + name;
    return module.FS.isDir(module.FS.stat(path).mode) ? sceneFiles(path) : [[path, module.FS.readFile(path)]];
  });

/** The files that a command may need. */
const commandFiles = () => sceneFiles().concat(module.FS.analyzePath(READER).exists ? [[READER, module.FS.readFile(READER)]] : []);

const toggle = (button, section) => {
  $(section).hidden = !$(section).hidden;
  $(button).setAttribute("aria-expanded", String(!$(section).hidden));
};

/** The window follows its element: when the page changes its size, and when the program asks for another. A program that is just about
 * to get the size that it asked for does not hear of another: it is told until it has the right one. */
const fitCanvas = () => {
  const canvas = $("canvas"), fit = () => window.dispatchEvent(new Event("resize"));
  const isFit = () => {
    const { width, height } = canvas.getBoundingClientRect();
    return Math.abs(canvas.width - width * devicePixelRatio) <= 1 && Math.abs(canvas.height - height * devicePixelRatio) <= 1;
  };
  let timer = 0;
  const fitSoon = (tries, delay) => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (!isFit() && tries > 0) {
        fit();
        fitSoon(tries - 1, FIT_DELAY);
      }
    }, delay);
  };
  new ResizeObserver(fit).observe($("stage"));
  new MutationObserver(() => fitSoon(FIT_TRIES, 0)).observe(canvas, { attributeFilter: ["width", "height"] });
};

const listen = (later) => {
  fitCanvas();
  $("errors").addEventListener("click", () => $("errors").dataset.line && editor?.showLine(Number($("errors").dataset.line)));
  $("scenes").addEventListener("change", () => {
    const name = $("scenes").value;
    showName(); // Until it is opened: a lesson that plays keeps to its scene.
    openScene(name, later);
  });
  $("share").addEventListener("click", () => module._web_ask_state());
  $("hide").addEventListener("click", () => toggle("hide", "editor"));
  $("commands").addEventListener("click", () => toggle("commands", "panel"));
  const canvas = $("canvas");
  canvas.addEventListener("pointerdown", () => canvas.focus());
  listenToKeys(canvas, () => editor && offerDownload(shown.split("/").pop(), editor.text()));
  // The window sleeps until it is woken, see src/web/waits.h.
  for (const type of ["keydown", "keyup", "mousemove", "mousedown", "mouseup", "mouseenter", "mouseleave", "wheel", "touchstart", "touchmove",
    "touchend", "touchcancel", "focus", "blur", "resize", "visibilitychange"]) {
    window.addEventListener(type, () => module._web_wake(), { capture: true, passive: true });
  }
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", drop);
  window.addEventListener("hashchange", () => location.reload());
  setInterval(() => {
    offerFiles();
    takeText();
  }, OFFER_DELAY);
};

/** Once the first picture is there: the words of the editor, pictures and models. */
const afterPicture = async (later) => {
  await picture;
  nameScenes();
  await loadScript("editor.js");
  const pointer = module._web_words();
  editor = self.dioptreEditor.createEditor($("text"), $("text-label").textContent, JSON.parse(module.UTF8ToString(pointer)), onEdit);
  module._free(pointer);
  showText();
  const currentScene = () => {
    endEdit();
    return shown;
  };
  createPanel({ scene: currentScene, files: commandFiles, later: () => Promise.all(later.map(fetchFile)), offerDownload });
  self.dioptre = { editor, module };
  for (const name of later) {
    await fetchFile(name);
  }
  nameScenes();
  document.body.dataset.complete = "yes";
  keepFiles();
};

/** Prepares the files of the program before it starts. */
const prepare = (later) => (started) => {
  module = started;
  started.ENV.LANGUAGE = started.ENV.LANG = isFrench ? "fr" : "en";
  started.ENV.SDL_RENDER_DRIVER = "software";
  started.ENV.SDL_EMSCRIPTEN_KEYBOARD_ELEMENT = "#canvas";
  started.ENV.SDL_EMSCRIPTEN_ASYNCIFY = "0";
  started.FS.chdir(HOME);
  for (const folder of new Set(later.map((name) => name.split("/")[0]))) {
    started.FS.mkdirTree(SCENES + folder);
  }
  if (opened) {
    started.FS.writeFile(fileOf(opened.name), opened.text);
  }
  const named = later.filter((name) => opened && opened.text.includes(name.split("/").pop()));
  if (named.length > 0) {
    started.addRunDependency("files");
    Promise.all(named.map(fetchFile)).then(() => started.removeRunDependency("files"));
  }
};

/** Says which way the program runs. */
const showMode = (mode) => {
  $("mode").textContent = mode.isThreaded ? say("%d threads, SIMD").replace("%d", mode.threads) : say("one thread, SIMD");
  $("mode").title = mode.isThreaded ? "" : say(isOneFile ? "A page that is one file has one thread." : "Several threads need https or localhost.");
};

const start = async () => {
  translate();
  $("canvas").setAttribute("aria-label", say("The picture of the scene"));
  $("panel").setAttribute("aria-label", $("commands").textContent);
  document.body.classList.toggle("embed", new URLSearchParams(location.search).has("embed"));
  setMessage(say("Loading …"));
  const mode = await chooseMode();
  if (mode.isReloading) {
    return;
  }
  if (!mode.hasSimd) {
    setMessage(say("This browser cannot run the program: it lacks WebAssembly with SIMD. Browsers of 2023 and later have it."));
    return;
  }
  showMode(mode);
  const parts = loadProgram(mode);
  const files = JSON.parse(new TextDecoder().decode(await readFile("files.json")));
  let refusal = "";
  opened = location.hash.length > 1 ? await unpack(location.hash.slice(1)).catch((error) => { refusal = error.message; return null; }) : null;
  files.scenes.forEach((name) => addScene(name));
  const lessons = $("scenes").appendChild(document.createElement("optgroup"));
  lessons.label = say("Lessons");
  files.lessons.forEach((name) => addScene(name, lessons));
  const launch = (scene) => startProgram(parts, {
    canvas: $("canvas"),
    arguments: ["view", fileOf(scene)],
    preRun: [prepare(files.later)],
    print: (line) => console.log(line),
    printErr: onError,
    onScene: (path) => {
      showScene(path);
      if (refusal) {
        showError(refusal);
        refusal = "";
      }
    },
    onFaulty: (path) => module.FS.analyzePath(path).exists && showFile(path), // To be mended; its error follows.
    onLesson: (words) => { $("lesson").textContent = words; },
    onPicture: () => setTimeout(tellPicture, SCREEN_DELAY),
    onState: copyLink,
    onCopy: copyText,
    onDescription: (facts) => $("canvas").setAttribute("aria-label", describe(drawn.slice(SCENES.length).replace(/\.lua$/, ""), JSON.parse(facts))),
    onStateRead: (isRight) => isRight || showError(say("The link is damaged: its view is left out.")),
    onAbort: () => setMessage(say("The program has failed. Reload the page to start it again.")),
    onExit: () => {
      if (opened && !shown && !faulty) {
        // The link's scene is faulty: another is drawn, and its text is there to be mended.
        faulty = fileOf(opened.name);
        setTimeout(launch, 0, opened.name === "box" ? "glass-sphere" : "box");
      } else {
        setMessage(say("The program has ended. Reload the page to start it again."));
      }
    },
  });
  await launch(opened ? opened.name : "box");
  listen(files.later);
  await afterPicture(files.later);
};

start().catch((error) => {
  console.info(error);
  setMessage(say("The page could not be loaded. Reload it to try again."));
});
