--[[
	Domino alarm. Sensors sit on bodies; the first one that moves starts the alarm,
	everything after that only counts. One-shot callbacks, a queue of timers.
]]
#version 2

local MOD = "savegame.mod.domino"
sensors = {}
queue = {}
log = ""
alarm = { on = false, t = 0, level = 0 }

local function after(delay, f, ...)
	local args = {...}
	queue[#queue + 1] = { t = delay, f = function() f(unpack(args)) end }
end

local function round(x, n)
	local m = math.pow(10, n or 0)
	return math.floor(x * m + 0.5) / m
end

local function newSensor(handle, index)
	local s = { body = handle, id = "s" .. index, calm = true }
	local t = GetBodyTransform(handle)
	s.home = TransformCopy(t)
	function s:moved()
		local now = GetBodyTransform(self.body)
		return VecLength(VecSub(now.pos, self.home.pos)) > 0.05
	end
	return s
end

function init()
	if not HasKey(MOD .. ".runs") then
		SetInt(MOD .. ".runs", 0)
		SetString(MOD .. ".color", "1,0.2,0.2")
		SetBool(MOD .. ".loud", true)
	end
	SetInt(MOD .. ".runs", GetInt(MOD .. ".runs") + 1)
	local i = 0
	for _, b in ipairs(FindBodies(nil, true)) do
		if IsBodyDynamic(b) and not HasTag(b, "ignore") then
			i = i + 1
			table.insert(sensors, newSensor(b, i))
		end
	end
	SetInt("level.domino.sensors", table.getn(sensors))
	-- only wait for the first frame, then get out of the way
	function tick(dt)
		SetString("level.domino.first", string.format("%.2f", GetTime()))
		tick = watch
	end
	after(0.5, function(v) ApplyBodyImpulse(FindBody("crate", true), Vec(0, 0.5, -1.6), v) end, Vec(0, 0, 900))
	after(1, Shoot, Vec(1.2, 1, -5), Vec(0, 0, 1), "shotgun", 1)
end

function trip(s)
	s.calm = false
	alarm.level = alarm.level + 1
	SetFloat("level.domino.hits." .. s.id, round(GetTime(), 2))
	if not alarm.on then
		alarm.on = true
		log = log .. "first " .. s.id .. "\n"
		draw = drawAlarm
	end
end

function watch(dt)
	for i = #queue, 1, -1 do
		local q = queue[i]
		q.t = q.t - dt
		if q.t <= 0 then
			table.remove(queue, i)
			q.f()
		end
	end
	for k, s in pairs(sensors) do
		if not IsHandleValid(s.body) then
			sensors[k] = nil
		elseif s.calm and s:moved() then
			trip(s)
		end
	end
	if alarm.on then
		alarm.t = alarm.t + dt
		if alarm.t > 2 then
			SetInt("level.domino.level", alarm.level)
			SetString("level.domino.log", log)
			tick = nil
			draw = nil
		end
	end
end

function drawAlarm(dt)
	local c = {}
	for part in string.gmatch(GetString(MOD .. ".color"), "([^,]+)") do
		c[#c + 1] = tonumber(part)
	end
	SetInt("level.domino.drawn", GetInt("level.domino.drawn") + 1)
	UiPush()
		UiTranslate(UiCenter(), 80)
		UiAlign("center middle")
		UiColor(c[1], c[2], c[3], 0.5 + 0.5 * math.sin(alarm.t * 10))
		UiRoundedRect(300, 60, 8)
		UiColor(1, 1, 1)
		UiFont("bold.ttf", 32)
		UiText("ALARM " .. alarm.level)
		for i, key in ipairs(ListKeys("level.domino.hits")) do
			UiTranslate(0, 40)
			UiPush()
				UiFont("regular.ttf", 20)
				UiAlign("left")
				UiText(key)
				UiTranslate(60, 0)
				UiText(GetFloat("level.domino.hits." .. key))
			UiPop()
		end
	UiPop()
end
