-- Meteor shower. Options live in the savegame. Classes by metatables.
Meteor = {}
Meteor.__index = Meteor

local options = { rate = "savegame.mod.meteors.rate", size = "savegame.mod.meteors.size" }
meteors = {}
acc = 0
landed = 0

function Meteor.new(pos, vel)
	local self = setmetatable({}, Meteor)
	self.pos = VecCopy(pos)
	self.vel = VecCopy(vel)
	self.dead = false
	self.rot = QuatEuler(math.random(0, 360), 0, 0)
	return self
end

function Meteor:step(dt)
	self.vel = VecAdd(self.vel, VecScale(Vec(0, -10, 0), dt))
	local len = VecLength(self.vel) * dt
	QueryRequire("physical")
	local hit, dist, normal, shape = QueryRaycast(self.pos, VecNormalize(self.vel), len, 0.1, true)
	self.rot = QuatRotateQuat(self.rot, QuatAxisAngle(Vec(0, 1, 0), 90 * dt))
	if hit then
		self.pos = VecAdd(self.pos, VecScale(VecNormalize(self.vel), dist))
		self:land(shape, normal)
	else
		self.pos = VecAdd(self.pos, VecScale(self.vel, dt))
	end
	if self.pos[2] < -50 then self.dead = true end
	ParticleReset()
	ParticleType("smoke")
	ParticleColor(1, 0.5, 0.1, 0.2, 0.2, 0.2)
	ParticleRadius(0.1, 0.4, "easeout")
	ParticleAlpha(0.8, 0.0)
	ParticleEmissive(5, 0, "easein")
	ParticleStretch(0)
	ParticleRotation(2, 0)
	ParticleCollide(0, 1)
	ParticleGravity(0, 2)
	ParticleDrag(0.3)
	SpawnParticle(self.pos, VecScale(self.vel, -0.05), 1.5)
end

function Meteor:land(shape, normal)
	self.dead = true
	landed = landed + 1
	local mat, r, g, b, a = GetShapeMaterialAtPosition(shape, VecSub(self.pos, VecScale(normal, 0.15)))
	local size = GetFloat(options.size)
	if mat == "wood" or mat == "foliage" then
		SpawnFire(self.pos)
	end
	MakeHole(self.pos, size, size * 0.7, size * 0.4)
	Paint(self.pos, size * 2, "explosion", 0.7)
	SetInt("level.meteors", landed)
	SetString("level.meteors.last", mat)
end

function init()
	if not HasKey(options.rate) then SetFloat(options.rate, 6) end
	if GetFloat(options.size) == 0 then SetFloat(options.size, 0.5) end
	math.randomseed(7)
end

function tick(dt)
	acc = acc + dt * GetFloat(options.rate)
	while acc > 1 do
		acc = acc - 1
		local p = Vec(math.random() * 4 - 2, 6, math.random() * 3 - 3)
		table.insert(meteors, Meteor.new(p, Vec(0, -8, 2)))
	end
	for i, m in pairs(meteors) do
		m:step(dt)
		if m.dead then meteors[i] = nil end
	end
end

function draw(dt)
	UiPush()
	UiTranslate(UiWidth() - 20, 20)
	UiAlign("right top")
	UiFont("bold.ttf", 28)
	UiText("Meteors: "..landed, true)
	UiColor(0.7, 0.7, 0.7)
	UiFont("regular.ttf", 18)
	for i, key in ipairs(ListKeys("savegame.mod.meteors")) do
		UiText(key .. " = " .. GetString("savegame.mod.meteors." .. key), true)
	end
	UiPop()
end
