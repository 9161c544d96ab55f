#pragma once
#include <csignal>
#include <string>

#include "samples/netplay/app/options.h"

namespace netplay {

/// Ends all loops of this program.
extern volatile std::sig_atomic_t isInterrupted;
/// Prints a line, at once.
void say(const std::string& line);

/// A player in a window, until he leaves. Returns the exit code.
int playInWindow(const Options& options);
/// A bot's play as images, evenly over the time. Returns the exit code.
int playIntoFrames(const Options& options);
/// Bots without an image. Returns the exit code.
int playBots(const Options& options);

}  // namespace netplay
