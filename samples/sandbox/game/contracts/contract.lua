-- A contract: a goal on a level of its own that can be won and lost. Which one is played is the key "game.contract",
-- which outlives a restart of the level; how it stands is a saved table, so that a loaded game goes on with it.
local belt = require("toolbelt")
local player = require("player")

local contract = {rules = {}}
-- Phases: "" none, "building", "planning", "running", "won", "lost".
local state = saved("contract", {id = "", phase = "", reason = "", time = 0})
contract.state = state

function contract.add(id)
    contract.rules[id] = require("contracts/" .. id)
end

function contract.current()
    return contract.rules[state.id]
end

-- Whether one is played that is neither won nor lost.
function contract.isOpen()
    return state.phase == "planning" or state.phase == "running"
end

function contract.isOver()
    return state.phase == "won" or state.phase == "lost"
end

function contract.finish(hasWon, reason)
    state.phase, state.reason = hasWon and "won" or "lost", reason
end

-- What tools may be used for, and how.
local function limit()
    local rules = contract.current()
    belt.limits = rules and rules.limits and rules.limits(state) or nil
    if belt.limits and not belt.isAllowed(belt.current) then belt.choose(belt.limits.first) end
    player.mayFly = not rules
    if rules then player.fly(false) end
end

-- Builds the level of the contract that is chosen, and puts the player where it starts.
function contract.begin()
    state.id = GetString("game.contract")
    ClearKey("contract")
    local rules = contract.current()
    if not rules then return limit() end
    state.phase = "building"
    start(function()
        wait(0)
        local feet, target = rules.build(state)
        SetPlayerTransform(Transform(feet, QuatLookAt(feet + Vec(0, 1.65, 0), target)))
        limit()
        state.phase = rules.firstPhase
    end)
end

-- After a load.
function contract.resume()
    limit()
end

-- Each step.
function contract.update(dt)
    if not contract.isOpen() then return end
    if state.phase == "running" then state.time = state.time + dt end
    contract.current().update(state, dt, contract)
end

-- What E does for the contract with what the eyes look at: a text, and the deed.
function contract.offer(aim)
    local rules = contract.current()
    if contract.isOpen() and rules.offer then return rules.offer(state, aim) end
end

-- How large explosions of bombs are, against those that are played freely.
function contract.charge()
    local rules = contract.current()
    return rules and rules.charge or 1
end

-- For other scripts.
function contract.publish()
    SetString("contract.phase", state.phase)
    SetString("contract.reason", state.reason)
    for key, value in pairs(state) do
        if math.type(value) then SetFloat("contract." .. key, value) end
    end
end

return contract
