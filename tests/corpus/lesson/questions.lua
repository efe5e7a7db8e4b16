lesson { scene = "../box.lua", title = "a", learnt = { "One", { en = "Two", fr = "Deux" } } }
local q = { en = "a?", fr = "b?", choices = { "x", { en = "y", fr = "z" }, "w" }, right = 2, because = { en = "so", fr = "car" } }
ask(q) hold("light left", 0.2) caption "c" ask(q) wait(1) ask { fr = "d?", choices = { "1", "2", "3", "4", "5", "6", "7", "8", "9" }, right = 9, because = "e" }
