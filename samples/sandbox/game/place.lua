-- Placing things: a pale image of the thing stands where the eyes look, is turned and put down. Each one can be taken back.
local belt = require("toolbelt")
local build = require("vehicles/build")
local draw = require("draw")
local explosives = require("explosives")
local keys = require("keys")
local sounds = require("sounds")
local things = require("things")
local vehicles = require("vehicles/vehicles")

local place = {thing = nil, say = nil}  -- what is placed; what shows a line for some seconds
local kReach, kGap, kTurn, kTips = 14, 0.02, 15, {Quat(), QuatEuler(90, 0, 0), QuatEuler(0, 0, 90)}
local turn, tip = 0, 1
local ghosts, shown, wasFree = {}, nil, nil  -- bodies of the image, of which thing, and whether it was free
local frame, isFree, doesReach = Transform(), false, false

function place.isActive()
    return place.thing ~= nil
end

function place.begin(thing)
    place.thing, turn, tip = thing, 0, 1
end

function place.finish()
    place.thing = nil
end

local function removeGhosts()
    for _, body in ipairs(FindBodies("ghost")) do Delete(body) end
    ghosts, shown = {}, nil
end

-- A palette as glass, pale where it can be put and red where it cannot.
local function ghostPalette(palette)
    local list = {}
    for i, c in ipairs(palette) do
        local goal = isFree and {0.75, 0.85, 0.95} or {1.0, 0.25, 0.18}
        list[i] = {opacity = 0.4, roughness = 0.9, emission = 0.3}
        for k = 1, 3 do list[i][k] = 0.45 * c[k] + 0.55 * goal[k] end
    end
    return list
end

local function pieceFrame(piece)
    return frame * Transform(piece.at or Vec(), piece.rot or QuatEuler(0, piece.turn or 0, 0))
end

local function showGhosts()
    local pieces = things.pieces(place.thing)
    local isThere = shown == place.thing and wasFree == isFree and #ghosts == #pieces
    for _, body in ipairs(ghosts) do isThere = isThere and IsHandleValid(body) end
    if isThere then
        for i, piece in ipairs(pieces) do SetBodyTransform(ghosts[i], pieceFrame(piece)) end
        return
    end
    removeGhosts()
    for i, piece in ipairs(pieces) do
        local m = piece.model
        ghosts[i] = CreateModel({size = m.size, origin = m.origin, voxel = m.voxel, boxes = m.boxes, grid = m.grid,
            palette = ghostPalette(m.palette)}, pieceFrame(piece), false)
        SetTag(ghosts[i], "ghost")
    end
    shown, wasFree = place.thing, isFree
end

-- How far a turned box reaches along a direction.
local function extent(rot, half, dir)
    local along = TransformToLocalVec(Transform(Vec(), rot), dir)
    return math.abs(along.x) * half.x + math.abs(along.y) * half.y + math.abs(along.z) * half.z
end

-- Whether something is where it would stand. The box is a little smaller, so that what it stands on does not count.
local function isBlocked(rot, low, high)
    local middle = frame.pos + rot * VecLerp(low, high, 0.5)
    local small = Vec(0, 0, 0)
    for k = 1, 3 do small[k] = math.max(0.02, 0.5 * (high[k] - low[k]) - 0.12) end
    local half = Vec(extent(rot, small, Vec(1, 0, 0)), extent(rot, small, Vec(0, 1, 0)), extent(rot, small, Vec(0, 0, 1)))
    local isSquare = turn % 90 == 0
    local inner = isSquare and half or Vec(0.6 * half.x, half.y, 0.6 * half.z)
    QueryRequire("physical")
    return #QueryAabbBodies(middle - inner, middle + inner) > 0
end

-- Before a wall it stands on the floor, where that is not far below.
local function lift(middle, height)
    QueryRequire("physical")
    local hit, dist = QueryRaycast(middle, {0, -1, 0}, height + 0.5)
    return hit and middle + Vec(0, height + kGap - dist, 0) or middle
end

-- Where the thing would be: its box touches what the eyes look at.
local function aim()
    local eye = GetPlayerCameraTransform()
    local ahead = eye.rot * Vec(0, 0, -1)
    local low, high = things.box(place.thing)
    local reach = kReach + VecLength(high - low)
    QueryRequire("physical")
    local hit, dist, normal = QueryRaycast(eye.pos, ahead, reach)
    doesReach = hit
    if not hit then
        dist = math.min(reach, 4 + VecLength(high - low))
        normal = Vec(0, 1, 0)
    end
    local yaw = math.deg(math.atan(-ahead.x, -ahead.z))
    local rot = QuatEuler(0, turn + math.floor(yaw / 15 + 0.5) * 15, 0) * (place.thing.isUpright and Quat() or kTips[tip])
    if place.thing.isUpright and normal.y < 0.5 then doesReach = false end
    local half = VecScale(high - low, 0.5)
    local middle = eye.pos + dist * ahead + (extent(rot, half, normal) + kGap) * normal
    if doesReach and math.abs(normal.y) < 0.5 then middle = lift(middle, extent(rot, half, Vec(0, 1, 0))) end
    frame = Transform(middle - rot * VecLerp(low, high, 0.5), rot)
    isFree = doesReach and not isBlocked(rot, low, high)
