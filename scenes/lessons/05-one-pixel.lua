-- The rays of one pixel: from the eye to a thing, from there to the lamp, and on.
-- `dioptre view scenes/lessons/05-one-pixel.lua` plays it; Space goes on.

lesson {
  scene = "../box.lua",
  title = { en = "The rays of one pixel", fr = "Les rayons d’un pixel" },
  size = {800, 600}, samples = 1, -- One ray per pixel, as it says.
  learnt = {
    { en = "The rays start at the eye, against the way of the light.",
      fr = "Les rayons partent de l’œil, en sens inverse de la lumière." },
    { en = "Where a ray meets something, a shadow ray asks for each lamp: does its light come here?",
      fr = "Là où un rayon rencontre un objet, un rayon d’ombre vérifie, pour chaque lampe, si sa lumière arrive ici." },
    { en = "A surface that mirrors sends one more ray on its way.",
      fr = "Une surface réfléchissante fait partir un rayon de plus." },
  },
}

local first = {
  en = "To find the colour of a pixel: where does the program start its first ray?",
  fr = "Pour trouver la couleur d’un pixel : d’où le programme fait-il partir son premier rayon ?",
  choices = {
    { en = "At the lamp", fr = "De la lampe" },
    { en = "At the eye", fr = "De l’œil" },
    { en = "At the thing that we see", fr = "De l’objet que l’on voit" },
  },
  right = 2,
  because = {
    en = "Of the lamp's light hardly any meets the eye. From the eye, each ray counts.",
    fr = "Seule une infime partie de la lumière de la lampe atteint l’œil. En partant de l’œil, aucun rayon n’est perdu." },
}

mark(0.55, 0.92)
caption { wait = true,
  en = "Each pixel of the picture gets one colour. Let us take one of them: the marked one, on the floor in front.",
  fr = "Chaque pixel de l’image reçoit une couleur. Prenons-en un seul : celui qui est marqué, sur le sol, devant." }
ask(first)
press "rays"
wait(0.5)
caption { wait = true,
  en = "A second camera shows the box from another side. The ray from the eye, ray 0, meets the floor.",
  fr = "Une seconde caméra montre la boîte d’un autre côté. Le rayon venu de l’œil, le rayon 0, rencontre le sol." }
press "rays"
mark(0.55, 0.92)

ask {
  en = "The floor is matt, and there is one lamp. How many rays does this pixel need in all?",
  fr = "Le sol est mat, et il y a une seule lampe. Combien de rayons faut-il en tout pour ce pixel ?",
  choices = { { en = "One", fr = "Un seul" }, { en = "Two", fr = "Deux" }, { en = "Three", fr = "Trois" },
              { en = "As many as there are things", fr = "Autant que d’objets" } },
  right = 2,
  because = {
    en = "Two: ray 0 from the eye to the floor, and ray 1, the shadow ray, from the floor to the lamp.",
    fr = "Deux : le rayon 0, de l’œil au sol, et le rayon 1, le rayon d’ombre, du sol à la lampe." },
}
press "rays"
ray(1) -- The shadow ray.
wait(0.5)
explain()
press "rays"
mark(0.4375, 0.7667)
caption { wait = true, en = "Now a pixel of the red ball. It shines: it mirrors a part of the light.",
          fr = "Maintenant, un pixel de la boule rouge. Elle est brillante : elle réfléchit une partie de la lumière." }

ask {
  en = "The ray from the eye meets the red ball. Which rays start there?",
  fr = "Le rayon venu de l’œil rencontre la boule rouge. Quels rayons partent de là ?",
  choices = {
    { en = "Only a shadow ray", fr = "Seulement un rayon d’ombre" },
    { en = "Only a mirrored ray", fr = "Seulement un rayon réfléchi" },
    { en = "Both", fr = "Les deux" },
  },
  right = 3,
  because = {
    en = "Its colour is a sum: its own red in the lamp's light, and a share of what the mirrored ray finds.",
    fr = "Sa couleur est une somme : son propre rouge, éclairé par la lampe, et une part de ce que trouve le rayon réfléchi." },
}
press "rays"
wait(0.5)
press "ray on"
wait(1)
press "ray on"
caption { wait = true,
  en = "The mirrored ray does as the first one did: it meets something, and asks for the lamp.",
  fr = "Le rayon réfléchi fait comme le premier : il rencontre un objet, et vérifie si la lampe l’éclaire." }
press "rays"

ask {
  en = "Where in this picture are most rays needed?",
  fr = "Où faut-il le plus de rayons dans cette image ?",
  choices = {
    { en = "In the shadows", fr = "Dans les ombres" },
    { en = "On the walls", fr = "Sur les murs" },
    { en = "On the ball and the cube", fr = "Sur la boule et le cube" },
  },
  right = 3,
  because = {
    en = "Yellow is much, blue is little. Ball and cube mirror each other, so rays go to and fro between them.",
    fr = "Jaune : beaucoup ; bleu : peu. La boule et le cube se reflètent l’un dans l’autre : les rayons vont et viennent entre eux." },
}
press "layer rays"
wait(1)
