-- shared helpers

function clamp(v, lo, hi)
	return math.max(lo, math.min(hi, v))
end

function rnd(lo, hi)
	return lo + math.random() * (hi - lo)
end
