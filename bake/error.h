#pragma once
// Two kinds of failure (docs/FORMATS.md lists the exit codes): ours asserts, theirs is an Error value.

#include <string>
#include <tl/expected.hpp>

namespace reliefbake {

/// What went wrong, as the exit code that a script sees.
enum class ErrorCode {
    internal = 1,      ///< a fault of ours
    usage = 2,         ///< an option is wrong or does not fit the others
    verification = 4,  ///< `verify` found a map unsafe
    budget = 5,        ///< the work does not fit the declared limits
    bad_data = 65,     ///< the input file cannot be decoded or is not what its use needs
    no_input = 66,     ///< the input file does not exist or cannot be opened
    cannot_create = 73, ///< the output file cannot be created
    write_failed = 74, ///< writing stopped half-way (disk full, ...); nothing was left behind
};

/// One line for a person: the file, what was expected, what was found, what to do.
struct Error {
    ErrorCode code;
    std::string message;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(ErrorCode code, std::string message) {
    return tl::unexpected<Error>(Error{code, std::move(message)});
}

} // namespace reliefbake
