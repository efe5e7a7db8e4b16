-- Marching, as report B came to it: a drawing in the plane, space, light, shadow, sky.
-- `dioptre view scenes/lessons/08-marching.lua` plays it; Space goes on.

lesson {
  scene = "marching.lua",
  title = { en = "Marching", fr = "Avancer pas à pas" },
  size = {800, 600}, samples = 4,
  learnt = {
    { en = "A distance function says how far the nearest thing is, in whatever direction.",
      fr = "Une fonction de distance dit à quelle distance est l’objet le plus proche, dans n’importe quelle direction." },
    { en = "So far the ray may go without meeting anything. Then it asks again.",
      fr = "Le rayon peut avancer d’autant sans rien rencontrer. Puis il demande de nouveau." },
    { en = "Near to things the steps are small: rays that pass close to an edge take most.",
      fr = "Près des objets, les pas sont petits : les rayons qui frôlent un bord en font le plus." },
  },
}

local stride = {
  en = "The ray starts at the white point. How far may it go at once, and surely meet nothing?",
  fr = "Le rayon part du point blanc. De combien peut-il avancer d’un coup en étant sûr de ne rien rencontrer ?",
  choices = {
    { en = "A small fixed step", fr = "D’un petit pas fixe" },
    { en = "As far as the nearest thing is, in any direction", fr = "De la distance à l’objet le plus proche, où qu’il soit" },
    { en = "As far as the ball is", fr = "De la distance à la boule" },
  },
  right = 2,
  because = {
    en = "Inside this circle there is nothing. So the ray may go to its edge, wherever it points.",
    fr = "Dans ce cercle, il n’y a rien. Le rayon peut donc aller jusqu’à son bord, quelle que soit sa direction." },
}

caption { wait = true,
  en = "First in the plane: an eye, a ray, a box and a ball. Which of them does the ray meet?",
  fr = "D’abord dans le plan : un œil, un rayon, une boîte et une boule. Lequel des deux le rayon rencontre-t-il ?" }
ask(stride)
press "time on"
wait(0.5)

ask {
  en = "The ray now passes close to the box. How large is its next step?",
  fr = "Le rayon passe maintenant tout près de la boîte. Quelle taille aura son prochain pas ?",
  choices = {
    { en = "Larger", fr = "Plus grand" },
    { en = "As large as the first", fr = "Égal au premier" },
    { en = "Smaller", fr = "Plus petit" },
  },
  right = 3,
  because = {
    en = "The box is near, so the circle is small. It does not matter that the ray will not meet the box.",
    fr = "La boîte est proche, donc le cercle est petit. Peu importe que le rayon ne la rencontre pas." },
}
press "time on"
wait(0.5)
explain()
for i = 3, 9 do
  press "time on"
  wait(0.5)
end
caption { wait = true, en = "Step by step, until the distance is nearly 0: there the ball is met.",
          fr = "Pas à pas, jusqu’à ce que la distance soit presque nulle : la boule est atteinte." }
press "time on"
caption { wait = true, en = "Now in space, with spheres in place of circles: a ray for each pixel.",
          fr = "Maintenant dans l’espace, avec des sphères au lieu de cercles : un rayon par pixel." }

ask {
  en = "Which pixels need most steps?",
  fr = "Quels pixels demandent le plus de pas ?",
  choices = {
    { en = "The middle of the ball", fr = "Le milieu de la boule" },
    { en = "Those just beside the edges of things", fr = "Ceux qui longent le bord des objets" },
    { en = "The background, which is far away", fr = "L’arrière-plan, qui est loin" },
  },
  right = 2,
  because = {
    en = "Bright is many steps. A ray that passes close by a thing makes small steps, as it did beside the box.",
    fr = "Clair : beaucoup de pas. Un rayon qui frôle un objet fait de petits pas, comme à côté de la boîte." },
}
turn(5, 0) -- The ball comes out from under the legend.
press "layer steps"
wait(1)
explain()
press "layer light"
press "home"
caption { wait = true, en = "What is still missing? All is flat: there is no light.",
          fr = "Que manque-t-il encore ? Tout est plat : il n’y a pas de lumière." }
press "time on"
caption { wait = true, en = "A sun. How much a place gets depends on its angle; for the shadow a ray marches to the sun.",
          fr = "Un soleil. Ce qu’un endroit reçoit dépend de l’angle ; pour l’ombre, un rayon avance pas à pas vers le soleil." }
press "time on"
caption { wait = true, en = "And a sky, for the rays that meet nothing. That was the way of report B.",
          fr = "Et un ciel, pour les rayons qui ne rencontrent rien. C’est le chemin qu’a suivi le rapport B." }
for i = 1, 12 do press "time back" end
caption { wait = true, en = "Back to the drawing.", fr = "Retour au dessin." }
ask(stride)
press "time on"
wait(0.5)
