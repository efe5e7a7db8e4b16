-- What a mirror does with a ray, and where its image is.
-- `dioptre view scenes/lessons/02-mirrors.lua` plays it; Space goes on.

lesson {
  scene = "mirror-and-ball.lua",
  title = { en = "Mirrors", fr = "Les miroirs" },
  size = {800, 600}, samples = 4, depth = 0, -- The mirror shows nothing yet.
  learnt = {
    { en = "A mirror sends a ray on at the angle at which it came.",
      fr = "Sur un miroir, l’angle de réflexion est égal à l’angle d’incidence." },
    { en = "It does not swap left and right: it swaps front and back.",
      fr = "Un miroir n’échange pas la gauche et la droite : il échange l’avant et l’arrière." },
    { en = "What we see in it depends on where our eye is.",
      fr = "Ce qu’on y voit dépend de la position de notre œil." },
  },
}

local sides = {
  en = "The cube stands to the right of the ball. And in the mirror?",
  fr = "Le cube est à droite de la boule. Et dans le miroir ?",
  choices = {
    { en = "To the left of the ball", fr = "À gauche de la boule" },
    { en = "To the right of the ball", fr = "À droite de la boule" },
    { en = "Upside down", fr = "À l’envers, la tête en bas" },
  },
  right = 2,
  because = {
    en = "What is on the right stays on the right. But the mirror shows the backs: front and back are swapped.",
    fr = "Ce qui est à droite reste à droite. Mais le miroir montre l’arrière des objets : c’est l’avant et l’arrière qui s’échangent." },
}

-- Our place before the mirror.
local function look()
  turn(-11, -3)
  zoom(5)
end

speed(0.25) -- Slowly, so that a class can follow.
look()
caption { wait = true,
  en = "A ball, a cube, and a mirror in a frame. The mirror is still switched off: it sends no ray on.",
  fr = "Une boule, un cube et un miroir encadré. Le miroir ne réfléchit pas encore : il ne renvoie aucun rayon." }
ask(sides)
press "deeper"
wait(0.5)
caption { wait = true,
  en = "We see sides of ball and cube that are turned away from us. Nothing was copied for that.",
  fr = "On voit les faces de la boule et du cube qui nous sont cachées. Pourtant, aucun objet n’a été copié." }

ask {
  en = "A ray from the eye meets the mirror at a slant. Where does it go then?",
  fr = "Un rayon venu de l’œil rencontre le miroir en biais. Où va-t-il ensuite ?",
  choices = {
    { en = "Back to the eye", fr = "Il revient vers l’œil" },
    { en = "On, to the other side, at the same angle", fr = "De l’autre côté de la normale, avec le même angle" },
    { en = "Straight out of the mirror", fr = "Perpendiculairement au miroir" },
  },
  right = 2,
  because = {
    en = "Angle in and angle out are equal. Then comes the same question as for each ray: what does it meet?",
    fr = "L’angle de réflexion est égal à l’angle d’incidence. Puis, la même question que pour tout rayon : que rencontre-t-il ?" },
}
pixel(0.5, 0.35)
wait(0.5)
explain()
press "rays"
caption { wait = true, en = "Back to the picture.", fr = "Retour à l’image." }

ask {
  en = "Our eye goes to the left. Which part of the room does the mirror show then?",
  fr = "Notre œil se déplace vers la gauche. Quelle partie de la pièce le miroir montre-t-il alors ?",
  choices = {
    { en = "The same part: the mirror has not moved", fr = "La même : le miroir n’a pas bougé" },
    { en = "More of what is on the left", fr = "Davantage de ce qui est à gauche" },
    { en = "More of what is on the right", fr = "Davantage de ce qui est à droite" },
  },
  right = 3,
  because = {
    en = "A mirror is like a window into a second room: who goes left sees more of its right.",
    fr = "Un miroir est comme une fenêtre sur une seconde pièce : en allant à gauche, on voit mieux sa partie droite." },
}
hold("camera left", 1.2)
wait(1)
explain()
hold("camera right", 2.4)
wait(0.3)
caption { wait = true, en = "And from the right we see more of what is on the left.",
          fr = "Et depuis la droite, on voit mieux ce qui est à gauche." }
press "home"
press "less deep"
look()
ask(sides)
press "deeper"
wait(0.5)
