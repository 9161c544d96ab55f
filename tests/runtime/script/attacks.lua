-- Scripts that try to take more than they are given. "--- NAME" begins one; "stopped", "fails" or "ends" says what it
-- must come to: the sandbox stops it for good, it ends with an error, or it does no harm and ends.

--- loop: stopped
while true do end
--- loop by goto: stopped
::again:: goto again
--- loop by repeat: stopped
repeat local x = 1 until false
--- loop of for: stopped
for i = 1, math.maxinteger do end
--- loop over an endless iterator: stopped
for x in function() return 1 end do end
--- loop by tail calls: stopped
local function f() return f() end f()
--- loop by two functions: stopped
local g local function f() return g() end g = function() return f() end f()
--- pcall in a loop: stopped
while true do pcall(function() while true do end end) end
--- pcall that swallows the stop: stopped
pcall(function() while true do end end) while true do pcall(error) end
--- pcall nested deep: stopped
local function f() pcall(f) while true do end end f()
--- pcall of pcall: stopped
while true do pcall(pcall, pcall, pcall, error) end
--- xpcall with a handler that loops: stopped
xpcall(error, function() while true do end end)
--- xpcall with a handler that fails: stopped
local function handler() error('again') end
for i = 1, 100 do xpcall(error, handler) end
error('still here')
--- xpcall with itself as a handler: stopped
local function f(...) return xpcall(error, f) end
while true do xpcall(error, f) end
--- xpcall with a handler that loops after the stop: stopped
xpcall(function() while true do end end, function() while true do end end)
--- error in the handler of an error in a handler: stopped
while true do xpcall(error, function() xpcall(error, function() error() end) error() end) end
--- error with a value whose text loops: stopped
error(setmetatable({}, {__tostring = function() while true do end end}))
--- error with a value whose text fails: fails
error(setmetatable({}, {__tostring = function() error('no text') end}))
--- error with itself: fails
local e = setmetatable({}, {}) getmetatable(e).__tostring = function() error(e) end error(e)
--- deep recursion: stopped
local function f() return 1 + f() end f()
--- deep recursion, caught in a loop: stopped
local function f() return 1 + f() end
while true do pcall(f) end
--- deep recursion through pcall: stopped
local function f() return 1, pcall(f) end while true do f() end
--- deep recursion in C by gsub: fails
local function f() return (string.gsub('x', '.', f)) end f()
--- deep recursion in C by sort: fails
local function f() table.sort({1, 2}, f) end f()
--- deep recursion in C by tostring: fails
local t = setmetatable({}, {__tostring = function(t) return tostring(t) end}) tostring(t)
--- deep recursion by __index: fails
local t = setmetatable({}, {__index = function(t, k) return t[k + 1] end}) return t[1]
--- loop of __index tables: fails
local t = {} setmetatable(t, {__index = t}) return t.x
--- loop of two __index tables: fails
local a, b = {}, {} setmetatable(a, {__index = b}) setmetatable(b, {__index = a}) return a.x
--- deep recursion by __call: stopped
local t = {} setmetatable(t, {__call = t}) t()
--- deep recursion by __call with many values: stopped
local t = {} setmetatable(t, {__call = t}) t(table.unpack({}, 1, 8000))
--- deep recursion by __concat: fails
local t = setmetatable({}, {__concat = function(a, b) return a .. b end}) return t .. 'x'
--- deep recursion by __eq: fails
local m = {} m.__eq = function(a, b) return a == b end
return setmetatable({}, m) == setmetatable({}, m)
--- deep recursion by __len: fails
local t = setmetatable({}, {__len = function(t) return #t end}) return #t
--- deep recursion of coroutines: stopped
local function f() return coroutine.wrap(f)() end f()
--- deep recursion of load: stopped
local function f() return load('return ...')(f()) end f()
--- nested brackets: ends
return load(('('):rep(10000) .. '1' .. (')'):rep(10000))
--- nested tables in a text: stopped
return load('return ' .. ('{'):rep(100000) .. ('}'):rep(100000))
--- nested functions in a text: stopped
return load(('function() return '):rep(5000))
--- labels and jumps: stopped
for i = 1, 100 do
    local parts = {}
    for j = 1, 5000 do parts[j] = '::a' .. j .. '::' end
    load(table.concat(parts, ' '))
end
--- compiling in a loop: stopped
local text = ('local a = 1 '):rep(150) while true do load(text) end
--- string.rep bomb: fails
return ('x'):rep(1e9)
--- string.rep bomb by steps: stopped
local s = 'x' while true do s = s:rep(2) end
--- string.rep of nothing: ends
return (''):rep(math.maxinteger)
--- string.rep with an empty separator: ends
return #(''):rep(math.maxinteger, '')
--- string.rep in a loop: stopped
while true do local s = ('x'):rep(200000) end
--- string.rep in a loop of pcall: stopped
while true do pcall(string.rep, 'x', 250000) end
--- doubling by concatenation: stopped
local s = 'x' while true do s = s .. s end
--- doubling by concatenation, caught: stopped
local s = 'x' while true do pcall(function() s = s .. s end) end
--- many long strings: stopped
local t = {} for i = 1, 1e6 do t[i] = ('x'):rep(100000) .. i end
--- many long strings, caught: stopped
local t = {} while true do pcall(function() t[#t + 1] = ('x'):rep(100000) .. #t end) end
--- concatenation of many values: stopped
local t = {} for i = 1, 200 do t[i] = ('x'):rep(1000) end while true do local s = table.concat(t) end
--- format of long strings: stopped
local s = ('x'):rep(100000) while true do local r = string.format('%s%s', s, s) end
--- format with a width: fails
return string.format('%9999d', 1)
--- format with many directives: stopped
local f = ('%d'):rep(200) while true do pcall(string.format, f, table.unpack({}, 1, 200)) end
--- pack of a large block: stopped
return string.pack('c2000000000', 'x')
--- pack of large blocks in a loop: stopped
while true do pcall(string.pack, 'c100000000', 'x') end
--- unpack of many values: fails
return string.unpack(('b'):rep(200000), ('x'):rep(200000))
--- byte of a long string: stopped
local s = ('x'):rep(200000) while true do pcall(string.byte, s, 1, 8000) end
--- char of many: stopped
local t = {} for i = 1, 200 do t[i] = 65 end while true do string.char(table.unpack(t)) end
--- upper of a long string: stopped
local s = ('x'):rep(250000) while true do s:upper() end
--- reverse of a long string: stopped
local s = ('x'):rep(250000) while true do s:reverse() end
--- utf8.len of a long string: stopped
local s = ('x'):rep(250000) while true do utf8.len(s) end
--- utf8.codepoint of a long string: stopped
local s = ('x'):rep(250000) while true do pcall(utf8.codepoint, s, 1, 8000) end
--- comparison of long strings: stopped
local a, b = ('x'):rep(250000), ('x'):rep(250000) while true do local c = a == b end
--- ordering of long strings: stopped
local a, b = ('x'):rep(250000), ('x'):rep(249999) .. 'y' while true do local c = a < b end
--- numbers out of long strings: stopped
local s = '1' .. (' '):rep(250000) while true do local n = tonumber(s) end
--- arithmetic with long strings: stopped
local s = '1' .. (' '):rep(250000) while true do local n = s + 1 end
--- pattern with backtracking: stopped
return (('a'):rep(10000)):find('.-.-.-.-.-.-b')
--- pattern with backtracking, greedy: stopped
return (('a'):rep(10000)):find('a*a*a*a*a*a*b')
--- pattern with optional items: stopped
return (('a'):rep(60)):find(('a?'):rep(60) .. ('a'):rep(61))
--- pattern in a coroutine: stopped
coroutine.wrap(function() return (('a'):rep(10000)):find('.-.-.-.-.-.-b') end)()
--- pattern in pcall: stopped
while true do pcall(string.find, ('a'):rep(10000), '.-.-.-b') end
--- pattern with balanced brackets: stopped
local s = ('('):rep(100000) while true do s:find('%b()') end
--- pattern with a back-reference: stopped
return (('ab'):rep(5000)):find('(.-)(.-)(.-)%1%2%3c')
--- pattern with a frontier: ends
return (('a'):rep(20000)):find('%f[^a].-.-.-%f[b]')
--- pattern with a long set: stopped
return (('a'):rep(100000)):find('[' .. ('bcdefg'):rep(10000) .. ']')
--- pattern too deep: fails
return (('a'):rep(1000)):find(('(a)'):rep(300))
--- pattern of gsub on a long string: stopped
local s = ('a'):rep(200000) while true do s:gsub('a', 'b') end
--- pattern of gsub that grows: stopped
local s = 'x' while true do s = s:gsub('x', 'xxxxxxxx') end
--- pattern of gsub with a long replacement: stopped
return (('x'):rep(10000)):gsub('x', ('y'):rep(10000))
--- pattern of gmatch without an end: stopped
while true do for a in (('a'):rep(1000)):gmatch('') do end end
--- plain search of a long string: stopped
local s = ('a'):rep(250000) while true do s:find('ab', 1, true) end
--- plain search, quadratic: stopped
local s, p = ('a'):rep(250000), ('a'):rep(125000) .. 'b' while true do s:find(p, 1, true) end
--- sort with a lying comparator: stopped
local t = {} for i = 1, 5000 do t[i] = i end
while true do table.sort(t, function(a, b) return true end) end
--- sort with a random comparator: stopped
local t = {} for i = 1, 2000 do t[i] = i end
while true do table.sort(t, function() return math.random() < 0.5 end) end
--- sort with a comparator of C: stopped
local t = {} for i = 1, 5000 do t[i] = i end while true do table.sort(t, math.max) end
--- sort of equal long strings: stopped
local s, t = ('x'):rep(250000), {} for i = 1, 5000 do t[i] = s end table.sort(t)
--- sort with a lying length: fails
table.sort(setmetatable({}, {__len = function() return math.maxinteger end}))
--- sort with a comparator that changes the list: ends
local t = {} for i = 1, 100 do t[i] = i end
table.sort(t, function(a, b) for i = 1, 100 do t[i] = nil end return a > b end)
--- sort with a comparator that yields: fails
coroutine.wrap(function() table.sort({1, 2, 3}, function(a, b) coroutine.yield() return a < b end) end)()
--- concat with a lying length: stopped
table.concat(setmetatable({}, {__len = function() return math.maxinteger end, __index = type}))
--- concat with a length that changes: fails
local n = 0
table.concat(setmetatable({}, {__len = function() n = n + 1 return n == 1 and 1 or 1e15 end}))
--- insert with a lying length: stopped
table.insert(setmetatable({}, {__len = function() return 1 << 60 end}), 1, 'x')
--- remove with a lying length: stopped
table.remove(setmetatable({}, {__len = function() return 1 << 60 end}), 1)
--- move of everything: stopped
table.move({}, 1, math.maxinteger - 1, 2)
--- move of much with metamethods: stopped
table.move(setmetatable({}, {__index = math.abs}), 1, 1 << 40, 1, setmetatable({}, {__newindex = rawequal}))
--- unpack of everything: fails
return table.unpack({}, 1, 1e8)
--- unpack of much in a loop: stopped
while true do pcall(table.unpack, {}, 1, 8000) end
--- select in a loop: stopped
local function f(...) while true do select(10000, ...) end end f(table.unpack({}, 1, 8000))
--- varargs passed on: stopped
local function f(...) return f(...) end f(table.unpack({}, 1, 8000))
--- next over an emptied table: stopped
local t = {} for i = 1, 30000 do t['k' .. i] = 1 end for k in next, t do t[k] = nil end
while true do next(t) end
--- pairs in a loop: stopped
local t = {} for i = 1, 10000 do t['k' .. i] = i end while true do pairs(t) end
--- pairs with a metamethod that loops: stopped
for k in pairs(setmetatable({}, {__pairs = function() while true do end end})) do end
--- giant table: stopped
local t = {} while true do t[#t + 1] = 0 end
--- giant table of tables: stopped
local t = {} while true do t = {t} end
--- giant table by its size: stopped
local t = {} for i = 1, 1e9 do t[-i] = i end
--- giant closure chain: stopped
local f = print while true do local g = f f = function() return g() end end
--- giant number of coroutines: stopped
local t = {} while true do t[#t + 1] = coroutine.create(print) end
--- garbage: stopped
while true do local t = {{}, {}, {}} end
--- collecting garbage in a loop: stopped
local t = {} for i = 1, 5000 do t[i] = {} end while true do collectgarbage() end
--- coroutines that each run a little: stopped
while true do coroutine.wrap(function() for i = 1, 50 do end end)() end
--- coroutine that loops: stopped
coroutine.wrap(function() while true do end end)()
--- coroutine that yields for ever: stopped
local c = coroutine.wrap(function() while true do coroutine.yield() end end) while true do c() end
--- coroutine whose stop is swallowed: stopped
while true do coroutine.resume(coroutine.create(function() while true do end end)) end
--- coroutine made before the budget ran low: stopped
local c = coroutine.create(function() coroutine.yield() while true do end end) coroutine.resume(c)
pcall(function() while true do end end) coroutine.resume(c)
--- coroutines in coroutines: stopped
local function f(n) local c = coroutine.wrap(function() if n > 0 then f(n - 1) end while true do end end) c() end f(20)
--- coroutine that resumes itself: ends
local c c = coroutine.create(function() return coroutine.resume(c) end) coroutine.resume(c)
--- coroutine wrapped around itself: fails
local w w = coroutine.wrap(function() return w() end) w()
--- coroutine that fails in a loop: stopped
while true do coroutine.resume(coroutine.create(error)) end
--- __close that loops: stopped
do local x <close> = setmetatable({}, {__close = function() while true do end end}) end
--- __close that loops after an error: stopped
pcall(function() local x <close> = setmetatable({}, {__close = function() while true do end end}) error('x') end)
while true do end
--- __close that loops after the stop: stopped
local x <close> = setmetatable({}, {__close = function() while true do end end}) while true do end
--- __close of a coroutine that loops: stopped
local c = coroutine.create(function()
    local x <close> = setmetatable({}, {__close = function() while true do end end})
    coroutine.yield()
end)
coroutine.resume(c) coroutine.close(c)
--- __close that closes more: stopped
local function open()
    local x <close> = setmetatable({}, {__close = function() open() end})
    error('again')
end
open()
--- __gc: fails
setmetatable({}, {__gc = function() while true do end end})
--- __gc added later: ends
local m = {} for i = 1, 100 do setmetatable({}, m) end m.__gc = function() while true do end end collectgarbage()
--- __gc by rawset: fails
local m = {} rawset(m, '__gc', function() while true do end end) setmetatable({}, m)
--- __gc of the metatable of strings: ends
getmetatable('').__gc = function() while true do end end
--- __mode tables in a loop: stopped
while true do setmetatable({}, {__mode = 'kv'})[{}] = {} end
--- metatable of strings that loops: stopped
getmetatable('').__index = function() while true do end end return ('x').y
--- metatable of globals that loops: stopped
setmetatable(_G, {__index = function() while true do end end}) return something
--- globals taken away: stopped
local l, g = load, _G for k in next, g do g[k] = nil end
while true do l('while true do end')() end
--- bytecode: fails
return load('\27Lua\x54\0\x19\x93\r\n\x1a\n')()
--- bytecode by dump: fails
return load(string.dump(function() end))
--- reading files: fails
return io.open('/etc/passwd')
--- running programs: fails
os.execute('true')
--- loading a library: fails
require('os')
--- debug: fails
debug.sethook()
--- the registry: fails
return debug.getregistry()
--- print in a loop: stopped
while true do print('flood') end
--- print of long strings: stopped
local s = ('x'):rep(200000) while true do print(s, s, s) end
--- random numbers in a wrong range: fails
return math.random(2, 1)
--- large exponents: stopped
local x = 2 while true do x = x ^ 1000 end
--- division by zero: fails
return 1 // 0
--- os.exit: fails
os.exit(0)
--- a pipe: fails
for line in io.popen('id'):lines() do print(line) end
--- a library of C: fails
return package.loadlib('libc.so.6', 'system')
--- format of long numbers: stopped
local f, t = ('%99.99f'):rep(100), {} for i = 1, 100 do t[i] = 1e300 end
while true do pcall(string.format, f, table.unpack(t)) end
--- format that quotes a long string: stopped
local s = ('\0'):rep(200000) while true do pcall(string.format, '%q', s) end
--- gsub with a callback that yields: fails
coroutine.wrap(function() ('abc'):gsub('.', coroutine.yield) end)()
--- gsub with a callback that fails: stopped
while true do pcall(string.gsub, ('x'):rep(1000), '.', error) end
--- gsub of nothing in a long string: stopped
local s = ('x'):rep(100000) while true do s:gsub('', 'y') end
--- loop by goto over __close: stopped
::again:: do local x <close> = setmetatable({}, {__close = function() end}) end goto again
--- coroutine in a finaliser: fails
setmetatable({}, {__gc = coroutine.wrap(function() while true do end end)})
--- finaliser that keeps what it gets: ends
local m, kept = {}, {} for i = 1, 100 do setmetatable({}, m) end
m.__gc = function(o) kept[#kept + 1] = o end collectgarbage() collectgarbage() assert(#kept == 0)
--- bytecode by its mode: fails
return load(('\27Lua'):rep(1000), 'x', 'b')()
--- a chunk by a function: stopped
return load(function() return 'while true do end ' end)
--- huge string keys: stopped
local t = {} for i = 1, 1e6 do t[('k'):rep(200000) .. i] = i end
--- environment that looks for ever: stopped
local _ENV = setmetatable({}, {__index = function(t, k) return t[k .. k] end}) return x
--- loop over all integers: stopped
for i = math.mininteger, math.maxinteger do end
--- sort with __lt that loops: stopped
local m = {__lt = function() while true do end end} table.sort({setmetatable({}, m), setmetatable({}, m)})
--- closing the coroutine that runs: fails
coroutine.close(coroutine.running())
--- error with a long text: fails
error(setmetatable({}, {__tostring = function() return ('x'):rep(250000) end}))
--- error handler that yields: ends
coroutine.wrap(function() xpcall(error, coroutine.yield) end)()
--- __newindex that stores by itself: fails
local t = setmetatable({}, {__newindex = function(t, k, v) t[k] = v end}) t.x = 1
--- __tostring that gives no text: fails
return string.format('%s', setmetatable({}, {__tostring = function() return {} end}))
--- coroutines with __close that are let go: ends
for i = 1, 500 do
    local c = coroutine.wrap(function()
        local x <close> = setmetatable({}, {__close = function() while true do end end})
        coroutine.yield()
    end)
    c()
end
collectgarbage()
--- utf8.char of many: stopped
local t = {} for i = 1, 200 do t[i] = 0x10ffff end while true do utf8.char(table.unpack(t)) end
--- utf8.codes of a long string: stopped
local s = ('é'):rep(100000) while true do for p, c in utf8.codes(s) do end end
--- move of a list onto itself: stopped
local t = {} for i = 1, 1000 do t[i] = i end while true do table.move(t, 1, 1000, 2) end
