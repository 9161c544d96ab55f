-- Lights a fire, watches it, and puts it out where it is too large.
function init()
	crate = FindShape("crate")
	local mi, ma = GetBodyBounds(GetShapeBody(crate))
	center = VecLerp(mi, ma, 0.5)
	SpawnFire(VecAdd(center, Vec(0, 0.35, 0)))
	SpawnFire(VecAdd(center, Vec(0.35, 0, 0)))
	most = 0
end

function tick(dt)
	local count = GetFireCount()
	if count > most then most = count end
	local found, pos = QueryClosestFire(center, 10)
	if found and count > 8 then
		RemoveAabbFires(VecSub(pos, Vec(0.5, 0.5, 0.5)), VecAdd(pos, Vec(0.5, 0.5, 0.5)))
		SetInt("level.fires.out", GetInt("level.fires.out") + 1)
		Paint(pos, 0.3, "explosion", 0.5)
	end
	SetInt("level.fires.most", most)
end

function draw()
	UiPush()
	UiTranslate(30, 40)
	UiFont("bold.ttf", 24)
	if GetFireCount() > 0 then UiColor(1, 0.4, 0.1) else UiColor(0.4, 1, 0.4) end
	UiText("Fires: " .. GetFireCount(), true)
	UiColor(1, 1, 1)
	UiText("Most: " .. most)
	UiPop()
end
