// What is printed on the keyboard in use, which the help and the window's hints name: from the browser, where it tells; from the language;
// from each key that is pressed.

/** SDL's numbers of the places whose letters differ, by the browser's names; those of letters follow each other. */
const PLACES = { Minus: 45, Equal: 46, BracketLeft: 47, BracketRight: 48, Backslash: 49, Semicolon: 51, Quote: 52, Backquote: 53, Comma: 54,
  Period: 55, Slash: 56, IntlBackslash: 100 };
const placeOf = (code) => /^Key[A-Z]$/.test(code) ? code.charCodeAt(3) - 61 : PLACES[code];

/** Places whose letters are others on the keyboards of France and Belgium, and the letters. */
const AZERTY = { KeyQ: "a", KeyW: "z", KeyA: "q", KeyZ: "w", KeyM: ",", Semicolon: "m", Comma: ";", Period: ":", Slash: "!", Minus: ")",
  BracketLeft: "^", BracketRight: "$", Quote: "ù", Backquote: "²" };

/** @return What is printed on the keys, as far as it is known: [[code, letter]]. */
const knownLayout = async () => {
  const map = await navigator.keyboard?.getLayoutMap?.().catch(() => null);
  return map?.size > 0 ? [...map.entries()] : /^fr(-FR|-BE)?$/.test(navigator.language) ? Object.entries(AZERTY) : [];
};

/** Tells the window what is printed on the keys. @param setKey Called with SDL's number of a place and a code point. */
export const watchLayout = async (setKey) => {
  const printed = {};
  const learn = (code, letter) => {
    const place = placeOf(code);
    if (place && [...letter].length === 1 && printed[code] !== letter) {
      printed[code] = letter;
      setKey(place, letter.codePointAt(0));
    }
  };
  window.addEventListener("keydown", (event) => {
    if (!event.ctrlKey && !event.altKey && !event.metaKey && !event.shiftKey && !event.getModifierState("CapsLock")) {
      learn(event.code, event.key);
    }
  }, { capture: true });
  (await knownLayout()).forEach(([code, letter]) => learn(code, letter));
};
