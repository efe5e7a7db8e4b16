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

-- How often rays are mirrored and refracted; 0: as the lesson begins.
local depth = 0
local function set_depth(wanted)
  for i = depth + 1, wanted do press "deeper" end
  for i = wanted + 1, depth do press "less deep" end
  depth = wanted
end

caption { wait = true,
  en = "A ball of glass. As yet no ray may go through it, so it is dark.",
  fr = "Une boule de verre. Pour l’instant, aucun rayon ne peut la traverser : elle est sombre." }
ask(order)
set_depth(8)
wait(1)
explain()

mark(0.63, 0.46)
ask {
  en = "The ray of the marked pixel enters the glass at a slant. What happens to its direction?",
  fr = "Le rayon du pixel marqué entre en biais dans le verre. Que devient sa direction ?",
  choices = {
    { en = "It goes straight on: glass is clear", fr = "Il va tout droit : le verre est transparent" },
    { en = "It bends towards the perpendicular", fr = "Il se rapproche de la normale" },
    { en = "It bends away from the perpendicular", fr = "Il s’écarte de la normale" },
  },
  right = 2,
  because = {
    en = "Towards the dashed perpendicular: light is slower in glass. The sine of its angle is divided by the index 1.5; on its way out it is multiplied by it.",
    fr = "Il se rapproche de la normale, en tirets : la lumière est plus lente dans le verre. À l’entrée, le sinus de l’angle est divisé par l’indice 1,5 ; à la sortie, il est multiplié par 1,5." },
}
-- Only the path through the ball: neither shadow rays nor what glass mirrors.
set_depth(2)
press "shadow rays"
press "mirrored rays"
press "rays"
ray(4) -- In the glass.
zoom(9)
wait(0.5)
explain()
press "rays"
press "mirrored rays"
press "shadow rays"
set_depth(8)
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
    en = "In the middle it is about 4 %. Near the rim, where the ray comes flat, it is many times that, as the first line says; at the very edge nearly all. That is Fresnel's law.",
    fr = "Au centre, c’est environ 4 %. Près du bord, le rayon est rasant et c’est bien davantage, comme le dit la première ligne ; tout au bord, presque tout est réfléchi : ce sont les formules de Fresnel." },
}
set_depth(2)
press "shadow rays"
pixel(0.5, 0.46)
wait(3)
pixel(0.75, 0.46)
wait(1)
explain()
press "rays"
press "shadow rays"
set_depth(8)
turn(12, 0)
zoom(12)
wait(0.5)
caption { wait = true, en = "You know it from a lake: clear at your feet, a mirror far away.",
          fr = "C’est comme un lac : transparent à vos pieds, miroir au loin." }
press "home"
set_depth(0)
ask(order)
set_depth(8)
wait(1)
