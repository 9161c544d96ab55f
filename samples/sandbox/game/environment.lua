-- What a prefab that was dropped is run with: nothing that changes the world or the game.
return function()
    local names, env = {"math", "string", "table", "utf8", "ipairs", "pairs", "next", "select", "tostring", "tonumber", "type",
        "error", "assert", "pcall", "setmetatable", "getmetatable", "rawget", "rawset", "rawequal", "rawlen"}, {}
    for _, name in ipairs(names) do env[name] = _G[name] end
    for name, value in pairs(_G) do
        local isOfVectors = type(name) == "string" and (name:match("^Vec") or name:match("^Quat") or name:match("^Transform"))
        if isOfVectors then env[name] = value end
    end
    return env
end
