-- A tool in the usual style: state in globals, cooldown, registry for options.
gCooldown = 0
gShots = 0

function init()
	if not HasKey("savegame.mod.power") then
		SetFloat("savegame.mod.power", 0.8)
	end
	gPower = GetFloat("savegame.mod.power")
	gOrigin = Vec(0, 1.2, -5)
end

function rnd(mi, ma)
	return math.random(1000) / 1000 * (ma - mi) + mi
end

function fire()
	local dir = VecNormalize(Vec(rnd(-0.2, 0.2), rnd(-0.1, 0.1), 1))
	QueryRejectBody(FindBody("crate"))
	local hit, dist, normal, shape = QueryRaycast(gOrigin, dir, 50)
	if hit then
		local p = VecAdd(gOrigin, VecScale(dir, dist))
		MakeHole(p, gPower, gPower * 0.7, 0)
		SpawnFire(p)
		ParticleReset()
		ParticleType("smoke")
		ParticleColor(0.7, 0.6, 0.5)
		ParticleRadius(0.2, 1.0)
		ParticleAlpha(0.8, 0)
		ParticleGravity(1)
		ParticleDrag(0.5)
		for i=1, 5 do
			local v = VecAdd(VecScale(normal, rnd(1, 3)), Vec(rnd(-1, 1), rnd(-1, 1), rnd(-1, 1)))
			SpawnParticle(p, v, rnd(0.5, 2.0))
		end
		gShots = gShots + 1
		SetInt("level.shots", gShots)
	end
end

function tick(dt)
	gCooldown = gCooldown - dt
	if gCooldown <= 0 then
		fire()
		gCooldown = 0.25
	end
	DebugWatch("shots", gShots)
end

function draw(dt)
	UiPush()
		UiTranslate(UiCenter(), UiHeight() - 60)
		UiAlign("center middle")
		UiFont("regular.ttf", 26)
		UiTextOutline(0, 0, 0, 1, 0.1)
		UiText("Shots: " .. gShots)
	UiPop()
end
