#include "cli/command_output.h"

#include <cstdio>

namespace reliefbake {

namespace {

thread_local CapturedOutput* captured = nullptr;

} // namespace

CapturedOutput::CapturedOutput() : outer_(captured) { captured = this; }
CapturedOutput::~CapturedOutput() { captured = outer_; }

bool output_is_captured() { return captured != nullptr; }

void print_result(const std::string& text) {
    if (captured) captured->result += text;
    else std::fputs(text.c_str(), stdout);
}

void print_warning(const std::string& command, const std::string& text) {
    if (captured) captured->warnings.push_back(text);
    else std::fprintf(stderr, "reliefbake %s: warning: %s\n", command.c_str(), text.c_str());
}

} // namespace reliefbake
