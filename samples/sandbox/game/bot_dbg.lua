local bot = require("bots/hands")
SetFloat("dbg.drive", 1100)
bot.play(function()
    bot.frames(3)
    bot.press("return")
    CreateModel({size = {120, 2, 120}, voxel = 1, origin = {60, 2, 60}, boxes = {{0, 0, 0, 119, 1, 119, 1}},
        palette = {{0.42, 0.43, 0.44, material = "concrete", roughness = 0.9}}}, Transform(Vec(0, 0, 0)), false)
    for _, kind in ipairs({"car"}) do
    SetString("game.spawn", kind .. " -20 0.02 20 0")
    bot.frames(60)
    for _, b in ipairs(FindBodies("vehicle")) do
      local t = GetBodyTransform(b)
      print(GetTagValue(b,"vehicle"), GetBodyMass(b), VecStr(t.pos), VecStr(GetBodyTransform(b) * GetBodyCenterOfMass(b)), #GetShapeJoints(GetBodyShapes(b)[1]))
    end
    for _, j in ipairs(FindJoints()) do if kind ~= "excavator" then print(GetJointType(j), GetJointMovement(j)) end end
    if kind == "car" then
    local body = FindBodies("vehicle")[1]
    local target = GetBodyTransform(body) * Vec(0, 0.9, 0.3)
    bot.stand(target + Vec(-2.9, -0.8, 0), target)
    bot.press("e")
    SetInput("w", true)
    for i = 1, 6 do bot.frames(20) print(GetString("game.vehicle"), GetBool("game.vehicle.dead"), VecStr(GetBodyTransform(body).pos), VecStr(GetBodyVelocity(body)), IsBodyActive(body)) end
    for _, b in ipairs(FindBodies("vehicle")) do print(VecStr(GetBodyAngularVelocity(b))) end
    SetInput("w", false)
    bot.press("e")
    end
    for _, b in ipairs(FindBodies("vehicle")) do Delete(b) end
    bot.frames(3)
    end
end)
function tick() bot.tick() end
