-- The colour that we see: colour of the light times colour of the surface.
-- `dioptre view scenes/lessons/04-colours.lua` plays it; Space goes on.

lesson {
  scene = "colours.lua",
  title = { en = "Colour of light, colour of things", fr = "Couleur de la lumière, couleur des objets" },
  size = {800, 600}, samples = 4,
  learnt = {
    { en = "A thing gives back a part of the light that it gets. It adds nothing.",
      fr = "Un objet renvoie une partie de la lumière qu’il reçoit. Il n’ajoute rien." },
    { en = "The program multiplies, colour by colour: light times surface.",
      fr = "Le programme multiplie, couleur par couleur, la lumière par la surface." },
    { en = "Lights add up: red and green make yellow; red, green and blue make white.",
      fr = "Les lumières s’ajoutent : rouge et vert font jaune ; rouge, vert et bleu font blanc." },
  },
}

local green = {
  en = "The white lamp becomes a red one. How will the green ball look?",
  fr = "La lampe blanche devient rouge. De quelle couleur paraîtra la boule verte ?",
  choices = {
    { en = "Green, as before", fr = "Verte, comme avant" },
    { en = "Red", fr = "Rouge" },
    { en = "Black", fr = "Noire" },
    { en = "Brown: a mixture of red and green", fr = "Marron : un mélange de rouge et de vert" },
  },
  right = 3,
  because = {
    en = "The green ball gives back green light only, and here there is none: red 1 x 0, green 0 x 1, blue 0 x 0.",
    fr = "La boule verte ne renvoie que du vert, et il n’y en a pas : rouge 1 × 0, vert 0 × 1, bleu 0 × 0." },
}

caption { wait = true,
  en = "On the floor five balls: red, green, blue, yellow, white. A white one hangs before the white wall. One white lamp, nothing else.",
  fr = "Au sol, cinq boules : rouge, verte, bleue, jaune, blanche. Une boule blanche est suspendue devant le mur blanc. Une seule lampe, blanche." }
ask(green)
press "time on"
wait(1)
caption { wait = true,
  en = "White and yellow give back red as well as red itself does: here all these balls look alike.",
  fr = "Le blanc et le jaune renvoient le rouge aussi bien que le rouge lui-même : ici, toutes ces boules ont la même couleur." }

ask {
  en = "A green lamp joins the red one. Which colour has the white wall where both shine?",
  fr = "Une lampe verte s’ajoute à la rouge. De quelle couleur est le mur blanc là où les deux éclairent ?",
  choices = {
    { en = "Brown, as with paint", fr = "Marron, comme avec la peinture" },
    { en = "Yellow", fr = "Jaune" },
    { en = "White", fr = "Blanc" },
  },
  right = 2,
  because = {
    en = "Lights add up: red and green give yellow. Paints take light away, so mixing them is another thing.",
    fr = "Les lumières s’ajoutent : rouge et vert donnent jaune. Les peintures, elles, absorbent de la lumière : c’est la synthèse soustractive." },
}
press "time on"
wait(1)
caption { wait = true,
  en = "Two lamps, two shadows on the wall. In each only the other lamp's colour is left.",
  fr = "Deux lampes, deux ombres sur le mur. Dans chacune, il ne reste que la couleur de l’autre lampe." }

ask {
  en = "A blue lamp joins. Which colour has the shadow in which only the red light is missing?",
  fr = "Une lampe bleue s’ajoute. De quelle couleur est l’ombre où seule la lumière rouge manque ?",
  choices = {
    { en = "Grey", fr = "Grise" },
    { en = "Red", fr = "Rouge" },
    { en = "Blue-green", fr = "Cyan (bleu-vert)" },
  },
  right = 3,
  because = {
    en = "Green and blue are left: cyan. The red lamp is on the left, so its shadow is the one on the right.",
    fr = "Il reste le vert et le bleu : du cyan. La lampe rouge est à gauche ; son ombre est donc celle de droite." },
}
press "time on"
wait(1)
caption { wait = true,
  en = "And where all three shine, the wall is nearly white. All colours of your screen are made so.",
  fr = "Et là où les trois éclairent, le mur est presque blanc. Votre écran fait toutes ses couleurs ainsi : c’est la synthèse additive." }
press "time back"
press "time back"
press "time back"
ask(green)
press "time on"
wait(1)
