-- Turret nest: a list of turrets with their own state machines, each aims at what has a tag and shoots in bursts.
-- Objects by closures, states as functions in a table, registry keys built from strings.

#include "turret_util.lua"

TURRETS = 3
local turrets = {}
local stats = setmetatable({}, { __index = function() return 0 end })

local function key(...)
	return table.concat({ "level", "nest", ... }, ".")
end

local State = {}

function State.search(t, dt)
	local best, bestDist = nil, 1000
	for i, shape in ipairs(FindShapes("target", true)) do
		local mi, ma = GetShapeBounds(shape)
		local c = VecLerp(mi, ma, 0.5)
		local d = VecLength(VecSub(c, t.pos))
		if d < bestDist then
			best, bestDist = shape, d
		end
	end
	if best then
		t.target = best
		t.state = "aim"
	end
end

function State.aim(t, dt)
	if not IsHandleValid(t.target) then
		t.state = "search"
		return
	end
	local mi, ma = GetShapeBounds(t.target)
	local want = QuatLookAt(t.pos, VecLerp(mi, ma, 0.5))
	t.rot = QuatSlerp(t.rot, want, clamp(dt * 8, 0, 1))
	t.timer = t.timer + dt
	if t.timer > 0.4 then
		t.timer = 0
		t.burst = 4
		t.state = "fire"
	end
end

function State.fire(t, dt)
	t.timer = t.timer + dt
	while t.timer > 0.1 and t.burst > 0 do
		t.timer = t.timer - 0.1
		t.burst = t.burst - 1
		local dir = TransformToParentVec(Transform(t.pos, t.rot), Vec(rnd(-0.05, 0.05), rnd(-0.05, 0.05), -1))
		QueryRequire("physical")
		local hit, dist, normal, shape = QueryRaycast(t.pos, dir, 50)
		if hit then
			local p = VecAdd(t.pos, VecScale(dir, dist))
			stats[GetShapeMaterialAtPosition(shape, VecSub(p, VecScale(normal, 0.05)))] =
				stats[GetShapeMaterialAtPosition(shape, VecSub(p, VecScale(normal, 0.05)))] + 1
			SpawnParticle(p, normal, 0.5)
			PointLight(p, 1, 0.7, 0.3, 2)
		end
		Shoot(t.pos, dir, "gun", 1, 50)
		t.shots = t.shots + 1
		SetInt(key("turret", t.id, "shots"), t.shots)
	end
	if t.burst == 0 then
		t.state = "search"
	end
end

function init()
	SetTag(FindBody("crate"), "boss")
	for i, s in ipairs(GetBodyShapes(FindBody("boss"))) do
		SetTag(s, "target", tostring(i))
	end
	SetTag(GetBodyShapes(FindBody("wall", true))[1], "target")
	for i = 1, TURRETS do
		local t = { id = tostring(i), pos = Vec(-3 + i * 1.5, 2, -6), rot = Quat(), timer = 0, shots = 0, burst = 0 }
		t.state = "search"
		turrets["turret" .. i] = t
	end
	ParticleReset()
	ParticleType("plain")
	ParticleColor(1, 0.8, 0.4)
	ParticleRadius(0.02, 0.05)
end

function update(dt)
	for name, t in pairs(turrets) do
		State[t.state](t, dt)
	end
end

function tick(dt)
	for name, t in pairs(turrets) do
		local tr = Transform(t.pos, t.rot)
		DrawLine(t.pos, TransformToParentPoint(tr, Vec(0, 0, -0.6)), 1, 0, 0)
		DebugCross(t.pos)
	end
	local all = {}
	for mat, n in pairs(stats) do
		all[#all + 1] = mat .. "=" .. n
	end
	table.sort(all)
	SetString(key("materials"), table.concat(all, ";"))
end

function draw()
	UiTranslate(20, 20)
	UiAlign("left top")
	UiFont("regular.ttf", 22)
	for name, t in pairs(turrets) do
		UiText(name .. ": " .. t.state .. " (" .. t.shots .. ")", true)
	end
end
