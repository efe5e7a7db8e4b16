-- Depth: a ray that is mirrored asks the same question again, and must stop some day.
-- `dioptre view scenes/lessons/07-depth.lua` plays it; Space goes on.

lesson {
  scene = "../facing-mirrors.lua",
  title = { en = "Depth and recursion", fr = "La profondeur et la récursivité" },
  size = {800, 600}, samples = 4, depth = 0,
  learnt = {
    { en = "Recursion: to know what a ray sees, the program asks what the next ray sees.",
      fr = "Récursivité : pour savoir ce que voit un rayon, le programme demande ce que voit le suivant." },
    { en = "The depth says how often. Without an end, two mirrors would never be done.",
      fr = "La profondeur dit combien de fois. Sans limite, entre deux miroirs, le calcul ne finirait jamais." },
    { en = "Each mirror keeps a part of the light, so what is very deep hardly counts.",
      fr = "Chaque miroir absorbe une part de la lumière : ce qui est très profond ne compte presque plus." },
  },
}

local second = {
  en = "Behind us hangs a second mirror. A ray may now be mirrored once. What will be in the mirror?",
  fr = "Un second miroir est accroché derrière nous. Un rayon peut être réfléchi une fois. Que verra-t-on dans le miroir ?",
  choices = {
    { en = "Still nothing", fr = "Toujours rien" },
    { en = "The room, and in it a black mirror", fr = "La pièce, et dans celle-ci un miroir noir" },
    { en = "Rooms without end", fr = "Des pièces à l’infini" },
  },
  right = 2,
  because = {
    en = "The ray is mirrored once and meets the second mirror. There it may not go on, so that mirror is black.",
    fr = "Le rayon est réfléchi une fois et rencontre le second miroir. Là, il n’a plus le droit de continuer : ce miroir reste noir." },
}

caption { wait = true,
  en = "Two mirrors face each other. So far no ray may be mirrored: the depth is 0.",
  fr = "Deux miroirs se font face. Pour l’instant, aucun rayon ne peut être réfléchi : la profondeur est 0." }
ask(second)
press "deeper"
wait(0.5)

ask {
  en = "And with depth 2?",
  fr = "Et avec une profondeur de 2 ?",
  choices = {
    { en = "One room more, then a black mirror", fr = "Une pièce de plus, puis un miroir noir" },
    { en = "Twice as many rooms, all complete", fr = "Deux fois plus de pièces, toutes complètes" },
    { en = "The same picture, only brighter", fr = "La même image, en plus clair" },
  },
  right = 1,
  because = {
    en = "Each step of depth lets the ray go on once more: one room more.",
    fr = "Chaque niveau de profondeur permet une réflexion de plus : une pièce de plus." },
}
press "deeper"
wait(0.5)

ask {
  en = "Of green a mirror gives back 94 %, of red 90 %, of blue 91 %. How will the end of the tunnel look?",
  fr = "Un miroir renvoie 94 % du vert, 90 % du rouge et 91 % du bleu. Comment sera le bout du tunnel ?",
  choices = {
    { en = "As bright as the first room", fr = "Aussi clair que la première pièce" },
    { en = "Darker and greener", fr = "Plus sombre et plus vert" },
    { en = "Darker and redder", fr = "Plus sombre et plus rouge" },
  },
  right = 2,
  because = {
    en = "After 20 mirrors 29 % of the green is left, and 12 % of the red: 0.94 and 0.90, multiplied 20 times.",
    fr = "Après 20 miroirs, il reste 29 % du vert et 12 % du rouge : 0,94 et 0,90 à la puissance 20." },
}
for i = 3, 24 do
  press "deeper"
  wait(0.15)
end
turn(10, 5)
zoom(8)
wait(0.5)
explain()
press "home"
caption { wait = true, en = "Back to our first view. Now let us count rays.",
          fr = "Retour à notre première vue. Comptons maintenant les rayons." }

ask {
  en = "Which pixels took most rays?",
  fr = "Quels pixels ont demandé le plus de rayons ?",
  choices = {
    { en = "Those on the floor", fr = "Ceux du sol" },
    { en = "All took the same", fr = "Tous le même nombre" },
    { en = "Those deep in the mirrors", fr = "Ceux au fond des miroirs" },
  },
  right = 3,
  because = {
    en = "There the ray goes to and fro between the mirrors, and each time it asks for the lamps, too.",
    fr = "Là, le rayon va et vient entre les miroirs, et à chaque fois un rayon d’ombre part vers chaque lampe." },
}
press "layer rays"
wait(1)
explain()
press "as at first"
caption { wait = true, en = "Once more from the beginning: depth 0.", fr = "Reprenons du début : profondeur 0." }
ask(second)
press "deeper"
wait(0.5)
