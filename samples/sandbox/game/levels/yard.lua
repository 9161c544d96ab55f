-- What levels stand on where there is no town: a lawn alone.
local blueprint = require("levels/blueprint")

-- Removes all there is. Takes some steps.
return function()
    for _, body in ipairs(FindBodies()) do Delete(body) end
    local lawn = blueprint({100, 2, 80}, 0.5)
    lawn:block("earth", 0, 0, 0, 99, 1, 79, 2)
    lawn:build(Vec(8, -1, 20))
    wait(0.1)
end
