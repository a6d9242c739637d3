#include "cli/command_files.h"

#include <utility>

namespace reliefbake {

namespace {

thread_local bool made_later = false;

} // namespace

FoldersMadeLater::FoldersMadeLater() : outer_(std::exchange(made_later, true)) {}
FoldersMadeLater::~FoldersMadeLater() { made_later = outer_; }

bool folders_are_made_later() { return made_later; }

} // namespace reliefbake
