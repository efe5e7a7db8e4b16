-- What a shadow is, and why one can be full of black points.
-- `dioptre view --lesson scenes/lessons/shadows-and-acne.lua` plays it; Space goes on.

lesson {
  scene = "../figure-c4.lua",
  title = { en = "Shadows and acne", fr = "Ombres et acné" },
  size = {800, 600}, samples = 4,
}

caption { wait = true,
  en = "From the eye a ray goes through each pixel. Where it meets something, we ask: does light come here?",
  fr = "De l'œil part un rayon par pixel. Là où il rencontre quelque chose, on demande : la lumière arrive-t-elle ici ?" }
caption { wait = true,
  en = "To know, a second ray goes from that point to the lamp: the shadow ray.",
  fr = "Pour le savoir, un second rayon va de ce point à la lampe : le rayon d'ombre." }
caption { wait = true,
  en = "If anything blocks it, the point is in shadow. A shadow is not drawn: it is where a ray did not get through.",
  fr = "Si quelque chose l'arrête, le point est à l'ombre. On ne dessine pas une ombre : c'est là qu'un rayon n'est pas passé." }

caption { en = "The lamp goes to the left: the shadows go to the right.",
          fr = "La lampe va à gauche : les ombres vont à droite." }
hold("light left", 0.5)
wait(1)
caption { en = "The lamp goes down: the shadows get longer.",
          fr = "La lampe descend : les ombres s'allongent." }
hold("light down", 0.25)
wait(1)
caption { en = "The lamp goes back, away from us: the shadows come forward.",
          fr = "La lampe recule, loin de nous : les ombres viennent en avant." }
hold("light away", 0.15)
wait(1)
caption { wait = true,
  en = "The edge of the shadow is sharp, because the lamp is a point. Real lamps are not.",
  fr = "Le bord de l'ombre est net, car la lampe est un point. Les vraies lampes n'en sont pas." }
press "home"

caption { wait = true,
  en = "Does the eye change the shadow? Watch it while the camera moves.",
  fr = "L'œil change-t-il l'ombre ? Regardez-la pendant que la caméra bouge." }
hold("camera right", 0.3)
wait(0.3)
hold("camera up", 0.2)
wait(0.5)
caption { wait = true,
  en = "No. It stays where it is: only the lamp and the things make it.",
  fr = "Non. Elle reste où elle est : seules la lampe et les choses la font." }
press "home"
caption { wait = true,
  en = "Now the shadow rays start at the very surface. Rounding puts some a little below it: they meet it, and the point is black.",
  fr = "Maintenant les rayons d'ombre partent de la surface même. L'arrondi en met un peu dessous : ils la rencontrent, et le point est noir." }
press "offset" -- bound, the default, gives way to none.
wait(2)
caption { wait = true,
  en = "That is shadow acne. It is no noise: the same places are rounded the same way each time.",
  fr = "C'est l'acné des ombres. Ce n'est pas du hasard : les mêmes endroits s'arrondissent toujours de même." }
press "layer acne"
caption { wait = true,
  en = "The program can say which pixels are wrong: those whose shadow ray met its own surface.",
  fr = "Le programme sait dire quels pixels sont faux : ceux dont le rayon d'ombre a rencontré sa propre surface." }
press "layer light"
press "offset" -- fixed
caption { wait = true,
  en = "The usual cure: start a fixed length away, epsilon, here a ten-thousandth. The points are gone.",
  fr = "Le remède habituel : partir à une longueur fixe, epsilon, ici un dix-millième. Les points ont disparu." }
caption { en = "But which length? Ten times as long, and ten times again ...",
          fr = "Mais quelle longueur ? Dix fois plus, et dix fois encore..." }
for i = 1, 4 do
  wait(1)
  press "epsilon ten times"
end
caption { wait = true,
  en = "Too long: the shadow comes off the ball, and light gets in where none should be.",
  fr = "Trop long : l'ombre se détache de la boule, et la lumière entre où il ne devrait pas y en avoir." }
press "as at first"
caption { wait = true,
  en = "So the program starts each ray as far away as the rounding of that very point can reach: no further, and no less.",
  fr = "Le programme fait donc partir chaque rayon aussi loin que peut aller l'arrondi de ce point-là : ni plus, ni moins." }
