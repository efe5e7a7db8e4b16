-- What costs time, and what is exact enough.
-- `dioptre view scenes/lessons/09-costs.lua` plays it; Space goes on.

lesson {
  scene = "../box.lua",
  title = { en = "What costs time", fr = "Ce qui prend du temps" },
  size = {800, 600}, samples = 1,
  learnt = {
    { en = "More rays in a pixel make edges smooth. They are needed at edges, hardly elsewhere.",
      fr = "Avec plus de rayons par pixel, les bords sont lisses. Il en faut aux bords, presque pas ailleurs." },
    { en = "What could not change the picture by one step may be left out.",
      fr = "On peut se passer de ce qui ne changerait pas l’image d’un seul niveau de couleur." },
    { en = "Speed and accuracy: ask what the picture needs, then pay for that.",
      fr = "Vitesse et précision : voyez ce que l’image exige, et ne payez que cela." },
  },
}

local most = {
  en = "Where in this picture are most rays spent on a sample?",
  fr = "Où faut-il le plus de rayons par échantillon dans cette image ?",
  choices = {
    { en = "Everywhere alike", fr = "Partout le même nombre" },
    { en = "Where things mirror each other", fr = "Là où les objets se reflètent l’un dans l’autre" },
    { en = "In the dark places", fr = "Dans les endroits sombres" },
  },
  right = 2,
  because = {
    en = "Blue is few rays, yellow is many. A wall takes two; between ball and cube a ray goes to and fro.",
    fr = "Bleu : peu de rayons ; jaune : beaucoup. Un mur en demande deux ; entre la boule et le cube, un rayon va et vient.",
  },
}

zoom(8)
turn(-3, -8)
caption { wait = true,
  en = "One ray per pixel. Look at the edge of the ball: it has steps like stairs.",
  fr = "Un rayon par pixel. Regardez le bord de la boule : il est en marches d’escalier." }

ask {
  en = "We send more rays through other places of each pixel, and take their mean. What happens to the edge?",
  fr = "Envoyons plus de rayons, par d’autres points de chaque pixel, et prenons leur moyenne. Que devient le bord ?",
  choices = {
    { en = "It gets smooth: pixels there get colours between", fr = "Il devient lisse : des couleurs intermédiaires" },
    { en = "The steps get finer: there are more pixels", fr = "Les marches sont plus petites : il y a plus de pixels" },
    { en = "Nothing: the ball has not changed", fr = "Rien : la boule n’a pas changé" },
  },
  right = 1,
  because = {
    en = "There are no more pixels than before. But a pixel of which the ball covers half now gets half of its colour.",
    fr = "Il n’y a pas plus de pixels. Mais un pixel à moitié couvert par la boule prend la moitié de sa couleur." },
}
for i = 1, 4 do
  press "samples twice"
  wait(0.7)
end
explain()
press "home"
caption { wait = true, en = "But more rays cost time. Let us see where they go.",
          fr = "Mais plus de rayons prennent plus de temps. Voyons où ils vont." }

ask(most)
press "layer rays"
wait(1)
caption { wait = true, en = "Ball and cube mirror each other, again and again. A ray may be mirrored 8 times here.",
          fr = "La boule et le cube se reflètent l’un dans l’autre, encore et encore. Ici, un rayon peut être réfléchi 8 fois." }
press "layer light"

ask {
  en = "We allow only 3 times. What will change?",
  fr = "N’en permettons que 3. Qu’est-ce qui va changer ?",
  choices = {
    { en = "The whole picture gets darker", fr = "Toute l’image devient plus sombre" },
    { en = "The mirror images disappear", fr = "Les reflets disparaissent" },
    { en = "So little that nobody sees it", fr = "Si peu que personne ne le voit" },
  },
  right = 3,
  because = {
    en = "On average, each mirroring leaves less than half of the light here. The fourth brings hardly anything.",
    fr = "Ici, chaque réflexion laisse en moyenne moins de la moitié de la lumière. La quatrième n’apporte presque rien." },
}
for i = 1, 5 do press "less deep" end
wait(1)
explain()
press "as at first"
caption { wait = true,
  en = "Numbers cost time, too: float knows 7 digits, double 16, and double takes longer.",
  fr = "Les nombres aussi prennent du temps : float a 7 chiffres, double en a 16, et double est plus lent." }

ask {
  en = "We draw the picture with both. Where do they differ so much that one could see it?",
  fr = "Dessinons l’image avec les deux. Où la différence serait-elle assez grande pour se voir ?",
  choices = {
    { en = "Nearly nowhere", fr = "Presque nulle part" },
    { en = "In all dark places", fr = "Dans tous les endroits sombres" },
    { en = "Everywhere a little", fr = "Un peu partout" },
  },
  right = 1,
  because = {
    en = "The difference of both pictures is blank: no pixel differs, or very few, at edges. Here float is enough.",
    fr = "La différence des deux images est vide : aucun pixel ne diffère, ou très peu, aux bords. Ici, float suffit." },
}
press "split"
press "engine"
press "split"
wait(1)
caption { wait = true, en = "For any scene, the command “dioptre needs” finds out what is enough, and why.",
          fr = "Pour chaque scène, la commande « dioptre needs » trouve ce qui suffit, et dit pourquoi." }
press "as at first"
for i = 1, 4 do press "samples twice" end
ask(most)
press "layer rays"
wait(1)
