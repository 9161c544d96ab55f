-- Swings the weight on its rope, then cuts the rope.
function init()
	rope = FindJoint("rope", true)
	weight = FindBody("weight")
	height = GetBodyTransform(weight).pos[2]
	t = 0
	cut = false
end

function update(dt)
	t = t + dt
	if not cut and t < 1.5 then
		local v = GetBodyVelocity(weight)
		local m = GetBodyMass(weight)
		ApplyBodyImpulse(weight, GetBodyTransform(weight).pos, Vec(m * dt * 4 * (v[1] >= 0 and 1 or -1), 0, 0))
	end
	local n = GetRopeNumberOfPoints(rope)
	for i=1, n-1 do
		DebugLine(GetRopePointPosition(rope, i), GetRopePointPosition(rope, i + 1), 1, 0, 0)
	end
	if not cut and t > 1.5 and n > 2 then
		BreakRope(rope, GetRopePointPosition(rope, math.floor(n / 2)))
		cut = true
		SetFloat("level.speed", VecLength(GetBodyVelocity(weight)))
	end
end

function tick(dt)
	if cut then SetBool("level.cut", GetBodyTransform(weight).pos[2] < height - 0.3) end
end
