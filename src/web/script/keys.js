// Which keys are the window's and which the browser's, while the picture has the keyboard.

/** Keys that the window knows with Ctrl: those that change and save objects or text, and fine moves. */
const WITH_CTRL = /^([acsvxyz]|Arrow\w+|Control|Shift)$/i;
/** Keys that browsers know with Alt: the pages before and after, the first page. */
const BROWSERS_WITH_ALT = /^(Arrow\w+|Home)$/;
/** Keys of the browser: to the next element, reload, its tools. */
const BROWSERS = /^(Tab|F5|F12)$/;

/** @return Whether a key is the browser's: zoom, print, a new tab. With AltGr a key writes a letter, such as [ in French. */
const isBrowsers = (event) => event.metaKey || BROWSERS.test(event.key) || (event.altKey && BROWSERS_WITH_ALT.test(event.key)) ||
  (event.ctrlKey && !event.getModifierState("AltGraph") && !WITH_CTRL.test(event.key));

/** Divides the keys. @param canvas The picture. @param saveText Called for Ctrl+S elsewhere; there it saves changed objects into the text. */
export const listenToKeys = (canvas, saveText) => {
  document.addEventListener("keydown", (event) => {
    if (event.target === canvas && isBrowsers(event)) {
      event.stopPropagation(); // Else SDL would take it from the browser in a page without threads, and act on it in all.
    }
  }, { capture: true });
  document.addEventListener("keydown", (event) => {
    const isSaving = (event.ctrlKey || event.metaKey) && !event.altKey && event.key.toLowerCase() === "s";
    if (isSaving && event.target !== canvas) {
      event.preventDefault();
      saveText();
    }
  });
  canvas.addEventListener("keydown", (event) => {
    // A key that writes a letter must come to its keypress, which the window's fields take it from.
    if (event.ctrlKey || (!event.altKey && event.key.length > 1)) {
      event.preventDefault();
    }
  });
  canvas.addEventListener("keypress", (event) => event.preventDefault());
};
