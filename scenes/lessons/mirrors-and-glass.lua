-- What mirrors and glass do with a ray.
-- `dioptre view --lesson scenes/lessons/mirrors-and-glass.lua` plays it; Space goes on.

lesson {
  scene = "mirror-and-ball.lua",
  title = { en = "Mirrors and glass", fr = "Miroirs et verre" },
  size = {800, 600}, samples = 4,
}

caption { wait = true,
  en = "A mirror has no colour of its own. It sends the ray on, at the angle at which it came.",
  fr = "Un miroir n'a pas de couleur à lui. Il renvoie le rayon sous l'angle où il est venu." }
caption { wait = true,
  en = "So the picture in the mirror is what an eye behind it would see. It moves when our eye moves.",
  fr = "L'image dans le miroir est donc ce que verrait un œil placé derrière. Elle bouge quand notre œil bouge." }
caption { en = "We go to the left.", fr = "Nous allons à gauche." }
hold("camera left", 0.4)
wait(1)
caption { en = "And to the right: another part of the room is in the mirror.",
          fr = "Et à droite : une autre partie de la pièce est dans le miroir." }
hold("camera right", 0.8)
wait(1)
press "home"

caption { wait = true,
  en = "The mirror shows the backs of the ball and of the cube: sides that we cannot see.",
  fr = "Le miroir montre l'arrière de la boule et du cube : des faces que nous ne voyons pas." }
zoom(5)
turn(-12, -3)
wait(0.5)
caption { wait = true,
  en = "Nothing was copied for that. Only one question was asked again: what does this ray meet?",
  fr = "Rien n'a été copié pour cela. On a seulement posé la même question : que rencontre ce rayon ?" }
press "home"

caption { wait = true,
  en = "Glass lets the ray through, and bends it: where it enters, and where it leaves.",
  fr = "Le verre laisse passer le rayon et le dévie : à l'entrée et à la sortie." }
turn(14, -2)
zoom(5)
wait(0.5)
caption { wait = true,
  en = "So the ball turns what is behind it upside down, and left to right: blue is on the left now.",
  fr = "La boule renverse donc ce qui est derrière : le haut en bas, la gauche à droite. Le bleu est maintenant à gauche." }
caption { wait = true,
  en = "Look at the rim. There the ray comes flat, and glass is a mirror: that is Fresnel's law.",
  fr = "Regardez le bord. Le rayon y arrive rasant, et le verre devient miroir : c'est la loi de Fresnel." }
press "home"
caption { wait = true,
  en = "How often may a ray be mirrored or bent? Eight times, here. Now fewer, one by one.",
  fr = "Combien de fois un rayon peut-il être réfléchi ou dévié ? Huit fois, ici. De moins en moins, maintenant." }
for i = 1, 8 do
  press "less deep"
  wait(0.7)
end
caption { wait = true,
  en = "With none left the mirror and the glass are black: they have nothing of their own to show.",
  fr = "Quand il n'en reste aucune, le miroir et le verre sont noirs : ils n'ont rien à montrer par eux-mêmes." }
press "as at first"
press "layer rays"
caption { wait = true,
  en = "This is how many rays each pixel took: few on the floor, most in the glass.",
  fr = "Voici combien de rayons chaque pixel a demandés : peu sur le sol, le plus dans le verre." }
press "layer light"
caption { wait = true,
  en = "Each ray that is mirrored and bent becomes two. Mirrors and glass are why such pictures take time.",
  fr = "Chaque rayon réfléchi et dévié en devient deux. C'est pour les miroirs et le verre que ces images prennent du temps." }
