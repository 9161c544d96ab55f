-- Tractor beam with constraints; a state machine with functions in a table
state = "search"
target = 0
hold = Vec(0, 2.2, -3)
t0 = 0

states = {
	search = function(dt)
		local best, bestDist = 0, 1e9
		local list = FindBodies(nil, true)
		for i=1, #list do
			local b = list[i]
			if IsBodyDynamic(b) and IsBodyActive(b) ~= nil and GetBodyMass(b) < 5000 and not IsBodyJointedToStatic(b) then
				local mi, ma = GetBodyBounds(b)
				local c = VecLerp(mi, ma, 0.5)
				local d = VecLength(VecSub(c, hold))
				if d < bestDist then best, bestDist = b, d end
			end
		end
		if best ~= 0 then
			target = best
			SetBodyActive(target, true)
			t0 = GetTime()
			return "lift"
		end
	end,
	lift = function(dt)
		local t = GetBodyTransform(target)
		local com = TransformToParentPoint(t, GetBodyCenterOfMass(target))
		ConstrainPosition(target, 0, com, hold, 4)
		ConstrainOrientation(target, 0, t.rot, QuatEuler(0, GetTime() * 40, 0), 2)
		ConstrainAngularVelocity(target, 0, Vec(0, 0.5, 0), 5)
		local d = VecLength(VecSub(com, hold))
		SetFloat("level.beam.height", math.max(GetFloat("level.beam.height"), com[2]))
		if d < 0.3 or GetTime() - t0 > 2 then return "drop" end
	end,
	drop = function(dt)
		local p = GetBodyTransform(target).pos
		local v = GetBodyVelocityAtPos(target, p)
		ApplyBodyImpulse(target, p, VecScale(Vec(0, 0, 3), GetBodyMass(target)))
		SetString("level.beam.v", VecStr(v))
		SetInt("level.beam.drops", GetInt("level.beam.drops") + 1)
		t0 = GetTime()
		return "pause"
	end,
	pause = function(dt)
		if GetTime() - t0 > 0.5 then return "search" end
	end,
}

function init()
	cam = GetPlayerCameraTransform()
	dir = TransformToParentVec(cam, Vec(0, 0, -1))
	SetPlayerTransform(Transform(Vec(0, 1, -6), QuatLookAt(Vec(0, 1, -6), Vec(0, 1, 0))))
end

function update(dt)
	local next = states[state](dt)
	if next and states[next] then state = next end
end

function tick()
	if target ~= 0 and IsHandleValid(target) then
		local p = GetBodyTransform(target).pos
		DrawLine(hold, p, 0.2, 0.6, 1)
		local hit, pt, n, sh = QueryClosestPoint(p, 5)
		if hit then DebugLine(pt, VecAdd(pt, n), 0, 1, 0) end
	end
end

function draw()
	UiTranslate(30, UiMiddle())
	UiFont("mono.ttf", 24)
	UiColor(0.2, 0.6, 1)
	UiText("beam: " .. state)
	UiTranslate(0, 10)
	UiPush() UiColor(0, 0, 0, 0.5) UiRoundedRect(204, 14, 4) UiPop()
	UiTranslate(2, 2)
	UiRect(200 * math.max(0, math.min(1, GetFloat("level.beam.height") / 3)), 10)
end
