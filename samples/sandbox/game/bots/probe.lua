local bot = require("bots/hands")
local V = {
  {"A", {{27.2,.5,38.25},{28.2,.5,38.25},{29.2,.5,38.25},{26.9,.5,37.4},{29.5,.5,37.4}}, 1.6},
  {"B", {{27.2,.5,38.25},{28.2,.5,38.25},{29.2,.5,38.25},{26.9,.5,37.4},{29.5,.5,37.4}}, 2.2},
  {"C", {{27.2,.8,38.25},{28.2,.8,38.25},{29.2,.8,38.25},{26.9,.8,37.4},{29.5,.8,37.4},{26.9,.8,36.9},{29.5,.8,36.9}}, 2.2},
}
bot.play(function()
    local i = GetInt("bot.stage")
    if i > 0 then
        for k = 1, 200 do if GetString("contract.phase") == "running" then break end bot.frames(1) end
        bot.frames(100)
        for _, p in ipairs(V[i][2]) do Explosion(Vec(p[1],p[2],p[3]), V[i][3]) bot.frames(7) end
        
        for k = 1, 8 do bot.frames(60)
          local c, n = Vec(0,0,0), 0
          for _, sh in ipairs(FindShapes("target")) do local b = GetShapeBody(sh) if IsBodyDynamic(b) then local w = GetShapeVoxelCount(sh) n = n + w c = c + VecScale(GetBodyTransform(b) * GetBodyCenterOfMass(b), w) end end
          if n > 0 then c = VecScale(c, 1/n) end
          print(V[i][1], k, string.format("%.2f m %.4f", GetFloat("contract.height"), GetFloat("contract.damage")), n, VecStr(c), GetString("contract.phase"), GetString("contract.reason"))
        end
    end
    if not V[i+1] then return end
    SetInt("bot.stage", i+1)
    SetString("game.contract", "demolition")
    RestartLevel()
    bot.frames(10)
end)
function tick() bot.tick() end
