// Starts the page: asks for isolation, loads the program, and ties the scene's text to its window.
"use strict";

const SCENES = "/scenes/";
const $ = (id) => document.getElementById(id);
const script = (source) => new Promise((resolve, reject) => {
  const element = document.createElement("script");
  element.src = source;
  element.onload = resolve;
  element.onerror = () => reject(new Error(source));
  document.head.append(element);
});

/** Milliseconds without a key before the text is drawn. */
const EDIT_DELAY = 150;

/** What a link carries: the scene's name and text. */
const pack = async (state) => {
  const stream = new Blob([JSON.stringify(state)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  return btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
};
const unpack = async (fragment) => {
  const binary = atob(fragment.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const state = JSON.parse(await new Response(stream).text());
  if (typeof state.text !== "string" || !/^[\w-]{1,64}$/.test(state.name)) {
    throw new Error("no scene");
  }
  return state;
};

/** A service worker adds the headers for shared memory where the host sent none: one reload. */
const isolate = async () => {
  if (navigator.serviceWorker) {
    const registration = await navigator.serviceWorker.register("service-worker.js").catch(() => null);
    if (registration && !self.crossOriginIsolated) {
      await navigator.serviceWorker.ready;
      if (!sessionStorage.getItem("reloaded")) {
        sessionStorage.setItem("reloaded", "1");
        location.reload();
        return false;
      }
    }
  }
  sessionStorage.removeItem("reloaded");
  return self.crossOriginIsolated && typeof SharedArrayBuffer !== "undefined";
};

/** The words of index.html in the browser's language. */
const translate = () => {
  document.documentElement.lang = isFrench ? "fr" : "en";
  for (const element of document.querySelectorAll("[data-text]")) {
    element.textContent = isFrench ? FRENCH[element.dataset.text] : element.textContent;
  }
  $("canvas").setAttribute("aria-label", say("The picture of the scene"));
};

/** Fetches a file that the scene names, or that waits for its turn. */
const fetchFile = async (name) => {
  const path = SCENES + name;
  if (Module.FS.analyzePath(path).exists) {
    return;
  }
  const response = await fetch("scenes/" + name);
  if (response.ok) {
    Module.FS.writeFile(path, new Uint8Array(await response.arrayBuffer()));
  }
};

/** Shows the text of the scene that the window shows. */
let shown = "";
const showScene = (path) => {
  shown = path;
  $("text").value = Module.FS.readFile(path, { encoding: "utf8" });
  $("errors").textContent = "";
  const name = path.slice(SCENES.length);
  if (![...$("scenes").options].some((option) => option.value === name)) {
    $("scenes").add(new Option(name.replace(/\.lua$/, ""), name));
  }
  $("scenes").value = name;
};

/** Writes the text of the editor, and tells the window. */
let editTimer = 0;
const applyText = () => {
  $("errors").textContent = "";
  Module.FS.writeFile(shown, $("text").value);
  Module._web_file_changed();
};

/** Opens a scene in the window. */
const openScene = (name) => {
  Module.ccall("web_open", null, ["string"], [SCENES + name]);
  $("canvas").focus();
};

/** Offers files that the program has written, such as snapshots, as downloads. */
const offerFiles = () => {
  for (const name of Module.FS.readdir("/home/web_user")) {
    if (/\.(bmp|png)$/.test(name)) {
      const path = "/home/web_user/" + name;
      const link = document.createElement("a");
      link.href = URL.createObjectURL(new Blob([Module.FS.readFile(path)], { type: "image/bmp" }));
      link.download = name;
      link.click();
      Module.FS.unlink(path);
      setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    }
  }
};

const share = async () => {
  const name = shown.slice(SCENES.length).replace(/\.lua$/, "").replace(/[^\w-]/g, "-");
  const fragment = await pack({ name, text: $("text").value });
  history.replaceState(null, "", "#" + fragment);
  await navigator.clipboard.writeText(location.href)
    .then(() => { $("errors").textContent = say("The link is in the clipboard: it carries the scene’s text."); })
    .catch(() => { $("errors").textContent = say("Copy this link:") + " " + location.href; });
};

/** Puts files that are dropped beside the scenes; a scene among them is opened. */
const drop = async (event) => {
  event.preventDefault();
  for (const file of event.dataTransfer.files) {
    const name = file.name.replace(/[^\w.-]/g, "-");
    Module.FS.writeFile(SCENES + name, new Uint8Array(await file.arrayBuffer()));
    if (/\.(lua|nff)$/.test(name)) {
      openScene(name);
    }
  }
  Module._web_file_changed();
};

/** Selects the line that an error names. */
const showLine = () => {
  const line = Number($("errors").dataset.line);
  if (line > 0) {
    const lines = $("text").value.split("\n");
    const start = lines.slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
    $("text").focus();
    $("text").setSelectionRange(start, start + (lines[line - 1] || "").length);
  }
};

const listen = () => {
  $("errors").addEventListener("click", showLine);
  $("text").addEventListener("input", () => {
    clearTimeout(editTimer);
    editTimer = setTimeout(applyText, EDIT_DELAY);
  });
  $("scenes").addEventListener("change", () => openScene($("scenes").value));
  $("share").addEventListener("click", share);
  $("hide").addEventListener("click", () => {
    $("editor").hidden = !$("editor").hidden;
    $("hide").setAttribute("aria-expanded", String(!$("editor").hidden));
  });
  $("canvas").addEventListener("click", () => $("canvas").focus());
  // The window's keys; those with Ctrl, Alt or the system's key stay the browser's.
  $("canvas").addEventListener("keydown", (event) => {
    if (!event.ctrlKey && !event.altKey && !event.metaKey && event.key !== "Tab" && event.key !== "F5") {
      event.preventDefault();
    }
  });
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", drop);
  setInterval(offerFiles, 500);
  // The window follows its element: when the page changes its size, and when the program asks for another.
  const canvas = $("canvas"), fit = () => window.dispatchEvent(new Event("resize"));
  new ResizeObserver(fit).observe($("stage"));
  new MutationObserver(() => {
    if (Math.abs(canvas.width - canvas.clientWidth * devicePixelRatio) > 1 ||
        Math.abs(canvas.height - canvas.clientHeight * devicePixelRatio) > 1) {
      setTimeout(fit, 0);
    }
  }).observe(canvas, { attributeFilter: ["width", "height"] });
};

/** Fetches pictures and models once the first picture is there. */
const fetchLater = async (names) => {
  while (!(Module.SDL2 && Module.SDL2.image)) {
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  performance.mark("picture");
  for (const name of names) {
    await fetchFile(name);
  }
  document.body.dataset.complete = "yes";
};

/** The program's settings before it starts. */
const createModule = (files, opened) => ({
  canvas: $("canvas"),
  arguments: ["view", opened ? SCENES + opened.name + ".lua" : SCENES + "box.lua"],
  preRun: [() => {
    Module.ENV.LANGUAGE = Module.ENV.LANG = isFrench ? "fr" : "en";
    Module.ENV.SDL_RENDER_DRIVER = "software";
    Module.ENV.SDL_EMSCRIPTEN_KEYBOARD_ELEMENT = "#canvas";
    Module.FS.chdir("/home/web_user"); // Where snapshots go, see offerFiles().
    for (const folder of ["/scenes/pictures", "/scenes/models"]) {
      Module.FS.mkdirTree(folder);
    }
    if (opened) {
      Module.FS.writeFile(SCENES + opened.name + ".lua", opened.text);
    }
    const named = files.later.filter((name) => opened && opened.text.includes(name.split("/").pop()));
    if (named.length > 0) {
      Module.addRunDependency("files");
      Promise.all(named.map(fetchFile)).then(() => Module.removeRunDependency("files"));
    }
  }],
  print: (line) => console.log(line),
  printErr: (line) => {
    $("errors").textContent += line + "\n";
    const place = new RegExp(shown + ":(\\d+):").exec(line);
    $("errors").dataset.line = place ? place[1] : "";
  },
  onScene: (path) => {
    $("message").textContent = "";
    showScene(path);
  },
  onExit: () => { $("message").textContent = say("The program has ended. Reload the page to start it again."); },
});

const start = async () => {
  translate();
  document.body.classList.toggle("embed", new URLSearchParams(location.search).has("embed"));
  $("message").textContent = say("Loading …");
  if (!await isolate()) {
    $("message").textContent = say("This browser gives no shared memory to this page: it needs https or localhost, and a browser of 2022 or later.");
    return;
  }
  const files = await (await fetch("files.json")).json();
  const opened = location.hash.length > 1 ? await unpack(location.hash.slice(1)).catch(() => {
    $("errors").textContent = say("The link is damaged: it holds no scene.");
  }) : null;
  for (const name of files.scenes) {
    $("scenes").add(new Option(name.replace(/\.lua$/, ""), name));
  }
  self.Module = createModule(files, opened);
  listen();
  await script("dioptre.js");
  await fetchLater(files.later);
};

script("words.js").then(start);
