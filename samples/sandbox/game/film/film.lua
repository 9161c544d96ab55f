-- Directs the film: shot after shot, each a file beside this one. A shot is a table:
--   name, seconds
--   unseen      seconds of the world that pass before it
--   begin()     sets the scene, before these
--   camera(t)   transform and field of view, t seconds after the cut
--   speed(t)    of the world's time; without it 1
--   cues        {t, function} each, in order
--   update(t)   each step
local shots = {require("film/town"), require("film/hands"), require("film/room"), require("film/tower"),
    require("film/dusk")}
local only, fps, wanted = GetString("film.shot"), GetFloat("film.fps"), GetFloat("film.seconds")
local current, frame, cue = 0, 0, 1
local time = 0             -- seconds after the cut, in steps too
local share, total = 1, 0  -- of the shots' lengths that is shown; frames of the film

local function isFilmed(shot) return only == "" or shot.name == only end

local function framesOf(shot) return math.max(1, math.floor(shot.seconds * share * fps + 0.5)) end

function init()
    local names, seconds = "", 0
    for _, shot in ipairs(shots) do
        names = names .. " " .. shot.name
        if isFilmed(shot) then seconds = seconds + shot.seconds end
    end
    if seconds == 0 then error("expected one of the shots" .. names .. ", found \"" .. only .. "\"", 0) end
    if wanted > 0 then share = math.min(1, wanted / seconds) end
    for _, shot in ipairs(shots) do
        if isFilmed(shot) then total = total + framesOf(shot) end
    end
end

local function cut()
    repeat current = current + 1 until current > #shots or isFilmed(shots[current])
    local shot = shots[current]
    if not shot then return QuitGame() end
    frame, cue, time = 0, 1, -1
    SetTimeScale(1)
    if shot.begin then shot.begin() end
    BeginShot(shot.name, (shot.unseen or 0) * share, total)
end

function tick()
    if current == 0 or frame >= framesOf(shots[current]) then cut() end
    local shot = shots[current]
    if not shot then return end
    local t = frame / fps
    time = t
    SetTimeScale(shot.speed and shot.speed(t) or 1)
    SetCameraTransform(shot.camera(t))
    while shot.cues and shot.cues[cue] and shot.cues[cue][1] <= t do
        start(shot.cues[cue][2])
        cue = cue + 1
    end
    frame = frame + 1
end

function update()
    local shot = shots[current]
    if not shot then return end
    if shot.update then shot.update(time) end
    time = time + 1 / (60 * (shot.speed and shot.speed(time) or 1))
end