end

-- The edges of its box.
local function drawEdges()
    local low, high = things.box(place.thing)
    local r, g, b = 0.62, 0.84, 1
    if not isFree then r, g, b = 1, 0.28, 0.2 end
    local function corner(k)
        return frame * Vec(k & 1 > 0 and high.x or low.x, k & 2 > 0 and high.y or low.y, k & 4 > 0 and high.z or low.z)
    end
    for k = 0, 7 do
        for bit = 0, 2 do
            if k & 1 << bit == 0 then DrawLine(corner(k), corner(k | 1 << bit), r, g, b, 0.85) end
        end
    end
end

-- made: takes the bodies.
local function putPieces(made)
    for i, piece in ipairs(things.pieces(place.thing)) do
        local body, shape = build.body(piece.model, pieceFrame(piece), piece.density)
        made[i] = body
        SetTag(body, "placed")
        if piece.tag == "explosive" then explosives.add(shape) end
        if piece.light then
            local m = piece.model
            local at = piece.light + VecScale(Vec(m.origin[1], m.origin[2], m.origin[3]), m.voxel)
            CreateLight(shape, Transform(at), Vec(9, 7, 4.6), {radius = 0.08, reach = 14})
        end
    end
end

-- What was dropped is read again. One that cannot be read any more says why.
local function putDrop()
    local bodies, why = PlaceDrop(place.thing.drop, frame)
    if not bodies then return place.say(why, 8) end
    for _, body in ipairs(bodies) do
        SetTag(body, "placed")
        if place.thing.isFree then SetBodyDynamic(body, true) end
    end
end

-- A prefab that was dropped may be anything. Where a piece of it cannot be made, none is.
local function putPrefab()
    local made = {}
    local isGood, what = pcall(putPieces, made)
    if isGood then return end
    for _, body in ipairs(made) do Delete(body) end
    place.say(things.blame(place.thing.path, what), 8)
end

local function put()
    if not isFree then return sounds.play("click", nil, 0.4) end
    AddUndoMark()
    if place.thing.vehicle then
        vehicles.spawn(place.thing.vehicle, frame)
    elseif place.thing.drop then
        putDrop()
    elseif place.thing.path then
        putPrefab()
    else
        putPieces({})
    end
    sounds.play("thud", frame.pos, 0.5)
end

-- Each frame in which something is placed.
function place.tick()
    aim()
    local wheel = InputValue("mousewheel") + (InputPressed("nexttool") and 1 or 0) - (InputPressed("lasttool") and 1 or 0)
    if wheel ~= 0 then turn = (turn + (wheel > 0 and kTurn or -kTurn)) % 360 end
    if InputPressed("reload") and not place.thing.isUpright then tip = tip % #kTips + 1 end
    if InputPressed("usetool") then put() end
    if InputPressed("grab") then place.finish() end
    if place.thing then drawEdges() end
    belt.lastAim = nil
end

-- Each step. `isShown`: no menu is open.
function place.update(isShown)
    if place.thing and isShown then
        if not place.thing.path then return showGhosts() end
        local isGood, what = pcall(showGhosts)  -- a prefab that was dropped may be anything
        if isGood then return end
        place.say(things.blame(place.thing.path, what), 8)
        place.finish()
        removeGhosts()
    elseif shown or #ghosts > 0 then
        removeGhosts()
    end
end

-- After a load nothing is being placed.
function place.resume()
    place.thing = nil
    removeGhosts()
end

function place.draw()
    local rows = {{keys.label("usetool"), "put down"},
        {keys.usesPad and keys.label("lasttool") .. "  " .. keys.label("nexttool") or "Wheel", "turn"},
        {keys.label("reload"), "tip over"}, {keys.label("grab"), "leave it"}, {keys.label("spawn"), "another thing"},
        {keys.label("undo"), "take back"}}
    if place.thing.isUpright then table.remove(rows, 3) end
    UiPush()
    UiTranslate(UiWidth() - 48, UiHeight() - 44)
    draw.text(place.thing.name, 30, "right", draw.ink, 1, "bold.ttf")
    UiTranslate(0, -40)
    draw.text(not doesReach and "too far" or not isFree and "no room" or "", 24, "right", {1, 0.45, 0.35})
    UiPop()
    draw.hints(rows)
end

return place
