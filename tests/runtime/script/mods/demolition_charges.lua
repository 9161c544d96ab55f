-- remote charges: plants bombs on shapes, counts down and blows them one after the other

bombs = {}
local armed = false

function plant(pos, shape, normal)
	local b = {}
	b.shape = shape
	b.t = TransformToLocalPoint(GetShapeWorldTransform(shape), pos)
	b.time = 1 + #bombs * 0.5
	b.body = GetShapeBody(shape)
	bombs[#bombs+1] = b
end

function init()
	for i=1, 4 do
		local o = Vec(-2 + i * 0.8, 0.6 + (i % 2) * 0.8, -4)
		local hit, d, n, s = QueryRaycast(o, Vec(0, 0, 1), 20)
		if hit then
			plant(VecAdd(o, VecScale(Vec(0, 0, 1), d)), s, n)
		end
	end
	armed = true
	SetString("level.charges.state", "armed")
end

function update(dt)
	if not armed then return end
	for i=#bombs,1,-1 do
		local b = bombs[i]
		b.time = b.time - dt
		if b.time <= 0 then
			if IsHandleValid(b.shape) then
				local p = TransformToParentPoint(GetShapeWorldTransform(b.shape), b.t)
				Explosion(p, 1.0)
				local mi, ma = VecAdd(p, Vec(-3, -3, -3)), VecAdd(p, Vec(3, 3, 3))
				QueryRequire("physical dynamic")
				for _, body in ipairs(QueryAabbBodies(mi, ma)) do
					local m = GetBodyMass(body)
					local dir = VecNormalize(VecSub(GetBodyTransform(body).pos, p))
					ApplyBodyImpulse(body, p, VecScale(dir, math.min(m * 2, 200)))
				end
				SetInt("level.charges.blown", GetInt("level.charges.blown") + 1)
			end
			table.remove(bombs, i)
		end
	end
	if #bombs == 0 then
		SetString("level.charges.state", "done")
	end
end

function draw()
	for i=1, #bombs do
		local b = bombs[i]
		local p = TransformToParentPoint(GetShapeWorldTransform(b.shape), b.t)
		local x, y, dist = UiWorldToPixel(p)
		if dist > 0 then
			UiPush()
				UiTranslate(x, y)
				UiAlign("center middle")
				UiColor(1, 0, 0)
				UiCircle(8)
				UiColor(1, 1, 1)
				UiFont("regular.ttf", 20)
				UiText(math.ceil(b.time))
			UiPop()
		end
	end
end
