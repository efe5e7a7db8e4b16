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

-- The camera goes around the middle of the mirror, slowly enough for a class to follow.
local function go_around(degrees)
  for i = 1, 20 do
    orbit(degrees / 20, 0, 0, 1.05, -3)
    wait(0.06)
  end
end

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
  en = "Beside us stand two posts: a blue one on the left, a green one on the right. Our eye goes to the left. Which one does the mirror show then?",
  fr = "À côté de nous, deux poteaux : un bleu à gauche, un vert à droite. Notre œil se déplace vers la gauche. Lequel le miroir montre-t-il alors ?",
  choices = {
    { en = "None: the mirror has not moved", fr = "Aucun : le miroir n’a pas bougé" },
    { en = "The blue one, on the left", fr = "Le bleu, à gauche" },
    { en = "The green one, on the right", fr = "Le vert, à droite" },
  },
  right = 3,
  because = {
    en = "A mirror is like a window into a second room: who goes left sees more of its right.",
    fr = "Un miroir est comme une fenêtre sur une seconde pièce : en allant à gauche, on voit mieux sa partie droite." },
}
go_around(25)
wait(0.5)
explain()
go_around(-50)
wait(0.3)
mark(0.383, 0.36)
caption { wait = true,
  en = "And from the right we see the blue post on the left. Let us take the marked pixel, in the middle of its image.",
  fr = "Et depuis la droite, on voit le poteau bleu, à gauche. Prenons le pixel marqué, au milieu de son image." }

ask {
  en = "The ray from the eye through this pixel meets the mirror at a slant. Where does it go then?",
  fr = "Le rayon qui part de l’œil par ce pixel rencontre le miroir en biais. Où va-t-il ensuite ?",
  choices = {
    { en = "Back to the eye", fr = "Il revient vers l’œil" },
    { en = "On, to the other side, at the same angle", fr = "De l’autre côté de la normale, avec le même angle" },
    { en = "Straight out of the mirror", fr = "Perpendiculairement au miroir" },
  },
  right = 2,
  because = {
    en = "Measured from the dashed normal, angle in and angle out are equal. Then, as for each ray: what does it meet? The blue post.",
    fr = "De part et d’autre de la normale, en tirets, les deux angles sont égaux. Puis, comme pour tout rayon : que rencontre-t-il ? Le poteau bleu." },
}
press "shadow rays" -- Here they would only be in the way.
press "rays"
ray(2) -- The mirrored one.
wait(0.5)
explain()
press "rays"
press "shadow rays"
press "home"
press "less deep"
caption { wait = true, en = "Back to our first place, with the mirror switched off.",
          fr = "Revenons au point de départ, avec le miroir qui ne réfléchit pas." }
ask(sides)
press "deeper"
wait(0.5)
