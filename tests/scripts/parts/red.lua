return material { color = {1, 0, 0} }
