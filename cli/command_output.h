#pragma once
// What commands tell: results to stdout, warnings to stderr, or both to whoever runs the command as a part of its own work.

#include <string>
#include <vector>

namespace reliefbake {

void print_result(const std::string& text);

/// One line, "reliefbake COMMAND: warning: TEXT".
void print_warning(const std::string& command, const std::string& text);

/// Takes what this thread's commands tell for as long as it lives; their progress lines stay away, too.
class CapturedOutput {
  public:
    CapturedOutput();
    ~CapturedOutput();
    CapturedOutput(const CapturedOutput&) = delete;
    CapturedOutput& operator=(const CapturedOutput&) = delete;

    std::string result;
    std::vector<std::string> warnings;

  private:
    CapturedOutput* outer_;
};

/// Whether this thread's output is taken.
bool output_is_captured();

} // namespace reliefbake
