-- What a shadow is, and what decides where it lies.
-- `dioptre view scenes/lessons/01-shadows.lua` plays it; Space goes on.

lesson {
  scene = "../figure-c4.lua",
  title = { en = "Shadows", fr = "Les ombres" },
  size = {800, 600}, samples = 4,
  learnt = {
    { en = "A shadow is where something stands between the surface and the lamp. Nobody draws it.",
      fr = "Il y a de l’ombre là où un objet se trouve entre la surface et la lampe. Personne ne la dessine." },
    { en = "The lamp and the things decide where it lies. The eye does not.",
      fr = "La lampe et les objets décident de la place de l’ombre. L’œil n’y change rien." },
    { en = "The lower the lamp, the longer the shadow.",
      fr = "Plus la lampe est basse, plus l’ombre est longue." },
  },
}

local eye = {
  en = "The camera goes to the right. What does the ball's shadow do on the floor?",
  fr = "La caméra se déplace vers la droite. Que fait l’ombre de la boule sur le sol ?",
  choices = {
    { en = "It goes to the right, too", fr = "Elle va aussi vers la droite" },
    { en = "It goes to the left", fr = "Elle va vers la gauche" },
    { en = "It stays at its place", fr = "Elle ne bouge pas" },
  },
  right = 3,
  because = {
    en = "Lamp and ball have not moved: the same places of the floor lack light. Only our view of them is another.",
    fr = "Ni la lampe ni la boule n’ont bougé : ce sont les mêmes endroits du sol qui manquent de lumière. Seul notre point de vue a changé." },
}

speed(0.25) -- Slowly, so that a class can follow.
caption { wait = true,
  en = "A ball, a sheet, and one lamp, which is above us to the right. Where light is missing, there is shadow.",
  fr = "Une boule, une feuille et une seule lampe, au-dessus de nous à droite. Là où la lumière manque, il y a de l’ombre." }

ask(eye)
hold("camera right", 0.56)
wait(0.3)
hold("camera up", 0.4)
wait(0.3)
explain()
press "home"
caption { wait = true, en = "Back to our first place.", fr = "Revenons au point de départ." }

ask {
  en = "Now the lamp goes to the left. Where does the shadow of the ball go?",
  fr = "Maintenant, c’est la lampe qui va vers la gauche. Où va l’ombre de la boule ?",
  choices = {
    { en = "To the left, with the lamp", fr = "À gauche, avec la lampe" },
    { en = "To the right, away from the lamp", fr = "À droite, à l’opposé de la lampe" },
    { en = "Nowhere: the ball has not moved", fr = "Nulle part : la boule n’a pas bougé" },
  },
  right = 2,
  because = {
    en = "The shadow lies behind the ball, seen from the lamp. When the lamp goes left, behind is on the right.",
    fr = "Vue de la lampe, l’ombre est derrière la boule. Quand la lampe va à gauche, « derrière » passe à droite." },
}
hold("light left", 2)
wait(0.5)

ask {
  en = "The lamp goes down. What happens to the shadow?",
  fr = "La lampe descend. Que devient l’ombre ?",
  choices = {
    { en = "It gets shorter", fr = "Elle raccourcit" },
    { en = "It gets longer", fr = "Elle s’allonge" },
    { en = "It gets darker, and keeps its length", fr = "Elle s’assombrit, sans changer de longueur" },
  },
  right = 2,
  because = {
    en = "Light that comes flat meets the floor far behind the ball: as in the evening, when the sun is low.",
    fr = "La lumière rasante ne retrouve le sol que loin derrière la boule : comme le soir, quand le soleil est bas." },
}
hold("light down", 1)
wait(0.5)
explain()
press "home"
mark(0.06, 0.72)
caption { wait = true, en = "Everything as at first. Let us look at one place of the floor: the marked one.",
          fr = "Tout est remis comme au début. Regardons maintenant un seul endroit du sol, celui qui est marqué." }

ask {
  en = "How does the program know that this place is in shadow?",
  fr = "Comment le programme sait-il que cet endroit est à l’ombre ?",
  choices = {
    { en = "It stretches the outline of the ball over the floor", fr = "Il étale le contour de la boule sur le sol" },
    { en = "It asks whether the way to the lamp is free", fr = "Il vérifie si le chemin vers la lampe est libre" },
    { en = "Somebody has painted it", fr = "Quelqu’un l’a peint" },
  },
  right = 2,
  because = {
    en = "From that place a ray goes towards the lamp, the yellow point: the shadow ray. Here the ball is in its way.",
    fr = "De cet endroit part un rayon vers la lampe, le point jaune : c’est le rayon d’ombre. Ici, la boule lui barre le chemin." },
}
press "rays"
ray(1) -- The shadow ray.
wait(0.5)
explain()
pixel(0.6, 0.9)
ray(1)
caption { wait = true,
  en = "And here, in the light, the way is free. So the lamp's light counts for this pixel.",
  fr = "Et ici, en pleine lumière, le chemin est libre. La lumière de la lampe compte donc pour ce pixel." }
press "rays"

ask(eye)
hold("camera right", 0.56)
wait(0.3)
hold("camera up", 0.4)
