// The program behind ./rubble lua.
#include <gtest/gtest.h>
#include <pty.h>
#include <rubble/rubble.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "generated/paths.h"
#include "samples/lua/yard.h"
#include "tests/support/temp_folder.h"

namespace rubble::script {
namespace {

/// What the program prints, with its errors.
std::string output(const std::string& before, const std::string& arguments) {
    FILE* pipe = popen((before + " " RUBBLE_LUA_PROGRAM " " + arguments + " 2>&1").c_str(), "r");
    std::string text;
    for (int byte = pipe ? std::fgetc(pipe) : EOF; byte != EOF; byte = std::fgetc(pipe)) text += char(byte);
    if (pipe) pclose(pipe);
    return text;
}

/// A level without shapes that names scripts.
void writeLevelWithScripts(const std::string& path, const std::vector<const char*>& scripts) {
    const rubble_api* api = nullptr;
    rubble_world world = 0;
    rubble_world_settings settings = {.struct_size = sizeof settings, .flags = RUBBLE_WORLD_NO_RENDERER};
    std::vector<rubble_level_script> rows;
    for (const char* script : scripts) rows.push_back({.path = script, .parameters = ""});
    ASSERT_EQ(rubble_get_api(RUBBLE_VERSION, &api), RUBBLE_OK);
    ASSERT_EQ(api->create_world(&settings, &world), RUBBLE_OK);
    EXPECT_EQ(lua_sample::buildYard(*api, world), "");
    EXPECT_EQ(api->set_level_scripts(world, rows.data(), uint32_t(rows.size())), RUBBLE_OK);
    EXPECT_EQ(api->step(world), RUBBLE_OK);
    EXPECT_EQ(api->save_level(world, path.c_str(), nullptr), RUBBLE_OK) << api->get_last_error();
    api->destroy_world(world);
}

TEST(LuaProgram, CallsWhatALineHasDefined) {
    const std::string text = output("printf 'function tick() print(\"ticks\") end\\n1 + 1\\n' |", "");
    EXPECT_NE(text.find("line: ticks"), std::string::npos) << text;
    EXPECT_NE(text.find("> 2\n"), std::string::npos) << text;
}

TEST(LuaProgram, PrintsVectors) {
    EXPECT_EQ(output("", "--eval 'Vec(1, 2, 3) + Vec(0, 0, 1)'"), "(1.0, 2.0, 4.0)\n");
}

TEST(LuaProgram, PrintsAllThatATextGives) {
    EXPECT_EQ(output("", "--eval 'nil, 1, nil'"), "nil\t1\tnil\n");
    EXPECT_EQ(output("", "--eval 'local x = 1'"), "");
    EXPECT_EQ(output("", "--eval '\"a\\0b\"'"), std::string("a\0b\n", 4));
    EXPECT_EQ(output("", "--eval 'wait(0.1) return 7, GetTime() > 0.09'"), "7\ttrue\n");
    EXPECT_EQ(output("", "--eval '#SplitShape(FindShape(\"crate\"))'"), "0\n") << "it is in one piece";
    EXPECT_NE(output("printf 'wait(0.02) return 5\\n1\\n2\\n' |", "").find("5\n"), std::string::npos);
}

TEST(LuaProgram, LinesGoOnAfterOneThatWasStopped) {
    const std::string text = output("printf 'x = 3\\nwhile true do end\\n40 + 2\\nx\\n' |", "");
    EXPECT_NE(text.find("the lines begin again"), std::string::npos) << text;
    EXPECT_NE(text.find("> 42\n"), std::string::npos) << text;
    EXPECT_NE(text.find("> nil\n"), std::string::npos) << text;
}

TEST(LuaProgram, SaysWhatEachFunctionHasCost) {
    const TempFolder folder;
    const std::string script = (folder.path() / "mod.lua").string();
    std::ofstream(script) << "function update() GetTime() end";
    const std::string text = output("", script + " --steps 5 --profile");
    EXPECT_NE(text.find(" 5 calls"), std::string::npos) << text;
    EXPECT_NE(text.find("GetTime"), std::string::npos) << text;
    EXPECT_NE(text.find("allocations"), std::string::npos) << text;
}

TEST(LuaProgram, GivesParametersToTextsAndLines) {
    EXPECT_EQ(output("", "--eval 'GetIntParam(\"n\", 1)' --param n=7"), "7\n");
    EXPECT_NE(output("echo 'GetIntParam(\"n\", 1)' |", "--param n=8").find("> 8\n"), std::string::npos);
    const TempFolder folder;
    const std::string script = (folder.path() / "mod.lua").string();
    std::ofstream(script) << "print(GetIntParam('n', 1) + GetIntParam('m', 1))";
    EXPECT_EQ(output("", "--steps 1 --param n=9 --param m=2 " + script), "mod.lua: 11\n");
}

TEST(LuaProgram, ALineTakesTheTimeThatItWaits) {
    const std::string text = output("printf 'wait(0.5) return 7\nGetTime()\n' |", "");
    EXPECT_NE(text.find("> 7\n> 0.5"), std::string::npos) << text;
}

TEST(LuaProgram, ReadsStatementsOfSeveralLines) {
    const std::string text = output("printf 'for i = 1, 2 do\nprint(i * 11)\nend\n(1 +\n1)\nx = = 1\n3\n' |", "");
    EXPECT_NE(text.find("line: 22\n"), std::string::npos) << text;
    EXPECT_NE(text.find(">> 2\n"), std::string::npos) << text;
    EXPECT_NE(text.find("line:1: unexpected symbol"), std::string::npos) << text;
    EXPECT_NE(text.find("> 3\n"), std::string::npos) << text;
}

TEST(LuaProgram, RefusesValuesThatItCannotUse) {
    EXPECT_NE(output("", "--eval 1 --steps -5").find("--steps"), std::string::npos);
    EXPECT_NE(output("", "/dev/zero --steps 1").find("expected a file"), std::string::npos);
    EXPECT_NE(output("", "--eval 1 --camera 1 1 1 1 1 1").find("two places"), std::string::npos);
    EXPECT_EQ(output("", "--eval 1 --camera 1 9 1 1 1 1"), "1\n") << "straight down";
    EXPECT_NE(output("", "--reference /dev/null/x").find("expected a folder that can be written"), std::string::npos);
}

TEST(LuaProgram, FailsWhereSomethingIsWrong) {
    const TempFolder folder;
    const std::string script = (folder.path() / "mod.lua").string(), status = " 2>&1; echo status $?";
    std::ofstream(script) << "function destroy() error('boom') end";
    const std::string ended = output("", script + " --steps 1" + status);
    EXPECT_NE(ended.find("mod.lua:1: boom\n"), std::string::npos) << ended;
    EXPECT_NE(ended.find("status 1"), std::string::npos) << ended;
    EXPECT_NE(output("", "--eval 1 --param foo" + status).find("expected NAME=VALUE, found foo"), std::string::npos);
    EXPECT_NE(output("", "--eval 1 --param =3").find("expected NAME=VALUE"), std::string::npos);
}

TEST(LuaProgram, FailsWhereAScriptOfTheLevelIsMissing) {
    const TempFolder folder;
    const std::string level = (folder.path() / "room.rubble").string(), status = " 2>&1; echo status $?";
    std::ofstream(folder.path() / "there.lua") << "print('there')";
    writeLevelWithScripts(level, {"there.lua", "gone.lua"});
    for (const char* how : {"", " --eval 2"}) {
        const std::string text = output("", "--level " + level + " --steps 1" + how + status);
        EXPECT_NE(text.find("there.lua: there\n"), std::string::npos) << text;
        EXPECT_NE(text.find("gone.lua\": expected a file beside the level, found none"), std::string::npos) << text;
        EXPECT_NE(text.find("status 1"), std::string::npos) << text;
    }
    writeLevelWithScripts(level, {"there.lua"});
    EXPECT_EQ(output("", "--level " + level + " --steps 1" + status), "there.lua: there\nstatus 0\n");
    EXPECT_NE(output("", "--level " + level + " --param n=1" + status).find("--param: expected a script or --eval"),
              std::string::npos);
}

TEST(LuaProgram, PlaysWhatTextsHaveDefined) {
    const char* ticks = "--eval 'function tick() n = (n or 0) + 1 print(n) end' --steps 3";
    EXPECT_EQ(output("", ticks), "eval: 1\neval: 2\neval: 3\n");
    EXPECT_NE(output("", "--eval 'function tick() end' --profile").find(" 1 calls"), std::string::npos);
}

TEST(LuaProgram, SaysWhichOptionsHaveNoEffect) {
    const std::string status = " 2>&1; echo status $?";
    EXPECT_NE(output("echo 1 |", "--steps 5").find("--steps: expected a script, --eval or a level"), std::string::npos);
    EXPECT_NE(output("", "--watch --eval 1").find("--watch requires script"), std::string::npos);
    EXPECT_NE(output("", RUBBLE_SOURCE_DIR "/samples/lua/drawing.lua --eval 1").find("script excludes --eval"),
              std::string::npos);
    EXPECT_NE(output("", "--eval 1 --reference /tmp").find("--eval excludes --reference"), std::string::npos);
    const std::string late = output("", "--eval 'wait(1) return 5' --steps 3" + status);
    EXPECT_EQ(late, "lua: --eval: the text still waits after 3 steps: see --steps\nstatus 1\n");
}

/// The program with a script that it watches, until it ends.
class Watched {
public:
    explicit Watched(const std::string& script) {
        int ends[2];
        EXPECT_EQ(pipe(ends), 0);
        m_process = fork();
        if (!m_process) {
            dup2(ends[1], STDOUT_FILENO);
            dup2(ends[1], STDERR_FILENO);
            close(ends[0]);
            execl(RUBBLE_LUA_PROGRAM, "rubble-lua", script.c_str(), "--watch", nullptr);
            _exit(127);
        }
        close(ends[1]);
        m_output = fdopen(ends[0], "r");
    }
    ~Watched() { std::fclose(m_output); }
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;

