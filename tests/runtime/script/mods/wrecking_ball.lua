#version 2
-- Wrecking Ball by a stranger: throws heavy crates from above every few seconds.
-- config
BALL_SPEED = 14
ball = {}
timer = 0
hits = 0

function Lerp(a, b, t) return a + (b - a) * t end

function init()
	RegisterTool("wreckingball", "Wrecking Ball", "MOD/vox/ball.vox", 3)
	SetBool("game.tool.wreckingball.enabled", true)
	snd = LoadSound("MOD/snd/thud.ogg")
	loop = LoadLoop("MOD/snd/wind.ogg")
	ball.body = FindBody("crate", true)
	ball.home = GetBodyTransform(ball.body)
	strength = GetFloatParam("strength", 1.0)
	name = GetStringParam("name", "ball")
end

function throw()
	local t = Transform(Vec(0, 1.2, -4), QuatLookAt(Vec(0, 1.2, -4), Vec(0, 1.2, 0)))
	local fwd = TransformToParentVec(t, Vec(0, 0, -1))
	SetBodyTransform(ball.body, t)
	SetBodyVelocity(ball.body, VecScale(fwd, BALL_SPEED * strength))
	SetBodyAngularVelocity(ball.body, Vec(0, 0, 0))
	PlaySound(snd, t.pos, 1.0)
end

function tick(dt)
	if not IsHandleValid(ball.body) then return end
	timer = timer - dt
	if timer < 0 or InputPressed("usetool") then
		timer = 2.0
		throw()
	end
	PlayLoop(loop, ball.home.pos, 0.2)
	local vel = GetBodyVelocity(ball.body)
	local speed = VecLength(vel)
	if speed > 5 then
		local com = TransformToParentPoint(GetBodyTransform(ball.body), GetBodyCenterOfMass(ball.body))
		local dir = VecNormalize(vel)
		QueryRequire("physical visible")
		QueryRejectBody(ball.body)
		local hit, dist = QueryRaycast(com, dir, 1.0, 0.2)
		if hit then
			local p = VecAdd(com, VecScale(dir, dist + 0.4))
			local n = MakeHole(p, 0.35, 0.3, 0.2, true)
			if n > 0 then
				hits = hits + 1
				SetInt("level.wb.hits", hits)
			end
			ShakeCamera(0.4)
		end
		DrawLine(com, VecAdd(com, vel), 1, 0, 0, 0.5)
	end
end

function draw()
	if GetPlayerVehicle() ~= 0 or not IsHandleValid(ball.body) then return end
	UiPush()
		UiAlign("center top")
		UiTranslate(UiCenter(), 40)
		UiFont("bold.ttf", 32)
		UiColor(1, 1, 0.5, Lerp(0.5, 1, math.abs(math.sin(GetTime()))))
		UiTextShadow(0, 0, 0, 0.5, 2)
		local w, h = UiText(string.format("%s %d / %.1f kg", name, hits, GetBodyMass(ball.body)))
		UiTranslate(0, h + 4)
		UiRect(w, 2)
	UiPop()
end
