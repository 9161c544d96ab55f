// The program behind ./rubble lua.
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/support/temp_folder.h"

namespace rubble::script {
namespace {

/// What the program prints, with its errors.
std::string output(const std::string& before, const std::string& arguments) {
    FILE* pipe = popen((before + " " RUBBLE_LUA_PROGRAM " " + arguments + " 2>&1").c_str(), "r");
    std::string text;
    std::array<char, 256> buffer;
    while (pipe && std::fgets(buffer.data(), buffer.size(), pipe)) text += buffer.data();
    if (pipe) pclose(pipe);
    return text;
}

TEST(LuaProgram, CallsWhatALineHasDefined) {
    const std::string text = output("printf 'function tick() print(\"ticks\") end\\n1 + 1\\n' |", "");
    EXPECT_NE(text.find("line: ticks"), std::string::npos) << text;
    EXPECT_NE(text.find("> 2\n"), std::string::npos) << text;
}

TEST(LuaProgram, PrintsVectors) {
    EXPECT_EQ(output("", "--eval 'Vec(1, 2, 3) + Vec(0, 0, 1)'"), "(1.0, 2.0, 4.0)\n");
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
