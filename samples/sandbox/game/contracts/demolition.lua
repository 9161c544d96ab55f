-- Demolition: the building must come below a height with so many bombs, and its neighbour must stay whole.
local bombs = require("tools/bombs")
local level = require("levels/mill")

local kHeight = 8         -- metres that it must come below
local kBombs = 8
local kAllowed = 0.02     -- share of the neighbour's voxels that may be lost
local kLook = 12          -- steps from one look at the world to the next
local kCharge = 1.8       -- of an explosion, against one that is played freely
local kRest = 2.5         -- seconds at rest that decide
local kLarge = 200        -- voxels of a piece that counts, and that is waited for
local kPatience = 12      -- seconds after a bomb that decide, whatever still moves

local demolition = {
    title = "Demolition contract", place = level.place, firstPhase = "running",
    brief = {string.format("Bring the mill below %d m with %d bombs.", kHeight, kBombs),
        "The shop next to it may lose " .. math.floor(100 * kAllowed) .. " % of what it is made of.",
        "The chimney falls to where its foot is gone."},
}

demolition.charge = kCharge

function demolition.build(state)
    local building, neighbour = level.build()
    for _, shape in ipairs(building) do SetTag(shape, "target") end
    SetTag(neighbour, "neighbour")
    SetRules({stress = true, strength = level.strength})
    wait(0.1)
    state.bombs, state.resting, state.since, state.steps = kBombs, 0, 0, 0
    state.whole, state.damage = GetShapeVoxelCount(neighbour), 0
    state.height, state.least = level.height, kHeight
    return level.start[1], level.start[2]
end

function demolition.limits(state)
    return {first = "remotebomb", tools = {remotebomb = true, timebomb = true, hands = true, spray = true},
        budget = {remotebomb = true, timebomb = true}, all = kBombs, left = state, key = "bombs"}
end

-- The highest voxel of what was the building. Pieces that are small do not count: one that hangs in a tree is no mill.
local function heightNow()
    local shapes = {}
    local top = 0
    for _, shape in ipairs(FindShapes("target")) do
        if GetShapeVoxelCount(shape) >= kLarge then
            shapes[shape] = true
            local _, high = GetShapeBounds(shape)
            top = math.max(top, high.y)
        end
    end
    local low, high = 0, top
    while high - low > 0.05 do
        local middle, isThere = (low + high) / 2, false
        for _, shape in ipairs(QueryAabbShapes(Vec(-200, middle, -200), Vec(300, top + 1, 300))) do
            isThere = isThere or shapes[shape]
        end
        if isThere then low = middle else high = middle end
    end
    return high
end

local function damageNow(state)
    local left = 0
    for _, shape in ipairs(FindShapes("neighbour")) do
        if not IsBodyDynamic(GetShapeBody(shape)) then left = left + GetShapeVoxelCount(shape) end
    end
    return math.max(0, 1 - left / state.whole)
end

-- Whether a piece of some size still falls.
local function isMoving()
    for _, shape in ipairs(FindShapes("target")) do
        local body = GetShapeBody(shape)
        local isLarge = GetShapeVoxelCount(shape) >= kLarge and GetBodyTransform(body).pos.y > -5
        if isLarge and IsBodyActive(body) and VecLength(GetBodyVelocity(body)) > 0.1 then return true end
    end
    return false
end

function demolition.update(state, dt, contract)
    state.steps = state.steps + 1
    if state.steps % kLook ~= 0 then return end
    state.height, state.damage = heightNow(), damageNow(state)
    local isLit = bombs.count() > 0 or #FindBodies("remotebomb") > 0
    state.since = isLit and 0 or state.since + kLook * dt
    state.resting = (isLit or isMoving()) and 0 or state.resting + kLook * dt
    local isDecided = state.resting >= kRest or state.since >= kPatience
    if state.damage > kAllowed then
        contract.finish(false, "The shop is damaged")
    elseif state.height < kHeight and isDecided then
        contract.finish(true, "The mill is down, the shop stands")
    elseif state.bombs == 0 and not isLit and isDecided then
        contract.finish(false, "No bombs are left, and the mill stands")
    end
end

local function percent(share)
    return string.format("%.1f %%", 100 * share)
end

function demolition.goal()
    return string.format("Bring the mill below %.0f m", kHeight)
end

-- What is shown while it is played: name, value, how far it has come, and whether that is bad.
function demolition.cells(state)
    local share = math.min(1, state.damage / kAllowed)
    return {
        {"Height", string.format("%.1f m", state.height), math.min(1, state.height / level.height),
            isGood = state.height < kHeight},
        {"Bombs", string.format("%d of %d", state.bombs, kBombs), state.bombs / kBombs, isBad = state.bombs == 0},
        {level.neighbourName, percent(state.damage) .. " of " .. percent(kAllowed), share, isBad = share > 0.5},
    }
end

function demolition.figures(state)
    return {{"Height", string.format("%.1f m, below %.1f m was asked for", state.height, kHeight)},
        {"Damage to the shop", percent(state.damage) .. " of " .. percent(kAllowed)},
        {"Bombs left", string.format("%d of %d", state.bombs, kBombs)}, {"Time", string.format("%.0f s", state.time)}}
end

-- A band around the chimney at the height that is marked.
function demolition.draw(state)
    local low, high = level.chimney[1], level.chimney[2]
    local out = 0.5
    local width = high.x - low.x + 2 * out
    local middle = Vec((low.x + high.x) / 2, kHeight, (low.z + high.z) / 2)
    for side = 0, 3 do
        local turn = QuatEuler(0, 90 * side, 0)
        UiPush()
        UiWorld(Transform(middle + turn * Vec(-width / 2, 0.06, width / 2), turn), 0.01)
        UiAlign("left top")
        UiColor(1.0, 0.72, 0.30, 0.9)
        UiRect(100 * width, 12)
        UiColor(1.0, 0.72, 0.30, 0.22)
        UiRect(100 * width, 40)
        UiPop()
    end
end

return demolition
