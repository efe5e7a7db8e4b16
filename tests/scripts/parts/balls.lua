function balls(count, look)
  for i = 1, count do
    sphere { center = {i, 0, 0}, material = look }
  end
end
