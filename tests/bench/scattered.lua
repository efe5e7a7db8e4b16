-- What the scenes of bench/tree share: as many things as --time says, spread through a cube; together
-- they hide about as much of it, whatever their number.
camera { position = {0.5, 0.5, 2.8}, look_at = {0.5, 0.5, 0} }
light { position = {4, 6, 5} }; ambient(0.1)
function scatter(put)
  local count = math.max(1, math.floor(t))
  for i = 1, count do
    put({i * 0.8191725134 % 1, i * 0.6710436067 % 1, i * 0.5497004779 % 1}, 0.6 / math.sqrt(count))
  end
end
