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
  en = "To be seen with --offset none: shadow rays that start at the very surface meet it again. Lit walls get black points.",
  fr = "À voir avec --offset none : des rayons d'ombre partis de la surface même la rencontrent. Les murs éclairés se couvrent de points noirs." }
