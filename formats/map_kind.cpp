#include "formats/map_kind.h"

#include "formats/decode_session.h"
#include "formats/fact_reader.h"

namespace reliefbake {

Result<std::string> kind_of_map(const std::filesystem::path& path, std::uint64_t max_bytes) {
    const Result<DecodeSession> session = DecodeSession::open(path, max_bytes, 1);
    if (!session) return tl::unexpected(session.error());
    const nlohmann::json facts = nlohmann::json::parse(session->claims().relief, nullptr, false);
    if (!facts.is_object()) return std::string();
    std::vector<std::string> ignored;
    return FactReader(facts, ignored).text("kind").value_or("");
}

} // namespace reliefbake
