// What the picture shows, in words, for readers of screens: from the facts of src/web/description.c.
import { isFrench, say } from "./words.js";

const list = new Intl.ListFormat(isFrench ? "fr" : "en", { type: "unit", style: "long" });
const number = new Intl.NumberFormat(isFrench ? "fr" : "en", { maximumSignificantDigits: 3 });
const vector = (numbers) => `(${numbers.map((each) => number.format(each)).join(isFrench ? "\u00a0; " : ", ")})`;

/** @return The words. @param name Of the scene. @param facts See src/web/description.c. */
export const describe = (name, facts) => {
  const kinds = Object.entries(facts.shapes).map(([kind, count]) => `${count} ${kind}`);
  const sentences = [
    say("The picture of the scene") + " " + name,
    say("shapes: %s").replace("%s", kinds.length > 0 ? list.format(kinds) : "0"),
    say("mirrors: %d, glass: %d, lights: %d").replace("%d", facts.mirrors).replace("%d", facts.glass).replace("%d", facts.lights),
    say("the camera is at %s and looks along %s").replace("%s", vector(facts.position)).replace("%s", vector(facts.direction)),
    facts.middle ? say("in its middle is: %s").replace("%s", facts.middle) : say("its middle is sky"),
  ];
  facts.layer && sentences.push(say("it shows the layer %s").replace("%s", facts.layer));
  return sentences.join(isFrench ? "\u00a0; " : "; ");
};
