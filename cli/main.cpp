#include "cli/run.h"
#include "cli/signals.h"

int main(int argc, char** argv) {
    reliefbake::leave_no_temporaries_when_interrupted();
    return reliefbake::run_command_line(argc, argv);
}
