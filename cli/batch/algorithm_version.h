#pragma once
// What stands in the ledger for "the same tool".

#include "cli/version.h"

#include <string>

namespace reliefbake {

/// To be raised with every change after which any command of a batch writes other bytes for the same file and options; a test holds
/// the bytes that this number stands for (tests/cli/test_batch.cpp).
constexpr int bytes_revision = 1;

inline std::string algorithm_version() { return std::string(version()) + "+" + std::to_string(bytes_revision); }

} // namespace reliefbake