    /// Reads lines until one has a text; false: the program has ended without it.
    bool says(const std::string& text) {
        std::array<char, 512> line;
        while (std::fgets(line.data(), line.size(), m_output))
            if (std::string(line.data()).find(text) != std::string::npos) return true;
        return false;
    }
    /// Ctrl+C; gives the status with which the program ends.
    int interrupt() {
        int status = -1;
        kill(m_process, SIGINT);
        EXPECT_TRUE(says("bye"));
        waitpid(m_process, &status, 0);
        return status;
    }

private:
    pid_t m_process = 0;
    FILE* m_output = nullptr;
};

TEST(LuaProgram, RefusesACameraThatIsNowhereAndAFolderThatIsNone) {
    for (const char* number : {"nan", "inf", "1e9", "''"})
        EXPECT_NE(
            output("", std::string("--camera 0 0 0 1 1 ") + number + " --eval 1").find("--camera: expected a number"),
            std::string::npos)
            << number;
    EXPECT_NE(
        output("", "--image /dev/null/a.png --steps 1 --eval 1").find("--image: expected a folder that can be made"),
        std::string::npos);
}

TEST(LuaProgram, WatchesWhatAScriptRequires) {
    const TempFolder folder;
    const std::string script = (folder.path() / "mod.lua").string(), tools = (folder.path() / "tools.lua").string();
    std::ofstream(tools) << "return 'old' .. ' tools'";
    std::ofstream(script) << "print(require('tools')) function destroy() print('bye') end";
    Watched program(script);
    EXPECT_TRUE(program.says("old tools"));
    std::ofstream(tools) << "return 'new' .. ' tools'";
    EXPECT_TRUE(program.says("new tools"));
    EXPECT_EQ(program.interrupt(), 0);
}

TEST(LuaProgram, WatchesAScriptThatWasStopped) {
    const TempFolder folder;
    const std::string script = (folder.path() / "mod.lua").string();
    std::ofstream(script) << "while true do end";
    Watched program(script);
    EXPECT_TRUE(program.says("mod.lua:1: the script wanted more than"));
    std::ofstream(script + ".new") << "local n = 0 function update() n = n + 1 if n == 3 then print('runs') end end\n"
                                      "function destroy() print('bye') end";
    std::filesystem::last_write_time(script + ".new", std::filesystem::last_write_time(script) + std::chrono::hours(1));
    std::filesystem::rename(script + ".new", script);
    EXPECT_TRUE(program.says("mod.lua: runs"));
    EXPECT_TRUE(WIFEXITED(program.interrupt()));
}

#ifdef RUBBLE_HAS_LIBEDIT
/// The program at a terminal, whose folder of the user is another one.
class Terminal {
public:
    explicit Terminal(const std::string& home) {
        m_process = forkpty(&m_keys, nullptr, nullptr, nullptr);
        if (m_process) return;
        setenv("HOME", home.c_str(), 1);
        setenv("TERM", "vt100", 1);
        execl(RUBBLE_LUA_PROGRAM, "rubble-lua", nullptr);
        _exit(127);
    }
    ~Terminal() { close(m_keys); }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    void type(const std::string& keys) { EXPECT_EQ(write(m_keys, keys.data(), keys.size()), ssize_t(keys.size())); }
    /// Reads until a text was shown; false: the program has ended without it.
    bool shows(const std::string& text) {
        std::array<char, 256> buffer;
        while (m_shown.find(text) == m_shown.npos) {
            const ssize_t size = read(m_keys, buffer.data(), buffer.size());
            if (size <= 0) return false;
            m_shown.append(buffer.data(), size_t(size));
        }
        m_shown.erase(0, m_shown.find(text) + text.size());
        return true;
    }
    /// Takes back what was typed, ends the input, and gives the status with which the program ends.
    int end() {
        int status = -1;
        type(kTakeBack + "'the' .. 'end'\n");
        EXPECT_TRUE(shows("theend"));
        type("x" + kTakeBack);  // the next key ends the input only where the program reads keys, not lines
        EXPECT_TRUE(shows("\x1b[K"));
        type("\x04");
        EXPECT_FALSE(shows("what is never shown"));
        waitpid(m_process, &status, 0);
        return status;
    }

private:
    inline static const std::string kTakeBack = "\x01\x0b";  ///< to the begin of the line, and all after it away
    pid_t m_process = 0;
    int m_keys = -1;
    std::string m_shown;
};

TEST(LuaProgram, EndsInOrderByCtrlCAtATerminal) {
    const TempFolder home;
    {
        Terminal terminal(home.path());
        ASSERT_TRUE(terminal.shows("> "));
        terminal.type("function destroy() print('b' .. 'ye') end\n");
        ASSERT_TRUE(terminal.shows("> "));
        terminal.type("not done\x03");
        EXPECT_TRUE(terminal.shows("bye"));
    }
    std::ifstream file(home.path() / ".rubble_lua_history");
    const std::string kept((std::istreambuf_iterator<char>(file)), {});
    EXPECT_NE(kept.find("destroy"), std::string::npos) << kept;
}

TEST(LuaProgram, TakesLettersBeyondAsciiAtATerminal) {
    const TempFolder home;
    Terminal terminal(home.path());
    ASSERT_TRUE(terminal.shows("> "));
    terminal.type("#'Gr\xc3\xbc\xc3\x9f' * 1111\n");
    EXPECT_TRUE(terminal.shows("\n6666"));
    EXPECT_EQ(terminal.end(), 0);
}

TEST(LuaProgram, CompletesNamesAndKeepsLinesAtATerminal) {
    const TempFolder home;
    {
        Terminal terminal(home.path());
        ASSERT_TRUE(terminal.shows("> "));
        terminal.type("math.maxi\t // math.maxi\t * 4321\n");
        EXPECT_TRUE(terminal.shows("\n4321"));
        terminal.type("Set\t\t");
        EXPECT_TRUE(terminal.shows("SetBodyVelocity(")) << "all that it can become";
        EXPECT_EQ(terminal.end(), 0);
    }
    Terminal terminal(home.path());
    ASSERT_TRUE(terminal.shows("> "));
    terminal.type("\x1b[A\x1b[A\n");  // the last line but one
    EXPECT_TRUE(terminal.shows("\n4321")) << "the line of the first run";
    EXPECT_EQ(terminal.end(), 0);
}
#endif

}  // namespace
}  // namespace rubble::script
