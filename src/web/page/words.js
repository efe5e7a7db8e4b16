// The words of the page in French; English stands in index.html and in the calls of say().
"use strict";

const FRENCH = {
  "scene": "Scène",
  "share": "Copier un lien vers cette scène",
  "hide": "Texte",
  "text": "Le texte de la scène\u00a0: ce que vous changez est dessiné aussitôt",
  "The picture of the scene": "L’image de la scène",
  "Loading …": "Chargement…",
  "The link is in the clipboard: it carries the scene’s text.":
    "Le lien est dans le presse-papiers\u00a0: il porte le texte de la scène.",
  "Copy this link:": "Copiez ce lien\u00a0:",
  "This browser gives no shared memory to this page: it needs https or localhost, and a browser of 2022 or later.":
    "Ce navigateur ne donne pas de mémoire partagée à cette page\u00a0: il faut https ou localhost, et un navigateur de 2022 ou plus récent.",
  "The program has ended. Reload the page to start it again.":
    "Le programme est terminé. Rechargez la page pour le relancer.",
  "The link is damaged: it holds no scene.": "Le lien est abîmé\u00a0: il ne contient pas de scène.",
  "your scene": "votre scène",
};
const isFrench = (navigator.languages || [navigator.language])
  .map((language) => language.slice(0, 2)).find((language) => language === "fr" || language === "en") === "fr";
const say = (words) => (isFrench && FRENCH[words]) || words;
