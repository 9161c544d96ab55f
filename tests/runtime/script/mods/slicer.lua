-- Slicer: cuts the wall into strips and counts what falls, with coroutines of its own
pieces = {}
local co

local function cut(shape)
	local x, y, z, scale = GetShapeSize(shape)
	local tr = GetShapeWorldTransform(shape)
	for i=1, x-1, 8 do
		for j=0, y do
			local p = TransformToParentPoint(tr, Vec(i * scale, j * scale, z * scale * 0.5))
			MakeHole(p, scale * 1.5, scale * 1.5, scale * 1.5)
			if j % 6 == 0 then coroutine.yield(i, j) end
		end
	end
	return "finished"
end

function init()
	wall = FindShape("wall")
	before = GetShapeVoxelCount(wall)
	mi, ma = GetShapeBounds(wall)
	co = coroutine.create(cut)
	print("slicing", before, unpack and "5.1" or _VERSION)
end

function tick(dt)
	if coroutine.status(co) ~= "dead" then
		local ok, a, b = coroutine.resume(co, wall)
		if not ok then DebugPrint("slicer: " .. tostring(a)) SetString("level.slicer.error", tostring(a)) end
		if a == "finished" then SetBool("level.slicer.done", true) end
	end
	local list = QueryAabbShapes(mi, ma)
	local n = 0
	for i=1, table.getn and table.getn(list) or #list do
		local s = list[i]
		if s ~= wall and not pieces[s] then
			pieces[s] = GetShapeVoxelCount(s)
			n = n + 1
		end
	end
	local left = IsHandleValid(wall) and GetShapeVoxelCount(wall) or 0
	SetInt("level.slicer.left", left)
	SetInt("level.slicer.removed", before - left)
	SetBool("level.slicer.broken", IsShapeBroken(wall))
end

function draw()
	UiPush()
	UiAlign("left")
	UiTranslate(50, 900)
	UiFont("regular.ttf", 30)
	UiText("left " .. GetInt("level.slicer.left"))
	UiPop()
end
