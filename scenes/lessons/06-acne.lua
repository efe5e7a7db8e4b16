-- Why a picture can be full of black points, and how far away a ray must start.
-- `dioptre view scenes/lessons/06-acne.lua` plays it; Space goes on.

lesson {
  scene = "../figure-c4.lua",
  title = { en = "Numbers and acne", fr = "Les nombres et l’acné" },
  size = {800, 600}, samples = 4,
  learnt = {
    { en = "A computer rounds its numbers: a point lies a little beside the surface.",
      fr = "L’ordinateur arrondit ses nombres : un point calculé se trouve un peu à côté de la surface." },
    { en = "A ray that starts at such a point may meet the surface that it leaves: acne.",
      fr = "Un rayon qui part d’un tel point peut rencontrer la surface qu’il quitte : c’est l’acné." },
    { en = "The cure is to start a little away: too little leaves acne, too much makes light leak.",
      fr = "Le remède : partir un peu plus loin. Pas assez, et l’acné reste ; trop, et la lumière fuit." },
  },
}

local acne = {
  en = "Let the shadow rays start exactly at the surface, with no distance at all. What will we see?",
  fr = "Faisons partir les rayons d’ombre exactement de la surface, sans aucun décalage. Que verra-t-on ?",
  choices = {
    { en = "The same picture", fr = "La même image" },
    { en = "Shadow where there should be light", fr = "De l’ombre là où il devrait y avoir de la lumière" },
    { en = "All shadows disappear", fr = "Toutes les ombres disparaissent" },
  },
  right = 2,
  because = {
    en = "Rounding puts some points a little below the surface. Their shadow ray meets that surface at once.",
    fr = "L’arrondi met certains points un peu sous la surface. Leur rayon d’ombre la rencontre aussitôt." },
}

caption { wait = true,
  en = "Each point's shadow ray starts a tiny bit above the surface. Why should it?",
  fr = "Chaque rayon d’ombre part un tout petit peu au-dessus de la surface. Pourquoi ?" }
ask(acne)
press "offset" -- bound, the default, gives way to none.
wait(1)

ask {
  en = "We draw the same picture again. Where will the dark points be?",
  fr = "Dessinons encore une fois la même image. Où seront les points sombres ?",
  choices = {
    { en = "At other places: it is chance", fr = "Ailleurs : c’est le hasard" },
    { en = "At the very same places", fr = "Exactement aux mêmes endroits" },
    { en = "There will be fewer", fr = "Il y en aura moins" },
  },
  right = 2,
  because = {
    en = "Rounding is no chance: the same sum is rounded in the same way, today and tomorrow.",
    fr = "L’arrondi n’est pas dû au hasard : le même calcul s’arrondit toujours de la même façon." },
}
press "layer normals"
wait(0.7)
press "layer light"
wait(1)
explain()
press "layer acne"
caption { wait = true,
  en = "This layer marks each pixel whose shadow ray has met its own surface, and counts them.",
  fr = "Ce calque marque chaque pixel dont le rayon d’ombre a rencontré sa propre surface, et les compte." }
press "layer light"
press "offset" -- fixed
caption { wait = true,
  en = "The usual cure: start at a fixed distance, epsilon. Here it is a ten-thousandth.",
  fr = "Le remède habituel : partir à une distance fixe, epsilon. Ici, un dix-millième." }

ask {
  en = "Then more must be better! What if epsilon is ten thousand times as large?",
  fr = "Alors, plus c’est grand, mieux c’est ! Et si epsilon est dix mille fois plus grand ?",
  choices = {
    { en = "The picture stays good", fr = "L’image reste bonne" },
    { en = "The acne comes back", fr = "L’acné revient" },
    { en = "Shadows come off, light gets in where none should be",
      fr = "Les ombres se décollent, la lumière passe là où il ne faut pas" },
  },
  right = 3,
  because = {
    en = "The rays now start so far away that they miss what is near: the shadow comes off the ball.",
    fr = "Les rayons partent maintenant si loin qu’ils manquent ce qui est tout près : l’ombre se détache de la boule." },
}
for i = 1, 4 do
  press "epsilon ten times"
  wait(0.7)
end
explain()
press "as at first" -- The offset is bound again.
caption { wait = true,
  en = "So this program computes for each point how far rounding can reach, and starts there: no further, no less.",
  fr = "Ce programme calcule donc, pour chaque point, jusqu’où peut aller l’arrondi, et part de là : ni plus loin, ni plus près." }
ask(acne)
press "offset"
wait(1)
