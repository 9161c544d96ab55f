-- Remote bomb: sticks where it is put; the right button sets all of them off, the farthest last.
local feel = require("feel")
local belt = require("toolbelt")
local bombs = require("tools/bombs")

local prop = {
    voxel = 0.05, size = {6, 6, 2},
    palette = {{0.30, 0.33, 0.22, material = "plastic"}, {0.14, 0.14, 0.15, material = "plastic"},
        {0.2, 1.0, 0.3, material = "plastic", emission = 4}},
    boxes = {{0, 0, 0, 5, 5, 1, 1}, {1, 1, 1, 4, 4, 1, 2}, {2, 3, 1, 2, 3, 1, 3}},
}

local function all()
    local list = {}
    for _, body in ipairs(FindBodies("remotebomb")) do
        if HasTag(body, "remotebomb") then list[#list + 1] = body end
    end
    return list
end

return {
    name = "Remote bomb",
    tip = "Right button: set them off",
    reach = 4,
    ammo = 12,
    cooldown = 0.3,
    turn = {12, -14, 0},
    hold = Vec(-0.005, -0.005, 0.02),
    model = {
        size = {9, 20, 6},
        origin = {4, 8, 3},
        palette = {{0.14, 0.14, 0.15, roughness = 0.5}, {0.30, 0.33, 0.22, roughness = 0.6},
            {0.85, 0.12, 0.10, roughness = 0.4, emission = 0.6}, {0.6, 0.6, 0.62, roughness = 0.3, metallic = 0.7},
            {0.2, 0.9, 0.3, emission = 2}},
        boxes = {{1, 0, 1, 7, 12, 4, 2}, {1, 1, 5, 7, 11, 5, 1}, {3, 5, 5, 5, 8, 5, 3}, {2, 13, 2, 2, 19, 2, 4},
            {6, 10, 5, 6, 10, 5, 5}, {0, 2, 2, 8, 10, 3, 1}},
        muzzle = Vec(0, 4, -3),
    },
    use = function(self, aim)
        if not aim.hit or aim.shape == 0 then return false end
        bombs.place(prop, aim, "remotebomb")
        belt.recoil(0.5)
    end,
    alt = function(self, aim)
        local list = all()
        if #list == 0 then return end
        AddUndoMark()
        table.sort(list, function(a, b)
            return VecLength(bombs.center(a) - aim.eye) < VecLength(bombs.center(b) - aim.eye)
        end)
        for i, body in ipairs(list) do
            if not bombs.left(body) then bombs.light(body, 0.12 * (i - 1)) end
        end
    end,
    draw = function(self)
        local count = #all()
        if count == 0 then return end
        for _, body in ipairs(all()) do
            local x, y, depth = UiWorldToPixel(bombs.center(body))
            if depth > 0.5 then
                UiPush()
                UiTranslate(x, y)
                UiAlign("center middle")
                UiColor(0.3, 1, 0.4, 0.8)
                UiCircleOutline(11, 2)
                UiPop()
            end
        end
    end,
}
