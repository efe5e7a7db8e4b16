// The editor of the scene's text: CodeMirror, with the words of the program's own tables (src/web/words.c).
import { EditorState } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, highlightSpecialChars, keymap, lineNumbers }
  from "@codemirror/view";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, bracketMatching, indentOnInput, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { lua } from "@codemirror/legacy-modes/mode/lua";
import { tags } from "@lezer/highlight";
import { editorPhrases } from "./words.js";

const theme = EditorView.theme({
  "&": { height: "100%", color: "#eee", backgroundColor: "#1b1e29", fontSize: "14px" },
  ".cm-content": { caretColor: "#ffcd5a", fontFamily: "monospace" },
  ".cm-scroller": { overflow: "auto", fontFamily: "monospace", lineHeight: "1.4" },
  ".cm-gutters": { backgroundColor: "#161924", color: "#9aa3bd", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "#252a3a" },
  "&.cm-focused": { outline: "2px solid #ffcd5a" },
  "&.cm-focused .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "#3d5a8a" },
  ".cm-cursor": { borderLeftColor: "#ffcd5a" },
  ".cm-tooltip": { backgroundColor: "#252a3a", color: "#eee", border: "1px solid #777" },
}, { dark: true });

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "#9fb3a0" },
  { tag: tags.keyword, color: "#f0b46c" },
  { tag: tags.string, color: "#a8d99a" },
  { tag: tags.number, color: "#9fc6ff" },
  { tag: [tags.standard(tags.variableName), tags.bool, tags.atom], color: "#dcb0f5" },
]);

/** The keyword whose braces are open before a position; null: none are. */
const openKeyword = (before, words) => {
  let depth = 0;
  for (let i = before.length - 1; i >= 0; i--) {
    if (before[i] === "}") {
      depth++;
    } else if (before[i] === "{" && depth-- === 0) {
      const name = /([A-Za-z_]\w*)\s*\(?\s*$/.exec(before.slice(Math.max(0, i - 60), i));
      const word = name && words.find((each) => each.name === name[1]);
      if (word) {
        return word;
      }
      depth = 0;
    }
  }
  return null;
};

const fieldOption = (field) => ({
  label: field.name, type: "property", apply: field.name + " = ",
  detail: field.choices.length > 0 ? field.choices.map((choice) => `"${choice}"`).join(" ") : field.unit, info: field.help || undefined,
});

/** A text is a lesson if it calls `lesson` at the beginning of a line. */
const isLesson = (text) => /^lesson\b/m.test(text);
/** An unfinished name of an action: `hold("camera r` or `press "ho`. */
const OPEN_ACTION = /\b(?:press|release|hold)\s*\(?\s*"([\w ]*)$/;

/** Completes the fields of a keyword inside its braces, choices and actions inside quotes, keywords and functions elsewhere. */
const completeFrom = ({ keywords: words, functions, lesson_functions: lessonFunctions, actions }) => (context) => {
  const before = context.state.sliceDoc(0, context.pos);
  const ofLesson = isLesson(context.state.sliceDoc()) ? lessonFunctions : [];
  const action = ofLesson.length > 0 && OPEN_ACTION.exec(before);
  if (action) {
    return { from: context.pos - action[1].length, options: actions.map((label) => ({ label, type: "enum" })) };
  }
  const keyword = openKeyword(before, words);
  const quoted = /(\w+)\s*=\s*"(\w*)$/.exec(before);
  if (quoted && keyword) {
    const field = keyword.fields.find((each) => each.name === quoted[1]);
    return field && field.choices.length > 0
      ? { from: context.pos - quoted[2].length, options: field.choices.map((label) => ({ label, type: "enum" })) } : null;
  }
  const typed = context.matchBefore(/[A-Za-z_][\w.]*/);
  if (!typed && !context.explicit) {
    return null;
  }
  const keywords = words.map((word) => ({ label: word.name, type: "class", info: word.help || undefined }))
    .concat([...ofLesson, ...functions].map((label) => ({ label, type: "function" })));
  const isValue = /[=(+*/^-]\s*[\w.]*$/.test(before);
  return { from: typed ? typed.from : context.pos, options: keyword && !isValue ? keyword.fields.map(fieldOption)
    .concat(keyword.is_shape ? [{ label: "material", type: "property", apply: "material = " }] : []) : keywords };
};

/** @return An editor in an element. @param onChange Called when the user has changed the text. */
export const createEditor = (host, label, words, onChange) => {
  // In a shadow tree its styles are sheets, which the policy of the page allows, and no elements.
  const root = host.attachShadow({ mode: "open" });
  const parent = root.appendChild(document.createElement("div"));
  parent.style.height = "100%";
  let isSetting = false;
  const extensions = [
    lineNumbers(), highlightActiveLineGutter(), highlightSpecialChars(), history(), drawSelection(), indentUnit.of("  "), indentOnInput(),
    bracketMatching(), closeBrackets(), autocompletion({ override: [completeFrom(words)] }), highlightActiveLine(),
    highlightSelectionMatches(), lintGutter(), EditorView.lineWrapping, StreamLanguage.define(lua), syntaxHighlighting(colours), theme,
    EditorState.phrases.of(editorPhrases), EditorView.contentAttributes.of({ "aria-label": label, spellcheck: "false", tabindex: "0" }),
    keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...completionKeymap, ...lintKeymap,
      indentWithTab]),
    EditorView.updateListener.of((update) => update.docChanged && !isSetting && onChange()),
  ];
  const view = new EditorView({ parent, root, state: EditorState.create({ extensions }) });
  return {
    text: () => view.state.doc.toString(),
    /** Shows another text; its history begins anew. */
    setText: (text) => {
      if (text !== view.state.doc.toString()) {
        isSetting = true;
        view.setState(EditorState.create({ doc: text, extensions }));
        isSetting = false;
      }
    },
    /** Shows errors at their lines. @param errors [{ line, message }] */
    setErrors: (errors) => view.dispatch(setDiagnostics(view.state, errors.map(({ line, message }) => {
      const place = view.state.doc.line(Math.min(Math.max(line, 1), view.state.doc.lines));
      return { from: place.from, to: place.to, severity: "error", message };
    }))),
    showLine: (line) => {
      const place = view.state.doc.line(Math.min(Math.max(line, 1), view.state.doc.lines));
      view.dispatch({ selection: { anchor: place.from, head: place.to }, scrollIntoView: true });
      view.focus();
    },
    /** As the user's own change. */
    replace: (text) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } }),
  };
};
