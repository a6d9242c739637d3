#include "cli/tradeoff/instruction_cost.h"
#include "cli/tradeoff/method.h"
#include "shaders-reference/renderer/shader_source.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include <unistd.h>

using namespace reliefbake;

namespace {

ShaderConfig config_of(const Candidate& candidate) {
    ShaderConfig config;
    config.sectors = candidate.map.kind == "acm" ? candidate.map.planes : 0;
    config.levels = candidate.map.kind == "cone-stack" || candidate.map.kind == "cone-pieces" ? candidate.map.planes : 1;
    config.pieces = candidate.map.kind == "cone-pieces";
    config.lookup = candidate.map.cone.lookup;
    config.technique = candidate.march.technique, config.exact_finish = candidate.march.exact_finish;
    config.ambient = Ambient::none;
    return config;
}

/// The optimised, inlined program as spirv-dis prints it.
std::string assembly_of(const ShaderConfig& config) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("reliefbake_instructions." + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "a.frag") << fragment_source(config, Prelude::core450);
    const std::string in = "cd " + folder.string() + " && ";
    const int code = std::system((in + GLSLANG_VALIDATOR + " -G --aml --amb -o a.spv a.frag > log && " + SPIRV_OPT + " -O a.spv -o b.spv && " + SPIRV_DIS + " --raw-id b.spv -o b.txt").c_str());
    std::stringstream text;
    text << std::ifstream(folder / "b.txt").rdbuf();
    std::filesystem::remove_all(folder);
    REQUIRE(code == 0);
    return text.str();
}

struct Block {
    int instructions = 0;
    std::vector<std::string> next;
    std::string merge, going_on; ///< of a loop's header: where it ends, and the block from which the next round begins
};

struct Program {
    std::map<std::string, Block> blocks;
    std::vector<std::string> order; ///< loops' headers too, as they stand
};

/// The blocks of the one function.
Program blocks_of(const std::string& assembly) {
    const std::set<std::string> no_work = {"OpFunction", "OpFunctionEnd", "OpVariable", "OpSelectionMerge", "OpPhi"};
    Program program;
    std::istringstream lines(assembly);
    Block* block = nullptr;
    int functions = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::vector<std::string> word{std::istream_iterator<std::string>(words), {}};
        if (word.empty()) continue;
        const std::string opcode = word.size() > 2 && word[1] == "=" ? word[2] : word[0];
        functions += opcode == "OpFunction";
        if (opcode == "OpLabel") block = &program.blocks[word[0]], program.order.push_back(word[0]);
        else if (opcode == "OpLoopMerge") block->merge = word[1], block->going_on = word[2];
        else if (block && !no_work.contains(opcode)) ++block->instructions;
        if (opcode == "OpBranch" || opcode == "OpBranchConditional")
            for (std::size_t k = opcode == "OpBranch" ? 1 : 2; k < word.size(); ++k) block->next.push_back(word[k]);
        if (opcode == "OpSwitch") // the optimiser's way to leave a function early: a default, then pairs of a number and a label
            for (std::size_t k = 2; k < word.size(); k += 2) block->next.push_back(word[k]);
    }
    REQUIRE(functions == 1); // all is inlined
    return program;
}

/// Instructions of the shortest or longest way from `from` to the end of a round, `to`; `worst` where there is none.
int way(const Program& program, const std::string& from, const std::string& to, const std::string& merge, bool longest) {
    const int worst = longest ? -1000000 : 1000000;
    const Block& block = program.blocks.at(from);
    if (from == to) return block.instructions;
    if (from == merge) return worst;
    int best = worst;
    for (const std::string& next : block.next) {
        const int rest = way(program, next, to, merge, longest);
        best = longest ? std::max(best, rest) : std::min(best, rest);
    }
    return best + block.instructions;
}

