#include "cli/command.h"

#include "cli/bake_cone.h"
#include "cli/explain.h"

namespace reliefbake {

namespace {

template <class T>
std::unique_ptr<Command> make() {
    return std::make_unique<T>();
}

constexpr CommandEntry all_commands[] = {
    {"cone", "Bake a height map into a cone map (normal, cone, depth)", make<ConeCommand>},
    {"explain", "Print what a baked map means and how to decode it", make<ExplainCommand>},
};

} // namespace

std::span<const CommandEntry> commands() { return all_commands; }

} // namespace reliefbake
