-- What scene functions say of wrong arguments names what the script has written, and nothing of the interface below.
local function says(call, ...)
    local _, message = pcall(call, ...)
    return tostring(message)
end

local function expectName(name, call, ...)
    local message = says(call, ...)
    Expect(message:find(": " .. name .. ": ", 1, true), name .. " in: " .. message)
end

function init()
    local shape, body = Box("crate", {0, 0, 0}, {4, 4, 4}, 6, {dynamic = true})
    Expect(FindShape("crate") == shape and FindBody("crate") == body, "to find what was just made by its tag")
    expectName("voxel", Box, "a", {0, 0, 0}, {4, 4, 4}, 6, {voxel = 1e9})
    expectName("corner", Box, "a", {1e30, 0, 0}, {4, 4, 4})
    expectName("spin", Box, "a", {0, 0, 0}, {4, 4, 4}, 6, {dynamic = true, spin = {1e30, 0, 0}})
    expectName("low", Joint, "hinge", shape, 0, {0, 0, 0}, {low = -1e9, high = 1})
    expectName("hertz", Joint, "hinge", shape, 0, {0, 0, 0}, {hertz = -1})
    expectName("break_force", Joint, "hinge", shape, 0, {0, 0, 0}, {break_force = -1})
    expectName("length", Joint, "rope", shape, 0, {0, 0, 0}, {length = -1})
    expectName("high", Water, {0, 0, 0}, {1, -1, 1})
    expectName("low", Bounds, {0 / 0, 0, 0}, {1, 1, 1})
    expectName("pos", Character, {1e30, 0, 0})
    expectName("table", Settings, 5)
    expectName("debris_bodies", Settings, {debris_bodies = -1})
end
