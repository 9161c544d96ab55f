-- Gremlin: walks through all tagged joints, loosens motors, snaps ropes and remembers who did what.

Gremlin = { mood = "bored", seen = {}, done = {}, n = 0 }

local names = {
	hinge = "HINGE",
	rope = "ROPE",
	ball = "BALL",
	prismatic = "SLIDER",
}

local function describe(j)
	local a, b = unpack(GetJointShapes(j))
	local other = GetJointOtherShape(j, a)
	local kind = GetJointType(j)
	return (names[kind] or kind) .. ":" .. tostring(other ~= a)
end

function Gremlin:collect(...)
	for i = 1, select("#", ...) do
		local tag = select(i, ...)
		for _, j in ipairs(FindJoints(tag, true)) do
			if not self.seen[j] then
				self.seen[j] = tag
				self.n = self.n + 1
				SetString("level.gremlin." .. tag, describe(j))
			end
		end
	end
end

-- one-shot: arms itself, fires once, clears itself
function Gremlin:once(cond, what)
	local me = {}
	me.run = function()
		if cond() then
			what()
			return true
		end
	end
	self.done[me] = true
end

function init()
	Gremlin:collect("hinge", "rope")
	Gremlin.door = FindBody("door", true)
	Gremlin.weight = FindBody("weight", true)
	SetJointMotor(FindJoint("hinge", true), 2, 2000)
	Gremlin:once(function() return math.abs(GetJointMovement(FindJoint("hinge"))) > 0.3 end, function()
		SetJointMotor(FindJoint("hinge"), 0, 0)
		Gremlin.mood = "amused"
		SetBool("level.gremlin.opened", true)
	end)
	Gremlin:once(function() return GetTime() > 1.5 end, function()
		local t = GetBodyTransform(Gremlin.weight)
		local com = TransformToParentPoint(t, GetBodyCenterOfMass(Gremlin.weight))
		SetFloat("level.gremlin.height", com[2])
		for j, tag in pairs(Gremlin.seen) do
			if tag == "rope" then
				Delete(j)
				DetachJointFromShape(j, GetJointShapes(j)[1])
			end
		end
	end)
	Gremlin:once(function() return GetBodyVelocity(Gremlin.weight)[2] < -2 end, function()
		Gremlin.mood = "evil"
		local p = GetBodyTransform(Gremlin.weight).pos
		Explosion(VecAdd(p, Vec(0, 0, 0.5)), 0.5)
		SetInt("level.gremlin.boom", 1)
	end)
end

function handleCommand(cmd)
	DebugPrint("gremlin got " .. cmd)
end

function tick(dt)
	for me in pairs(Gremlin.done) do
		if me.run() then Gremlin.done[me] = nil end
	end
	local left = 0
	for me in pairs(Gremlin.done) do left = left + 1 end
	SetInt("level.gremlin.left", left)
	DebugWatch("gremlin", Gremlin.mood)
	if left == 0 then
		SetString("level.gremlin.mood", Gremlin.mood)
		tick = function() end
	end
end

function draw()
	local x, y, d = UiWorldToPixel(GetBodyTransform(Gremlin.door).pos)
	UiPush()
	if d > 0 then
		UiTranslate(x, y)
		UiRotate(math.sin(GetTime()) * 10)
		UiScale(1.5)
		UiColorFilter(1, 1, 1, 0.8)
		UiAlign("center middle")
		UiFont("bold.ttf", 18)
		local w, h = UiGetTextSize(Gremlin.mood)
		UiRectOutline(w + 8, h + 4, 1)
		UiText(Gremlin.mood)
	end
	UiPop()
end
