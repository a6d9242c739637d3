#include "cli/batch/ledger.h"

namespace reliefbake {

namespace {

using nlohmann::json;

constexpr int ledger_version = 1;

json to_json(const FileRecord& file) {
    const FileStamp& s = file.stamp;
    return {{"name", file.name}, {"stamp", {s.size, s.inode, s.modified, s.changed}}, {"hash", file.hash}};
}

json to_json(const std::vector<FileRecord>& files) {
    json list = json::array();
    for (const FileRecord& file : files) list.push_back(to_json(file));
    return list;
}

std::vector<FileRecord> files_from(const json& list) {
    std::vector<FileRecord> files;
    for (const json& item : list) {
        const json& stamp = item.at("stamp");
        files.push_back({item.at("name").get<std::string>(),
                         {stamp.at(0).get<std::uint64_t>(), stamp.at(1).get<std::uint64_t>(), stamp.at(2).get<std::int64_t>(), stamp.at(3).get<std::int64_t>()},
                         item.at("hash").get<std::string>()});
    }
    return files;
}

LedgerLine parse(const json& value) {
    LedgerLine line;
    const std::pair<const char*, std::string*> texts[] = {{"id", &line.id},       {"source", &line.source},       {"kind", &line.kind}, {"arguments", &line.arguments},
                                                          {"algorithm", &line.algorithm}, {"decoded", &line.decoded}};
    for (const auto& [key, text] : texts) *text = value.at(key).get<std::string>();
    line.inputs = files_from(value.at("inputs"));
    line.outputs = files_from(value.at("outputs"));
    line.seconds = value.at("seconds").get<double>();
    line.warnings = value.at("warnings").get<std::vector<std::string>>();
    line.statistics = value.at("statistics");
    if (const auto failure = value.find("failure"); failure != value.end())
        line.failure = Error{ErrorCode(failure->at("code").get<int>()), failure->at("reason").get<std::string>()};
    return line;
}

LedgerLines last_of_each(const std::vector<std::string>& lines) {
    LedgerLines known;
    for (const std::string& text : lines)
        if (std::optional<LedgerLine> line = from_line(text)) known.insert_or_assign(line->id, std::move(*line));
    return known;
}

} // namespace

std::string to_line(const LedgerLine& line) {
    json value = {{"ledger", ledger_version},     {"id", line.id},           {"source", line.source},           {"kind", line.kind},
                  {"arguments", line.arguments},  {"algorithm", line.algorithm}, {"decoded", line.decoded},     {"inputs", to_json(line.inputs)},
                  {"outputs", to_json(line.outputs)}, {"seconds", line.seconds}, {"warnings", line.warnings}, {"statistics", line.statistics}};
    if (line.failure) value["failure"] = {{"code", int(line.failure->code)}, {"reason", line.failure->message}};
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<LedgerLine> from_line(const std::string& text) {
    const json value = json::parse(text, nullptr, false);
    try {
        if (value.is_object() && value.at("ledger") == ledger_version) return parse(value);
    } catch (const json::exception&) { // a member that is missing or of another type: no line of ours
    }
    return {};
}

Result<LedgerLines> Ledger::read(const std::filesystem::path& file) {
    return Journal::read(file).map(last_of_each);
}

Result<Ledger> Ledger::open(const std::filesystem::path& file) {
    Result<Journal> journal = Journal::open(file);
    if (!journal) return tl::unexpected(journal.error());
    LedgerLines known = last_of_each(journal->lines());
    constexpr std::size_t slack = 64;
    if (journal->lines().size() > 2 * known.size() + slack) {
        std::vector<std::string> lines;
        for (const auto& [id, line] : known) lines.push_back(to_line(line));
        if (Result<void> replaced = journal->replace(lines); !replaced) return tl::unexpected(replaced.error());
    }
    return Ledger(std::move(*journal), std::move(known));
}

Result<void> Ledger::record(const LedgerLine& line) {
    const std::string text = to_line(line);
    const std::lock_guard lock(*mutex_);
    return journal_.append(text);
}

} // namespace reliefbake
