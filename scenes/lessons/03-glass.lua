-- What glass does with a ray: it bends it, and it mirrors a part.
-- `dioptre view scenes/lessons/03-glass.lua` plays it; Space goes on.

lesson {
  scene = "../glass-sphere.lua",
  title = { en = "Glass and Fresnel", fr = "Le verre et Fresnel" },
  size = {800, 600}, samples = 4, depth = 0, -- The ball lets nothing through yet.
  learnt = {
    { en = "Glass bends a ray where it enters, and where it leaves.",
      fr = "Le verre dévie le rayon à l’entrée et à la sortie : c’est la réfraction." },
    { en = "On its way into glass, a ray is bent towards the perpendicular.",
      fr = "En entrant dans le verre, le rayon se rapproche de la normale." },
    { en = "Glass mirrors, too: little where we look straight on it, much where we look flat along it.",
      fr = "Le verre réfléchit aussi : peu si on le regarde de face, beaucoup sous incidence rasante." },
  },
}

local order = {
  en = "Behind the ball stand columns: red, yellow, green, blue from the left. And seen through the ball?",
  fr = "Derrière la boule, des colonnes : de gauche à droite rouge, jaune, verte, bleue. Et à travers la boule ?",
  choices = {
    { en = "The same order, only larger", fr = "Le même ordre, en plus grand" },
    { en = "The other way round: blue is on the left", fr = "L’ordre inverse : la bleue à gauche" },
    { en = "The ball shows only itself", fr = "La boule ne montre qu’elle-même" },
  },
  right = 2,
  because = {
    en = "The rays cross behind the ball. So left and right, top and bottom change places.",
    fr = "Les rayons se croisent derrière la boule. La gauche et la droite sont donc échangées, le haut et le bas aussi." },
}

caption { wait = true,
  en = "A ball of glass. As yet no ray may go through it, so it is dark.",
  fr = "Une boule de verre. Pour l’instant, aucun rayon ne peut la traverser : elle est sombre." }
ask(order)
for i = 1, 8 do press "deeper" end
wait(1)

ask {
  en = "A ray enters the glass at a slant. What happens to its direction?",
  fr = "Un rayon entre en biais dans le verre. Que devient sa direction ?",
  choices = {
    { en = "It goes straight on: glass is clear", fr = "Il va tout droit : le verre est transparent" },
    { en = "It bends towards the perpendicular", fr = "Il se rapproche de la normale" },
    { en = "It bends away from the perpendicular", fr = "Il s’écarte de la normale" },
  },
  right = 2,
  because = {
    en = "Light is slower in glass. The sine of its angle is divided by the index 1.5; on its way out it is multiplied by it.",
    fr = "La lumière est plus lente dans le verre. À l’entrée, le sinus de l’angle est divisé par l’indice 1,5 ; à la sortie, il est multiplié par 1,5." },
}
pixel(0.6, 0.4)
wait(0.5)
explain()
press "rays"
caption { wait = true, en = "Back to the picture.", fr = "Retour à l’image." }

ask {
  en = "Glass also mirrors a part of the light. Where is that part largest?",
  fr = "Le verre réfléchit aussi une partie de la lumière. Où cette partie est-elle la plus grande ?",
  choices = {
    { en = "In the middle of the ball", fr = "Au centre de la boule" },
    { en = "At its rim", fr = "Sur son bord" },
    { en = "Everywhere the same", fr = "La même partout" },
  },
  right = 2,
  because = {
    en = "In the middle 4 % are mirrored. At the rim the ray comes flat, and nearly all is: that is Fresnel's law.",
    fr = "Au centre, 4 % de la lumière est réfléchie. Au bord, le rayon est rasant et presque tout est réfléchi : ce sont les formules de Fresnel." },
}
turn(12, 0)
zoom(12)
wait(1)
caption { wait = true, en = "You know it from a lake: clear at your feet, a mirror far away.",
          fr = "C’est comme un lac : transparent à vos pieds, miroir au loin." }
press "home"
for i = 1, 8 do press "less deep" end
ask(order)
for i = 1, 8 do press "deeper" end
wait(1)