/// Loops within a loop, those over the cones above a texel, become blocks of `rounds` rounds.
void flatten(Program& program, int rounds) {
    for (std::size_t k = program.order.size(); k-- > 0;) { // the innermost come first
        const std::string label = program.order[k], merge = program.blocks.at(label).merge;
        const auto around = [&](std::size_t outer) {
            const Block& block = program.blocks.at(program.order[outer]);
            return !block.merge.empty() && std::find(program.order.begin() + std::ptrdiff_t(outer), program.order.end(), block.merge) > program.order.begin() + std::ptrdiff_t(k);
        };
        bool inside = false;
        for (std::size_t outer = 0; outer < k; ++outer) inside |= around(outer);
        if (merge.empty() || !inside) continue;
        Block& header = program.blocks.at(label);
        const int round = way(program, label, header.going_on, merge, true), end = way(program, label, merge, header.going_on, false) - program.blocks.at(merge).instructions;
        header = {rounds * round + end, {merge}, "", ""};
        const auto first = program.order.begin() + std::ptrdiff_t(k) + 1;
        program.order.erase(first, std::find(first, program.order.end(), merge));
    }
    std::erase_if(program.blocks, [&](const auto& block) { return std::find(program.order.begin(), program.order.end(), block.first) == program.order.end(); });
}

InstructionCount counted(const std::string& assembly, bool refines, int levels) {
    Program program = blocks_of(assembly);
    if (levels > 1) flatten(program, levels - 1);
    std::vector<int> shortest;
    InstructionCount count{"", 0, 0, 0, 0};
    std::set<std::string> in_loops;
    for (std::size_t k = 0; k < program.order.size(); ++k) {
        const Block& header = program.blocks.at(program.order[k]);
        if (header.merge.empty()) continue;
        for (std::size_t inside = k; program.order[inside] != header.merge; ++inside) REQUIRE(in_loops.insert(program.order[inside]).second); // no loop in a loop
        shortest.push_back(way(program, program.order[k], header.going_on, header.merge, false));
        if (shortest.size() == 1) count.patch = way(program, program.order[k], header.going_on, header.merge, true) - shortest[0];
    }
    for (const auto& [name, block] : program.blocks)
        if (!in_loops.contains(name)) count.outside += block.instructions;
    REQUIRE(shortest.size() == (refines ? 2 : 1));
    count.step = shortest[0], count.refinement = refines ? shortest[1] : 0;
    return count;
}

} // namespace

TEST_CASE("the table of instructions is what the compiler makes of the shaders") {
    std::vector<std::string> seen;
    for (const Method& method : all_methods()) {
        const std::string program = instruction_program(method.base);
        if (method.base.map.kind == "cone-pieces") continue; // its shortest way leaves before the first piece
        if (std::find(seen.begin(), seen.end(), program) != seen.end()) continue;
        seen.push_back(program);
        CAPTURE(program);
        const InstructionCount now = counted(assembly_of(config_of(method.base)), technique_info(method.base.march.technique).refines, config_of(method.base).levels);
        INFO("the row: {\"" << program << "\", " << now.outside << ", " << now.step << ", " << now.refinement << ", " << now.patch << "},");
        const auto counts = instruction_counts();
        const auto row = std::find_if(counts.begin(), counts.end(), [&](const InstructionCount& count) { return count.program == program; });
        CHECK((row != counts.end() && row->outside == now.outside && row->step == now.step && row->refinement == now.refinement && row->patch == now.patch));
    }
    CHECK(seen.size() == instruction_counts().size());
}

TEST_CASE("instructions grow by a step's for each step") {
    Candidate candidate = find_method("relaxed")->base;
    candidate.march.steps = 15, candidate.march.refinements = 8;
    const InstructionCount* row = nullptr;
    for (const InstructionCount& count : instruction_counts())
        if (count.program == "relaxed") row = &count;
    REQUIRE(row);
    CHECK(instruction_cost(candidate, 18, 8, 18) == row->outside + 10 * row->step + 8 * row->refinement);
    candidate.march.technique = Technique::dynamic;
    CHECK(instruction_cost(candidate, 18, 8, 18) == 0);

    const Candidate exact = find_method("exact-finish")->base;
    CHECK(instruction_cost(exact, 10, 0, 18) - instruction_cost(exact, 10, 0, 10) > 50); // two patches
}
