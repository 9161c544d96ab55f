-- Sounds that the world does not report: of tools, menus, wind. Impacts, breaks, fire, water and steps sound by themselves.
local sounds = {}
local once, loops = {}, {}

function sounds.play(name, pos, volume)
    once[name] = once[name] or LoadSound(name)
    PlaySound(once[name], pos, volume)
end

-- Goes on for as long as it is called, in each frame or step. Without a place it comes from all around.
function sounds.loop(name, pos, volume, pitch)
    loops[name] = loops[name] or LoadLoop(name)
    PlayLoop(loops[name], pos, volume, pitch)
end

return sounds
