#pragma once

namespace reliefbake {

/// The version of this build, as --version and the metadata of a map say it.
inline const char* version() { return RELIEFBAKE_VERSION; }

} // namespace reliefbake
