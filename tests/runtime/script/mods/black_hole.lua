-- Pulls all loose bodies to a point, then blows them away.
function init()
	center = Vec(0, 2, -2)
	strength = 0
	time = 0
	done = false
end

function update(dt)
	if done then return end
	time = time + dt
	strength = math.min(strength + dt * 5, 10)
	QueryRequire("physical dynamic")
	local bodies = QueryAabbBodies(VecSub(center, Vec(6, 6, 6)), VecAdd(center, Vec(6, 6, 6)))
	for i=1,#bodies do
		local b = bodies[i]
		if IsBodyActive(b) or time < 0.1 then
			SetBodyActive(b, true)
		end
		local t = GetBodyTransform(b)
		local c = TransformToParentPoint(t, GetBodyCenterOfMass(b))
		local d = VecSub(center, c)
		local m = GetBodyMass(b)
		local l = VecLength(d)
		if l > 0.2 then
			ApplyBodyImpulse(b, c, VecScale(VecNormalize(d), m * strength * dt * 3))
		end
	end
	PointLight(center, 0.3, 0.2, 1, strength)
	if time > 3 then
		done = true
		Explosion(center, 2)
		for i=1,#bodies do
			if IsHandleValid(bodies[i]) then
				SetBodyVelocity(bodies[i], Vec(0, 5, 0))
			end
		end
		SetInt("level.blackhole.bodies", #bodies)
	end
end

function draw()
	UiColor(0.5, 0.4, 1, 0.8)
	UiTranslate(UiCenter(), UiMiddle())
	UiAlign("center middle")
	UiCircleOutline(40 + strength * 4, 4)
end
