-- Draws a sphere of voxels next to the wall, counts materials, copies and trims.
function init()
	wall = FindShape("wall")
	local x, y, z, scale = GetShapeSize(wall)
	local types = {}
	for ix=0, x-1, 4 do
		for iy=0, y-1, 4 do
			local mat, r, g, b, a, entry = GetShapeMaterialAtIndex(wall, ix, iy, 0)
			types[mat] = (types[mat] or 0) + 1
		end
	end
	local names = {}
	for mat, count in pairs(types) do
		if mat ~= "" then names[#names + 1] = mat end
	end
	table.sort(names)
	SetString("level.materials", table.concat(names, ","))
	start(build)
end

function build()
	local shape = CreateShape(FindBody("wall"), Transform(Vec(0, 2.6, 0)), wall)
	ResizeShape(shape, 0, 0, 0, 15, 15, 15)
	SetBrush("sphere", 6, 7)
	DrawShapeLine(shape, 8, 8, 8, 8, 8, 8)
	wait(0.1)
	SetInt("level.art.voxels", GetShapeVoxelCount(shape))
	TrimShape(shape)
	wait(0.1)
	local sx, sy, sz = GetShapeSize(shape)
	SetInt("level.art.size", sx)
	SetShapeEmissiveScale(shape, 0.5)
	SetTag(shape, "art")
end

function tick(dt)
	SetInt("level.art.found", #FindShapes("art", true))
end
