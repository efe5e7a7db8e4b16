-- What is fast, what is exact, and how much of each is enough.
-- `dioptre view --lesson scenes/lessons/speed-and-accuracy.lua` plays it; Space goes on.

lesson {
  scene = "../box.lua",
  title = { en = "Speed and accuracy", fr = "Vitesse et précision" },
  size = {800, 600}, samples = 16,
}

caption { wait = true,
  en = "The title of the window counts: milliseconds for this picture, and millions of rays a second.",
  fr = "Le titre de la fenêtre compte : les millisecondes pour cette image, et les millions de rayons par seconde." }
caption { wait = true,
  en = "While something moves, one ray a pixel must do. Watch the edges: they look like stairs.",
  fr = "Pendant un mouvement, un rayon par pixel doit suffire. Regardez les bords : on dirait des escaliers." }
hold("camera right", 0.3)
caption { wait = true,
  en = "Then more rays a pixel come, each through another place of it. Their mean makes the edges smooth.",
  fr = "Puis viennent d'autres rayons par pixel, chacun par un autre endroit. Leur moyenne rend les bords lisses." }
caption { wait = true,
  en = "Four times as many rays take about four times as long, but leave more than a quarter of the error. That is expensive.",
  fr = "Quatre fois plus de rayons prennent environ quatre fois plus de temps, mais laissent plus d'un quart de l'erreur. Le gain coûte cher." }
press "home"
caption { wait = true,
  en = "So pixels without an edge get few rays, and those on one get many: nobody sees the difference, and the clock does.",
  fr = "Les pixels sans bord reçoivent donc peu de rayons, et ceux d'un bord beaucoup : personne ne voit la différence, l'horloge si." }
zoom(8)
turn(-3, -8)
wait(0.5)
caption { wait = true,
  en = "The ball mirrors the cube, which mirrors the ball, and so on. Each time less light is left.",
  fr = "La boule reflète le cube, qui reflète la boule, et ainsi de suite. À chaque fois il reste moins de lumière." }
caption { wait = true,
  en = "When what is left could not change the picture by one step of 255, we stop. That is exact enough, and no slower.",
  fr = "Quand le reste ne peut plus changer l'image d'un pas sur 255, on s'arrête. C'est assez exact, et pas plus lent." }
press "home"
press "split"
press "engine"
caption { wait = true,
  en = "Numbers have an end, too. One half of this picture was made with float, 7 digits, the other with double, 16. Which?",
  fr = "Les nombres aussi ont une fin. Une moitié de cette image est faite en float, 7 chiffres, l'autre en double, 16. Laquelle ?" }
press "split"
caption { wait = true,
  en = "The difference of the two: blank, but for a few points on edges. Double takes more time for that.",
  fr = "La différence des deux : rien, sauf quelques points sur des bords. Pour cela, double prend plus de temps." }
press "split"
press "as at first"
caption { wait = true,
  en = "Here float is enough. `dioptre needs` finds out for any scene: why, and how much time double would take.",
  fr = "Ici, float suffit. `dioptre needs` le découvre pour toute scène : pourquoi, et combien de temps prendrait double." }
