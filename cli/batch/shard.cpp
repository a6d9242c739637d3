#include "cli/batch/shard.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <numeric>
#include <queue>

namespace reliefbake {

namespace {

std::optional<int> whole_number(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 0) return {};
    return number;
}

Result<std::optional<int>> number_from_environment(const char* name) {
    const char* const text = std::getenv(name);
    if (!text || !*text) return std::optional<int>();
    const std::optional<int> number = whole_number(text);
    if (!number) return fail(ErrorCode::usage, std::string(name) + ": expected a number, found '" + text + "'");
    return number;
}

Result<Shard> checked(const Shard& shard, const std::string& who) {
    if (shard.count >= 1 && shard.count <= most_shards && shard.index < shard.count) return shard;
    return fail(ErrorCode::usage, who + ": expected a shard from 0 to N - 1 of N (1 to " + std::to_string(most_shards) + "), found " + std::to_string(shard.index) + " of " +
                                      std::to_string(shard.count));
}

Result<Shard> parse(const std::string& text) {
    const std::size_t slash = text.find('/');
    const std::optional<int> index = whole_number(std::string_view(text).substr(0, slash));
    const std::optional<int> count = slash == text.npos ? std::nullopt : whole_number(std::string_view(text).substr(slash + 1));
    if (!index || !count) return fail(ErrorCode::usage, "--shard: expected I/N, as 0/8 to 7/8, found '" + text + "'");
    return checked({*index, *count}, "--shard " + text);
}

} // namespace

Result<Shard> find_shard(const std::string& given, int count) {
    if (!given.empty()) return parse(given);
    const Result<std::optional<int>> task = number_from_environment("SLURM_ARRAY_TASK_ID"), least = number_from_environment("SLURM_ARRAY_TASK_MIN"),
                                     tasks = number_from_environment("SLURM_ARRAY_TASK_COUNT"), completion = number_from_environment("JOB_COMPLETION_INDEX");
    for (const auto* read : {&task, &least, &tasks, &completion})
        if (!*read) return tl::unexpected(read->error());
    if (*task) {
        if (*tasks && count && **tasks != count)
            return fail(ErrorCode::usage, "--shards " + std::to_string(count) + ": the array has " + std::to_string(**tasks) + " tasks; leave out --shards, or submit --array=0-" + std::to_string(count - 1));
        const int of = *tasks ? **tasks : count;
        if (!of) return fail(ErrorCode::usage, "SLURM_ARRAY_TASK_ID is set, SLURM_ARRAY_TASK_COUNT is not: name --shards N");
        const int first = least->value_or(0);
        if (**task < first) return fail(ErrorCode::usage, "SLURM_ARRAY_TASK_ID: is less than SLURM_ARRAY_TASK_MIN");
        return checked({**task - first, of}, "SLURM_ARRAY_TASK_ID (an array without steps is wanted, as 0-7)");
    }
    if (*completion) {
        if (!count) return fail(ErrorCode::usage, "JOB_COMPLETION_INDEX is set: name --shards N, the job's completions");
        return checked({**completion, count}, "JOB_COMPLETION_INDEX");
    }
    return fail(ErrorCode::usage, "which shard? Name --shard I/N, or run it as a task of a Slurm array, or as an indexed Kubernetes job with --shards N");
}

std::vector<int> assign_shards(const std::vector<BatchJob>& jobs, int count) {
    std::vector<std::size_t> order(jobs.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return jobs[a].predicted.seconds > jobs[b].predicted.seconds; });
    using Load = std::pair<double, int>; // predicted seconds, shard
    std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
    for (int shard = 0; shard < count; ++shard) loads.push({0, shard});
    std::vector<int> assigned(jobs.size());
    for (const std::size_t job : order) {
        const auto [seconds, shard] = loads.top();
        loads.pop();
        assigned[job] = shard;
        loads.push({seconds + jobs[job].predicted.seconds, shard});
    }
    return assigned;
}

void keep_shard(BatchPlan& plan, const Shard& shard) {
    const std::vector<int> assigned = assign_shards(plan.jobs, shard.count);
    std::vector<BatchJob> kept;
    for (std::size_t k = 0; k < plan.jobs.size(); ++k)
        if (assigned[k] == shard.index) kept.push_back(std::move(plan.jobs[k]));
    plan.jobs = std::move(kept);
}

std::filesystem::path shard_folder(const std::filesystem::path& state, const Shard& shard) {
    return state / "shards" / (std::to_string(shard.index) + "-of-" + std::to_string(shard.count));
}

std::optional<Shard> shard_of_folder(const std::string& name) {
    const std::size_t middle = name.find("-of-");
    if (middle == name.npos) return {};
    const std::optional<int> index = whole_number(std::string_view(name).substr(0, middle)), count = whole_number(std::string_view(name).substr(middle + 4));
    if (!index || !count || *index >= *count) return {};
    return Shard{*index, *count};
}

} // namespace reliefbake
