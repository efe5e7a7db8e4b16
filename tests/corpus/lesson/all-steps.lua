lesson { scene = "../box.lua", title = { en = "a", fr = "b" }, size = {800, 600}, samples = 4, depth = 3, engine = "f32x8" }
caption { wait = true, en = "Text", fr = "Texte" }
press "home" hold("camera left", 0.4) wait(1) turn(-12, -3) zoom(5) speed(2) size(640, 480) pixel(0.5, 0.5) walk(1, 0) bar(0.3) snapshot()
