// The words of the page in French; English stands in index.html and in the calls of say().
const FRENCH = {
  "scene": "Scène",
  "share": "Copier un lien",
  "hide": "Texte",
  "commands": "Commandes",
  "run": "Lancer",
  "Run": "Lancer",
  "Stop": "Arrêter",
  "command": "Commande",
  "text": "Le texte de la scène\u00a0: ce que vous changez est dessiné aussitôt",
  "The picture of the scene": "L’image de la scène",
  "shapes: %s": "formes\u00a0: %s",
  "mirrors: %d, glass: %d, lights: %d": "miroirs\u00a0: %d, verre\u00a0: %d, lumières\u00a0: %d",
  "the camera is at %s and looks along %s": "la caméra est en %s et regarde selon %s",
  "in its middle is: %s": "en son milieu\u00a0: %s",
  "its middle is sky": "en son milieu, le ciel",
  "it shows the layer %s": "elle montre la couche %s",
  "Lessons": "Leçons",
  "Loading …": "Chargement…",
  "The link is in the clipboard: it carries scene, view, layer and settings.":
    "Le lien est dans le presse-papiers\u00a0: il porte la scène, la vue, le calque et les réglages.",
  "Copy this link:": "Copiez ce lien\u00a0:",
  "This browser cannot run the program: it lacks WebAssembly with SIMD. Browsers of 2023 and later have it.":
    "Ce navigateur ne peut pas exécuter le programme\u00a0: il lui manque WebAssembly avec SIMD, qu’ont les navigateurs depuis 2023.",
  "The program has ended. Reload the page to start it again.":
    "Le programme est terminé. Rechargez la page pour le relancer.",
  "The program has failed. Reload the page to start it again.":
    "Le programme a échoué. Rechargez la page pour le relancer.",
  "The page could not be loaded. Reload it to try again.": "La page n’a pas pu être chargée. Rechargez-la pour réessayer.",
  "The scene is too long for a link. Send its file instead.": "La scène est trop longue pour un lien. Envoyez plutôt son fichier.",
  "The link is refused: it is too long.": "Le lien est refusé\u00a0: il est trop long.",
  "The link is refused: it unpacks to more than 1 MB.": "Le lien est refusé\u00a0: décompressé, il dépasse 1 Mo.",
  "The link is damaged: it holds signs that no link has.": "Le lien est endommagé\u00a0: il contient des signes qu’aucun lien n’a.",
  "The link is damaged: a part of it is missing.": "Le lien est endommagé\u00a0: il en manque une partie.",
  "The link is damaged: it holds no scene.": "Le lien est endommagé\u00a0: il ne contient pas de scène.",
  "The link is damaged: its view is left out.": "Le lien est endommagé\u00a0: sa vue est ignorée.",
  "%d threads, SIMD": "%d fils d’exécution, SIMD",
  "one thread, SIMD": "un seul fil d’exécution, SIMD",
  "Several threads need https or localhost.": "Plusieurs fils demandent https ou localhost.",
  "A page that is one file has one thread.": "Une page d’un seul fichier a un seul fil.",
  "ended with %d": "terminé avec %d",
  "CPU seconds a megapixel": "secondes de processeur par mégapixel",
  "error, rms of linear light": "erreur quadratique moyenne, lumière linéaire",
  "The tables are written. A page has no gnuplot: it draws their charts itself.":
    "Les tableaux sont écrits. Une page n’a pas gnuplot\u00a0: elle trace elle-même leurs graphiques.",
  "largest": "la plus grande",
  "done": "terminé",
  "running …": "en cours…",
};
/** CodeMirror's own words. */
const FRENCH_EDITOR = {
  "Completions": "Propositions", "Diagnostics": "Erreurs", "No diagnostics": "Aucune erreur", "Find": "Chercher", "Replace": "Remplacer",
  "next": "suivant", "previous": "précédent", "all": "tout", "match case": "casse", "by word": "mot entier", "regexp": "expression",
  "replace": "remplacer", "replace all": "tout remplacer", "close": "fermer", "current match": "occurrence", "on line": "à la ligne",
  "replaced match on line $": "remplacé à la ligne $", "replaced $ matches": "$ remplacements", "Go to line": "Aller à la ligne", "go": "aller",
  "Selection deleted": "Sélection effacée", "Control character": "Caractère de contrôle",
};
export const isFrench = (navigator.languages || [navigator.language])
  .map((language) => language.slice(0, 2)).find((language) => language === "fr" || language === "en") === "fr";
export const editorPhrases = isFrench ? FRENCH_EDITOR : {};
export const say = (words) => (isFrench && FRENCH[words]) || words;
/** Translates the elements of a page that have data-text. */
export const translate = () => {
  document.documentElement.lang = isFrench ? "fr" : "en";
  for (const element of document.querySelectorAll("[data-text]")) {
    element.textContent = isFrench ? FRENCH[element.dataset.text] : element.textContent;
  }
};
