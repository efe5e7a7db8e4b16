// What a link carries behind its #: name and text of the scene, and the state of the window (src/web/state.c), as JSON that is
// compressed (deflate) and written in base64url. A link is a stranger's: it is refused beyond its limits.
import { say } from "./words.js";

/** Longest fragment, characters: chat programs and browsers cut longer links. */
const FRAGMENT_MAXIMUM = 65536;
/** Most bytes that a fragment is unpacked to. */
const TEXT_MAXIMUM = 1 << 20;

const refuse = (words) => { throw new Error(say(words)); };

const base64 = (bytes) => {
  let binary = "";
  for (const byte of bytes) {
    binary += String.fromCharCode(byte);
  }
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
};

/** @return The fragment of a state; it throws an Error, to be shown, if that is too long. */
export const pack = async (state) => {
  const stream = new Blob([JSON.stringify(state)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const fragment = base64(new Uint8Array(await new Response(stream).arrayBuffer()));
  if (fragment.length > FRAGMENT_MAXIMUM) {
    refuse("The scene is too long for a link. Send its file instead.");
  }
  return fragment;
};

/** Unpacks bytes, but not more than the limit. */
const inflate = async (bytes) => {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const parts = [];
  for (let size = 0, next = await reader.read(); !next.done; next = await reader.read()) {
    size += next.value.length;
    if (size > TEXT_MAXIMUM) {
      reader.cancel();
      refuse("The link is refused: it unpacks to more than 1 MB.");
    }
    parts.push(next.value);
  }
  return new Blob(parts).text();
};

/** @return What a fragment carries; it throws an Error, to be shown, if it carries nothing. */
export const unpack = async (fragment) => {
  if (fragment.length > FRAGMENT_MAXIMUM) {
    refuse("The link is refused: it is too long.");
  }
  if (!/^[\w-]+$/.test(fragment)) {
    refuse("The link is damaged: it holds signs that no link has.");
  }
  let text = "", state = null;
  try {
    const binary = atob(fragment.replaceAll("-", "+").replaceAll("_", "/"));
    text = await inflate(Uint8Array.from(binary, (character) => character.charCodeAt(0)));
  } catch (error) {
    throw error.message.includes("1 ") ? error : new Error(say("The link is damaged: a part of it is missing."));
  }
  try {
    state = JSON.parse(text);
  } catch {
    refuse("The link is damaged: it holds no scene.");
  }
  if (!state || typeof state.text !== "string" || !/^[\w-]{1,64}(\.nff)?$/.test(state.name) ||
      !(state.view === undefined || typeof state.view === "string")) {
    refuse("The link is damaged: it holds no scene.");
  }
  return state;
};
