#pragma once
#include <string>

namespace rubble {

/// Counts an input, or a call of one, that has got as far as `stage`, a text that lives for ever: the fuzzer's last
/// lines say how many did, so that one whose inputs are all refused at once is noticed.
void reached(const char* stage);
/// One line for each stage, of the counts and their shares of `inputs`.
std::string stageReport(unsigned long long inputs);

}  // namespace rubble
